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
    if (settings.cuts.size() > Scene::k_max_cuts)
        refuse("there are more than " + std::to_string(Scene::k_max_cuts) + " cutting planes.");
    if (!(settings.quality.step > 0 && settings.quality.step <= 100)) refuse("quality.step has to be above 0.");
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
