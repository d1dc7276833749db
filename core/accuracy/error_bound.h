#pragma once

#include <vector>

#include "core/render/plan.h"

namespace lacuna {

/// A way in which a plan's picture may differ from brute force's.
enum class Loss {
    termination,       ///< rays end before all is seen
    step,              ///< samples lie elsewhere
    nearest,           ///< voxels instead of the values between them
    sparse,            ///< pixels between the cast ones are interpolated
    thresholds,        ///< values that differ count as equal
    quantised,         ///< leap keeps 15 bits of f32 values, or its kernel takes equal samples for a region
    stored_gradients,  ///< packed to 32 bits
    gradient_filter,
    refinement,
    segments,   ///< integrated otherwise than sample by sample
    shear_warp  ///< another method: there is no brute force of it
};

/// How an error is known.
enum class ErrorKnown {
    exact,     ///< the same samples as brute force, taken alike
    bounded,   ///< cannot be larger
    measured,  ///< of this picture, against brute force
    unknown
};

/// How far a picture may be from brute force.
struct ErrorBound {
    ErrorKnown known = ErrorKnown::unknown;
    double levels = 0;           ///< in 1/255, of any channel of any pixel; meaningless where unknown
    std::vector<Loss> losses{};  ///< what the plan gives up, in the order of the enumeration
};

/// The brute force a scene's plans are held against: its default plan at a step, without structure, early termination
/// and every other loss.
Plan brute_force(const Scene& scene, double step);

/// What a plan gives up against brute force in this scene; parameters the mode has no use for are passed over. Empty:
/// nothing, and the pictures are the same to the device's rounding (held below one level by tests/kernel).
std::vector<Loss> losses(const Plan& plan, const Scene& scene, const Plan& brute);

/// What is known of a plan's error without drawing anything: exact where nothing is given up, at most hidden_levels()
/// where that is early termination alone and no effect amplifies it, else unknown. Pure.
ErrorBound known_bound(const Plan& plan, const Scene& scene, const Plan& brute);

}  // namespace lacuna
