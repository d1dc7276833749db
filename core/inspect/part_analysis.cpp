#include "core/inspect/part_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/names.h"
#include "core/inspect/analysis_work.h"
#include "core/inspect/defect_measures.h"
#include "core/regions/part_outline.h"

namespace lacuna {

namespace {

constexpr NameTable<ThresholdMethod, 3> k_method_names{
    {{ThresholdMethod::local, "local"}, {ThresholdMethod::otsu, "otsu"}, {ThresholdMethod::fixed, "fixed"}}};
constexpr NameTable<DefectType, 2> k_type_names{{{DefectType::void_, "void"}, {DefectType::inclusion, "inclusion"}}};

}  // namespace

namespace inspect {

namespace {

constexpr double k_binary_sigma_voxels = 0.35;  ///< an edge one voxel wide has sigma 0.29

void check_options(const Volume& volume, const DetectionOptions& o) {
    const auto refuse = [](const char* sentence) { throw Error(Errc::bad_usage, sentence); };
    if (volume.empty()) throw Error(Errc::bad_input, "There is no volume to inspect.");
    if (o.min_voxels < 1) refuse("min_voxels must be 1 or more.");
    if (o.material && !(o.material->lo < o.material->hi))
        refuse("The material's range needs its low end below its high end.");
    if (o.void_below && !std::isfinite(*o.void_below)) refuse("The void threshold must be a finite number.");
    if (o.inclusion_above && !std::isfinite(*o.inclusion_above))
        refuse("The inclusion threshold must be a finite number.");
    if (o.void_below && o.inclusion_above && !(*o.void_below < *o.inclusion_above))
        refuse("The void threshold must lie below the inclusion threshold.");
    if (o.method == ThresholdMethod::fixed && !o.void_below && !o.material && o.voids)
        refuse("A fixed threshold needs its value: give the material's range or the void threshold.");
}

/// Levels where the user names the material: the sides' own modes, whatever the histogram's valleys say.
void adopt_given(Work& w, const VolumeStatistics& s) {
    const double t = w.options.material ? w.options.material->lo : *w.options.void_below;
    double below = 0, n_below = 0, above = 0, n_above = 0;
    std::uint64_t most_below = 0, most_above = 0;
    const double top = w.options.material ? w.options.material->hi : std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < s.histogram.size(); ++b) {
        const double v = s.bin_centre(b);
        if (v < t && s.histogram[b] >= most_below) most_below = s.histogram[b];
        if (v >= t && v <= top && s.histogram[b] > most_above) most_above = s.histogram[b];
    }
    // The mean of the values above half the mode's height: steadier than the mode.
    for (std::size_t b = 0; b < s.histogram.size(); ++b) {
        const double v = s.bin_centre(b), n = double(s.histogram[b]);
        if (v < t && 2 * s.histogram[b] >= most_below) below += n * v, n_below += n;
        if (v >= t && v <= top && 2 * s.histogram[b] >= most_above) above += n * v, n_above += n;
    }
    w.levels.has_material = n_above > 0;
    w.levels.why_not = n_above > 0 ? "" : "No value lies in the material's range.";
    w.levels.material = n_above > 0 ? above / n_above : t;
    w.levels.air = n_below > 0 ? below / n_below : t - std::max(w.levels.material - t, 1e-6);
    w.levels.threshold = t;
    w.levels.noise = measure_noise(w.volume, t);
}

void set_thresholds(Work& w, const JobContext& job) {
    const DetectionOptions& o = w.options;
    double t = w.levels.threshold;
    w.filled = outline::fills_frame(w.volume, t);
    w.sweep =
        sweep_thresholds(w.volume, w.levels, w.filled, o.connectivity, std::max<std::int64_t>(o.min_voxels, 1), job);
    const ValueRange plateau = w.sweep.curve.plateau;
    if (!w.void_is_given()) {
        // Local surfaces lie half way; detection starts from there, Otsu's from its threshold. Where that is not on the
        // plateau it moves onto it: a little more or less must not change what is found.
        if (o.method == ThresholdMethod::local) t = (w.levels.air + w.levels.material) / 2;
        if (plateau.lo <= plateau.hi) t = std::clamp(t, plateau.lo, plateau.hi);
        w.filled = outline::fills_frame(w.volume, t);
    }
    if (plateau.lo > plateau.hi)
        w.warn(
            "The number of voids or the porosity changes with every threshold: the curve has no plateau, and no "
            "threshold is better founded than its neighbours.");
    w.part().material_threshold = o.material ? o.material->lo : t;
    w.void_threshold = o.void_below ? *o.void_below : t;
    if (!o.material && o.void_below) w.part().material_threshold = *o.void_below;
    w.analysis.stability = w.sweep.curve;
}

/// Inclusions found on their own: half way from the material to the level of what is clearly brighter.
void set_inclusion_threshold(Work& w, const VolumeStatistics& s) {
    const double material = w.levels.material;
    const double clear = material + std::max(6 * w.levels.noise, 0.2 * w.levels.contrast());
    std::vector<std::pair<double, double>> above;
    double total = 0;
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (s.bin_centre(b) > clear && s.histogram[b] > 0)
            above.emplace_back(s.bin_centre(b), double(s.histogram[b])), total += double(s.histogram[b]);
    // The upper quarter of them: the rest are their blurred edges.
    double seen = 0, level = clear;
    for (const auto& [v, n] : above)
        if ((seen += n) >= 0.75 * total) {
            level = v;
            break;
        }
    w.inclusion_level = level;
    if (w.options.inclusion_above)
        w.inclusion_threshold = *w.options.inclusion_above;
    else if (w.options.material)
        w.inclusion_threshold = w.options.material->hi;
    else
        w.inclusion_threshold = above.empty() ? std::numeric_limits<double>::infinity() : (material + level) / 2;
    w.inclusion_level = std::max(level, 2 * w.inclusion_threshold - material);
}

void set_sharpness(Work& w, const JobContext& job) {
    const double sigma = measure_edge_width(w.volume, w.levels, job), h = w.volume.geometry().smallest_spacing_mm();
    w.binary = sigma < k_binary_sigma_voxels * h;
    w.part().edge_width_mm = sigma;
    if (!std::isnan(sigma)) return;
    w.part().edge_width_mm = 0.7 * h;
    w.warn("No clear edge was found to measure the blur by; 0.7 voxels are taken.");
}

void no_material(Work& w) {
    w.warn(w.levels.why_not + " Nothing can be inspected.");
    const GridGeometry& g = w.volume.geometry();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    w.analysis.labels = {g, std::make_shared<std::vector<std::uint32_t>>(std::size_t(g.voxel_count()), 0u)};
    w.analysis.part_mask = {g,
                            std::make_shared<std::vector<std::uint8_t>>(std::size_t(g.voxel_count()), std::uint8_t(0))};
    w.part().porosity_percent = w.part().part_volume_mm3 = {nan, nan, nan};
    w.part().edge_width_mm = nan;
    w.analysis.stability.plateau = {0, -1};
}

}  // namespace

}  // namespace inspect

