#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/order_statistics.h"
#include "core/base/parallel.h"
#include "core/regions/bounding_sphere.h"
#include "core/regions/part_outline.h"
#include "core/regions/region_march.h"
#include "core/regions/region_shell.h"
#include "core/regions/regions.h"
#include "core/regions/separation.h"
#include "core/regions/value_window.h"
#include "core/volume/statistics.h"

namespace lacuna {

namespace {

using Points = std::vector<PointTree::Point>;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr int k_layers = 3;  ///< boundary layer: the edge of a blur of sigma up to one voxel
constexpr std::size_t k_few = 20;

double histogram_median(const VolumeStatistics& s, double lo, double hi) {
    double total = 0, seen = 0;
    const auto inside = [&](std::size_t b) { return s.bin_centre(b) >= lo && s.bin_centre(b) <= hi; };
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (inside(b)) total += double(s.histogram[b]);
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (inside(b) && (seen += double(s.histogram[b])) >= total / 2 && total > 0) return s.bin_centre(b);
    return k_nan;
}

/// What all regions of a table are measured against.
struct Setting {
    const Volume& volume;
    const RegionTable& table;
    const JobContext& job;
    bool has_part = false;
    double part_from = 0;  ///< material has values from here up
    double part_voxels = 0;
    MaskVolume part{};
    Points surface{};  ///< of the part
    double inside = k_nan,
           outside = k_nan;  ///< usual levels, where a region has no core of its own, or no surroundings
    std::size_t stride = 1;  ///< every n-th vertex stands for the surface in distances

    bool exact() const { return table.made_with.threshold.has_value(); }
};

/// Where material begins: at the end of the threshold that cuts the values in two, at Otsu's threshold else.
double part_threshold(const RegionOptions& options, const VolumeStatistics& s) {
    if (options.threshold) {
        const ValueRange r = *options.threshold;
        const bool from_bottom = r.lo <= s.range.lo, to_top = r.hi >= s.range.hi;
        if (from_bottom && !to_top) return std::nextafter(r.hi, std::numeric_limits<double>::infinity());
        if (to_top && !from_bottom) return r.lo;
    }
    return otsu_threshold(s);
}

void set_usual_levels(Setting& set, const VolumeStatistics& s) {
    if (!set.exact()) return;
    const ValueRange r = *set.table.made_with.threshold;
    constexpr double k_far = std::numeric_limits<double>::infinity();
    set.inside = histogram_median(s, r.lo, r.hi);
    if (r.lo <= s.range.lo)
        set.outside = histogram_median(s, r.hi, k_far);
    else if (r.hi >= s.range.hi)
        set.outside = histogram_median(s, -k_far, r.lo);
}

void set_part(Setting& set, const VolumeStatistics& s) {
    if (!(s.range.width() > 0)) return;
    const Connectivity voids = set.table.made_with.connectivity;
    set.part_from = part_threshold(set.table.made_with, s);
    const bool filled = outline::fills_frame(set.volume, set.part_from);
    const outline::VoidScan scan =
        outline::scan_voids(set.volume, set.part_from, filled, voids, set.job.part(0.05, 0.08));
    const outline::PartRuns runs_of_part = outline::find_part(scan, voids, set.job.part(0.08, 0.1));
    if (runs_of_part.voxels == 0) return;
    set.has_part = true;
    set.part_voxels = double(runs_of_part.voxels);
    set.part = outline::mask_of(runs_of_part, set.volume.geometry()).mask;
    set.surface = outline::outer_surface(set.volume, set.part, set.part_from, set.job.part(0.1, 0.15));
}

/// Distances look at no more points of the regions' surfaces than a sixteenth of the voxels.
void set_stride(Setting& set) {
    const GridGeometry& g = set.volume.geometry();
    double area = 0;
    for (const RegionCharacteristics& row : set.table.rows) area += row.surface_mm2;
    const double expected = 1.5 * area / std::cbrt(g.voxel_volume_mm3() * g.voxel_volume_mm3());
    const double most = std::max(double(g.voxel_count()) / 16, 1e6);
    set.stride = std::size_t(std::max(1.0, std::ceil(expected / most)));
}

/// Of many values the median of some 200 000 of them, evenly taken.
class Sampled {
public:
    void add(float value) {
        if (seen_++ % stride_ != 0) return;
        values_.push_back(value);
        if (values_.size() < k_most) return;
        for (std::size_t i = 0; 2 * i < values_.size(); ++i) values_[i] = values_[2 * i];
        values_.resize(k_most / 2);
        stride_ *= 2;
    }
    std::size_t count() const { return seen_; }
    double middle() const { return median(values_); }
    /// Standard deviation by the ways from the median to the tenth parts at both ends: a second level that takes up
    /// more than a tenth shows.
    double spread() {
        const std::size_t tenth = values_.size() / 10;
        const double centre = middle();
        std::nth_element(values_.begin(), values_.begin() + std::ptrdiff_t(tenth), values_.end());
        const double low = values_[tenth];
        std::nth_element(values_.begin(), values_.end() - 1 - std::ptrdiff_t(tenth), values_.end());
        const double high = values_[values_.size() - 1 - tenth];
        return std::max(centre - low, high - centre) / 1.2816;
    }

private:
    static constexpr std::size_t k_most = std::size_t(1) << 18;
    std::size_t seen_ = 0, stride_ = 1;
    std::vector<float> values_;
};

/// Of a surface's vertices those that can lie on its convex hull: the outermost ones on each line of the grid. The hubs
/// within a cube are means of others and never do.
class HullCandidates {
public:
    HullCandidates(const glm::ivec3& first, const glm::ivec3& extent, const GridGeometry& geometry)
        : first_(first), extent_(extent), geometry_(geometry) {
        for (int axis = 0; axis < 3; ++axis)
            ends_[axis].resize(std::size_t(extent[(axis + 1) % 3]) * std::size_t(extent[(axis + 2) % 3]));
    }

