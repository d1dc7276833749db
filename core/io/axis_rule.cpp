#include "core/io/axis_rule.h"

#include "core/io/text_fields.h"

namespace lacuna {

namespace {

/// "left-posterior-superior", "RAS", "LAS-time" and the like (NRRD format, section 5.1).
bool is_anatomical(std::string_view space) {
    std::string name = lower_case(space);
    if (const std::string time = "-time"; name.ends_with(time)) name.resize(name.size() - time.size());
    for (const std::string_view known : {"right-anterior-superior", "left-anterior-superior", "left-posterior-superior",
                                         "ras", "las", "lps", "rast", "last", "lpst"})
        if (name == known) return true;
    return false;
}

}  // namespace

AxisNames axis_names_of(const SpaceStatement& statement) {
    bool patient = false;
    switch (statement.format) {
        case FileFormat::dicom:
            patient = statement.oriented && !statement.component;
            break;
        case FileFormat::nifti:
            patient = statement.oriented;
            break;
        case FileFormat::nrrd:
            patient = is_anatomical(statement.space) && !statement.told_xyz;
            break;
        case FileFormat::meta_image:
            patient = !statement.space.empty() && statement.space.find('?') == std::string_view::npos;
            break;
        case FileFormat::tiff:
        case FileFormat::raw:
        case FileFormat::dat:
        case FileFormat::vgi:
            break;
    }
    return patient ? AxisNames::patient : AxisNames::xyz;
}

}  // namespace lacuna
