#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/regions/label_volume.h"
#include "core/regions/triangle_mesh.h"
#include "core/volume/statistics.h"

namespace lacuna {

enum class Connectivity { c6 = 6, c18 = 18, c26 = 26 };

/// How to cut a volume into regions: exactly one of range_width and threshold is set.
struct RegionOptions {
    std::optional<double> range_width;     ///< 0..1: homogeneous-region growing (Frey & Ertl 2009), a region's values
                                           ///< span at most this share of the volume's value range
    std::optional<ValueRange> threshold;   ///< components of the voxels whose value lies in the closed range
    std::optional<ValueRange> background;  ///< range_width only: values never grown (default: none)
    Connectivity connectivity = Connectivity::c6;
    std::int64_t min_voxels = 1;  ///< smaller regions go back to background
    /// Voxels with a larger gradient (central differences, unit per mm) belong to no region: edges part regions.
    std::optional<double> gradient_limit;
    /// Slivers are what is left over between regions in face-connected pieces under min_voxels; each joins the region
    /// it shares most faces with (ties: the lower id) instead of going to background.
    bool merge_slivers = false;
};

/// The row of `lacuna regions` (contract). Lengths in mm.
struct RegionCharacteristics {
    static constexpr double k_unmeasured = std::numeric_limits<double>::quiet_NaN();

    std::uint32_t id = 0;
    std::int64_t voxels = 0;
    double volume_mm3 = 0;
    double fraction = 0;             ///< of all voxels in any region
    double surface_mm2 = 0;          ///< estimator named by RegionTable::surface_method; corrected where it cannot be
    double surface_crofton_mm2 = 0;  ///< the same as estimated
    double shape_factor = 0;         ///< s^3/v^2; 36*pi for a ball, never below it
    double sphericity = 0;           ///< Wadell 1935: pi^(1/3) (6v)^(2/3) / s; never above 1
    std::int64_t holes = 0;          ///< cavities: subsets of the boundary layer less the outer one
    std::int64_t tunnels = 0;        ///< by Euler's number: components + cavities - euler
    std::int64_t euler = 0;
    double mean = 0, min = 0, max = 0, stddev = 0;
    glm::dvec3 centroid_mm{0};
    glm::dvec3 bbox_min_mm{0}, bbox_max_mm{0};  ///< of the voxel cells (outer faces), axis-aligned in mm
    glm::ivec3 bbox_first{0}, bbox_last{0};     ///< in voxels, both included
    double equivalent_diameter_mm = 0;          ///< of the ball of equal volume
    glm::dvec3 principal_lengths_mm{0};         ///< full axes of the ellipsoid of equal second moments, longest first
    bool touches_border = false;                ///< of the volume; an axis of one voxel has none
    /// A value that had to be corrected or cannot be trusted: "surface_clamped" (the estimate fell below the surface of
    /// the ball of equal volume, as it does for a few voxels; the ball's stands instead), "topology_unsure" (tunnels
    /// came out negative, because the label is in pieces or regions cross at edges; 0 stands instead),
    /// "diameter_clamped" (the sphere round the surface came out smaller than the ball of equal volume; the ball's
    /// stands instead), "sides_unclear" (what lies round the region is not of one level: no integral_volume_mm3),
    /// "larger_than_part" (the integral exceeds the part the region lies in).
    std::vector<std::string> flags;

