#pragma once

#include <QPainterPath>
#include <QRectF>
#include <cstdint>
#include <vector>

#include "core/volume/volume.h"

namespace lacuna::ui {

/// The outline of a histogram in a rectangle: for each column of pixels the highest of the bins under it, as it is or
/// on a logarithmic scale, the highest shown as high as the rectangle.
/// @param range  from the first bin's lower to the last one's upper end. @param shown  values from side to side
QPainterPath histogram_shape(const std::vector<std::uint64_t>& counts, lacuna::ValueRange range,
                             lacuna::ValueRange shown, bool logarithmic, const QRectF& plot);

}  // namespace lacuna::ui
