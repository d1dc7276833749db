#pragma once

#include <QColor>
#include <QImage>
#include <memory>
#include <span>
#include <vector>

#include "core/regions/label_volume.h"
#include "core/volume/voi_window.h"

namespace lacuna::ui {

/// What is tinted in a slice: the voxels of one label, and of others by a palette.
struct SliceOverlay {
    std::shared_ptr<const LabelVolume> labels;
    std::uint32_t id = 0;  ///< 0: none stands out
    QColor color{255, 130, 40};
    /// Tint of each label; transparent, or a label beyond its end: none. Null: no label but `id` is tinted.
    std::shared_ptr<const std::vector<QRgb>> tints = nullptr;

    bool empty() const { return !labels || (id == 0 && !tints); }
};

/// Values (rows from the top, NaN black) as a grey picture through a window.
QImage slice_image(std::span<const float> values, QSize size, const VoiWindow& window);

/// Tints the picture's pixels by the labels that lie there.
/// @param opacity  of the tint, 0..1
void tint_image(QImage& image, std::span<const std::uint32_t> labels, const SliceOverlay& overlay, double opacity);

}  // namespace lacuna::ui
