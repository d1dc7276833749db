#pragma once

#include <glm/gtc/quaternion.hpp>
#include <string_view>

#include "core/volume/reslice.h"
#include "core/volume/voi_window.h"

namespace lacuna {

/// How the slices are cut and painted, beside their window.
struct SliceSettings {
    VoiFunction function = VoiFunction::linear_exact;  ///< of the window
    int table = 0;                                     ///< which of the document's tables VoiFunction::table means
    /// Turns the three planes together about the cross-hair, in patient space; the identity: they lie along the grid.
    glm::dquat tilt{1, 0, 0, 0};
    Slab slab;
    double overlay_opacity = 0.65;  ///< of regions and defects, 0..1
    friend bool operator==(const SliceSettings&, const SliceSettings&) = default;
};

/// What no view can show of them, in one sentence; empty when they are sound.
const char* fault_of(const SliceSettings& settings);

/// "linear", "linear-exact", "sigmoid", "table"; @throws Error(bad_usage) for an unknown word
std::string_view name_of(VoiFunction function);
VoiFunction parse_voi_function(std::string_view text);
/// "mean", "mip", "minip"; @throws Error(bad_usage) for an unknown word
std::string_view name_of(SlabMode mode);
SlabMode parse_slab_mode(std::string_view text);

}  // namespace lacuna
