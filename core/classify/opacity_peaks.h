#pragma once

#include <optional>
#include <vector>

#include "core/classify/classification.h"

namespace lacuna {

/// Values between which a classification's peaks reach half their height: local maxima of opacity that fall to half on
/// both sides, shapes in use, and visible segmentation ranges. What lies within is lost by whatever takes few values
/// for many.
std::vector<ValueRange> opacity_peaks(const Classification& classification);

/// The width in values of the narrowest of them.
std::optional<double> narrowest_peak(const Classification& classification);

}  // namespace lacuna
