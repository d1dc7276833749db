#include "core/inspect/part_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/inspect/defect_measures.h"
#include "core/inspect/grey_levels.h"
#include "core/inspect/stability.h"
#include "core/inspect/void_scan.h"

namespace lacuna {

namespace inspect {

namespace {

constexpr std::int64_t k_detection_voxels = 4;      ///< fewer are never a find
constexpr std::uint32_t k_untouched = 0xFFFFFFFFu;  ///< the id of a component that is no candidate
constexpr double k_least_probability = 0.5;         ///< a find more likely noise than not is none
constexpr double k_binary_sigma_voxels = 0.35;      ///< an edge one voxel wide has sigma 0.29

struct Work {
    const Volume& volume;
    const DetectionOptions& options;
    PartAnalysis analysis{};
    GreyLevels levels{};
    double void_threshold = 0, inclusion_threshold = 0, inclusion_level = 0;
    bool filled = false, binary = false;
    StabilitySweep sweep{};

    PartFacts& part() { return analysis.part; }
    void warn(std::string sentence) { analysis.part.warnings.push_back(std::move(sentence)); }
    bool void_is_given() const { return options.void_below || options.material; }
};

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
    w.filled = fills_frame(w.volume, t);
    w.sweep =
        sweep_thresholds(w.volume, w.levels, w.filled, o.connectivity, std::max<std::int64_t>(o.min_voxels, 1), job);
    const ValueRange plateau = w.sweep.curve.plateau;
    if (!w.void_is_given()) {
        // Local surfaces lie half way; detection starts from there. Otsu's threshold moves onto the plateau.
        if (o.method == ThresholdMethod::local) t = (w.levels.air + w.levels.material) / 2;
        if (o.method == ThresholdMethod::otsu && plateau.lo <= plateau.hi) t = std::clamp(t, plateau.lo, plateau.hi);
        w.filled = fills_frame(w.volume, t);
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

/// Fills the part's mask, its box and its volume at the threshold.
std::int64_t set_part(Work& w, const PartRuns& runs_of_part, double* material_voxels, const VoidScan& scan) {
    const GridGeometry& geometry = w.volume.geometry();
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(std::size_t(geometry.voxel_count()), std::uint8_t(0));
    glm::ivec3 first(std::numeric_limits<int>::max()), last(-1);
    for (int z = 0; z < geometry.size.z; ++z)
        runs::for_runs(runs_of_part.list, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            if (!runs_of_part.kept(k)) return;
            std::uint8_t* row = bytes->data() + geometry.linear_index(0, y, at_z);
            std::fill(row + run.first, row + run.last + 1, std::uint8_t(1));
            first = glm::min(first, glm::ivec3(run.first, y, at_z));
            last = glm::max(last, glm::ivec3(run.last, y, at_z));
        });
    w.analysis.part_mask = {geometry, bytes};
    double voids = 0;
    for (int z = 0; z < geometry.size.z; ++z)
        runs::for_runs(scan.list, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            if (!scan.is_outside(k) && (*bytes)[std::size_t(geometry.linear_index(run.first, y, at_z))])
                voids += run.last - run.first + 1;
        });
    *material_voxels = double(runs_of_part.voxels) - voids;
    PartFacts& part = w.part();
    if (runs_of_part.voxels == 0) return 0;
    part.bbox_min_mm = glm::dvec3(std::numeric_limits<double>::infinity());
    part.bbox_max_mm = -part.bbox_min_mm;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::dvec3 mm = geometry.voxel_to_mm(glm::mix(glm::dvec3(first) - 0.5, glm::dvec3(last) + 0.5, side));
        part.bbox_min_mm = glm::min(part.bbox_min_mm, mm);
        part.bbox_max_mm = glm::max(part.bbox_max_mm, mm);
    }
    for (int a = 0; a < 3; ++a)
        part.cut_by_frame =
            part.cut_by_frame || (geometry.size[a] > 1 && (first[a] == 0 || last[a] == geometry.size[a] - 1));
    return runs_of_part.voxels;
}

/// Components that may be defects and the ids they have in the labels.
struct Candidates {
    DefectType type;
    const runs::RunList& list;
    const runs::Components& components;
    std::vector<std::uint32_t> id_of;  ///< per component; 0: none
};

void paint(const Candidates& candidates, LabelVolume& labels, const JobContext& job) {
    parallel_for(
        0, candidates.list.size.z,
        [&](std::int64_t z) {
            runs::for_runs(candidates.list, int(z), [&](int y, int at_z, const runs::Run& run, std::size_t k) {
                const std::size_t c = candidates.components.of_run[k];
                if (candidates.id_of[c] == k_untouched) return;
                std::uint32_t* row = labels.labels->data() + labels.geometry.linear_index(0, y, at_z);
                std::fill(row + run.first, row + run.last + 1, candidates.id_of[c]);
            });
        },
        job);
}

std::int64_t least_voxels(const DetectionOptions& o) {
    return o.min_voxels > k_measurable_voxels ? o.min_voxels : std::min(o.min_voxels, k_detection_voxels);
}

/// Gives provisional ids to the components that are large enough and lie in the part, from `next` on.
template <class Eligible>
void choose(Candidates& candidates, const MaskVolume& part, std::int64_t least, std::uint32_t& next,
            Eligible eligible) {
    constexpr std::uint32_t k_most_defects = 1u << 22;
    candidates.id_of.assign(candidates.components.count(), k_untouched);
    for (int z = 0; z < candidates.list.size.z; ++z)
        runs::for_runs(candidates.list, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            const std::size_t c = candidates.components.of_run[k];
            if (candidates.id_of[c] != k_untouched || candidates.components.voxels[c] < std::uint64_t(least) ||
                !eligible(c) || !part(run.first, y, at_z))
                return;
            if (next > k_most_defects)
                throw Error(Errc::bad_usage,
                            "The part falls into more than 4194304 defects; raise min_voxels or smooth the volume.");
            candidates.id_of[c] = next++;
        });
}

