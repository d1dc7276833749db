#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>

#include "core/session/document.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

/// View mode, isovalue, shading and quality.
class RenderPanel final : public QWidget {
    Q_OBJECT
public:
    explicit RenderPanel(QWidget* parent = nullptr);
    void setVolumeFacts(const lacuna::VolumeStatistics& statistics, const QString& unit);
    void setSettings(const lacuna::ViewSettings& settings);
    /// Says which structures can draw the scene, and why the others cannot.
    void setScene(const lacuna::Scene& scene);
    QComboBox* modeBox() const { return mode_; }
    /// Puts a panel of its own below the rows.
    void append(QWidget* panel) { form_->addRow(panel); }
    QComboBox* structureBox() const { return structure_; }
    /// What is to be known of the mode on this volume; hidden where that is nothing.
    QLabel* note() const { return note_; }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::ViewSettings& next);

private:
    void buildRows();
    void connectRows();
    void showRelevantRows();
    bool airAround(const lacuna::Volume& volume) const;
    template <class Change>
    void edit(const QString& name, Change&& change);

    ViewSettings settings_;
    QFormLayout* form_;
    QComboBox* mode_;
    QLabel* note_;
    double air_below_ = 0;  ///< Otsu's threshold of the volume
    ValueSlider* iso_;
    ValueSlider* lmip_;
    QCheckBox* by_tf_;
    QComboBox* shading_;
    QComboBox* quality_;
    QComboBox* structure_;
};

/// The view modes in the order of their keys 1 to 7, with a name for people.
struct ModeName {
    lacuna::ViewMode mode;
    QString name, hint;
};
const std::vector<ModeName>& mode_names();

}  // namespace lacuna::ui
