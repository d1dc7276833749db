#include "core/inspect/defect_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/order_statistics.h"
#include "core/regions/bounding_sphere.h"
#include "core/regions/region_shell.h"
#include "core/regions/surface_mesher.h"
#include "core/regions/value_window.h"

namespace lacuna::inspect {

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_shift = 0.1;  ///< of the contrast: the thresholds a volume's interval spans

/// Grey values of a region's inside and of the material round it.
struct Sides {
    double defect_level, material_level, threshold;
    double full_threshold = threshold;  ///< half way to the level of large defects, however shallow this one is
    std::size_t round = 0;              ///< voxels the material level comes from
    double n = 0, sum = 0, squares = 0, nan = 0;
    double min = std::numeric_limits<double>::infinity(), max = -std::numeric_limits<double>::infinity();
};

void count_value(Sides& sides, float value) {
    if (!std::isfinite(value)) {
        ++sides.nan;
        return;
    }
    const double v = value;
    ++sides.n;
    sides.sum += v;
    sides.squares += v * v;
    sides.min = std::min(sides.min, v);
    sides.max = std::max(sides.max, v);
}

/// The level of a defect too small to have a core: that of its few deepest voxels where blur has left them clearly
/// short of the level of large ones, which stands otherwise.
double shallow_level(std::vector<float>& own, const Surroundings& s) {
    constexpr std::size_t k_deepest = 3;
    if (own.empty()) return s.defect_level;
    const std::size_t count = std::min(k_deepest, own.size());
    const double sign = s.type == DefectType::void_ ? 1 : -1;
    std::partial_sort(own.begin(), own.begin() + std::ptrdiff_t(count), own.end(),
                      [sign](float a, float b) { return sign * double(a) < sign * double(b); });
    double deepest = 0;
    for (std::size_t i = 0; i < count; ++i) deepest += double(own[i]) / double(count);
    return sign * (deepest - s.defect_level) > 2 * s.noise ? deepest : s.defect_level;
}

/// The local levels: material from two layers of voxels beyond the boundary layer, the defect's from its core where it
/// has one and from its deepest voxels else. Where there are too few voxels, the levels of the whole part stand.
Sides look_at_sides(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                    const Defect& defect, const JobContext& job) {
    constexpr std::size_t k_few = 20;
    const int layers = boundary_layers(s, volume.geometry());
    RegionShell shell(labels, &part, defect.id, defect.bbox_first, defect.bbox_last, layers + 2);
    SliceReader reader(volume, shell.first(), shell.extent());
    constexpr std::int64_t k_small = 500;  ///< voxels; larger ones have a core or are no blurred spot
    std::vector<float> round, core, own;
    Sides sides{s.defect_level, s.material_level, s.threshold};
    for (int z = 0; z < shell.extent().z; ++z) {
        job.check();
        const RegionShell::SliceView at = shell.slice(z);
        const std::vector<float>& values = reader.read(z);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (at.own[i] == 0) count_value(sides, values[i]);
            if (!std::isfinite(values[i])) continue;
            if (at.own[i] == 0 && defect.voxels <= k_small) own.push_back(values[i]);
            if (at.beyond[i] > layers) core.push_back(values[i]);
            if (at.own[i] > layers && at.own[i] <= layers + 2 && at.foreign[i] > layers + 1) round.push_back(values[i]);
        }
    }
    if (!s.local) return sides;
    const double contrast = s.material_level - s.defect_level;
    const auto plausible = [&](double level, double expected) {
        return std::abs(level - expected) < 0.4 * std::abs(contrast);
    };
    if (round.size() >= k_few)
        if (const double level = median(round); plausible(level, s.material_level))
            sides.material_level = level, sides.round = round.size();
    double inner = sides.defect_level;
    if (core.size() >= k_few) {
        if (const double level = median(core); plausible(level, s.defect_level)) sides.defect_level = inner = level;
    } else {
        inner = shallow_level(own, s);  // moves the surface alone: partial volumes refer to a whole voxel of void
    }
    sides.threshold = (sides.material_level + inner) / 2;
    sides.full_threshold = (sides.material_level + sides.defect_level) / 2;
    return sides;
}

