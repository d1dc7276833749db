// lacuna info: what an input holds.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/input_options.h"
#include "core/volume/statistics.h"

namespace lacuna::cli {

namespace {

using nlohmann::ordered_json;

ordered_json dicom_json(const DicomFacts& facts) {
    ordered_json json{{"modality", facts.modality},
                      {"description", facts.description},
                      {"series_uid", facts.series_uid},
                      {"slices_found", facts.slices_found},
                      {"slices_used", facts.slices_used},
                      {"slices_missing", facts.slices_missing},
                      {"duplicates", facts.duplicates},
                      {"slice_spacing_min", facts.slice_spacing_min_mm},
                      {"slice_spacing_max", facts.slice_spacing_max_mm},
                      {"gantry_tilt_deg", facts.gantry_tilt_deg},
                      {"transfer_syntax", facts.transfer_syntax},
                      {"photometric_interpretation", facts.photometric_interpretation}};
    json["window"] = facts.window_center && facts.window_width ? ordered_json{*facts.window_center, *facts.window_width}
                                                               : ordered_json();
    ordered_json component = ordered_json::object();
    for (const auto& [key, value] : facts.component) component[key] = value;
    json["component"] = component;
    return json;
}

ordered_json info_json(const Volume& volume, const VolumeStatistics& statistics, const std::string& sha256) {
    const GridGeometry& g = volume.geometry();
    ordered_json direction = ordered_json::array();  // rows of the matrix whose columns are the grid's axes
    for (int row = 0; row < 3; ++row)
        direction.push_back({g.direction[0][row], g.direction[1][row], g.direction[2][row]});
    ordered_json warnings = ordered_json::array();
    for (const Warning& w : volume.warnings) warnings.push_back({{"text", w.text}, {"max_error_mm", w.max_error_mm}});
    ordered_json json{{"dims", {g.size.x, g.size.y, g.size.z}},
                      {"spacing", {g.spacing.x, g.spacing.y, g.spacing.z}},
                      {"origin", {g.origin.x, g.origin.y, g.origin.z}},
                      {"direction", direction},
                      {"axes", g.axis_names == AxisNames::patient ? "patient" : "xyz"},
                      {"scalar", std::string(name_of(volume.type()))},
                      {"range", {statistics.range.lo, statistics.range.hi}},
                      {"unit", volume.unit},
                      {"bytes", volume.bytes()},
                      {"sha256", sha256},
                      {"warnings", warnings},
                      {"nan_voxels", statistics.nan_count},
                      {"mean", statistics.mean},
                      {"stddev", statistics.stddev},
                      {"otsu", otsu_threshold(statistics)}};
    json["dicom"] = volume.dicom ? dicom_json(*volume.dicom) : ordered_json();
    return json;
}

std::string dicom_text(const DicomFacts& facts) {
    std::string text = fmt::format("modality   {}\n", facts.modality);
    if (!facts.description.empty()) text += fmt::format("series     {}\n", facts.description);
    text += fmt::format("slices     {} found, {} used, {} missing, {} duplicate\n", facts.slices_found,
                        facts.slices_used, facts.slices_missing.size(), facts.duplicates.size());
    text += fmt::format("slice step {:.6g} to {:.6g} mm\n", facts.slice_spacing_min_mm, facts.slice_spacing_max_mm);
    if (facts.gantry_tilt_deg != 0) text += fmt::format("tilt       {:.3g} degrees\n", facts.gantry_tilt_deg);
    text += fmt::format("coding     {}, {}\n", facts.transfer_syntax, facts.photometric_interpretation);
    for (const auto& [key, value] : facts.component) text += fmt::format("component  {}: {}\n", key, value);
    return text;
}

std::string info_text(const Volume& volume, const VolumeStatistics& statistics, const std::string& sha256) {
    const GridGeometry& g = volume.geometry();
    const std::string unit = volume.unit.empty() ? "" : " " + volume.unit;
    std::string text = fmt::format("dims       {} x {} x {} voxels\n", g.size.x, g.size.y, g.size.z);
    text += fmt::format("spacing    {:.6g} x {:.6g} x {:.6g} mm\n", g.spacing.x, g.spacing.y, g.spacing.z);
    text += fmt::format("origin     {:.6g}, {:.6g}, {:.6g} mm\n", g.origin.x, g.origin.y, g.origin.z);
    const char axis_names[] = {'x', 'y', 'z'};
    for (int axis = 0; axis < 3; ++axis)
        text += fmt::format("axis {}     {:.6g}, {:.6g}, {:.6g}\n", axis_names[axis], g.direction[axis].x,
                            g.direction[axis].y, g.direction[axis].z);
    text += g.axis_names == AxisNames::patient ? "axes       a patient's: x to the left, y to the back, z to the head\n"
                                               : "axes       X, Y, Z of a part\n";
    text +=
        fmt::format("values     {}, {:.6g} to {:.6g}{}, mean {:.6g}, Otsu's threshold {:.6g}\n", name_of(volume.type()),
                    statistics.range.lo, statistics.range.hi, unit, statistics.mean, otsu_threshold(statistics));
    if (statistics.nan_count > 0) text += fmt::format("not finite {} voxels\n", statistics.nan_count);
    text += fmt::format("bytes      {}\nsha256     {}\n", volume.bytes(), sha256);
    if (volume.dicom) text += dicom_text(*volume.dicom);
    for (const Warning& w : volume.warnings) {
        text += "warning    " + w.text;
        if (w.max_error_mm > 0) text += fmt::format(" (largest position error {:.3g} mm)", w.max_error_mm);
        text += "\n";
    }
    return text;
}

}  // namespace

void add_info_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("info", "what an input holds: size, geometry, values, warnings");
    command->footer("Example: lacuna info scans/head --json");
    auto input = std::make_shared<InputOptions>();
    auto as_json = std::make_shared<bool>(false);
    input->add_to(*command);
    command->add_flag("--json", *as_json, "print JSON");
    command->callback([&chosen, input, as_json] {
        chosen = [input, as_json](Console& console) {
            input->check();
            input->say_warnings = false;  // they are part of the answer
            const Volume volume = input->load(console);
            const VolumeStatistics statistics = compute_statistics(volume, console.job("Measuring"));
            const std::string sha256 = voxel_sha256(volume, console.job("Checksum"));
            // Text of files is not always valid UTF-8: what is not becomes U+FFFD.
            console.print(*as_json ? info_json(volume, statistics, sha256)
                                             .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                                         "\n"
                                   : info_text(volume, statistics, sha256));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
