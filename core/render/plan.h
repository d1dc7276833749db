#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/accel/leap_volume.h"
#include "core/accel/voxel_normals.h"
#include "core/render/scene.h"

namespace lacuna {

/// How empty space is skipped (docs/seeds.md names the papers): min-max macro-cells; Lesar's full min-max octree with
/// kd-restart; Levoy's pyramid of binary volumes; distances to the next visible cell or voxel, isotropic (pc), a
/// direction octant (acd) or anisotropic (eacd); leaps through homogeneous regions (Frey & Ertl). `visible` belongs to
/// shear_warp and to nothing else.
enum class Structure { none, macrocells, octree, pyramid, pc, acd, eacd, leap, visible };
enum class Sampler { nearest, linear };
enum class Refinement { none, bisect, regula_falsi, newton };

/// How rays leap. lossless: the renderer's own samples, and runs of one value where a leap voxel says so. confirmed:
/// the kernel as published, on the 16-bit volume alone, one look-up a step (EA, no shading); it takes a region for one
/// only where a leap voxel's top bit says so. published: on two equal samples, wherever they are; it can be fooled.
enum class Leaping { lossless, confirmed, published };

/// How the structure leap is made and used.
struct LeapPlan {
    Leaping kernel = Leaping::lossless;
    LeapWay way = LeapWay::transform;
    CentreGroups groups;                     ///< of LeapWay::groups
    std::int64_t min_voxels = 64;            ///< smaller regions are none
    std::optional<ValueRange> quantisation;  ///< f32 volumes: the values that get 15 bits; there it must be given
};

/// How a scene is drawn: plain values, and the reasons for them.
struct Plan {
    Structure structure = Structure::macrocells;
    double step = 0.5;  ///< in units of the smallest voxel spacing
    Sampler sampler = Sampler::linear;
    Refinement refine = Refinement::regula_falsi;
    int refine_steps = 5;
    double ert = 0.002;      ///< EA stops when opacity exceeds 1 - ert; 0: never
    double homogeneity = 0;  ///< octree, pc, acd, eacd: values (octree) or opacities that differ by no more
                             ///< count as equal; leap: the share of the value range that a
                             ///< region's values may span, 0..1; 0: lossless
    double homogeneity_angle_deg =
        0;           ///< acd, eacd, pc a voxel: gradient directions that differ by no more count as equal
    int cells = 8;   ///< voxels a macro-cell edge for pc, acd, eacd: 4, 8, 16; 1: a field a voxel, as published
    int sparse = 0;  ///< cast every k-th pixel, refine at edges (Lesar 2015); below 2: every pixel
    double sparse_gradient = 0.02;  ///< colour difference (0..1) between cast pixels above which all between are cast
    int directions = 24;  ///< shear_warp: regions of viewing directions visible voxels are listed for, 6 or 24
    VoxelGradient voxel_gradient = VoxelGradient::sobel;  ///< shear_warp, nearest: normals of the listed voxels
    int brick = 0;  ///< the volume is cut into bricks of so many voxels an edge, cast one after the other; 0: whole
    std::uint64_t brick_bytes = 0;  ///< bricks and their structures may take so much together; 0: Engine says
    LeapPlan leap;                  ///< structure leap only
    std::vector<std::string> why;   ///< one sentence a choice, and what was not built
};

std::string_view name_of(Structure structure);
std::string_view name_of(Sampler sampler);
std::string_view name_of(Refinement refinement);
std::string_view name_of(VoxelGradient filter);
std::string_view name_of(Leaping kernel);
std::string_view name_of(LeapWay way);
/// @throws Error(bad_usage) listing the known names
Structure parse_structure(std::string_view text);
Sampler parse_sampler(std::string_view text);
Refinement parse_refinement(std::string_view text);
VoxelGradient parse_voxel_gradient(std::string_view text);
Leaping parse_leaping(std::string_view text);
LeapWay parse_leap_way(std::string_view text);

/// The least structure that serves the scene's mode, with its reasons.
Plan default_plan(const Scene& scene);
/// The brute-force plan every other is measured against: no structure, no early termination, linear sampling.
Plan reference_plan(const Scene& scene, const Plan& like);

/// @throws Error(bad_usage) for a parameter out of range, or a structure that cannot serve the scene's mode, naming
/// those that can
void check(const Plan& plan, const Scene& scene);

}  // namespace lacuna
