#pragma once

#include <functional>

#include "ui/file_writes.h"
#include "ui/panels/regions_panel.h"
#include "ui/task.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Homogeneous regions in the window: finds them, shows their table, marks the chosen one in every view.
class RegionsFeature final : public QObject {
    Q_OBJECT
public:
    explicit RegionsFeature(Workbench& bench);

    RegionsPanel* panel() const { return panel_; }
    QDockWidget* dock() const { return dock_; }
    void compute() { computeThen(nullptr); }
    /// @param found  what is to be done with the regions found this time; dropped when a newer search begins
    void computeThen(std::function<void()> found);
    void cancel();
    /// Marks a region of the table as choosing its row does.
    void select(std::uint32_t id);

public Q_SLOTS:
    void exportTable();

Q_SIGNALS:
    void finished();
    void gathered(std::uint32_t id);  ///< the chosen region's voxels are marked

private:
    void choose(std::uint32_t id);

    Workbench& bench_;
    RegionsPanel* panel_;
    QDockWidget* dock_;
    Task<std::shared_ptr<const RegionTable>> find_;
    LatestJob<std::shared_ptr<const Highlight>> gather_;
    FileWrites writes_;
};

}  // namespace lacuna::ui