std::string_view name_of(ThresholdMethod method) { return name_in(k_method_names, method); }

ThresholdMethod parse_threshold_method(std::string_view text) {
    return parse_name(k_method_names, text, "threshold method");
}

std::string_view name_of(DefectType type) { return name_in(k_type_names, type); }

TriangleMesh defect_mesh(const Volume& volume, const PartAnalysis& analysis, std::uint32_t id, const JobContext& job) {
    if (id == 0 || id > analysis.defects.size() || volume.geometry().size != analysis.labels.geometry.size)
        throw Error(Errc::bad_usage, "There is no defect of that number in this analysis of the volume.");
    const Defect& d = analysis.defects[id - 1];
    inspect::Surroundings s;
    s.type = d.type;
    s.defect_level = analysis.part.void_level;
    s.material_level = analysis.part.material_level;
    s.sigma_mm = analysis.part.edge_width_mm;
    s.binary = s.sigma_mm < inspect::k_binary_sigma_voxels * volume.geometry().smallest_spacing_mm();
    TriangleMesh mesh = inspect::surface_at(volume, analysis.labels, analysis.part_mask, s, id, d.bbox_first,
                                            d.bbox_last, d.threshold, job);
    if (std::isfinite(d.volume_mm3.value))
        offset_to_volume(mesh, d.volume_mm3.value, 0.5 * volume.geometry().smallest_spacing_mm());
    return mesh;
}

PartAnalysis analyse_part(const Volume& volume, const DetectionOptions& options, const JobContext& job) {
    inspect::check_options(volume, options);
    inspect::Work w{volume, options};
    w.analysis.options = options;
    w.analysis.surface_method =
        "marching cubes on the values (surface_mesh) and Crofton's formula, 13 directions, weighted for the voxel "
        "spacing";
    w.analysis.adjacency = "defects " + std::to_string(int(options.connectivity)) + "-connected, cavities " +
                           (options.connectivity == Connectivity::c6 ? "26" : "6") + "-connected";
    const VolumeStatistics statistics = compute_statistics(volume, job.part(0, 0.05));
    w.levels = inspect::find_levels(volume, statistics);
    if (statistics.range.width() > 0 && (options.material || options.void_below)) inspect::adopt_given(w, statistics);
    PartFacts& part = w.part();
    part.has_material = w.levels.has_material;
    part.void_level = w.levels.air;
    part.material_level = w.levels.material;
    part.material_threshold = w.levels.threshold;
    part.noise = w.levels.noise;
    if (statistics.nan_count > 0)
        w.warn(std::to_string(statistics.nan_count) + " voxels hold no finite value; they count as empty.");
    if (!w.levels.has_material) {
        inspect::no_material(w);
        return std::move(w.analysis);
    }
    inspect::set_sharpness(w, job.part(0.05, 0.1));
    inspect::set_thresholds(w, job.part(0.1, 0.4));
    if (options.inclusions) inspect::set_inclusion_threshold(w, statistics);
    inspect::find_and_measure(w, job.part(0.4, 1));
    if (part.cut_by_frame)
        w.warn("The part reaches the volume's border: the border counts as its surface, and what it cuts is flagged.");
    if (!(part.part_volume_mm3.value > 0)) w.warn("No material lies inside the outline of a part.");
    job.checkpoint(1, 1);
    return std::move(w.analysis);
}

}  // namespace lacuna
