#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/accel/voxel_normals.h"
#include "core/render/scene.h"

namespace lacuna {

/// How empty space is skipped (docs/seeds.md names the papers): min-max macro-cells; Lesar's full min-max octree with
/// kd-restart; Levoy's pyramid of binary volumes; distances to the next visible cell or voxel, isotropic (pc), a
/// direction octant (acd) or anisotropic (eacd). `visible` belongs to shear_warp and to nothing else.
enum class Structure { none, macrocells, octree, pyramid, pc, acd, eacd, visible };
/// adaptive: nearest where every value a sample could have there is drawn alike, linear elsewhere; the picture is
/// linear's.
enum class Sampler { nearest, linear, adaptive };
/// How an isosurface's depth is found once two samples lie on different sides. regula_falsi carries the Illinois
/// modification; regula_falsi_plain (Lesar 2015) stalls on convex stretches; cubic solves every cell between voxels
/// that the ray crosses exactly (Marmitt et al. 2004), so that no wall thinner than a step is missed.
enum class Refinement { none, bisect, regula_falsi, newton, regula_falsi_plain, cubic };
/// Normals: central differences, or the 3x3x3 Sobel operator (scene.h).
enum class GradientFilter { central, sobel };
/// Where gradients come from: computed where a sample shows, or read from one packed word a voxel.
enum class GradientStore { on_the_fly, stored };
/// EA: one value a step, or segments between samples integrated beforehand (Engel et al. 2001).
enum class Integration { riemann, preintegrated };

/// How a scene is drawn: plain values, and the reasons for them.
struct Plan {
    Structure structure = Structure::macrocells;
    double step = 0.5;  ///< in units of the smallest voxel spacing
    Sampler sampler = Sampler::linear;
    Refinement refine = Refinement::regula_falsi;
    int refine_steps = 5;  ///< of bisect, regula falsi and newton
    GradientFilter gradient = GradientFilter::central;
    GradientStore gradient_store = GradientStore::on_the_fly;
    Integration integration = Integration::riemann;
    double ert = 0.002;      ///< EA stops when opacity exceeds 1 - ert; 0: never
    double homogeneity = 0;  ///< octree, pc, acd, eacd: values (octree) or opacities that differ by no more
                             ///< count as equal; 0: lossless
    double homogeneity_angle_deg =
        0;           ///< acd, eacd, pc a voxel: gradient directions that differ by no more count as equal
    int cells = 8;   ///< voxels a macro-cell edge for pc, acd, eacd: 4, 8, 16; 1: a field a voxel, as published
    int sparse = 0;  ///< cast every k-th pixel, refine at edges (Lesar 2015); below 2: every pixel
    double sparse_gradient = 0.02;  ///< colour difference (0..1) between cast pixels above which all between are cast
    int directions = 24;  ///< shear_warp: regions of viewing directions visible voxels are listed for, 6 or 24
    VoxelGradient voxel_gradient = VoxelGradient::sobel;  ///< shear_warp, nearest: normals of the listed voxels
    int brick = 0;  ///< the volume is cut into bricks of so many voxels an edge, cast one after the other; 0: whole
    std::uint64_t brick_bytes = 0;  ///< bricks and their structures may take so much together; 0: Engine says
    bool sparse_aware = false;      ///< also where min-max cells allow for something between the cast rays
    std::vector<std::string> why;   ///< one sentence a choice, and what was not built
};

std::string_view name_of(Structure structure);
std::string_view name_of(Sampler sampler);
std::string_view name_of(Refinement refinement);
std::string_view name_of(VoxelGradient filter);
std::string_view name_of(GradientFilter filter);
std::string_view name_of(GradientStore store);
std::string_view name_of(Integration integration);
/// @throws Error(bad_usage) listing the known names
Structure parse_structure(std::string_view text);
Sampler parse_sampler(std::string_view text);
Refinement parse_refinement(std::string_view text);
VoxelGradient parse_voxel_gradient(std::string_view text);
Integration parse_integration(std::string_view text);
/// "central", "sobel", "on-the-fly", "stored", or one of each with a comma between, in any order.
void parse_gradient(std::string_view text, GradientFilter& filter, GradientStore& store);

/// Grey levels (of 255) that early termination can hide at most: what lies behind opacity 1 - ert weighs below ert, and
/// Phong's gloss lets a colour reach 1.2.
double hidden_levels(double ert, Shading shading);
/// That bound as a sentence for Plan::why.
std::string termination_reason(double ert, Shading shading);

/// Adds to Plan::why what the methods that were asked for do to the picture and to the work.
void add_method_reasons(Plan& plan, const Scene& scene);

/// The least structure that serves the scene's mode, with its reasons.
Plan default_plan(const Scene& scene);
/// One sentence where the plan's structure can gain nothing in the scene's mode (projections without segmentation
/// ranges); empty else. For plans whose structure was asked for.
std::string gain_note(const Plan& plan, const Scene& scene);
/// The brute-force plan every other is measured against: no structure, no early termination, linear sampling.
Plan reference_plan(const Scene& scene, const Plan& like);

/// @throws Error(bad_usage) for a parameter out of range, or a structure that cannot serve the scene's mode, naming
/// those that can
void check(const Plan& plan, const Scene& scene);

}  // namespace lacuna
