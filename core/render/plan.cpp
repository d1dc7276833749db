#include "core/render/plan.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "core/base/names.h"
#include "core/classify/opacity_peaks.h"
#include "core/render/brick_plan.h"

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
constexpr NameTable<Sampler, 3> k_sampler_names{
    {{Sampler::nearest, "nearest"}, {Sampler::linear, "linear"}, {Sampler::adaptive, "adaptive"}}};
constexpr NameTable<Refinement, 6> k_refinement_names{{{Refinement::none, "none"},
                                                       {Refinement::bisect, "bisect"},
                                                       {Refinement::regula_falsi, "regula-falsi"},
                                                       {Refinement::newton, "newton"},
                                                       {Refinement::regula_falsi_plain, "regula-falsi-plain"},
                                                       {Refinement::cubic, "cubic"}}};
constexpr NameTable<GradientFilter, 2> k_filter_names{
    {{GradientFilter::central, "central"}, {GradientFilter::sobel, "sobel"}}};
constexpr NameTable<GradientStore, 2> k_store_names{
    {{GradientStore::on_the_fly, "on-the-fly"}, {GradientStore::stored, "stored"}}};
constexpr NameTable<Integration, 2> k_integration_names{
    {{Integration::riemann, "riemann"}, {Integration::preintegrated, "preintegrated"}}};
constexpr NameTable<VoxelGradient, 3> k_voxel_gradient_names{
    {{VoxelGradient::central, "central"}, {VoxelGradient::sobel, "sobel"}, {VoxelGradient::gaussian, "gaussian"}}};

constexpr NameTable<Leaping, 3> k_leaping_names{
    {{Leaping::lossless, "lossless"}, {Leaping::confirmed, "confirmed"}, {Leaping::published, "published"}}};
constexpr NameTable<LeapWay, 3> k_leap_way_names{
    {{LeapWay::transform, "transform"}, {LeapWay::kd_tree, "kd-tree"}, {LeapWay::groups, "groups"}}};

constexpr double k_min_step = 0.01, k_max_step = 100;
constexpr int k_max_refine_steps = 64;
// Up to here cells of 4^3 are worth their eightfold number; beyond, their field leaves the caches.
constexpr std::int64_t k_fine_cells_voxels = std::int64_t(1) << 25;
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
    if (scene.mode == ViewMode::ea && plan.integration == Integration::preintegrated)
        throw Error(
            Errc::bad_usage,
            "The structure 'leap' answers with runs of equal samples, which pre-integrated segments do not take; "
            "none, macrocells, octree, pyramid, pc, acd and eacd can serve them.");
    if (leap.kernel == Leaping::lossless) return;
    if (scene.regions)
        throw Error(Errc::bad_usage, "The leaping kernel '" + std::string(name_of(leap.kernel)) +
                                         "' shows all regions alike; 'lossless' hides some or draws them its own way.");
    const bool gradients = scene.shading != Shading::none || scene.classification.uses_gradient();
    if (scene.mode != ViewMode::ea || gradients || plan.sampler != Sampler::linear)
        throw Error(Errc::bad_usage,
                    "The leaping kernel '" + std::string(name_of(leap.kernel)) +
                        "' serves mode ea without shading and opacity by gradient, sampled linearly; 'lossless' serves "
                        "the rest.");
}

}  // namespace

