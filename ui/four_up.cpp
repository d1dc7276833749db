#include "ui/four_up.h"

#include <QVBoxLayout>

namespace lacuna::ui {

FourUp::FourUp(QWidget* parent)
    : QWidget(parent),
      volume_(new VolumeView(this)),
      slices_{new SliceView(SliceKind::axial, this), new SliceView(SliceKind::coronal, this),
              new SliceView(SliceKind::sagittal, this)},
      top_(new QSplitter(Qt::Horizontal, this)),
      bottom_(new QSplitter(Qt::Horizontal, this)) {
    top_->addWidget(volume_);
    top_->addWidget(slices_[0]);
    bottom_->addWidget(slices_[1]);
    bottom_->addWidget(slices_[2]);
    auto* rows = new QSplitter(Qt::Vertical, this);
    rows->addWidget(top_);
    rows->addWidget(bottom_);
    for (QSplitter* splitter : {top_, bottom_, rows}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(5);
        splitter->setSizes({1000, 1000});
    }
    // The columns move together, so that the four stay a grid.
    connect(top_, &QSplitter::splitterMoved, this, [this] { bottom_->setSizes(top_->sizes()); });
    connect(bottom_, &QSplitter::splitterMoved, this, [this] { top_->setSizes(bottom_->sizes()); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(rows);
    connect(volume_, &VolumeView::maximizeRequested, this, [this] { toggleMaximized(volume_); });
    for (SliceView* slice : slices_)
        connect(slice, &SliceView::maximizeRequested, this, [this, slice] { toggleMaximized(slice); });
    setTabOrder(volume_, slices_[0]);
    setTabOrder(slices_[0], slices_[1]);
    setTabOrder(slices_[1], slices_[2]);
}

void FourUp::toggleMaximized(QWidget* view) {
    maximized_ = maximized_ ? nullptr : view;
    for (QWidget* each : {static_cast<QWidget*>(volume_), static_cast<QWidget*>(slices_[0]),
                          static_cast<QWidget*>(slices_[1]), static_cast<QWidget*>(slices_[2])})
        each->setVisible(!maximized_ || each == maximized_);
    top_->setVisible(!maximized_ || top_->isAncestorOf(maximized_));
    bottom_->setVisible(!maximized_ || bottom_->isAncestorOf(maximized_));
    if (maximized_) maximized_->setFocus();
}

void FourUp::toggleFocused() {
    QWidget* view = volume_;
    for (SliceView* slice : slices_)
        if (slice->hasFocus()) view = slice;
    toggleMaximized(view);
}

}  // namespace lacuna::ui
