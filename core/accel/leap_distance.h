#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// Labelled voxels, x fastest; 0: in no region.
struct LabelGrid {
    glm::ivec3 size{0};
    glm::dvec3 spacing_mm{1};
    const std::uint32_t* labels = nullptr;

    std::int64_t voxel_count() const { return std::int64_t(size.x) * size.y * size.z; }
};

/// Distances are whole numbers of 15 bits and saturate, never wrap.
inline constexpr int k_leap_limit = 32767;

/// floor(distance / unit), saturating; rounding upwards by a billionth of a unit, so that whole results stay whole.
int leap_units(double distance_mm, double unit_mm);

/// For every voxel of a region the distance between its centre and that of the nearest voxel of another label, in units
/// of unit_mm, rounded down; 0 for voxels of no region. The volume's border limits nothing. Exact for any spacing: the
/// separable lower envelope of parabolas (Meijster, Roerdink, Hesselink 2000; Felzenszwalb & Huttenlocher 2012), each
/// line cut where the label changes, so that all regions are done at once. O(n), on all threads; memory: `distance` and
/// 8 bytes a voxel of one slice a thread.
void exact_distances(const LabelGrid& grid, double unit_mm, std::uint16_t* distance, const JobContext& job = {});

/// The boundary layers of all regions (Frey & Ertl 2009, section 3): the voxels beside a region (sharing a face) that
/// are not of it, sorted by region, each once a region.
struct BoundaryList {
    std::vector<std::int64_t> voxel;  ///< linear index in the grid
    std::vector<std::int64_t> first;  ///< where a label's begin, and one more; the index is the label
};
BoundaryList boundary_list(const LabelGrid& grid, std::uint32_t labels, const JobContext& job = {});

/// Frey & Ertl's classification by a neighbour list: 1 for leap voxels, those of a region with no voxel of another
/// label at a distance below (radius + 1) units, else 0.
void classify_by_neighbours(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, int radius,
                            std::uint16_t* leaps, const JobContext& job = {});

/// Turns the leap voxels' 1 of classify_by_neighbours into the distances exact_distances gives: a kd-tree a region over
/// its boundary layer, asked for every leap voxel. About 10 times the cost of the transform and more.
void tree_distances(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, std::uint16_t* leaps,
                    const JobContext& job = {});

struct CentreGroups {
    double probability = 0.001;    ///< of a leap voxel to become a centre, 0..1
    double relative_radius = 0.5;  ///< of a centre's distance: how far it hands values out, 0..1
    std::uint64_t seed = 1;        ///< same seed, same values, on any number of threads
};

/// The same by centre-voxel groups: only centres ask the tree; a voxel at distance n from a centre with distance d,
/// n <= min(relative_radius * d, d - guard), has at least d - n and takes the largest it is offered. Voxels no group
/// reaches keep the least a leap voxel can have, radius + 1 units.
void group_distances(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, int radius,
                     const CentreGroups& groups, std::uint16_t* leaps, const JobContext& job = {});

}  // namespace lacuna
