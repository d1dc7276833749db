#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "core/session/cut_gizmo.h"
#include "ui/views/view_tool.h"

namespace lacuna::ui {

/// Draws the cutting planes and the box over the 3D picture, and lets them be dragged: the arrow, the disc or the
/// outline moves a plane along its normal, the round handles tilt it (Ctrl: to the volume's axes and diagonals); the
/// box's square handles move its sides, the one in the middle all of it. Values in, signals out.
class CutTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    static constexpr double k_reach_px = 10;  ///< how far from a handle the mouse still takes it

    using QObject::QObject;
    void setGeometry3d(const lacuna::GridGeometry& geometry) { geometry_ = geometry; }
    void setCuts(const std::vector<lacuna::CutSetting>& cuts);
    void setBox(const lacuna::BoxRoi& box) { box_ = box; }
    void setSelected(int cut) { selected_ = cut; }
    void setVisible(bool visible) { visible_ = visible; }

    void paint(QPainter& painter, const ViewRays& rays) const override;
    bool press(const ViewRays& rays, const QMouseEvent& event) override;
    void drag(const ViewRays& rays, const QMouseEvent& event) override;
    void release() override;
    bool hover(const ViewRays& rays, const QMouseEvent& event) override;
    void leave() override;

Q_SIGNALS:
    void cutsEdited(const QString& name, const std::vector<lacuna::CutSetting>& cuts);
    void boxEdited(const QString& name, const lacuna::BoxRoi& box);
    void cutChosen(int cut);
    void repaintNeeded();

private:
    struct Target {
        int cut = -1;  ///< whose grip it is; -1: the box's
        Grip grip;
    };
    Target targetAt(const ViewRays& rays, const glm::dvec2& at) const;
    bool shown(int cut) const { return cuts_[std::size_t(cut)].enabled; }
    void paintOutline(QPainter& painter, const ViewRays& rays, int cut) const;
    void paintHandles(QPainter& painter, const ViewRays& rays) const;
    void paintBox(QPainter& painter, const ViewRays& rays) const;

    GridGeometry geometry_;
    std::vector<CutSetting> cuts_;
    BoxRoi box_;
    int selected_ = -1;
    bool visible_ = true;
    Target hovered_;
    std::optional<PlaneDrag> plane_drag_;
    std::optional<BoxDrag> box_drag_;
};

}  // namespace lacuna::ui
