#pragma once

#include <QScrollArea>
#include <QStyle>
#include <algorithm>

namespace lacuna::ui {

/// A panel of the window that is scrolled where there is less room than it needs, so that it neither keeps the window
/// from fitting a small screen nor is cut. Where there is room it lies there as without.
class PanelScroll final : public QScrollArea {
public:
    /// @param least  it asks for no more than this, in pixels
    PanelScroll(QWidget* panel, const QSize& least, QWidget* parent = nullptr) : QScrollArea(parent), least_(least) {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setFocusPolicy(Qt::NoFocus);
        setWidget(panel);
    }
    QSize minimumSizeHint() const override { return wholePanel().boundedTo(least_) + QSize(bar(), 0); }
    QSize sizeHint() const override { return widget()->sizeHint().expandedTo(wholePanel()) + QSize(bar(), 0); }
    /// The least size at which nothing is scrolled.
    QSize wholePanel() const { return widget()->minimumSizeHint().expandedTo(widget()->minimumSize()); }

private:
    int bar() const { return style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this); }

    QSize least_;
};

}  // namespace lacuna::ui
