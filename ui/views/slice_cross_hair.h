#pragma once

#include <QPointF>
#include <vector>

#include "ui/views/slice_plane.h"
#include "ui/views/slice_tool.h"

namespace lacuna::ui {

/// The cross-hair of a slice view: where the two other planes cut this one, in their colours. Its handles, near the
/// ends of the lines, turn the two about the cross-hair, so that all three stay at right angles; Shift+drag does so
/// from anywhere, Ctrl+Left and Ctrl+Right by a degree.
class SliceCrossHair final : public SliceTool {
public:
    bool press(SliceView& view, const QMouseEvent& event) override;
    bool move(SliceView& view, const QMouseEvent& event) override;
    bool release(SliceView& view, const QMouseEvent& event) override;
    bool key(SliceView& view, const QKeyEvent& event) override;
    void leave(SliceView& view) override;
    void paint(const SliceView& view, QPainter& painter) const override;

    /// Where the handles of a view are now; those outside it have none.
    static std::vector<QPointF> handles(const SliceView& view);

private:
    static void turn(SliceView& view, double radians);

    const SliceView* over_ = nullptr;     ///< the mouse is in this view
    const SliceView* turning_ = nullptr;  ///< the drag is in this view
    double last_angle_ = 0;
};

}  // namespace lacuna::ui