SurfaceLevel level_for(DefectType type, double threshold) {
    SurfaceLevel level;
    if (type == DefectType::void_)
        level.hi = float(threshold);
    else
        level.lo = float(threshold);
    return level;
}

/// Surfaces at several thresholds and the grey-value integral, in one walk.
struct Walk {
    std::vector<TriangleMesh> meshes;
    PartialVolume partial;
};

Walk walk_surfaces(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                   std::uint32_t id, const glm::ivec3& bbox_first, const glm::ivec3& bbox_last,
                   const std::vector<double>& thresholds, const JobContext& job) {
    const int layers = boundary_layers(s, volume.geometry());
    RegionShell shell(labels, &part, id, bbox_first, bbox_last, layers);
    SliceReader reader(volume, shell.first(), shell.extent());
    std::vector<SurfaceMesher> meshers;
    meshers.reserve(thresholds.size());
    for (const double t : thresholds)
        meshers.emplace_back(shell.extent(), shell.first(), volume.geometry(), level_for(s.type, t));
    const std::size_t plane = std::size_t(shell.extent().x) * std::size_t(shell.extent().y);
    std::vector<std::uint8_t> inside(plane), mine(plane);
    const double sign = s.type == DefectType::void_ ? 1 : -1;
    Walk walk;
    for (int z = 0; z < shell.extent().z; ++z) {
        job.check();
        const RegionShell::SliceView at = shell.slice(z);
        const std::vector<float>& values = reader.read(z);
        for (std::size_t i = 0; i < plane; ++i) {
            const bool own = at.own[i] == 0, known = std::isfinite(values[i]);
            mine[i] = own || (known && in_boundary_layer(at, i, layers));
            if (!mine[i]) continue;
            if (!known || at.beyond[i] > layers)
                walk.partial.add_whole();
            else
                walk.partial.add(double(values[i]));
        }
        for (std::size_t k = 0; k < meshers.size(); ++k) {
            const double limit = sign * thresholds[k];
            for (std::size_t i = 0; i < plane; ++i) inside[i] = mine[i] && !(sign * double(values[i]) >= limit);
            meshers[k].push(inside.data(), values.data());
        }
    }
    for (SurfaceMesher& mesher : meshers) walk.meshes.push_back(mesher.finish());
    return walk;
}

Measured hull(double value, std::initializer_list<double> others, double margin) {
    Measured m{value, value, value};
    for (const double other : others) m.lo = std::min(m.lo, other), m.hi = std::max(m.hi, other);
    m.lo = std::max(0.0, m.lo - margin);
    m.hi += margin;
    return m;
}

/// What a surface may have more than its mesh shows: an edge of the body comes out rounded, and grey values blurred do
/// not tell a blunted edge from a round one, so every curved place may have been an edge. A right-angled one loses, per
/// length, (2 - sqrt 2)/2 = 0.29 voxels to the chamfer of marching cubes, and 0.85 sigma where a Gaussian blur rounds
/// the 50 % contour (of Phi(x) Phi(y) = 1/2, by quadrature). The length of the edges follows from the integral of mean
/// curvature, pi/4 of it for right angles, and that from volumes and areas inside to outside (Steiner's formula, dA =
/// 2 M dr, dV = A dr); never less than the ball's of that area, the least of convex bodies (Minkowski), so that convex
/// and concave places do not cancel out.
double blunted_area_mm2(const std::array<double, 3>& volume_mm3, const std::array<double, 3>& area_mm2, double sigma_mm,
                        double voxel_mm) {
    constexpr double k_chamfer = 0.293, k_rounding = 0.85;
    const double area = area_mm2[0], dr = area > 0 ? (volume_mm3[2] - volume_mm3[1]) / area : 0;
    double curvature = std::sqrt(4 * k_pi * area);
    if (std::abs(dr) > 1e-3 * voxel_mm)
        curvature = std::max(curvature, std::abs((area_mm2[2] - area_mm2[1]) / (2 * dr)));
    const double edges_mm = 4 / k_pi * curvature;
    return std::min(area, (k_chamfer * voxel_mm + k_rounding * sigma_mm) * edges_mm);
}

