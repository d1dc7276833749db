#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/inspect/analysis_work.h"
#include "core/inspect/defect_measures.h"
#include "core/regions/part_outline.h"

namespace lacuna::inspect {

namespace {

constexpr std::int64_t k_detection_voxels = 4;      ///< fewer are never a find
constexpr std::uint32_t k_untouched = 0xFFFFFFFFu;  ///< the id of a component that is no candidate
constexpr double k_least_probability = 0.5;         ///< a find more likely noise than not is none

/// Fills the part's mask, its box and its volume at the threshold.
std::int64_t set_part(Work& w, const outline::PartRuns& runs_of_part, double* material_voxels,
                      const outline::VoidScan& scan) {
    const GridGeometry& geometry = w.volume.geometry();
    const auto [mask, first, last] = outline::mask_of(runs_of_part, geometry);
    w.analysis.part_mask = mask;
    double voids = 0;
    for (int z = 0; z < geometry.size.z; ++z)
        runs::for_runs(scan.list, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            if (!scan.is_outside(k) && w.analysis.part_mask(run.first, y, at_z)) voids += run.last - run.first + 1;
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

struct FaintVoids {
    outline::VoidScan scan;
    std::vector<std::uint32_t> id_of;
};

/// Components of the faint scan that hold no voxel of a void found already and are no larger than blur can make a pore
/// vanish (a radius of three sigma): the rest are regions of lower density, not pores.
void choose_faint(const Work& w, FaintVoids& faint, std::uint32_t& next) {
    const GridGeometry& g = w.volume.geometry();
    const double radius = 3 * w.analysis.part.edge_width_mm;
    const double most = std::max(8.0, 4.19 * radius * radius * radius / g.voxel_volume_mm3());
    std::vector<std::uint8_t> ordinary(faint.scan.components.count(), 0);
    for (int z = 0; z < g.size.z; ++z)
        runs::for_runs(faint.scan.list, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            const std::size_t c = faint.scan.components.of_run[k];
            if (ordinary[c] || double(faint.scan.components.voxels[c]) > most) return;
            for (int x = run.first; x <= run.last; ++x)
                if (w.analysis.labels(x, y, at_z) != 0) ordinary[c] = 1;
        });
    Candidates candidates{DefectType::void_, faint.scan.list, faint.scan.components, {}};
    choose(candidates, w.analysis.part_mask, least_voxels(w.options), next, [&](std::size_t c) {
        return faint.scan.kind[c] == outline::Space::closed && !ordinary[c] &&
               double(faint.scan.components.voxels[c]) <= most;
    });
    faint.id_of = std::move(candidates.id_of);
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
        s.local = w.local_voids();
    } else {
        s.threshold = w.inclusion_threshold;
        s.defect_level = w.inclusion_level;
        s.local = w.options.method == ThresholdMethod::local && !w.options.inclusion_above && !w.options.material;
    }
    return s;
}

/// Measures what the labels hold and keeps what is more than noise; ids are still provisional.
std::vector<Defect> measure_candidates(Work& w, std::uint32_t first_faint, std::uint32_t first_inclusion,
                                       const JobContext& job) {
    PartAnalysis& a = w.analysis;
    std::vector<Defect> defects;
    for (const RegionCharacteristics& row :
         measure_regions(w.volume, a.labels, w.options.connectivity, job.part(0, 0.4))) {
        const DefectType type = row.id >= first_inclusion ? DefectType::inclusion : DefectType::void_;
        Defect d = defect_of(row, type);
        if (row.id >= first_faint && type == DefectType::void_) d.flags.emplace_back("faint");
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
void number_defects(std::vector<Defect>& defects, std::uint32_t provisional, const std::vector<Candidates*>& candidates,
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
        paint(*c, labels, JobContext{job.stop, nullptr});
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

}  // namespace

void find_and_measure(Work& w, const JobContext& job) {
    const DetectionOptions& o = w.options;
    PartAnalysis& a = w.analysis;
    const double voxel = w.volume.geometry().voxel_volume_mm3();
    outline::VoidScan scan =
        outline::scan_voids(w.volume, w.part().material_threshold, w.filled, o.connectivity, job.part(0, 0.1));
    double material_voxels = 0;
    w.part().part_volume_mm3.value =
        double(set_part(w, outline::find_part(scan, o.connectivity, job.part(0.1, 0.15)), &material_voxels, scan)) *
        voxel;
    w.part().material_volume_mm3 = material_voxels * voxel;
    if (w.void_threshold != w.part().material_threshold)
        scan = outline::scan_voids(w.volume, w.void_threshold, w.filled, o.connectivity, job.part(0.15, 0.2));

    a.labels = {w.volume.geometry(),
                std::make_shared<std::vector<std::uint32_t>>(std::size_t(w.volume.geometry().voxel_count()))};
    std::uint32_t next = 1;
    Candidates voids{DefectType::void_, scan.list, scan.components, {}};
    voids.id_of.assign(scan.components.count(), k_untouched);
    if (o.voids)
        choose(voids, a.part_mask, least_voxels(o), next,
               [&](std::size_t c) { return scan.kind[c] != outline::Space::outside; });
    paint(voids, a.labels, job.part(0.2, 0.25));
    const std::uint32_t first_faint = next;
    FaintVoids faint;
    if (o.voids && w.local_voids() && w.faint_threshold() > w.void_threshold) {
        faint.scan = outline::scan_voids(w.volume, w.faint_threshold(), w.filled, o.connectivity, job.part(0.25, 0.27));
        choose_faint(w, faint, next);
    }
    Candidates faint_voids{DefectType::void_, faint.scan.list, faint.scan.components, faint.id_of};
    if (!faint.id_of.empty()) paint(faint_voids, a.labels, job.part(0.27, 0.28));
    const std::uint32_t first_inclusion = next;
    runs::RunList bright;
    runs::Components bright_components;
    if (o.inclusions && std::isfinite(w.inclusion_threshold)) {
        bright = runs::find_runs(w.volume.geometry().size, runs::mark_above(w.volume, w.inclusion_threshold),
                                 job.part(0.28, 0.31));
        bright_components = runs::join(bright, o.connectivity, job.part(0.31, 0.32));
    }
    Candidates inclusions{DefectType::inclusion, bright, bright_components, {}};
    if (bright.count() > 0) {
        choose(inclusions, a.part_mask, least_voxels(o), next, [](std::size_t) { return true; });
        paint(inclusions, a.labels, job.part(0.32, 0.35));
    }
    a.defects = measure_candidates(w, first_faint, first_inclusion, job.part(0.35, 0.95));
    std::vector<Candidates*> all{&voids};
    if (!faint.id_of.empty()) all.push_back(&faint_voids);
    if (bright.count() > 0) all.push_back(&inclusions);
    number_defects(a.defects, next, all, a.labels, job.part(0.95, 1));
    judge(w, a.defects);
    set_porosity(w);
}

}  // namespace lacuna::inspect
