#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/regions/label_volume.h"
#include "core/regions/point_tree.h"
#include "core/regions/run_components.h"

/// A volume parted into a part and what is round it, at one threshold, by runs of rows alone.
namespace lacuna::outline {

enum class Space : std::uint8_t {
    outside,  ///< air round the part: reaches an edge of the frame
    cut,      ///< inside the part's outline, but cut by a face of the frame
    closed    ///< out of reach of the frame
};

struct VoidScan {
    runs::RunList list;           ///< of all that is not material
    runs::Components components;  ///< of `list`
    std::vector<Space> kind;      ///< per component

    bool is_outside(std::size_t run) const { return kind[components.of_run[run]] == Space::outside; }
};

/// Whether material covers at least half of each face of the frame: then the part fills the frame and there is no
/// outside. Axes of one voxel have no faces.
bool fills_frame(const Volume& volume, double threshold);

/// All that is below the threshold (NaN included), as components; `filled`: from fills_frame.
/// A component that reaches one of the frame's twelve edges is air outside: a part inside its frame always leaves those
/// free. One that only meets faces is a void the frame cuts.
VoidScan scan_voids(const Volume& volume, double threshold, bool filled, Connectivity connectivity,
                    const JobContext& job);

/// The part at that threshold: all that is not outside, less loose specks (under a thousandth of the largest piece).
struct PartRuns {
    runs::RunList list;
    runs::Components components;      ///< 6-connected for 26-connected voids, 26 for 6 and 18
    std::vector<std::uint8_t> speck;  ///< per component: 1 for those left out
    std::int64_t voxels = 0;

    bool kept(std::size_t run) const { return !speck[components.of_run[run]]; }
};
PartRuns find_part(const VoidScan& scan, Connectivity connectivity, const JobContext& job);

/// The part as voxels.
struct PartMask {
    MaskVolume mask;               ///< 1 in the part, its voids included
    glm::ivec3 first{0}, last{0};  ///< the part's box, both included; last < first where there is no part
};
PartMask mask_of(const PartRuns& part, const GridGeometry& geometry);

/// Points of the part's outer surface, for nearest-neighbour queries: between each voxel of the part and its neighbour
/// outside, where the values pass the threshold, half way where they do not; where the frame cuts the part, the faces
/// of the voxels there; in mm from the first voxel, so that single precision does. At most a sixteenth of the volume's
/// voxels (100 000 at least): beyond that every n-th stands for its neighbours.
std::vector<PointTree::Point> outer_surface(const Volume& volume, const MaskVolume& part, double threshold,
                                            const JobContext& job);

/// Euler's number of closed and cut voids of at least `min_voxels`, rows taken as bits: per lattice row, the runs of
/// the union of its neighbours (closed cells, 18 and 26) or of their intersection (6), with alternating signs.
std::int64_t euler_of_voids(const VoidScan& scan, Connectivity connectivity, std::int64_t min_voxels);

}  // namespace lacuna::outline