double ball_diameter(double volume) { return std::cbrt(6 * std::max(0.0, volume) / k_pi); }

void set_values(Defect& defect, const Sides& sides) {
    if (sides.nan > 0) defect.flags.emplace_back("holds_nan");
    if (!(sides.n > 0)) {
        defect.mean = defect.min = defect.max = defect.stddev = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    defect.mean = sides.sum / sides.n;
    defect.min = sides.min;
    defect.max = sides.max;
    defect.stddev = std::sqrt(std::max(0.0, sides.squares / sides.n - defect.mean * defect.mean));
}

/// What is impossible is set right and said: no body has less surface than the ball of its volume, and none fits into a
/// smaller sphere.
void set_shape(Defect& defect) {
    const double v = defect.volume_mm3.value, d = ball_diameter(v), ball_mm2 = k_pi * d * d;
    if (!(defect.area_mm2.value >= ball_mm2)) {
        defect.area_mm2.value = ball_mm2;
        defect.area_mm2.lo = std::min(defect.area_mm2.lo, ball_mm2);
        defect.area_mm2.hi = std::max(defect.area_mm2.hi, ball_mm2);
        defect.flags.emplace_back("surface_clamped");
    }
    if (defect.diameter_mm.value < d) {
        defect.diameter_mm.value = d;
        defect.diameter_mm.hi = std::max(defect.diameter_mm.hi, d);
        defect.flags.emplace_back("diameter_clamped");
    }
    const double a = defect.area_mm2.value;
    defect.shape_factor = v > 0 ? std::max(36 * k_pi, a / v * a / v * a) : std::numeric_limits<double>::quiet_NaN();
    defect.sphericity = a > 0 ? std::min(1.0, ball_mm2 / a) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

int boundary_layers(const Surroundings& s, const GridGeometry& geometry) {
    if (s.binary) return 2;
    return std::clamp(int(std::ceil(2 * s.sigma_mm / geometry.smallest_spacing_mm())) + 1, 2, 4);
}

TriangleMesh surface_at(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                        std::uint32_t id, const glm::ivec3& bbox_first, const glm::ivec3& bbox_last, double threshold,
                        const JobContext& job) {
    Walk walk = walk_surfaces(volume, labels, part, s, id, bbox_first, bbox_last, {threshold}, job);
    return std::move(walk.meshes.front());
}

void measure_by_values(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                       Defect& defect, std::vector<PointTree::Point>& points, const JobContext& job) {
    const GridGeometry& geometry = volume.geometry();
    const double voxel = geometry.voxel_volume_mm3(), h = std::cbrt(voxel);
    const Sides sides = look_at_sides(volume, labels, part, s, defect, job);
    set_values(defect, sides);
    defect.threshold = sides.threshold;
    const double contrast = sides.material_level - sides.defect_level;
    std::vector<double> thresholds{sides.threshold, sides.threshold - k_shift * contrast,
                                   sides.threshold + k_shift * contrast};
    // Shallow by its size or only blurred at its edge? Where a scan keeps the 50 % level at the edge, the surface lies
    // at the full contrast's half; a find too shallow to reach that level cannot be of this kind and has no surface
    // there.
    if (std::abs(sides.full_threshold - sides.threshold) > 1e-9 * std::abs(contrast)) {
        thresholds.push_back(sides.full_threshold);
        thresholds.push_back(sides.full_threshold - k_shift * contrast);
    }
    const Walk walk =
        walk_surfaces(volume, labels, part, s, defect.id, defect.bbox_first, defect.bbox_last, thresholds, job);

    std::array<double, 3> volume_mm3, area, diameter;
    for (std::size_t k = 0; k < 3; ++k) {
        volume_mm3[k] = enclosed_volume_mm3(walk.meshes[k]);
        area[k] = area_mm2(walk.meshes[k]);
        diameter[k] = 2 * smallest_enclosing_sphere(walk.meshes[k].vertices).radius;
    }
    // Taken as linear between voxels, values put a curved surface a little inside the true one.
    const double deficit =
        std::clamp(linear_deficit_mm3(walk.meshes[0], geometry), -0.2 * volume_mm3[0], volume_mm3[0]);
    for (double& v : volume_mm3) v = v > 0 ? std::max(0.0, v + deficit) : 0;
    defect.voxel_volume_mm3 = double(defect.voxels) * voxel;
    defect.integral_volume_mm3 = std::max(0.0, walk.partial.voxels(sides.defect_level, sides.material_level)) * voxel;
    defect.surface_mesh_mm2 = area[0];

    // Noise: each summed voxel's own, and that of the material level they are all held against.
    const double relative = s.noise / std::abs(contrast);
    const double integral_noise =
        relative * voxel * std::sqrt(walk.partial.boundary_voxels()) +
        (sides.round ? relative * voxel * walk.partial.boundary_voxels() / std::sqrt(double(sides.round)) : 0);
    const double smooth_area =
        std::max(defect.surface_crofton_mm2, std::min(area[0], 1.5 * defect.surface_crofton_mm2));
    const double rounding = (s.binary ? 0.15 : 0.03) * h * smooth_area;
    const double by_surface = s.binary ? defect.integral_volume_mm3 : volume_mm3[0];
    defect.volume_mm3 = hull(
        by_surface,
        {volume_mm3[0], volume_mm3[1], volume_mm3[2], std::max(0.0, defect.integral_volume_mm3 - 2 * integral_noise),
         defect.integral_volume_mm3 + 2 * integral_noise},
        rounding);
    for (std::size_t k = 3; k < walk.meshes.size(); ++k)
        if (const double full = enclosed_volume_mm3(walk.meshes[k]); full > 0)
            defect.volume_mm3.lo = std::min(defect.volume_mm3.lo, std::max(0.0, full - rounding));
    defect.equivalent_diameter_mm = {ball_diameter(defect.volume_mm3.value), ball_diameter(defect.volume_mm3.lo),
                                     ball_diameter(defect.volume_mm3.hi)};
    const double coarsest = std::max({geometry.spacing.x, geometry.spacing.y, geometry.spacing.z});
    const double jitter = 2 * relative * s.sigma_mm * std::sqrt(2 * k_pi);
    defect.diameter_mm =
        hull(diameter[0], {diameter[1], diameter[2]}, s.binary ? 0.6 * coarsest : 0.1 * coarsest + 2 * jitter);
    defect.area_mm2 = hull(s.binary ? defect.surface_crofton_mm2 : area[0],
                           {area[0], area[1], area[2], defect.surface_crofton_mm2}, 0.03 * smooth_area);
    defect.area_mm2.hi += blunted_area_mm2(volume_mm3, area, s.sigma_mm, h);
    set_shape(defect);
    for (const glm::dvec3& v : walk.meshes[0].vertices) points.push_back({glm::vec3(v - geometry.origin), defect.id});
    if (walk.meshes[0].vertices.empty())  // too faint for a surface at the local level: its centre stands for it
        points.push_back({glm::vec3(defect.centroid_mm - geometry.origin), defect.id});
}

double expected_by_chance(std::int64_t voxels, double depth, double noise, double trials) {
    if (!(noise > 0)) return 0;
    constexpr double k_shapes = 35;
    const double p = 0.5 * std::erfc(depth / noise / std::numbers::sqrt2);
    if (!(p > 0)) return 0;
    return std::exp(std::log(trials) + double(voxels - 1) * std::log(k_shapes) + double(voxels) * std::log(p));
}

}  // namespace lacuna::inspect