    // What measure_surfaces() adds; NaN before.
    double surface_mesh_mm2 = k_unmeasured;       ///< of the region's mesh, by RegionTable::mesh_method
    double diameter_mm = k_unmeasured;            ///< of the smallest sphere round that mesh
    glm::dvec3 projected_area_mm2{k_unmeasured};  ///< of the voxels, onto the planes across the grid's x, y, z
    double integral_volume_mm3 = k_unmeasured;    ///< partial volumes summed: grey-value integration
    double surface_distance_mm = k_unmeasured;    ///< from its mesh to the part's outer surface, 0 where it reaches it
    double gap_mm = k_unmeasured;                 ///< from its mesh to the next region's; infinity if there is none
    double volume_lo_mm3 = k_unmeasured, volume_hi_mm3 = k_unmeasured;  ///< interval; of a threshold's regions alone
    double gap_lo_mm = k_unmeasured, gap_hi_mm = k_unmeasured;
};

struct RegionTable {
    LabelVolume labels;                       ///< ids 1..n as in rows
    std::vector<RegionCharacteristics> rows;  ///< ordered by id; ids by descending voxel count, ties by first voxel
    std::string surface_method;               ///< e.g. "Crofton, 13 directions, spacing-weighted"
    std::string adjacency;                    ///< e.g. "regions 26-connected, cavities 6-connected"
    std::string mesh_method;                  ///< of surface_mesh_mm2; empty before measure_surfaces()
    ValueRange value_range;                   ///< of the volume
    RegionOptions made_with;
};

/// Segments and measures. Deterministic for any number of threads. NaN and infinite voxels belong to no region.
/// Memory beyond the volume: 4 bytes a voxel for the labels, about 450 a region kept, and the front of the fill; within
/// 6 bytes a voxel while a region has 250 voxels on average. On noise, min_voxels keeps it there: 8 is a good choice,
/// as below that a region's uncertainty exceeds its size.
/// @throws Error(bad_usage) for options out of range, or more than 4 194 304 regions; Error(cancelled)
RegionTable find_regions(const Volume& volume, const RegionOptions& options, const JobContext& job = {});

/// Homogeneous regions without their measures: what structures and views are made from.
struct HomogeneousRegions {
    LabelVolume labels;        ///< ids 1..n as find_regions gives them
    std::vector<double> mean;  ///< of a region's values, by id; [0] unused
    ValueRange value_range;    ///< of the volume
};

/// The regions find_regions would measure. @pre options.range_width is set. Memory: 4 bytes a voxel.
/// @throws as find_regions
HomogeneousRegions grow_homogeneous_regions(const Volume& volume, const RegionOptions& options,
                                            const JobContext& job = {});

/// Measures regions already labelled (any ids; 0 is background); each label should be one connected region, or its
/// tunnels mean little. @throws Error(bad_input) if the grids differ
std::vector<RegionCharacteristics> measure_regions(const Volume& volume, const LabelVolume& labels,
                                                   Connectivity connectivity, const JobContext& job = {});

/// Fills what follows from each region's surface and the values round it: mesh area, sphere round it, projected areas,
/// sub-voxel volume, distance to the part's surface, gap. The part is the material, by the threshold that made the
/// regions where it cuts the values in two, by Otsu's else, with the voids in it; without one (all values equal) there
/// is no distance to its surface. Partial volumes count over three layers of voxels, between the median of a region's
/// core and the median of what lies round it (grown regions: their mean); a region too small for that takes those of
/// all values in and outside the threshold. Distances go from vertex to vertex; beyond a sixteenth of the volume's
/// voxels of them, every n-th stands for its neighbours. Deterministic for any number of threads. Cost: a walk through
/// each region's box, some 0.1 ms for a small one; memory 5 bytes a voxel and 40 a vertex.
/// @param table  as find_regions() gives it for this volume, or some of its rows and labels
/// @throws Error(bad_input) if the grids differ; Error(cancelled), the rows then in part measured
void measure_surfaces(const Volume& volume, RegionTable& table, const JobContext& job = {});

/// Areas of a region's shadow along the grid's x, y and z, mm^2. @pre the box lies in the labels
glm::dvec3 projected_areas_mm2(const LabelVolume& labels, std::uint32_t id, const glm::ivec3& bbox_first,
                               const glm::ivec3& bbox_last);

/// One closed, outward-oriented surface of a labelled region (marching cubes on its mask, padded), in mm.
TriangleMesh region_mesh(const LabelVolume& labels, const RegionCharacteristics& region, const JobContext& job = {});

/// The same with its vertices where the volume's values, taken as linear between voxels, leave the closed `range` that
/// made the region (RegionOptions::threshold); half way where they do not, as towards the frame.
/// @throws Error(bad_input) if the grids differ
TriangleMesh region_mesh(const Volume& volume, const ValueRange& range, const LabelVolume& labels,
                         const RegionCharacteristics& region, const JobContext& job = {});

/// The region as bytes over its box bbox_first..bbox_last (x fastest): 1 inside, 0 elsewhere.
/// @throws Error(bad_input) if the row's box does not lie in the labels
std::vector<std::uint8_t> region_mask(const LabelVolume& labels, const RegionCharacteristics& region);

/// {"surface_method", "surface_mesh_method", "adjacency", "value_range": [lo, hi], "count", "regions": [row, ...]}; a
/// row has the names of the struct's fields, in order, bbox_mm as [[min x, y, z], [max x, y, z]], then euler, flags,
/// surface_crofton_mm2 and what measure_surfaces() adds. What is not measured is null.
std::string regions_to_json(const RegionTable& table);

/// RFC 4180 with CRLF, dot decimals in every locale, digits that read back the same. Vectors stand in one field each
/// ("x y z"; bbox_mm as six numbers), and once more in a column a component behind the last row field; what
/// measure_surfaces() adds stands behind those.
std::string regions_to_csv(const RegionTable& table);

}  // namespace lacuna