std::string_view name_of(Structure structure) { return name_in(k_structure_names, structure); }
std::string_view name_of(Sampler sampler) { return name_in(k_sampler_names, sampler); }
std::string_view name_of(Refinement refinement) { return name_in(k_refinement_names, refinement); }
std::string_view name_of(VoxelGradient filter) { return name_in(k_voxel_gradient_names, filter); }
std::string_view name_of(Leaping kernel) { return name_in(k_leaping_names, kernel); }
std::string_view name_of(LeapWay way) { return name_in(k_leap_way_names, way); }
std::span<const std::pair<Structure, std::string_view>> structure_names() { return k_structure_names; }
std::span<const std::pair<Sampler, std::string_view>> sampler_names() { return k_sampler_names; }
std::span<const std::pair<Refinement, std::string_view>> refinement_names() { return k_refinement_names; }
std::span<const std::pair<VoxelGradient, std::string_view>> voxel_gradient_names() { return k_voxel_gradient_names; }
Structure parse_structure(std::string_view text) { return parse_name(k_structure_names, text, "structure"); }
Sampler parse_sampler(std::string_view text) { return parse_name(k_sampler_names, text, "sampler"); }
Leaping parse_leaping(std::string_view text) { return parse_name(k_leaping_names, text, "leaping kernel"); }
LeapWay parse_leap_way(std::string_view text) { return parse_name(k_leap_way_names, text, "way of leap values"); }
Refinement parse_refinement(std::string_view text) { return parse_name(k_refinement_names, text, "refinement"); }
VoxelGradient parse_voxel_gradient(std::string_view text) {
    return parse_name(k_voxel_gradient_names, text, "voxel gradient");
}

std::string_view name_of(GradientFilter filter) { return name_in(k_filter_names, filter); }
std::string_view name_of(GradientStore store) { return name_in(k_store_names, store); }
std::string_view name_of(Integration integration) { return name_in(k_integration_names, integration); }
Integration parse_integration(std::string_view text) { return parse_name(k_integration_names, text, "integration"); }

void parse_gradient(std::string_view text, GradientFilter& filter, GradientStore& store) {
    bool filter_named = false, store_named = false, known = !text.empty();
    for (std::string_view rest = text; known && !rest.empty();) {
        const std::size_t comma = rest.find(',');
        const std::string_view word = rest.substr(0, comma);
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
        known = comma == std::string_view::npos || !rest.empty();
        if (word == "central" || word == "sobel") {
            filter = word == "sobel" ? GradientFilter::sobel : GradientFilter::central;
            known = known && !std::exchange(filter_named, true);
        } else if (word == "on-the-fly" || word == "stored") {
            store = word == "stored" ? GradientStore::stored : GradientStore::on_the_fly;
            known = known && !std::exchange(store_named, true);
        } else {
            known = false;
        }
    }
    if (!known)
        throw Error(Errc::bad_usage, "There is no gradient '" + std::string(text) +
                                         "'; known are central or sobel, on-the-fly or stored, or one of each "
                                         "(sobel,stored).");
}

double hidden_levels(double ert, Shading shading) { return 255 * ert * (shading == Shading::phong ? 1.2 : 1.0); }

std::string termination_reason(double ert, Shading shading) {
    if (!(ert > 0)) return "Rays run to their end: nothing is hidden.";
    char text[120];
    std::snprintf(text, sizeof text, "Rays end at opacity %.4g: what is left is below %.2g of 255 grey levels.",
                  1 - ert, hidden_levels(ert, shading));
    return text;
}

