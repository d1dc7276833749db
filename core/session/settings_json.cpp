#include "core/session/settings_json.h"

#include "core/session/settings_fields.h"

namespace lacuna {

std::string to_json(const ViewSettings& settings) { return FieldWriter::write(settings).dump(); }

ViewSettings view_settings_from_json(const std::string& json, const std::string& where) {
    ViewSettings settings;
    FieldReader::read(parse_json(json, where), settings, where);
    check(settings, where);
    return settings;
}

void check(const ViewSettings& settings, const std::string& where) {
    const auto refuse = [&](const std::string& fault) { throw Error(Errc::bad_input, where + ": " + fault); };
    if (settings.ranges.size() > Classification::k_max_ranges)
        refuse("there are more than " + std::to_string(Classification::k_max_ranges) + " ranges.");
    if (settings.cuts.size() > ViewSettings::k_max_planes)
        refuse("there are more than " + std::to_string(ViewSettings::k_max_planes) + " cutting planes.");
    for (int axis = 0; axis < 3; ++axis)
        if (!(settings.roi.lo[axis] >= 0 && settings.roi.lo[axis] < settings.roi.hi[axis] &&
              settings.roi.hi[axis] <= 1))
            refuse("the ends of the box have to ascend within 0 to 1.");
    const auto check_quality = [&](const Quality& quality) {
        if (!(quality.step >= 0.01 && quality.step <= 100)) refuse("quality.step has to lie between 0.01 and 100.");
    };
    check_quality(settings.quality);
    for (const auto& [mode, own] : settings.other_modes) {
        check_quality(own.quality);
        for (const double v : {own.projection_window.lo, own.projection_window.hi})
            if (!std::isfinite(v)) refuse("a grey level is no number.");
    }
    for (const CutSetting& cut : settings.cuts)
        if (!(glm::dot(cut.plane.normal, cut.plane.normal) > 0) || !std::isfinite(cut.plane.offset))
            refuse("a cutting plane has no direction.");
    for (const double v : {settings.window.lo, settings.window.hi, settings.iso, settings.lmip_threshold})
        if (!std::isfinite(v)) refuse("a grey level is no number.");
    if (const char* fault = fault_of(settings.slices); *fault) refuse(fault);
    for (const Measurement& m : settings.measurements)
        if (const char* fault = fault_of(m); *fault) refuse("measurement " + std::to_string(m.id) + ": " + fault);
    check(settings.tf);
}

}  // namespace lacuna
