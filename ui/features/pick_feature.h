#pragma once

#include <optional>

#include "core/session/pick.h"
#include "ui/features/cut_feature.h"
#include "ui/views/view_tool.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Points on what the 3D view shows: a click reads one out and marks it, Shift with the mouse moving takes the slices
/// along, and a menu over the view does more with it (slices, focus, centre of rotation, cut).
class PickFeature final : public QObject, public ViewTool {
    Q_OBJECT
public:
    /// @param cuts  whose commands stand in the view's menu, too
    PickFeature(Workbench& bench, CutFeature* cuts);
    /// The point shown at a place of the 3D view, mm; none where nothing is seen.
    std::optional<glm::dvec3> pointAt(const QPointF& at) const;
    /// The point read out last.
    const std::optional<glm::dvec3>& marked() const { return marked_; }
    void paint(QPainter& painter, const ViewRays& rays) const override;

Q_SIGNALS:
    void readOut(const glm::ivec3& voxel);
    void readOutEnded();

private:
    void buildMenu();
    void mark(const QPointF& at, bool slices_too);
    void hover(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void showMenu(const QPointF& at);
    void focusOn(const glm::dvec3& mm);
    void turnAbout(const glm::dvec3& mm);

    Workbench& bench_;
    CutFeature* cuts_;
    std::shared_ptr<const Scene> scene_;  ///< of the frame shown
    std::shared_ptr<const Frame> frame_;
    std::optional<glm::dvec3> marked_;
};

}  // namespace lacuna::ui
