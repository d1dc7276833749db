#include "core/session/preset_settings.h"

namespace lacuna {

namespace {

constexpr double k_least_step = 0.01, k_largest_step = 100;  // as check(plan)

}  // namespace

ViewSettings with_preset(const ViewSettings& settings, const PresetFile& preset) {
    ViewSettings next = settings;
    next.tf = preset.tf;
    if (!preset.technique) return next;
    const Technique& technique = *preset.technique;
    try {
        if (!technique.mode.empty()) switch_mode(next, parse_view_mode(technique.mode));
        if (!technique.shading.empty()) next.shading = parse_shading(technique.shading);
    } catch (const Error& fault) {
        throw Error(Errc::bad_input, "The preset \"" + preset.tf.name + "\" cannot be shown: " + fault.what());
    }
    if (technique.step != 0) {
        if (!(technique.step >= k_least_step && technique.step <= k_largest_step))
            throw Error(Errc::bad_input, "The preset \"" + preset.tf.name +
                                             "\" cannot be shown: its step must lie between 0.01 and 100.");
        next.quality.step = technique.step;
    }
    return next;
}

PresetFile preset_of(const ViewSettings& settings, const std::string& name) {
    PresetFile preset{settings.tf, Technique{std::string(name_of(settings.mode)),
                                             std::string(name_of(settings.shading)), settings.quality.step}};
    preset.tf.name = name;
    return preset;
}

}  // namespace lacuna
