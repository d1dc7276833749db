#include "core/render/scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/names.h"
#include "core/volume/statistics.h"

namespace lacuna {

namespace {

constexpr NameTable<ViewMode, 7> k_mode_names{{{ViewMode::iso, "iso"},
                                               {ViewMode::ea, "ea"},
                                               {ViewMode::mip, "mip"},
                                               {ViewMode::lmip, "lmip"},
                                               {ViewMode::minip, "minip"},
                                               {ViewMode::mean, "mean"},
                                               {ViewMode::shear_warp, "shear-warp"}}};
constexpr NameTable<Shading, 3> k_shading_names{
    {{Shading::none, "none"}, {Shading::lambert, "lambert"}, {Shading::phong, "phong"}}};

[[noreturn]] void refuse(const std::string& sentence) { throw Error(Errc::bad_usage, sentence); }

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_color(const glm::dvec3& color, const char* name) {
    for (int c = 0; c < 3; ++c)
        if (!(color[c] >= 0 && color[c] <= 1))
            refuse(std::string("Each part of the ") + name + " colour must lie between 0 and 1.");
}

/// Beyond that, single-precision positions tell less than 1/64 of a voxel apart.
void check_axes(glm::ivec3 size) {
    constexpr int k_longest_axis = 1 << 17;
    const int longest = std::max({size.x, size.y, size.z});
    if (longest > k_longest_axis)
        throw Error(Errc::unsupported, "An axis of " + std::to_string(longest) + " voxels is longer than the " +
                                           std::to_string(k_longest_axis) + " that can be drawn; crop the volume.");
}

void check_cuts(const std::vector<CuttingPlane>& cuts) {
    if (cuts.size() > Scene::k_max_cuts)
        refuse("A scene takes at most " + std::to_string(Scene::k_max_cuts) + " cutting planes, not " +
               std::to_string(cuts.size()) + ".");
    for (const CuttingPlane& cut : cuts) {
        if (!finite(cut.normal) || !(glm::dot(cut.normal, cut.normal) > 0))
            refuse("A cutting plane needs a normal a,b,c that is finite and not 0,0,0.");
        if (!std::isfinite(cut.offset)) refuse("A cutting plane's offset must be a finite number.");
    }
}

void check_classification(const Scene& scene) {
    const auto& ranges = scene.classification.ranges;
    if (ranges.size() > Classification::k_max_ranges)
        refuse("A scene takes at most " + std::to_string(Classification::k_max_ranges) + " segmentation ranges, not " +
               std::to_string(ranges.size()) + ".");
    for (const SegmentationRange& range : ranges) {
        if (!(range.range.lo <= range.range.hi))
            refuse("A segmentation range's lower end must not exceed its upper end.");
    }
    const bool iso_like = scene.mode == ViewMode::iso || scene.mode == ViewMode::shear_warp;
    if (scene.mode == ViewMode::ea || (scene.color_by_tf && !iso_like)) {
        check(scene.classification.tf);
        for (const SegmentationRange& range : ranges)
            if (range.tf) check(*range.tf);
    }
}

void check_regions(const Scene& scene) {
    const RegionClasses& regions = scene.regions;
    if (!regions) {
        if (!regions.functions.empty()) refuse("Transfer functions of regions need the regions' voxels.");
        return;
    }
    if (std::int64_t(regions.of_voxel->size()) != scene.volume.geometry().voxel_count())
        refuse("The region classes must hold one byte for each voxel of the volume.");
    if (regions.functions.size() + scene.classification.ranges.size() > RegionClasses::k_max_functions)
        refuse("A scene takes at most " + std::to_string(RegionClasses::k_max_functions) +
               " segmentation ranges and transfer functions of regions together.");
    if (scene.mode == ViewMode::shear_warp)
        refuse(
            "Shear-warp paints surface voxels, whatever region they are in; use mode iso, ea, mip, lmip, minip or mean "
            "to show or hide regions.");
    if (!regions.functions.empty() && scene.mode != ViewMode::ea)
        refuse("Regions have transfer functions of their own in mode ea alone.");
    for (const TransferFunction& tf : regions.functions) check(tf);
}

void check_camera(const Scene& scene) {
    const Camera& camera = scene.camera;
    if (!std::isfinite(camera.azimuth_deg) || !std::isfinite(camera.elevation_deg) || !std::isfinite(camera.roll_deg))
        refuse("The camera's angles must be finite numbers.");
    if (camera.center_mm && !finite(*camera.center_mm)) refuse("The camera's centre must be finite.");
    if (scene.mode == ViewMode::shear_warp && camera.fov_deg)
        refuse(
            "Shear-warp is orthographic only; take the perspective away, or use mode iso, ea, mip, lmip, minip or "
            "mean.");
    resolve(camera, scene.volume.geometry(), scene.size);
}

void check_highlights(const std::vector<Highlight>& highlights) {
    for (const Highlight& highlight : highlights) {
        const glm::ivec3 size = highlight.size;
        if (size.x < 0 || size.y < 0 || size.z < 0 || !highlight.inside ||
            highlight.inside->size() != std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
            refuse("A highlight must hold one byte for each voxel of its box.");
        check_color(highlight.color, "highlight");
        if (!(highlight.opacity >= 0 && highlight.opacity <= 1))
            refuse("A highlight's opacity must lie between 0 and 1.");
    }
}

}  // namespace

std::string_view name_of(ViewMode mode) { return name_in(k_mode_names, mode); }
std::string_view name_of(Shading shading) { return name_in(k_shading_names, shading); }
ViewMode parse_view_mode(std::string_view text) { return parse_name(k_mode_names, text, "view mode"); }
Shading parse_shading(std::string_view text) { return parse_name(k_shading_names, text, "shading"); }

Scene default_scene(const Volume& volume, const VolumeStatistics& statistics) {
    Scene scene;
    scene.volume = volume;
    scene.iso = otsu_threshold(statistics);
    scene.classification.tf = fit_transfer_function(volume, statistics);
    scene.window = statistics.range;
    if (!(scene.window.hi > scene.window.lo)) scene.window.hi = scene.window.lo + 1;  // a constant volume is black
    scene.lmip_threshold = scene.iso;
    return scene;
}

void check(const Scene& scene) {
    if (scene.volume.empty()) refuse("The scene holds no volume; open one first.");
    check_axes(scene.volume.geometry().size);
    check_camera(scene);
    check_cuts(scene.cuts);
    check_classification(scene);
    check_regions(scene);
    if (!std::isfinite(scene.iso)) refuse("The isovalue must be a finite number.");
    if (!std::isfinite(scene.lmip_threshold)) refuse("The LMIP threshold must be a finite number.");
    if (!(scene.window.lo < scene.window.hi) || !std::isfinite(scene.window.width()))
        refuse("The grey window's lower end must be below its upper end.");
    check_color(scene.surface_color, "surface");
    check_color(scene.background, "background");
    check_highlights(scene.highlights);
    check(scene.effects, scene.mode);
}

}  // namespace lacuna
