#pragma once

#include <QColor>
#include <QImage>
#include <memory>
#include <vector>

#include "core/regions/label_volume.h"
#include "core/volume/volume.h"
#include "ui/views/slice_plane.h"

namespace lacuna::ui {

/// What is tinted in a slice: the voxels of one label, and of others by a palette.
struct SliceOverlay {
    std::shared_ptr<const LabelVolume> labels;
    std::uint32_t id = 0;  ///< 0: none stands out
    QColor color{255, 130, 40};
    /// Tint of each label; transparent, or a label beyond its end: none. Null: no label but `id` is tinted.
    std::shared_ptr<const std::vector<QRgb>> tints = nullptr;
};

/// One slice, one pixel a voxel, through a grey window (lo black, hi white; NaN black).
/// @param index  along the plane's w axis, inside the grid
QImage slice_image(const Volume& volume, const SlicePlane& plane, int index, ValueRange window,
                   const SliceOverlay& overlay = {});

}  // namespace lacuna::ui