void add_method_reasons(Plan& plan, const Scene& scene) {
    const auto add = [&](const char* sentence) { plan.why.emplace_back(sentence); };
    if (plan.sampler == Sampler::adaptive)
        add(plan.structure == Structure::none
                ? "Adaptive sampler: nearest in blocks whose every value is drawn alike, so the picture is linear's; "
                  "most "
                  "reads of eight voxels go, little of the time."
                : "Adaptive sampler: little to gain here, the structure already leaves out most blocks that are drawn "
                  "alike.");
    if (scene.mode == ViewMode::iso && plan.refine == Refinement::cubic)
        add("Cubic: every cell the ray crosses is solved, so no wall is missed, whatever the step.");
    if (scene.mode == ViewMode::iso && plan.refine == Refinement::regula_falsi_plain)
        add("Plain regula falsi: stalls on convex stretches; regula-falsi does not.");
    if (scene.mode == ViewMode::ea && plan.structure == Structure::octree && plan.homogeneity > 0) {
        const auto peak = narrowest_peak(scene.classification);
        if (peak && *peak < plan.homogeneity)
            add("A peak of the transfer function is narrower than the threshold: homogeneous nodes may hide it; pc, "
                "acd and eacd compare opacities.");
    }
    if (plan.integration == Integration::preintegrated)
        add("Pre-integrated segments: a transfer function's peaks between two samples are not missed.");
    if (plan.sparse >= 2)
        add(plan.sparse_aware ? "Sparse casting asks min-max cells what its rays may have missed."
                              : "Sparse casting loses what is thinner than its pixel distance and no cast ray meets.");
    if (plan.gradient_store == GradientStore::stored && (scene.mode == ViewMode::iso || scene.mode == ViewMode::ea))
        add("Stored gradients: 4 bytes a voxel, directions within 0.2 degrees of those on the fly.");
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
                termination_reason(plan.ert, scene.shading)};
            break;
        case ViewMode::lmip:
            plan.why = {"Macro-cells: cells that can hold no winner are jumped over."};
            break;
        case ViewMode::mip:
        case ViewMode::minip:
            plan.why = {
                "Macro-cells: a stretch of samples whose cells hold no value better than the best so far is left out, "
                "after the most promising stretch was sampled first."};
            break;
        case ViewMode::mean:
            plan.structure = ranges ? Structure::acd : Structure::none;
            plan.why = {ranges ? "Distances over macro-cells: rays jump over what the segmentation ranges hide."
                               : "No structure: the mean counts every sample."};
            break;
    }
    if (!scene.regions.functions.empty()) {
        plan.structure = Structure::none;
        plan.why = {"No structure: regions have transfer functions of their own; none and leap know them."};
    }
    const Volume& volume = scene.volume;
    if (plan.structure == Structure::acd && !volume.empty() && size_of(volume.type()) > 1 &&
        volume.geometry().voxel_count() <= k_fine_cells_voxels) {
        plan.cells = 4;
        plan.why.push_back("Cells of 4^3 voxels: closer to what is visible than 8^3, an eighth of the voxels' bytes.");
    }
    plan.why.push_back("Two samples a voxel, trilinear: below that, thin walls are missed.");
    plan.why.push_back("No stored gradients: they are taken where a sample shows.");
    return plan;
}

std::string gain_note(const Plan& plan, const Scene& scene) {
    const bool family = scene.mode == ViewMode::mip || scene.mode == ViewMode::minip || scene.mode == ViewMode::lmip ||
                        scene.mode == ViewMode::mean;
    if (!family || plan.structure == Structure::none || !scene.classification.ranges.empty()) return {};
    if (scene.mode == ViewMode::mean) return "Every sample counts in the mean: a structure gains nothing here.";
    const bool bits_only = plan.structure == Structure::pyramid ||
                           (plan.cells == 1 && (plan.structure == Structure::pc || plan.structure == Structure::acd ||
                                                plan.structure == Structure::eacd));
    if (bits_only)
        return "'" + std::string(name_of(plan.structure)) +
               "' knows what is visible, not how large it is: without segmentation ranges it gains nothing in this "
               "mode.";
    return {};
}

Plan reference_plan(const Scene& scene, const Plan& like) {
    Plan plan = like;
    plan.why = {"Brute force: what every other plan is measured against."};
    if (scene.mode == ViewMode::shear_warp) return plan;  // nothing to leave out
    plan.structure = Structure::none;
    plan.sampler = Sampler::linear;
    plan.gradient_store = GradientStore::on_the_fly;
    plan.ert = 0;
    plan.sparse = 0;
    plan.homogeneity = plan.homogeneity_angle_deg = 0;
    return plan;
}

