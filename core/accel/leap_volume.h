#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/accel/leap_distance.h"
#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Where the leap values come from; all three give distances that never exceed the true ones.
enum class LeapWay {
    transform,  ///< exact distance transform
    kd_tree,    ///< the nearest boundary voxel by kd-tree, for every leap voxel; the transform's values
    groups      ///< by centre-voxel groups; smaller values
};

struct LeapOptions {
    double range_width = 0;        ///< a region's values span at most this share (0..1) of the range of values
    std::int64_t min_voxels = 64;  ///< smaller regions are none
    double step_mm = 0;            ///< largest distance between a ray's samples
    LeapWay way = LeapWay::transform;
    CentreGroups groups;  ///< of LeapWay::groups
    /// f32 volumes only, and there it must be given: the values that the codes 0 and 32766 stand for. Values beyond
    /// count as the nearer of the two.
    std::optional<ValueRange> quantisation;
    /// A byte a voxel (or null): regions are cut where it changes, so that a leap never crosses such a border.
    const std::uint8_t* voxel_class = nullptr;
    bool flatten = true;  ///< make LeapVolume::flat too
};

/// A volume prepared for leaping (Frey & Ertl 2009): 16 bits a voxel.
///   top bit 0: a density of 15 bits; value = value_lo + code * value_scale. Voxels outside regions hold their own,
///     guards (voxels of a region with a voxel of no or another region, or the volume's border, near by) their region's
///     average. f32 volumes: 32767 is NaN.
///   top bit 1: a leap voxel; the low bits say, in units of unit_mm, how far a ray may go from anywhere in the voxel's
///     cell so that trilinear reconstruction at every point on the way, the end included, reads voxels of its region
///     only. Never overestimated.
/// Near: at most radius_mm = two voxel diagonals and two sampling steps, so that a ray takes two samples among guards,
/// equal ones, before a leap voxel enters its trilinear neighbourhood. (The radius as published, one step, leaves the
/// neighbourhood out.) At the volume's border two steps and a voxel an axis. Integer volumes whose range has at most
/// 32768 values keep them exactly (value_scale 1); wider ones lose the lowest bit.
struct LeapVolume {
    glm::ivec3 size{0};
    VoxelBuffer entries;  ///< u16 a voxel, x fastest
    double unit_mm = 1, radius_mm = 0, step_mm = 0;
    double value_lo = 0, value_scale = 1;
    Volume flat;  ///< the volume with each region's voxels at its average: what a picture by leaping is a picture of.
                  ///< Shares the volume's voxels where nothing differs (regions of equal values)
    std::int64_t regions = 0, region_voxels = 0, leap_voxels = 0;

    const std::uint16_t* data() const { return reinterpret_cast<const std::uint16_t*>(entries.data()); }
    std::size_t bytes() const { return entries.size(); }  ///< without `flat`
};

inline constexpr std::uint16_t k_leap_bit = 0x8000, k_leap_nan = 0x7fff;

/// Grows the regions, classifies, finds the leap values. Memory meanwhile: 4 bytes a voxel for the labels.
/// @throws Error(bad_usage) for options out of range, or an f32 volume without a quantisation; Error(cancelled)
LeapVolume build_leap_volume(const Volume& volume, const LeapOptions& options, const JobContext& job = {});

}  // namespace lacuna
