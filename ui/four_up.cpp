#include "ui/four_up.h"

#include <QDataStream>
#include <QIODevice>
#include <QVBoxLayout>

namespace lacuna::ui {

namespace {
constexpr quint32 k_state_version = 1;
}

FourUp::FourUp(QWidget* parent)
    : QWidget(parent),
      volume_(new VolumeView(this)),
      slices_{new SliceView(SliceKind::axial, this), new SliceView(SliceKind::coronal, this),
              new SliceView(SliceKind::sagittal, this)},
      outer_(new QSplitter(Qt::Vertical, this)),
      first_(new QSplitter(Qt::Horizontal, this)),
      second_(new QSplitter(Qt::Horizontal, this)) {
    first_->addWidget(volume_);
    first_->addWidget(slices_[0]);
    second_->addWidget(slices_[1]);
    second_->addWidget(slices_[2]);
    outer_->addWidget(first_);
    outer_->addWidget(second_);
    for (QSplitter* splitter : {outer_, first_, second_}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(5);
    }
    evenSizes();
    // In the grid the columns move together.
    connect(first_, &QSplitter::splitterMoved, this, [this] {
        if (shared_ == Arrangement::four) second_->setSizes(first_->sizes());
    });
    connect(second_, &QSplitter::splitterMoved, this, [this] {
        if (shared_ == Arrangement::four) first_->setSizes(second_->sizes());
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(outer_);
    connect(volume_, &VolumeView::maximizeRequested, this, [this] { toggleMaximized(volume_); });
    for (SliceView* slice : slices_)
        connect(slice, &SliceView::maximizeRequested, this, [this, slice] { toggleMaximized(slice); });
    setTabOrder(volume_, slices_[0]);
    setTabOrder(slices_[0], slices_[1]);
    setTabOrder(slices_[1], slices_[2]);
}

std::array<QWidget*, 4> FourUp::views() const { return {volume_, slices_[0], slices_[1], slices_[2]}; }

QWidget* FourUp::focused() const {
    for (QWidget* view : views())
        if (view->hasFocus()) return view;
    return volume_;
}

void FourUp::arrange(Arrangement shared) {
    shared_ = shared;
    const bool grid = shared == Arrangement::four;
    outer_->setOrientation(grid ? Qt::Vertical : Qt::Horizontal);
    second_->setOrientation(grid ? Qt::Horizontal : Qt::Vertical);
    grid ? first_->addWidget(slices_[0]) : second_->insertWidget(0, slices_[0]);
    evenSizes();
}

void FourUp::evenSizes() {
    first_->setSizes({1000, 1000});
    second_->setSizes({1000, 1000, 1000});
    outer_->setSizes(shared_ == Arrangement::four ? QList<int>{1000, 1000} : QList<int>{2400, 1000});
}

void FourUp::showViews() {
    for (QWidget* view : views()) view->setVisible(!maximized_ || view == maximized_);
    for (QSplitter* part : {first_, second_}) part->setVisible(!maximized_ || part->isAncestorOf(maximized_));
}

void FourUp::setArrangement(Arrangement arrangement) {
    if (arrangement == this->arrangement()) return;
    QWidget* const view = focused();
    maximized_ = arrangement == Arrangement::single ? view : nullptr;
    if (!maximized_ && arrangement != shared_) arrange(arrangement);
    showViews();
    if (maximized_) maximized_->setFocus();
    Q_EMIT arrangementChanged(arrangement);
}

void FourUp::toggleMaximized(QWidget* view) {
    maximized_ = maximized_ ? nullptr : view;
    showViews();
    view->setFocus();
    Q_EMIT arrangementChanged(arrangement());
}

void FourUp::toggleFocused() { toggleMaximized(focused()); }

void FourUp::focusView(QWidget* view) {
    if (maximized_ && maximized_ != view) {
        maximized_ = view;
        showViews();
    }
    view->setFocus(Qt::TabFocusReason);
}

void FourUp::reset() {
    setArrangement(Arrangement::four);
    evenSizes();
}

QByteArray FourUp::saveState() const {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << k_state_version << qint32(shared_);
    qint32 alone = -1;
    for (int i = 0; i < 4; ++i)
        if (views()[std::size_t(i)] == maximized_) alone = i;
    stream << alone << outer_->saveState() << first_->saveState() << second_->saveState();
    return bytes;
}

bool FourUp::restoreState(const QByteArray& state) {
    QDataStream stream(state);
    quint32 version = 0;
    qint32 shared = 0, alone = -1;
    QByteArray outer, first, second;
    stream >> version >> shared >> alone >> outer >> first >> second;
    if (stream.status() != QDataStream::Ok || version != k_state_version || shared < 0 || shared > 1 || alone < -1 ||
        alone > 3)
        return false;
    arrange(Arrangement(shared));
    outer_->restoreState(outer);
    first_->restoreState(first);
    second_->restoreState(second);
    maximized_ = alone < 0 ? nullptr : views()[std::size_t(alone)];
    showViews();
    Q_EMIT arrangementChanged(arrangement());
    return true;
}

}  // namespace lacuna::ui