namespace {

/// Methods that serve one mode, or not together.
void check_methods(const Plan& plan, const Scene& scene) {
    const auto refuse = [](const char* sentence) { throw Error(Errc::bad_usage, sentence); };
    if (plan.sampler == Sampler::adaptive && scene.mode == ViewMode::shear_warp)
        refuse("The sampler 'adaptive' belongs to ray casting; shear-warp takes nearest or linear.");
    if (plan.refine == Refinement::cubic && scene.mode == ViewMode::iso && plan.sampler != Sampler::linear)
        refuse("The refinement 'cubic' solves the trilinear signal: it goes with the sampler linear alone.");
    const bool plain = plan.sampler != Sampler::adaptive && plan.gradient == GradientFilter::central &&
                       plan.gradient_store == GradientStore::on_the_fly && plan.integration == Integration::riemann &&
                       plan.refine != Refinement::cubic && !plan.sparse_aware;
    if (plan.brick != 0 && !plain)
        refuse(
            "Bricks go with the samplers nearest and linear, central gradients on the fly, the integration riemann, "
            "refinements other than cubic and plain sparse casting.");
    if (plan.integration == Integration::riemann) return;
    if (scene.mode != ViewMode::ea)
        refuse("Pre-integrated segments serve the mode ea alone; take the integration riemann for the others.");
    if (plan.sampler != Sampler::linear)
        refuse("Pre-integrated segments take values to change linearly: they go with the sampler linear alone.");
    if (plan.homogeneity > 0 || plan.homogeneity_angle_deg > 0)
        refuse("Homogeneous runs do not go with pre-integrated segments; take the integration riemann.");
    if (scene.classification.uses_gradient())
        refuse("Opacity by gradient cannot be integrated over values alone; take the integration riemann.");
}

}  // namespace

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
    const bool distances =
        plan.structure == Structure::pc || plan.structure == Structure::acd || plan.structure == Structure::eacd;
    if (distances && plan.homogeneity > 1)
        throw Error(Errc::bad_usage,
                    "The homogeneity of pc, acd and eacd is a difference of opacities: it must lie "
                    "within 0 to 1.");
    if (plan.cells != 1 && plan.cells != 4 && plan.cells != 8 && plan.cells != 16)
        throw Error(Errc::bad_usage, "The macro-cell edge must be 1, 4, 8 or 16 voxels.");
    if (plan.brick != 0 && (plan.brick < k_least_brick || plan.brick > k_largest_brick))
        throw Error(Errc::bad_usage, "The brick edge must lie between 8 and 1024 voxels; 0: no bricks.");
    if (plan.brick != 0 && scene.mode == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "Shear-warp does not work on bricks; use mode iso.");
    if (plan.brick != 0 && takes_whole_volume(plan, scene))
        throw Error(
            Errc::bad_usage,
            "Regions, leaping kernels and leap above homogeneity 0 need the whole volume at hand, not bricks of "
            "it; leave one out, or raise the memory limit.");
    if (scene.regions && ((scene.mode == ViewMode::iso && plan.refine == Refinement::cubic) ||
                          (scene.mode == ViewMode::ea && plan.integration == Integration::preintegrated) ||
                          (plan.sampler == Sampler::adaptive && !scene.regions.functions.empty())))
        throw Error(Errc::bad_usage,
                    "Regions are shown, hidden and coloured sample by sample, which cubic refinement, pre-integration "
                    "and the adaptive sampler do not do; leave one of them out.");
    if (plan.sparse != 0 && (plan.sparse < 2 || plan.sparse > 64))
        throw Error(Errc::bad_usage, "Sparse casting takes every 2nd to 64th pixel.");
    if (!(plan.sparse_gradient >= 0))
        throw Error(Errc::bad_usage, "The colour gradient of sparse casting must not be negative.");
    if (plan.sparse != 0 && scene.mode == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "Sparse casting skips rays; shear-warp casts none. Leave one of them out.");
    if (plan.directions != 6 && plan.directions != 24)
        throw Error(Errc::bad_usage, "Shear-warp divides the viewing directions into 6 or 24 regions.");
    check_methods(plan, scene);
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
    if (plan.structure == Structure::leap) check_leap(plan, scene);
}

}  // namespace lacuna
