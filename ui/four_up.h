#pragma once

#include <QSplitter>
#include <QWidget>
#include <array>

#include "ui/views/slice_view.h"
#include "ui/views/volume_view.h"

namespace lacuna::ui {

/// How the views share their place: a grid of four, a large 3D view with the slices in a column beside it, or one view.
enum class Arrangement { four, one_and_three, single };

/// The four linked views. Any of them can take the whole place for a while.
class FourUp final : public QWidget {
    Q_OBJECT
public:
    explicit FourUp(QWidget* parent = nullptr);
    VolumeView* volumeView() const { return volume_; }
    SliceView* slice(SliceKind kind) const { return slices_[std::size_t(kind)]; }
    const std::array<SliceView*, 3>& slices() const { return slices_; }
    Arrangement arrangement() const { return maximized_ ? Arrangement::single : shared_; }
    /// Arrangement and sizes, to be kept; restoreState() takes nothing from bytes it does not know.
    QByteArray saveState() const;
    bool restoreState(const QByteArray& state);

public Q_SLOTS:
    /// `single` shows the view that has the focus (the 3D view where none has).
    void setArrangement(lacuna::ui::Arrangement arrangement);
    /// Shows one view alone, or all again if it already is.
    void toggleMaximized(QWidget* view);
    /// The same for the view that has the focus (the 3D view where none has).
    void toggleFocused();
    /// Gives a view the keys; one that another hides takes its place.
    void focusView(QWidget* view);
    /// Even sizes in the grid of four.
    void reset();

Q_SIGNALS:
    void arrangementChanged(lacuna::ui::Arrangement arrangement);

private:
    std::array<QWidget*, 4> views() const;
    QWidget* focused() const;
    void arrange(Arrangement shared);
    void evenSizes();
    void showViews();

    VolumeView* volume_;
    std::array<SliceView*, 3> slices_;
    QSplitter *outer_, *first_, *second_;  ///< first_ holds the 3D view, in the grid the axial slice too
    Arrangement shared_ = Arrangement::four;
    QWidget* maximized_ = nullptr;
};

}  // namespace lacuna::ui
