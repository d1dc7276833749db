#pragma once

#include <QColor>
#include <QImage>
#include <memory>

#include "core/regions/label_volume.h"
#include "core/volume/volume.h"
#include "ui/views/slice_plane.h"

namespace lacuna::ui {

/// What is tinted in a slice: the voxels of one label.
struct SliceOverlay {
    std::shared_ptr<const LabelVolume> labels;
    std::uint32_t id = 0;  ///< 0: nothing
    QColor color{255, 130, 40};
};

/// One slice, one pixel a voxel, through a grey window (lo black, hi white; NaN black).
/// @param index  along the plane's w axis, inside the grid
QImage slice_image(const Volume& volume, const SlicePlane& plane, int index, ValueRange window,
                   const SliceOverlay& overlay = {});

}  // namespace lacuna::ui
