#include "core/render/plan.h"

#include <cmath>

#include "core/base/names.h"

namespace lacuna {

namespace {

constexpr NameTable<Structure, 9> k_structure_names{{{Structure::none, "none"},
                                                     {Structure::macrocells, "macrocells"},
                                                     {Structure::octree, "octree"},
                                                     {Structure::pyramid, "pyramid"},
                                                     {Structure::pc, "pc"},
                                                     {Structure::acd, "acd"},
                                                     {Structure::eacd, "eacd"},
                                                     {Structure::leap, "leap"},
                                                     {Structure::visible, "visible"}}};
constexpr NameTable<Sampler, 2> k_sampler_names{{{Sampler::nearest, "nearest"}, {Sampler::linear, "linear"}}};
constexpr NameTable<Refinement, 4> k_refinement_names{{{Refinement::none, "none"},
                                                       {Refinement::bisect, "bisect"},
                                                       {Refinement::regula_falsi, "regula-falsi"},
                                                       {Refinement::newton, "newton"}}};
constexpr NameTable<VoxelGradient, 3> k_voxel_gradient_names{
    {{VoxelGradient::central, "central"}, {VoxelGradient::sobel, "sobel"}, {VoxelGradient::gaussian, "gaussian"}}};

constexpr NameTable<Leaping, 3> k_leaping_names{
    {{Leaping::lossless, "lossless"}, {Leaping::confirmed, "confirmed"}, {Leaping::published, "published"}}};
constexpr NameTable<LeapWay, 3> k_leap_way_names{
    {{LeapWay::transform, "transform"}, {LeapWay::kd_tree, "kd-tree"}, {LeapWay::groups, "groups"}}};

constexpr double k_min_step = 0.01, k_max_step = 100;
constexpr int k_max_refine_steps = 64;
constexpr int k_least_brick = 8, k_largest_brick = 1024;

/// @throws Error(bad_usage) where leaping cannot serve the scene
void check_leap(const Plan& plan, const Scene& scene) {
    const LeapPlan& leap = plan.leap;
    if (!(plan.homogeneity <= 1))
        throw Error(Errc::bad_usage,
                    "The homogeneity of leap is a share of the value range: it must lie within 0 to 1.");
    if (!(leap.groups.probability >= 0 && leap.groups.probability <= 1) ||
        !(leap.groups.relative_radius >= 0 && leap.groups.relative_radius <= 1))
        throw Error(Errc::bad_usage, "Centre-voxel groups take a probability and a relative radius within 0 to 1.");
    if (leap.min_voxels < 1) throw Error(Errc::bad_usage, "The smallest region to leap through has 1 voxel or more.");
    if (leap.quantisation && (!(leap.quantisation->lo < leap.quantisation->hi) ||
                              !std::isfinite(leap.quantisation->lo) || !std::isfinite(leap.quantisation->hi)))
        throw Error(Errc::bad_usage, "The range leap is to quantise must be finite, its lower end below its upper.");
    if (scene.volume.type() == VoxelType::f32 && !leap.quantisation)
        throw Error(Errc::bad_usage,
                    "The structure 'leap' keeps 15 bits a voxel and cannot serve f32 values unless the range to "
                    "quantise is stated; none, macrocells, octree, pyramid, pc, acd and eacd can.");
    if (leap.kernel == Leaping::lossless) return;
    if (scene.regions)
        throw Error(Errc::bad_usage, "The leaping kernel '" + std::string(name_of(leap.kernel)) +
                                         "' shows all regions alike; 'lossless' hides some or draws them its own way.");
    bool gradients = scene.shading != Shading::none || !scene.classification.tf.gradient_opacity.empty();
    for (const SegmentationRange& range : scene.classification.ranges)
        gradients = gradients || (range.tf && !range.tf->gradient_opacity.empty());
    if (scene.mode != ViewMode::ea || gradients || plan.sampler != Sampler::linear)
        throw Error(Errc::bad_usage,
                    "The leaping kernel '" + std::string(name_of(leap.kernel)) +
                        "' serves mode ea without shading and gradient opacity, sampled linearly; 'lossless' serves "
                        "the rest.");
}

}  // namespace

std::string_view name_of(Structure structure) { return name_in(k_structure_names, structure); }
std::string_view name_of(Sampler sampler) { return name_in(k_sampler_names, sampler); }
std::string_view name_of(Refinement refinement) { return name_in(k_refinement_names, refinement); }
std::string_view name_of(VoxelGradient filter) { return name_in(k_voxel_gradient_names, filter); }
std::string_view name_of(Leaping kernel) { return name_in(k_leaping_names, kernel); }
std::string_view name_of(LeapWay way) { return name_in(k_leap_way_names, way); }
Structure parse_structure(std::string_view text) { return parse_name(k_structure_names, text, "structure"); }
Sampler parse_sampler(std::string_view text) { return parse_name(k_sampler_names, text, "sampler"); }
Leaping parse_leaping(std::string_view text) { return parse_name(k_leaping_names, text, "leaping kernel"); }
LeapWay parse_leap_way(std::string_view text) { return parse_name(k_leap_way_names, text, "way of leap values"); }
Refinement parse_refinement(std::string_view text) { return parse_name(k_refinement_names, text, "refinement"); }
VoxelGradient parse_voxel_gradient(std::string_view text) {
    return parse_name(k_voxel_gradient_names, text, "voxel gradient");
}

Plan default_plan(const Scene& scene) {
    Plan plan;
    const bool ranges = !scene.classification.ranges.empty();
    switch (scene.mode) {
        case ViewMode::shear_warp:
            plan.structure = Structure::visible;
            plan.refine = Refinement::none;
            plan.why = {
                "Visible voxels: shear-warp paints the surface voxels that 1 of 24 regions of viewing directions can "
                "see; 2x2 predecessors list about half as many as the 3x3 of 6 regions.",
                "Bilinear within the slices for a still picture; nearest is the faster one while the view moves.",
                "No distances: no ray is cast."};
            return plan;
        case ViewMode::iso:
            plan.structure = Structure::acd;
            plan.why = {
                "Distances over macro-cells, an octant of directions each: rays jump to the next cell whose "
                "values lie on both sides of the surface.",
                "Regula falsi, 5 steps: the surface's depth is far more exact than the sample distance."};
            break;
        case ViewMode::ea:
            plan.structure = Structure::acd;
            plan.why = {
                "Distances over macro-cells, an octant of directions each: rays jump to the next cell with a "
                "visible value.",
                "Rays end at opacity 0.998: what is left is below one grey level."};
            break;
        case ViewMode::lmip:
            plan.why = {"Macro-cells: cells that can hold no winner are jumped over."};
            break;
        case ViewMode::mip:
        case ViewMode::minip:
        case ViewMode::mean:
            plan.structure = ranges ? Structure::acd : Structure::none;
            plan.why = {ranges ? "Distances over macro-cells: rays jump over what the segmentation ranges hide."
                        : scene.mode == ViewMode::mean
                            ? "No structure: the mean counts every sample."
                            : "No structure: asking whether a cell can still win costs what it saves."};
            break;
    }
    if (!scene.regions.functions.empty()) {
        plan.structure = Structure::none;
        plan.why = {"No structure: regions have transfer functions of their own; none and leap know them."};
    }
    plan.why.push_back("Two samples a voxel, trilinear: below that, thin walls are missed.");
    plan.why.push_back("No stored gradients: they are taken where a sample shows.");
    return plan;
}

Plan reference_plan(const Scene& scene, const Plan& like) {
    Plan plan = like;
    plan.why = {"Brute force: what every other plan is measured against."};
    if (scene.mode == ViewMode::shear_warp) return plan;  // nothing to leave out
    plan.structure = Structure::none;
    plan.sampler = Sampler::linear;
    plan.ert = 0;
    plan.sparse = 0;
    plan.homogeneity = plan.homogeneity_angle_deg = 0;
    return plan;
}

void check(const Plan& plan, const Scene& scene) {
    if (!(plan.step >= k_min_step && plan.step <= k_max_step))
        throw Error(Errc::bad_usage, "The step must lie between 0.01 and 100 voxel spacings.");
    if (plan.refine_steps < 0 || plan.refine_steps > k_max_refine_steps)
        throw Error(Errc::bad_usage, "The number of refinement steps must lie between 0 and 64.");
    if (!(plan.ert >= 0 && plan.ert < 1))
        throw Error(Errc::bad_usage, "The early ray termination must be at least 0 and below 1.");
    if (!(plan.homogeneity >= 0) || !(plan.homogeneity_angle_deg >= 0 && plan.homogeneity_angle_deg <= 180))
        throw Error(Errc::bad_usage,
                    "The homogeneity threshold must not be negative, its angle lie within 0 to 180 degrees.");
    if (plan.cells != 1 && plan.cells != 4 && plan.cells != 8 && plan.cells != 16)
        throw Error(Errc::bad_usage, "The macro-cell edge must be 1, 4, 8 or 16 voxels.");
    if (plan.brick != 0 && (plan.brick < k_least_brick || plan.brick > k_largest_brick))
        throw Error(Errc::bad_usage, "The brick edge must lie between 8 and 1024 voxels; 0: no bricks.");
    if (plan.brick != 0 && scene.mode == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "Shear-warp does not work on bricks; use mode iso.");
    if (plan.sparse != 0 && (plan.sparse < 2 || plan.sparse > 64))
        throw Error(Errc::bad_usage, "Sparse casting takes every 2nd to 64th pixel.");
    if (!(plan.sparse_gradient >= 0))
        throw Error(Errc::bad_usage, "The colour gradient of sparse casting must not be negative.");
    if (plan.sparse != 0 && scene.mode == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "Sparse casting skips rays; shear-warp casts none. Leave one of them out.");
    if (plan.directions != 6 && plan.directions != 24)
        throw Error(Errc::bad_usage, "Shear-warp divides the viewing directions into 6 or 24 regions.");
    if (!scene.regions.functions.empty() && plan.structure != Structure::none && plan.structure != Structure::leap)
        throw Error(Errc::bad_usage, "The structure '" + std::string(name_of(plan.structure)) +
                                         "' knows no transfer functions of regions; none and leap do.");
    const bool shear_warp = scene.mode == ViewMode::shear_warp;
    if (shear_warp != (plan.structure == Structure::visible))
        throw Error(Errc::bad_usage, "The structure '" + std::string(name_of(plan.structure)) +
                                         "' cannot serve the mode '" + std::string(name_of(scene.mode)) +
                                         (shear_warp ? "'; 'visible' can."
                                                     : "'; none, macrocells, octree, pyramid, pc, acd, eacd and "
                                                       "leap can."));
    if (plan.brick > 0 && (plan.structure == Structure::leap || scene.regions))
        throw Error(
            Errc::bad_usage,
            "Regions are those of the whole volume: bricks go with none, macrocells, octree, pyramid, pc, acd and "
            "eacd, and with all regions shown.");
    if (plan.structure == Structure::leap) check_leap(plan, scene);
}

}  // namespace lacuna
