// lacuna regions: cuts a volume into regions and measures each.

#include <fmt/format.h>

#include <algorithm>

#include "app/command.h"
#include "app/input_options.h"
#include "app/parse.h"
#include "app/read_guard.h"
#include "core/base/atomic_file.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "core/regions/regions.h"

namespace lacuna::cli {

namespace {

struct RegionsWords {
    InputOptions input;
    std::optional<std::string> range_width, threshold, background, connectivity, min_voxels, gradient_limit;
    std::string labels, mesh_folder, json, csv;
    std::optional<std::string> mesh_format;
    bool inner = false, merge_slivers = false, exact_surfaces = false, no_surfaces = false;

    bool wants_surfaces() const { return !no_surfaces && !(json.empty() && csv.empty()); }
};

/// The words that need no volume; threshold ends are resolved later.
RegionOptions parse_options(const RegionsWords& words) {
    if (words.range_width.has_value() == words.threshold.has_value())
        throw Error(Errc::bad_usage, "give either --range-width W or --threshold LO,HI.");
    RegionOptions options;
    if (words.range_width) {
        options.range_width = parse_number("--range-width", *words.range_width);
        if (!(*options.range_width >= 0 && *options.range_width <= 1))
            refuse("--range-width", *words.range_width, "a share from 0 to 1");
    }
    if (words.threshold) parse_word_range("--threshold", *words.threshold);
    if (words.background) {
        if (!words.range_width) throw Error(Errc::bad_usage, "--background goes with --range-width.");
        parse_word_range("--background", *words.background);
    }
    if (words.connectivity) {
        const std::int64_t n = parse_integer("--connectivity", *words.connectivity, 0, 99);
        if (n != 6 && n != 18 && n != 26) refuse("--connectivity", *words.connectivity, "6, 18 or 26");
        options.connectivity = Connectivity(n);
    }
    // Growing turns noise into regions of one voxel by the million: a default that leaves them out keeps the table
    // readable and its memory small.
    if (words.range_width) options.min_voxels = 8;
    if (words.min_voxels) options.min_voxels = parse_integer("--min-voxels", *words.min_voxels, 1, INT64_MAX);
    if (words.gradient_limit) {
        options.gradient_limit = parse_number("--gradient-limit", *words.gradient_limit);
        if (!(*options.gradient_limit >= 0))
            refuse("--gradient-limit", *words.gradient_limit, "a number from 0 up, in the volume's unit per mm");
    }
    options.merge_slivers = words.merge_slivers;
    if (words.exact_surfaces && (!words.threshold || words.mesh_folder.empty()))
        throw Error(Errc::bad_usage, "--exact-surfaces goes with --threshold and --mesh.");
    const char* const formats[] = {"stl", "ply", "obj", "vtp"};
    if (words.mesh_format && std::find(std::begin(formats), std::end(formats), *words.mesh_format) == std::end(formats))
        refuse("--mesh-format", *words.mesh_format, "stl, ply, obj or vtp");
    if (words.mesh_format && words.mesh_folder.empty()) throw Error(Errc::bad_usage, "--mesh-format goes with --mesh.");
    if (words.no_surfaces && words.json.empty() && words.csv.empty())
        throw Error(Errc::bad_usage, "--no-surfaces goes with --json or --csv.");
    return options;
}

void check_targets(const RegionsWords& words) {
    for (const std::string* target : {&words.labels, &words.json, &words.csv})
        if (!target->empty()) check_target(*target);
    check_apart({words.labels, words.json, words.csv});
    check_not_read(words.input.input, {words.labels, words.json, words.csv});
    if (!words.labels.empty() && !words.labels.ends_with(".nrrd"))
        refuse("--labels", words.labels, "a .nrrd file, the one kind of label volume written");
    if (words.mesh_folder.empty()) return;
    // The folder is made when the meshes are; here only what stands in its way is found.
    std::error_code ec;
    std::filesystem::path there = std::filesystem::absolute(words.mesh_folder, ec);
    while (!std::filesystem::exists(there, ec) && there.has_relative_path()) there = there.parent_path();
    if (!std::filesystem::is_directory(there, ec))
        throw Error(Errc::io, fmt::format("Cannot write meshes to {}: {} is a file; name a folder.", words.mesh_folder,
                                          there.string()));
    check_target(there / "region");
}

/// The folders and files of one run: what is not kept is taken back.
class MeshFolder {
public:
    explicit MeshFolder(const std::filesystem::path& folder) : folder_(folder) {
        std::error_code ec;
        for (auto at = std::filesystem::absolute(folder, ec); !std::filesystem::exists(at, ec); at = at.parent_path())
            made_.push_back(at);
        if (std::filesystem::create_directories(folder, ec); ec)
            throw Error(Errc::io,
                        fmt::format("Cannot make the folder {}: {}; name another one.", folder.string(), ec.message()));
    }
    ~MeshFolder() {
        std::error_code ec;
        if (kept_) return;
        for (const auto& file : written_) std::filesystem::remove(file, ec);
        for (const auto& folder : made_) std::filesystem::remove(folder, ec);  // only where it is empty
    }
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    void add(const TriangleMesh& mesh, const std::string& name) {
        const std::filesystem::path file = folder_ / name;
        std::error_code ec;
        const bool is_new = !std::filesystem::exists(file, ec);
        write_mesh(mesh, file);
        if (is_new) written_.push_back(file);
    }
    void keep() { kept_ = true; }

private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> made_, written_;
    bool kept_ = false;
};

std::optional<ValueRange> resolve(const std::string& flag, const std::optional<std::string>& text,
                                  const VolumeStatistics& statistics) {
    if (!text) return std::nullopt;
    const std::array<RangeEnd, 2> ends = parse_word_range(flag, *text);
    const ValueRange range{ends[0].resolve(statistics), ends[1].resolve(statistics)};
    if (range.lo > range.hi)
        refuse(flag, *text, fmt::format("a range LO,HI here: it means {:.6g},{:.6g}", range.lo, range.hi));
    return range;
}

/// Takes the regions that touch the volume's border out of table and labels; the rest keep their order.
void keep_inner(RegionTable& table) {
    std::vector<std::uint32_t> new_id(table.rows.size() + 1, 0);
    std::vector<RegionCharacteristics> rows;
    std::int64_t voxels = 0;
    for (RegionCharacteristics& row : table.rows) {
        if (row.touches_border) continue;
        new_id[row.id] = std::uint32_t(rows.size() + 1);
        row.id = new_id[row.id];
        voxels += row.voxels;
        rows.push_back(std::move(row));
    }
    for (RegionCharacteristics& row : rows) row.fraction = double(row.voxels) / double(voxels);
    for (std::uint32_t& label : *table.labels.labels) label = new_id[label];
    table.rows = std::move(rows);
}

std::string table_text(const RegionTable& table) {
    constexpr std::size_t k_shown = 20;
    std::string text =
        fmt::format("{:>6} {:>10} {:>12} {:>8} {:>11} {:>10} {:>12} {:>6} {:>7} {:>11} {:>10} {:>11}  {}\n", "id",
                    "voxels", "volume mm3", "share %", "surface mm2", "sphericity", "shape factor", "holes", "tunnels",
                    "mean", "stddev", "diameter mm", "border");
    for (std::size_t i = 0; i < std::min(k_shown, table.rows.size()); ++i) {
        const RegionCharacteristics& r = table.rows[i];
        text += fmt::format(
            "{:>6} {:>10} {:>12.5g} {:>8.3g} {:>11.5g} {:>10.4f} {:>12.5g} {:>6} {:>7} {:>11.5g} {:>10.4g} {:>11.4g}  "
            "{}\n",
            r.id, r.voxels, r.volume_mm3, 100 * r.fraction, r.surface_mm2, r.sphericity, r.shape_factor, r.holes,
            r.tunnels, r.mean, r.stddev, r.equivalent_diameter_mm, r.touches_border ? "yes" : "no");
    }
    if (table.rows.size() > k_shown) text += fmt::format("... and {} smaller\n", table.rows.size() - k_shown);
    text += fmt::format("{} regions; {}; surface: {}\n", table.rows.size(), table.adjacency, table.surface_method);
    return text;
}

/// One region's closed surface, moved outwards all over by a small length, so that it encloses what its flat triangles
/// and cut corners leave out: the region's voxels, or on the threshold itself the volume a curved surface has there.
TriangleMesh mesh_of(const Volume& volume, const RegionTable& table, const RegionCharacteristics& row, bool exact,
                     const JobContext& job) {
    const GridGeometry& g = volume.geometry();
    TriangleMesh mesh = exact ? region_mesh(volume, *table.made_with.threshold, table.labels, row, job)
                              : region_mesh(table.labels, row, job);
    const double encloses =
        exact ? enclosed_volume_mm3(mesh) + std::max(0.0, linear_deficit_mm3(mesh, g)) : row.volume_mm3;
    offset_to_volume(mesh, encloses, 0.5 * g.smallest_spacing_mm());
    return mesh;
}

void write_meshes(const Volume& volume, const RegionTable& table, const RegionsWords& words, const JobContext& job) {
    MeshFolder folder(words.mesh_folder);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const JobContext quiet{job.stop, nullptr};
        folder.add(mesh_of(volume, table, table.rows[i], words.exact_surfaces, quiet),
                   fmt::format("region-{:05}.{}", table.rows[i].id, words.mesh_format.value_or("stl")));
        job.checkpoint(i + 1, table.rows.size());
    }
    folder.keep();
}

int run_regions(RegionsWords& words, Console& console) {
    words.input.check();
    RegionOptions options = parse_options(words);
    check_targets(words);
    const Volume volume = words.input.load(console);
    words.input.require_memory(
        volume.bytes() + (words.wants_surfaces() ? 8 : 6) * std::uint64_t(volume.geometry().voxel_count()),
        "The volume with its region labels");
    if (words.threshold || words.background) {
        const VolumeStatistics statistics = compute_statistics(volume, console.job("Measuring"));
        options.threshold = resolve("--threshold", words.threshold, statistics);
        options.background = resolve("--background", words.background, statistics);
    }
    RegionTable table = find_regions(volume, options, console.job("Finding regions"));
    if (words.inner) keep_inner(table);
    if (words.wants_surfaces()) measure_surfaces(volume, table, console.job("Measuring surfaces"));
    if (!words.labels.empty()) write_labels(table.labels, words.labels, console.job("Writing labels"));
    if (!words.mesh_folder.empty()) write_meshes(volume, table, words, console.job("Writing meshes"));
    if (!words.json.empty()) write_file(words.json, regions_to_json(table));
    if (!words.csv.empty()) write_file(words.csv, regions_to_csv(table));
    console.print(table_text(table));
    return 0;
}

}  // namespace