    void add(const glm::dvec3& mm) {
        const glm::dvec3 voxel = geometry_.mm_to_voxel(mm) - glm::dvec3(first_), whole = glm::round(voxel);
        const glm::bvec3 off = glm::greaterThan(glm::abs(voxel - whole), glm::dvec3(1e-5));
        if (int(off.x) + int(off.y) + int(off.z) != 1) return;
        const int axis = off.x ? 0 : (off.y ? 1 : 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
        Ends& ends = ends_[axis][std::size_t(whole[v]) * std::size_t(extent_[u]) + std::size_t(whole[u])];
        if (voxel[axis] < ends.lo) ends.lo = voxel[axis], ends.at_lo = mm;
        if (voxel[axis] > ends.hi) ends.hi = voxel[axis], ends.at_hi = mm;
    }

    std::vector<glm::dvec3> points() const {
        std::vector<glm::dvec3> all;
        for (const auto& line : ends_)
            for (const Ends& e : line) {
                if (e.lo > e.hi) continue;
                all.push_back(e.at_lo);
                if (e.lo < e.hi) all.push_back(e.at_hi);
            }
        return all;
    }

private:
    struct Ends {
        double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
        glm::dvec3 at_lo{0}, at_hi{0};
    };
    glm::ivec3 first_, extent_;
    const GridGeometry& geometry_;
    std::vector<Ends> ends_[3];
};

/// Surface, sphere round it, and the points that stand for it in distances.
void measure_surface(const Setting& set, RegionCharacteristics& row, Points& points) {
    const GridGeometry& g = set.volume.geometry();
    SurfaceLevel level;
    if (set.exact()) level = {float(set.table.made_with.threshold->lo), float(set.table.made_with.threshold->hi)};
    SurfaceMesher mesher = mesher_for(set.table.labels, row, level);
    HullCandidates hull(row.bbox_first - 1, row.bbox_last - row.bbox_first + 3, g);
    double area = 0;
    std::size_t met = 0;
    march_region(
        set.table.labels, row, set.exact() ? &set.volume : nullptr, mesher,
        [&] {
            const TriangleMesh done = mesher.take();
            area += area_mm2(done);
            for (const glm::dvec3& v : done.vertices) {
                hull.add(v);
                if (met++ % set.stride == 0) points.push_back({glm::vec3(v - g.origin), row.id});
            }
        },
        JobContext{set.job.stop, nullptr});
    row.surface_mesh_mm2 = area;
    row.diameter_mm = 2 * smallest_enclosing_sphere(hull.points()).radius;
    if (row.diameter_mm >= row.equivalent_diameter_mm) return;
    row.diameter_mm = row.equivalent_diameter_mm;  // nothing fits into a sphere smaller than the ball of its volume
    row.flags.emplace_back("diameter_clamped");
}

/// Where a region lies: all of it in the part, and void rather than material?
struct Place {
    bool in_part = true, is_void = false;
};

Place place_of(const Setting& set, const RegionCharacteristics& row) {
    Place place;
    for (int z = row.bbox_first.z; z <= row.bbox_last.z && place.in_part; ++z)
        for (int y = row.bbox_first.y; y <= row.bbox_last.y && place.in_part; ++y) {
            const std::int64_t start = set.table.labels.geometry.linear_index(0, y, z);
            const std::uint32_t* labels = set.table.labels.labels->data() + start;
            const std::uint8_t* part = set.part.labels->data() + start;
            for (int x = row.bbox_first.x; x <= row.bbox_last.x; ++x)
                if (labels[x] == row.id && !part[x]) place.in_part = false;
        }
    place.is_void = place.in_part && row.mean < set.part_from;
    return place;
}

/// Voxels a region would have were its threshold a tenth of the contrast tighter, and that much wider.
class ShiftedCounts {
public:
    explicit ShiftedCounts(const Setting& set) {
        if (!set.exact()) return;
        const ValueRange r = *set.table.made_with.threshold, all = set.table.value_range;
        const double shift = 0.1 * std::abs(set.outside - set.inside);  // NaN between two thresholds: no interval
        const double at_lo = r.lo > all.lo ? shift : 0, at_hi = r.hi < all.hi ? shift : 0;
        tight_ = {r.lo + at_lo, r.hi - at_hi};
        wide_ = {r.lo - at_lo, r.hi + at_hi};
        known_ = std::isfinite(shift);
    }
    void add_whole() { ++fewest_, ++most_; }
    void add_own(float value) { fewest_ += holds(tight_, value), ++most_; }
    void add_beside(float value) { most_ += holds(wide_, value); }