Defect defect_of(const RegionCharacteristics& row, DefectType type) {
    Defect d;
    d.id = row.id;
    d.type = type;
    d.voxels = row.voxels;
    d.centroid_mm = row.centroid_mm;
    d.bbox_min_mm = row.bbox_min_mm, d.bbox_max_mm = row.bbox_max_mm;
    d.bbox_first = row.bbox_first, d.bbox_last = row.bbox_last;
    d.principal_lengths_mm = row.principal_lengths_mm;
    d.surface_crofton_mm2 = row.surface_mm2;
    d.mean = row.mean;
    d.euler = row.euler, d.cavities = row.holes, d.tunnels = row.tunnels;
    d.touches_border = row.touches_border;
    for (const std::string& flag : row.flags)
        if (flag == "topology_unsure") d.flags.push_back(flag);
    return d;
}

Surroundings surroundings_of(const Work& w, DefectType type) {
    Surroundings s;
    s.type = type;
    s.noise = w.levels.noise;
    s.sigma_mm = w.analysis.part.edge_width_mm;
    s.material_level = w.levels.material;
    s.binary = w.binary;
    if (type == DefectType::void_) {
        s.threshold = w.void_threshold;
        s.defect_level = w.levels.air;
        s.local = w.options.method == ThresholdMethod::local && !w.void_is_given();
    } else {
        s.threshold = w.inclusion_threshold;
        s.defect_level = w.inclusion_level;
        s.local = w.options.method == ThresholdMethod::local && !w.options.inclusion_above && !w.options.material;
    }
    return s;
}

/// Measures what the labels hold and keeps what is more than noise; ids are still provisional.
std::vector<Defect> measure_candidates(Work& w, std::uint32_t first_inclusion, const JobContext& job) {
    PartAnalysis& a = w.analysis;
    std::vector<Defect> defects;
    for (const RegionCharacteristics& row :
         measure_regions(w.volume, a.labels, w.options.connectivity, job.part(0, 0.4))) {
        const DefectType type = row.id >= first_inclusion ? DefectType::inclusion : DefectType::void_;
        Defect d = defect_of(row, type);
        const double depth = std::abs(w.levels.material - row.mean);
        const double chance =
            std::isfinite(depth)
                ? expected_by_chance(row.voxels, depth, w.levels.noise,
                                     a.part.material_volume_mm3 / w.volume.geometry().voxel_volume_mm3())
                : 0;
        d.probability = 1 / (1 + chance);
        if (d.probability >= k_least_probability) defects.push_back(std::move(d));
    }
    std::vector<std::vector<PointTree::Point>> points(defects.size());
    // The large ones first, so that no thread is left alone with one at the end.
    std::vector<std::size_t> order(defects.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t x, std::size_t y) { return defects[x].voxels > defects[y].voxels; });
    parallel_for(
        0, std::int64_t(defects.size()),
        [&](std::int64_t i) {
            Defect& d = defects[order[std::size_t(i)]];
            measure_by_values(w.volume, a.labels, a.part_mask, surroundings_of(w, d.type), d,
                              points[order[std::size_t(i)]], JobContext{job.stop, nullptr});
            d.projected_area_mm2 = projected_areas_mm2(a.labels, d.id, d.bbox_first, d.bbox_last);
        },
        job.part(0.4, 0.8));
    set_distances(w.volume, a.part_mask, a.part.material_threshold, surroundings_of(w, DefectType::void_), defects,
                  points, job.part(0.8, 1));
    return defects;
}

void judge(Work& w, std::vector<Defect>& defects) {
    const double part = w.analysis.part.part_volume_mm3.value;
    for (Defect& d : defects) {
        d.measurable = d.voxels >= k_measurable_voxels && d.volume_mm3.value > 0;
        if (d.touches_border) d.flags.emplace_back("cut_by_frame");
        if (!d.measurable) d.flags.emplace_back("not_measurable");
        if (d.volume_mm3.value > part) d.flags.emplace_back("larger_than_part");
    }
}

