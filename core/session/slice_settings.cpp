#include "core/session/slice_settings.h"

#include <cmath>

#include "core/base/names.h"

namespace lacuna {

namespace {

constexpr NameTable<VoiFunction, 4> k_functions{{{VoiFunction::linear, "linear"},
                                                 {VoiFunction::linear_exact, "linear-exact"},
                                                 {VoiFunction::sigmoid, "sigmoid"},
                                                 {VoiFunction::table, "table"}}};
constexpr NameTable<SlabMode, 3> k_modes{
    {{SlabMode::mean, "mean"}, {SlabMode::mip, "mip"}, {SlabMode::minip, "minip"}}};

}  // namespace

const char* fault_of(const SliceSettings& settings) {
    if (!(std::abs(glm::length(settings.tilt) - 1) <= 1e-6)) return "slices.tilt is no unit quaternion.";
    if (!(settings.slab.thickness_mm >= 0) || !std::isfinite(settings.slab.thickness_mm))
        return "slices.slab.thickness_mm has to be 0 or more.";
    if (settings.table < 0) return "slices.table has to be 0 or more.";
    if (!(settings.overlay_opacity >= 0 && settings.overlay_opacity <= 1))
        return "slices.overlay_opacity has to be from 0 to 1.";
    return "";
}

std::string_view name_of(VoiFunction function) { return name_in(k_functions, function); }
VoiFunction parse_voi_function(std::string_view text) { return parse_name(k_functions, text, "window function"); }
std::string_view name_of(SlabMode mode) { return name_in(k_modes, mode); }
SlabMode parse_slab_mode(std::string_view text) { return parse_name(k_modes, text, "slab mode"); }

}  // namespace lacuna