    /// @param integral_mm3  NaN where there is none
    void set_interval(RegionCharacteristics& row, double integral_mm3, const GridGeometry& geometry) const {
        if (!known_) return;
        const double voxel = geometry.voxel_volume_mm3();
        double lo = std::min(row.volume_mm3, fewest_ * voxel), hi = std::max(row.volume_mm3, most_ * voxel);
        if (integral_mm3 < lo) lo = integral_mm3;
        if (integral_mm3 > hi) hi = integral_mm3;
        const double by_grid = 0.15 * std::cbrt(voxel) * row.surface_mm2;  // as for values of two levels: voxels count
        row.volume_lo_mm3 = std::max(0.0, lo - by_grid);
        row.volume_hi_mm3 = hi + by_grid;
    }

private:
    static bool holds(const ValueRange& range, float value) {
        return double(value) >= range.lo && double(value) <= range.hi;
    }
    ValueRange tight_, wide_;
    bool known_ = false;
    double fewest_ = 0, most_ = 0;
};

/// Each of the two surfaces may be off by half the interval of the equivalent diameter, and by half a voxel at least.
void set_gap_interval(RegionCharacteristics& row, const GridGeometry& geometry) {
    const auto diameter = [](double volume) { return std::cbrt(6 * volume / std::numbers::pi); };
    const double own = 0.5 * (diameter(row.volume_hi_mm3) - diameter(row.volume_lo_mm3));
    const double half_voxel = 0.5 * geometry.smallest_spacing_mm();
    const double off = 2 * (own > half_voxel ? own : half_voxel);  // NaN: half a voxel
    row.gap_lo_mm = std::max(0.0, row.gap_mm - off);
    row.gap_hi_mm = row.gap_mm + off;
}

/// Grey-value integration between the level of the region's core and that of what lies round it. Other regions keep
/// their own part of a boundary that is shared, unless regions were grown: then all voxels belong to some region, and
/// what lies round one is taken as it is.
void measure_integral(const Setting& set, const Place& place, RegionCharacteristics& row) {
    RegionShell shell(set.table.labels, place.is_void ? &set.part : nullptr, row.id, row.bbox_first, row.bbox_last,
                      k_layers + 2);
    SliceReader reader(set.volume, shell.first(), shell.extent());
    Sampled core, round;
    PartialVolume partial;
    ShiftedCounts shifted(set);
    for (int z = 0; z < shell.extent().z; ++z) {
        set.job.check();
        const RegionShell::SliceView at = shell.slice(z);
        const std::vector<float>& values = reader.read(z);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (at.own[i] > k_layers + 2 || !std::isfinite(values[i])) continue;
            const bool alone = !set.exact() || at.foreign[i] > k_layers + 1;
            if (at.own[i] > k_layers) {
                if (alone) round.add(values[i]);
                continue;
            }
            if (at.beyond[i] > k_layers) {
                core.add(values[i]);
                partial.add_whole();
                shifted.add_whole();
            } else if (at.own[i] == 0 || !set.exact() || in_boundary_layer(at, i, k_layers)) {
                partial.add(double(values[i]));
                at.own[i] == 0 ? shifted.add_own(values[i]) : shifted.add_beside(values[i]);
            }
        }
    }
    const double inside = !set.exact() ? row.mean : (core.count() >= k_few ? core.middle() : set.inside);
    const double outside = round.count() >= k_few ? round.middle() : set.outside;
    const double contrast = std::abs(outside - inside);
    const bool one_level = round.count() < k_few || round.spread() <= 0.25 * contrast;
    const double voxels = partial.voxels(inside, outside);
    if (contrast > 0 && one_level && voxels > 0) {
        row.integral_volume_mm3 = voxels * set.volume.geometry().voxel_volume_mm3();
        if (place.in_part && set.has_part && voxels > set.part_voxels) row.flags.emplace_back("larger_than_part");
    } else {
        row.flags.emplace_back("sides_unclear");
    }
    shifted.set_interval(row, row.integral_volume_mm3, set.volume.geometry());
}

void check_measured(const Volume& volume, const RegionTable& table) {
    if (volume.empty() || volume.geometry().size != table.labels.geometry.size || !table.labels.labels)
        throw Error(Errc::bad_input, "The labels do not lie on the volume's grid; make them from this volume.");
}

}  // namespace

glm::dvec3 projected_areas_mm2(const LabelVolume& labels, std::uint32_t id, const glm::ivec3& bbox_first,
                               const glm::ivec3& bbox_last) {
    const glm::ivec3 n = bbox_last - bbox_first + 1;
    std::vector<std::uint8_t> along_x(std::size_t(n.y) * std::size_t(n.z)),
        along_y(std::size_t(n.x) * std::size_t(n.z)), along_z(std::size_t(n.x) * std::size_t(n.y));
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y) {
            const std::uint32_t* row =
                labels.labels->data() + labels.geometry.linear_index(bbox_first.x, bbox_first.y + y, bbox_first.z + z);
            for (int x = 0; x < n.x; ++x) {
                if (row[x] != id) continue;
                along_x[std::size_t(z) * std::size_t(n.y) + std::size_t(y)] = 1;
                along_y[std::size_t(z) * std::size_t(n.x) + std::size_t(x)] = 1;
                along_z[std::size_t(y) * std::size_t(n.x) + std::size_t(x)] = 1;
            }
        }
    const auto sum = [](const std::vector<std::uint8_t>& shadow) {
        return double(std::count(shadow.begin(), shadow.end(), 1));
    };
    const glm::dvec3 h = labels.geometry.spacing;
    return {sum(along_x) * h.y * h.z, sum(along_y) * h.x * h.z, sum(along_z) * h.x * h.y};
}

