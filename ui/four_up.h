#pragma once

#include <QSplitter>
#include <QWidget>
#include <array>

#include "ui/views/slice_view.h"
#include "ui/views/volume_view.h"

namespace lacuna::ui {

/// The four linked views. Any of them can take the whole place for a while.
class FourUp final : public QWidget {
    Q_OBJECT
public:
    explicit FourUp(QWidget* parent = nullptr);
    VolumeView* volumeView() const { return volume_; }
    SliceView* slice(SliceKind kind) const { return slices_[std::size_t(kind)]; }
    const std::array<SliceView*, 3>& slices() const { return slices_; }
    bool maximized() const { return maximized_ != nullptr; }

public Q_SLOTS:
    /// Shows one view alone, or all again if it already is.
    void toggleMaximized(QWidget* view);
    /// The same for the view that has the focus (the 3D view where none has).
    void toggleFocused();

private:
    VolumeView* volume_;
    std::array<SliceView*, 3> slices_;
    QSplitter *top_, *bottom_;
    QWidget* maximized_ = nullptr;
};

}  // namespace lacuna::ui
