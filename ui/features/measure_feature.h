#pragma once

#include "ui/file_writes.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/slice_measure.h"
#include "ui/workbench.h"

class QActionGroup;

namespace lacuna::ui {

/// Distances, angles and regions of interest on the slices: the Measure menu, the tool in the views, the list.
class MeasureFeature final : public QObject {
    Q_OBJECT
public:
    explicit MeasureFeature(Workbench& bench);

    SliceMeasure* tool() const { return tool_; }
    MeasurePanel* panel() const { return panel_; }
    QDockWidget* dock() const { return dock_; }
    /// The table as text with tabs between its columns.
    QString tableText() const;

public Q_SLOTS:
    void exportTable();
    void copyTable();
    void removeAll();

private:
    void buildMenu();
    void showKind();
    void showSettings();
    void choose(std::uint32_t id);
    MeasurePanel::Row rowOf(const Measurement& m) const;

    Workbench& bench_;
    SliceMeasure* tool_;
    MeasurePanel* panel_;
    QDockWidget* dock_;
    QActionGroup* kinds_ = nullptr;
    QAction* remove_ = nullptr;
    FileWrites writes_;
};

}  // namespace lacuna::ui