void measure_surfaces(const Volume& volume, RegionTable& table, const JobContext& job) {
    check_measured(volume, table);
    Setting set{volume, table, job};
    const VolumeStatistics statistics = compute_statistics(volume, job.part(0, 0.05));
    set_usual_levels(set, statistics);
    set_part(set, statistics);
    set_stride(set);
    std::vector<RegionCharacteristics>& rows = table.rows;
    std::vector<Points> points(rows.size());
    std::vector<Place> places(rows.size());
    std::vector<std::size_t> order(rows.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto box = [&rows](std::size_t i) {
        const glm::ivec3 n = rows[i].bbox_last - rows[i].bbox_first + 1;
        return std::int64_t(n.x) * n.y * n.z;
    };
    // The large ones first, so that no thread is left alone with one at the end.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return box(x) > box(y); });
    parallel_for(
        0, std::int64_t(rows.size()),
        [&](std::int64_t i) {
            const std::size_t k = order[std::size_t(i)];
            if (set.has_part) places[k] = place_of(set, rows[k]);
            measure_surface(set, rows[k], points[k]);
            rows[k].projected_area_mm2 =
                projected_areas_mm2(table.labels, rows[k].id, rows[k].bbox_first, rows[k].bbox_last);
            measure_integral(set, places[k], rows[k]);
        },
        job.part(0.15, 0.8));
    const PointTree surface(std::move(set.surface));
    const std::vector<Separation> apart = separations(surface, points, job.part(0.8, 1));
    // Vertices keep a thousandth of an edge away from voxel centres; nearer than that surfaces touch.
    const double touching = 3e-3 * volume.geometry().smallest_spacing_mm();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].gap_mm = apart[i].gap_mm > touching ? apart[i].gap_mm : 0;
        set_gap_interval(rows[i], volume.geometry());
        if (!set.has_part) continue;
        const bool at_surface = !places[i].in_part || rows[i].touches_border || !(apart[i].to_surface_mm > touching);
        rows[i].surface_distance_mm = at_surface ? 0 : apart[i].to_surface_mm;
    }
    table.mesh_method = set.exact() ? "marching cubes, vertices where the values pass the threshold"
                                    : "marching cubes on the voxels, vertices half way";
}

}  // namespace lacuna
