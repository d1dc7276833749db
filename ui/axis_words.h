#pragma once

#include <QString>

#include "core/volume/axis_names.h"

namespace lacuna::ui {

/// A coordinate without its unit: "R 12.50" of a patient, "X -12.50" of a part.
QString coordinate_words(AxisNames names, int axis, double mm);

/// A standard view of VolumeView::lookFrom() by its name in a menu: "Front (anterior)", "From -Y".
QString standard_view_name(AxisNames names, char side);

}  // namespace lacuna::ui
