#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/accel/distance_field.h"
#include "core/base/job.h"
#include "shared/ray_params.h"

namespace lacuna {

/// The octants that rays of the picture run into, as gather_distance() of skip_distance.clh counts them.
/// @param margin_px  pixels beyond the picture that may be cast too
OctantSet octants_of_rays(const RayParams& rays, int margin_px);

/// Where the rays of each packet of 4x4 pixels can meet cells that may show something: the bounding polyhedra of Avila,
/// Sobierajski & Kaufman (Towards a comprehensive volume visualization system, 1992), here the cells' boxes, of which
/// those suffice through which a ray can come in or leave. Packets that meet none need no ray, the others none of the
/// way before the first and behind the last.
class PacketSpans {
public:
    /// Finds the cells that are not of region 1 and border on one that is, or on the outside. Where they are many,
    /// blocks of cells stand for them.
    void hold(const RegionGrid& grid, int shift);

    /// For each packet, x fastest, the nearest and the farthest ray parameter (mm from where rays start) at which one
    /// of its rays can be in such a cell; (inf, -inf) where none can. With the eye in or beside a cell every packet
    /// gets all of its way.
    /// @param packets  an axis. Cost: some 30 ns a cell, on all threads
    void project(const RayParams& rays, glm::ivec2 packets, glm::vec2* spans) const;

    std::size_t cells() const { return cells_.size(); }

private:
    using Place = glm::vec<3, std::uint16_t>;
    std::vector<Place> cells_;
    int edge_ = 8;  ///< voxels
};

}  // namespace lacuna
