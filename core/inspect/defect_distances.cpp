#include <algorithm>

#include "core/inspect/defect_measures.h"
#include "core/regions/part_outline.h"
#include "core/regions/separation.h"

namespace lacuna::inspect {

void set_distances(const Volume& volume, const MaskVolume& part, double threshold, const Surroundings& s,
                   std::vector<Defect>& defects, const std::vector<std::vector<PointTree::Point>>& points,
                   const JobContext& job) {
    if (defects.empty()) return;
    const PointTree surface(outline::outer_surface(volume, part, threshold, job.part(0, 0.2)));
    const std::vector<Separation> apart = separations(surface, points, job.part(0.2, 1));
    const glm::dvec3 h = volume.geometry().spacing;
    const double coarsest = std::max({h.x, h.y, h.z});
    // Both surfaces move by the threshold's shift (a quarter of sigma for 10 %) and by the grid's rounding.
    const double margin = s.binary ? 0.5 * coarsest : 2 * 0.2533 * s.sigma_mm + 0.1 * coarsest;
    for (std::size_t i = 0; i < defects.size(); ++i) {
        const double to_surface = defects[i].touches_border ? 0 : apart[i].to_surface_mm;
        defects[i].surface_distance_mm = {to_surface, std::max(0.0, to_surface - margin), to_surface + margin};
        defects[i].gap_mm = apart[i].gap_mm;
    }
}

}  // namespace lacuna::inspect