/// Ids 1..n by descending volume, in the rows and in the labels; what was dropped is taken out.
void number_defects(std::vector<Defect>& defects, std::uint32_t provisional, std::vector<Candidates*> candidates,
                    LabelVolume& labels, const JobContext& job) {
    std::stable_sort(defects.begin(), defects.end(),
                     [](const Defect& x, const Defect& y) { return x.volume_mm3.value > y.volume_mm3.value; });
    std::vector<std::uint32_t> final_id(provisional, 0);
    for (std::size_t i = 0; i < defects.size(); ++i) {
        final_id[defects[i].id] = std::uint32_t(i) + 1;
        defects[i].id = std::uint32_t(i) + 1;
    }
    for (Candidates* c : candidates) {
        for (std::uint32_t& id : c->id_of)
            if (id != k_untouched) id = final_id[id];
        paint(*c, labels, job);
    }
}

/// Volume of the part and porosity with their intervals, from the sweep at thresholds +-10 % of the contrast away.
void set_porosity(Work& w) {
    PartFacts& part = w.part();
    const double voxel = w.volume.geometry().voxel_volume_mm3(), shift = 0.1 * w.levels.contrast();
    const double t = part.material_threshold;
    const double less = w.sweep.part_voxels_at(t + shift) * voxel, more = w.sweep.part_voxels_at(t - shift) * voxel;
    const double value = part.part_volume_mm3.value;
    part.part_volume_mm3 = {value, std::min(value, less), std::max(value, more)};
    Measured voids;
    for (const Defect& d : w.analysis.defects) {
        if (d.type != DefectType::void_) continue;
        voids.value += d.volume_mm3.value;
        voids.hi += d.volume_mm3.hi;
        if (d.measurable) voids.lo += d.volume_mm3.lo;
    }
    if (!(value > 0)) return;
    part.porosity_percent = {100 * voids.value / value,
                             std::min(100 * voids.lo / part.part_volume_mm3.hi, 100 * voids.value / value),
                             std::min(100.0, 100 * voids.hi / std::max(part.part_volume_mm3.lo, 1e-300))};
    part.porosity_percent.value = std::min(100.0, part.porosity_percent.value);
    part.porosity_percent.hi = std::max(part.porosity_percent.hi, part.porosity_percent.value);
}

void find_and_measure(Work& w, const JobContext& job) {
    const DetectionOptions& o = w.options;
    PartAnalysis& a = w.analysis;
    const double voxel = w.volume.geometry().voxel_volume_mm3();
    VoidScan scan = scan_voids(w.volume, w.part().material_threshold, w.filled, o.connectivity, job.part(0, 0.1));
    double material_voxels = 0;
    w.part().part_volume_mm3.value =
        double(set_part(w, find_part(scan, o.connectivity, job.part(0.1, 0.15)), &material_voxels, scan)) * voxel;
    w.part().material_volume_mm3 = material_voxels * voxel;
    if (w.void_threshold != w.part().material_threshold)
        scan = scan_voids(w.volume, w.void_threshold, w.filled, o.connectivity, job.part(0.15, 0.2));

    a.labels = {w.volume.geometry(),
                std::make_shared<std::vector<std::uint32_t>>(std::size_t(w.volume.geometry().voxel_count()))};
    std::uint32_t next = 1;
    Candidates voids{DefectType::void_, scan.list, scan.components, {}};
    voids.id_of.assign(scan.components.count(), k_untouched);
    if (o.voids)
        choose(voids, a.part_mask, least_voxels(o), next,
               [&](std::size_t c) { return scan.kind[c] != Space::outside; });
    paint(voids, a.labels, job.part(0.2, 0.25));
    const std::uint32_t first_inclusion = next;
    runs::RunList bright;
    runs::Components bright_components;
    if (o.inclusions && std::isfinite(w.inclusion_threshold)) {
        bright = runs::find_runs(w.volume.geometry().size, runs::mark_above(w.volume, w.inclusion_threshold),
                                 job.part(0.25, 0.3));
        bright_components = runs::join(bright, o.connectivity, job.part(0.3, 0.32));
    }
    Candidates inclusions{DefectType::inclusion, bright, bright_components, {}};
    if (bright.count() > 0) {
        choose(inclusions, a.part_mask, least_voxels(o), next, [](std::size_t) { return true; });
        paint(inclusions, a.labels, job.part(0.32, 0.35));
    }
    a.defects = measure_candidates(w, first_inclusion, job.part(0.35, 0.95));
    number_defects(
        a.defects, next,
        bright.count() > 0 ? std::vector<Candidates*>{&voids, &inclusions} : std::vector<Candidates*>{&voids}, a.labels,
        job.part(0.95, 1));
    judge(w, a.defects);
    set_porosity(w);
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

std::string_view name_of(ThresholdMethod method) {
    switch (method) {
        case ThresholdMethod::otsu:
            return "otsu";
        case ThresholdMethod::fixed:
            return "fixed";
        case ThresholdMethod::local:
            break;
    }
    return "local";
}

std::string_view name_of(DefectType type) { return type == DefectType::void_ ? "void" : "inclusion"; }

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
    return inspect::surface_at(volume, analysis.labels, analysis.part_mask, s, id, d.bbox_first, d.bbox_last,
                               d.threshold, job);
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
