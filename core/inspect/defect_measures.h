#pragma once

#include "core/inspect/part_analysis.h"
#include "core/regions/point_tree.h"

/// How one defect is measured.
namespace lacuna::inspect {

/// What all defects of one kind share.
struct Surroundings {
    DefectType type = DefectType::void_;
    bool local = true;          ///< the threshold is set anew between the two sides of each boundary
    double threshold = 0;       ///< detection's, and of the surface where not local
    double defect_level = 0;    ///< grey level a defect has inside
    double material_level = 0;  ///< and of the material round it
    double noise = 0;
    double sigma_mm = 0;  ///< of the blur
    bool binary = false;  ///< edges as sharp as voxels: values tell nothing of where in a voxel the surface lies
};

/// Layers of voxels round a region that count as its boundary layer: what the blur spreads its edge over.
int boundary_layers(const Surroundings& s, const GridGeometry& geometry);

/// Fills what follows from the grey values round defect.id (its voxel measures stand already): threshold, volumes,
/// areas, diameters with their intervals, and grey statistics without NaN. Adds its surface's vertices to `points`
/// in mm from the volume's first voxel, tagged with its id.
void measure_by_values(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                       Defect& defect, std::vector<PointTree::Point>& points, const JobContext& job);

/// The surface at one threshold, restricted to the region and the layers of voxels that belong to it.
TriangleMesh surface_at(const Volume& volume, const LabelVolume& labels, const MaskVolume& part, const Surroundings& s,
                        std::uint32_t id, const glm::ivec3& bbox_first, const glm::ivec3& bbox_last, double threshold,
                        const JobContext& job);

/// Distance of each defect to the part's outer surface (its interval: both surfaces' shift) and to the next defect,
/// from surface to surface: `points` holds each defect's own surface vertices. The frame counts as surface where it
/// cuts the part.
void set_distances(const Volume& volume, const MaskVolume& part, double threshold, const Surroundings& s,
                   std::vector<Defect>& defects, const std::vector<std::vector<PointTree::Point>>& points,
                   const JobContext& job);

/// Expected number of clusters of `voxels` joined voxels (26 neighbours) among `trials` voxels of normal noise that lie
/// `depth` away from the level on average: trials * a^(n-1) * p^n, a = 35 bounding the growth of the number of shapes.
double expected_by_chance(std::int64_t voxels, double depth, double noise, double trials);

}  // namespace lacuna::inspect