void add_regions_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("regions", "cut a volume into regions and measure each");
    command->footer(
        "Example: lacuna regions sample:casting --threshold min,otsu --inner --csv pores.csv\n"
        "Prints the 20 largest regions; the files hold them all.");
    auto words = std::make_shared<RegionsWords>();
    words->input.add_to(*command);
    command->add_option("--range-width", words->range_width,
                        "grow homogeneous regions: values span at most this share (0..1) of the volume's range");
    command->add_option("--threshold", words->threshold,
                        "components of the values LO,HI; each end a number, min, otsu or max");
    command->add_option("--background", words->background, "values LO,HI never grown (with --range-width)");
    command->add_option("--connectivity", words->connectivity, "neighbours of a voxel: 6, 18 or 26 (default 6)");
    command->add_option("--min-voxels", words->min_voxels,
                        "leave out smaller regions (default 8 with --range-width, else 1)");
    command->add_option("--gradient-limit", words->gradient_limit,
                        "voxels with a larger gradient (unit per mm) belong to no region");
    command->add_flag("--merge-slivers", words->merge_slivers,
                      "pieces left over that are smaller than --min-voxels join the region they touch most");
    command->add_flag("--exact-surfaces", words->exact_surfaces,
                      "with --threshold: mesh vertices lie where the values pass the threshold, not half way");
    command->add_flag("--inner", words->inner, "leave out regions that touch the volume's border (air around a part)");
    command->add_option("--labels", words->labels, "write the regions' ids as a volume, e.g. labels.nrrd");
    command->add_option("--mesh", words->mesh_folder, "write one closed surface a region into this folder");
    command->add_option("--mesh-format", words->mesh_format, "stl (default), ply, obj or vtp");
    command->add_flag("--no-surfaces", words->no_surfaces,
                      "leave out of the files what takes a walk round each region: mesh surface, sphere round it, "
                      "projected areas, sub-voxel volume, distances");
    command->add_option("--json", words->json, "write the table as JSON");
    command->add_option("--csv", words->csv, "write the table as CSV");
    command->callback(
        [&chosen, words] { chosen = [words](Console& console) { return run_regions(*words, console); }; });
}

}  // namespace lacuna::cli
