#pragma once

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace lacuna::ui {

class SliceView;

/// Something a person does in slice views beyond scrolling and windowing. The views ask their tools, in the order they
/// were added, before they act themselves; a tool that answers true has dealt with the event. One tool may serve
/// several views. Positions are the view's (SliceView::toMm()).
class SliceTool {
public:
    virtual ~SliceTool() = default;
    virtual bool press(SliceView&, const QMouseEvent&) { return false; }
    virtual bool move(SliceView&, const QMouseEvent&) { return false; }
    virtual bool release(SliceView&, const QMouseEvent&) { return false; }
    virtual bool doubleClick(SliceView&, const QMouseEvent&) { return false; }
    virtual bool key(SliceView&, const QKeyEvent&) { return false; }
    virtual void leave(SliceView&) {}
    /// Over the picture and the cross-hair.
    virtual void paint(const SliceView&, QPainter&) const {}
};

}  // namespace lacuna::ui
