#pragma once

#include <optional>

#include "ui/views/view_tool.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// How the hand works in the 3D view beside the camera: Ctrl with the right button shifts (down: to higher values, as
/// on the slices) and widens (to the right) the transfer function, the isovalue or the grey window, whichever the mode
/// shows by; and the choice between turntable and free rotation, which is remembered.
class HandFeature final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit HandFeature(Workbench& bench);
    QAction* freeRotation() const { return free_; }

    bool press(const ViewRays& rays, const QMouseEvent& event) override;
    void drag(const ViewRays& rays, const QMouseEvent& event) override;

private:
    void changeLevels(const ViewSettings& from, double higher, double wider);

    Workbench& bench_;
    QAction* free_;
    QPointF from_;
    std::optional<ViewSettings> before_;  ///< the drag's beginning: coming back brings it back
};

}  // namespace lacuna::ui
