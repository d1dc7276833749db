#pragma once

#include "core/classify/part_histogram.h"
#include "core/session/document.h"

namespace lacuna {

/// The part of a volume that the settings leave to be seen: inside the cutting planes and the segmentation ranges in
/// use.
VolumePart shown_part(const ViewSettings& settings);

}  // namespace lacuna
