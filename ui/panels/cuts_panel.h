#pragma once

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "core/session/cut_gizmo.h"
#include "ui/panels/box_panel.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

/// A cutting plane in terms a person turns: where its normal points, and how far it lies from the volume's centre.
struct CutPose {
    double azimuth_deg = 0, elevation_deg = 0;  ///< of the normal, as the camera's: (sin A cos E, -cos A cos E, sin E)
    double distance_mm = 0;                     ///< from the volume's centre along the normal; what lies beyond is kept
};
CutPose pose_of(const CuttingPlane& plane, const GridGeometry& geometry);
CuttingPlane plane_of(const CutPose& pose, bool cap, const GridGeometry& geometry);

/// The list of cutting planes, the one being edited, and the box.
class CutsPanel final : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t k_max_cuts = ViewSettings::k_max_planes;

    explicit CutsPanel(QWidget* parent = nullptr);
    void setGeometry3d(const lacuna::GridGeometry& geometry);
    void setCuts(const std::vector<lacuna::CutSetting>& cuts);
    void setBox(const lacuna::BoxRoi& box) { box_->setBox(box); }
    /// The cut being edited; -1: none.
    int current() const { return list_->currentRow(); }
    BoxPanel* boxPanel() const { return box_; }
    QCheckBox* capBox() const { return cap_; }
    QPushButton* addButton() const { return add_; }
    QListWidget* list() const { return list_; }
    ValueSlider* offsetSlider() const { return offset_; }

public Q_SLOTS:
    void addCut();
    void removeCurrent();
    void flipCurrent();
    /// Chooses the cut to edit; past the last one the first follows.
    void select(int cut);

Q_SIGNALS:
    void edited(const QString& name, const std::vector<lacuna::CutSetting>& cuts);
    void boxEdited(const QString& name, const lacuna::BoxRoi& box);
    void currentChanged(int cut);

private:
    void build();
    void nameAxes(lacuna::AxisNames names);
    void showCut();
    void editPose(const QString& name, const CutPose& pose);
    void setAxis(double azimuth_deg, double elevation_deg);
    CutPose currentPose() const { return poses_[std::size_t(current())]; }

    GridGeometry geometry_;
    std::vector<CutSetting> cuts_;
    std::vector<CutPose> poses_;  ///< kept beside the planes: at the poles the azimuth is not in the normal
    QListWidget* list_;
    QPushButton *add_, *remove_, *flip_;
    QPushButton* axes_[3];
    ValueSlider *azimuth_, *elevation_, *offset_;
    QCheckBox* cap_;
    BoxPanel* box_;
};

}  // namespace lacuna::ui
