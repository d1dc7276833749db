#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/inspect/measured.h"
#include "core/regions/label_volume.h"
#include "core/regions/regions.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

/// How the value that parts two sides is found: Otsu's threshold of the whole volume (moved onto the stable plateau of
/// the stability curve), a value given, or locally at the 50 % level between the two sides of each boundary.
enum class ThresholdMethod { otsu, fixed, local };
enum class DefectType { void_, inclusion };

std::string_view name_of(ThresholdMethod method);  ///< "otsu", "fixed", "local"
/// @throws Error(bad_usage) listing the known words
ThresholdMethod parse_threshold_method(std::string_view text);
std::string_view name_of(DefectType type);  ///< "void", "inclusion"

/// Below this many voxels a defect's size is less certain than it is large.
inline constexpr std::int64_t k_measurable_voxels = 8;

/// What is a part's material and what counts as a defect in it.
struct DetectionOptions {
    std::optional<ValueRange> material;     ///< closed range of the material's values; none: found by Otsu
    bool voids = true;                      ///< look for voids ...
    std::optional<double> void_below;       ///< ... of values below this; none: found
    bool inclusions = false;                ///< look for inclusions ...
    std::optional<double> inclusion_above;  ///< ... of values above this; none: found
    ThresholdMethod method = ThresholdMethod::local;
    /// Smaller finds are no defects; up to k_measurable_voxels, finds between the detection limit and that many voxels
    /// are listed too, as detected but not measurable.
    std::int64_t min_voxels = 8;
    Connectivity connectivity = Connectivity::c26;  ///< of defects
};

/// One row of the defect table. Lengths in mm, values in the volume's unit.
struct Defect {
    std::uint32_t id = 0;  ///< 1..n by descending volume; the label in PartAnalysis::labels
    DefectType type = DefectType::void_;
    std::int64_t voxels = 0;
    /// Sub-voxel: inside the surface at `threshold`. The interval spans that volume at thresholds +-10 % of the
    /// contrast away, the grey-value integral (what a blurred defect had before the blur) and the grid's rounding.
    /// Where the defect is small against the blur and so shallow, also the volume inside half of the full contrast.
    Measured volume_mm3;
    double voxel_volume_mm3 = 0;     ///< voxels times the volume of one
    double integral_volume_mm3 = 0;  ///< grey-value integration over the boundary layer: partial volumes summed
    double threshold = 0;            ///< the value its surface lies at
    glm::dvec3 centroid_mm{0};
    glm::dvec3 bbox_min_mm{0}, bbox_max_mm{0};
    glm::ivec3 bbox_first{0}, bbox_last{0};  ///< in voxels, both included
    Measured diameter_mm;                    ///< of the circumscribed sphere
    Measured equivalent_diameter_mm;         ///< of the ball of equal volume
    glm::dvec3 principal_lengths_mm{0};      ///< longest first
    /// Of its surface: by marching cubes, or Crofton where values are binary. The upper end also holds what edges as
    /// sharp as a box's have lost to the blur and to the chamfer of marching cubes.
    Measured area_mm2;
    double surface_crofton_mm2 = 0, surface_mesh_mm2 = 0;
    double sphericity = 0, shape_factor = 0;
    Measured surface_distance_mm;      ///< to the part's outer surface
    double gap_mm = 0;                 ///< to the next defect; infinity when there is none
    glm::dvec3 projected_area_mm2{0};  ///< onto the planes across x, y, z
    double mean = 0, min = 0, max = 0, stddev = 0;
    std::int64_t euler = 0, cavities = 0, tunnels = 0;
    double probability = 0;  ///< that it is a defect and no artefact of noise, 0..1
    bool measurable = true;  ///< false: detected, but too small for its size to mean anything
    bool touches_border = false;
    std::vector<std::string> flags;  ///< values corrected or not to be trusted, and why (short words, as in regions)
};

/// Porosity and defect count against the threshold.
struct StabilityCurve {
    std::vector<double> threshold, porosity_percent, count, euler;  ///< of equal length, ascending threshold
    ValueRange plateau{0, 0};  ///< thresholds between which porosity hardly changes; lo > hi: there is none
};

/// What is known of the part as a whole.
struct PartFacts {
    double material_threshold = 0;              ///< material is at or above
    double void_level = 0, material_level = 0;  ///< grey levels of the two sides (modes)
    double noise = 0;                           ///< standard deviation within the material
    double edge_width_mm = 0;                   ///< sigma of the blur, estimated from the surface's edges
    Measured part_volume_mm3;                   ///< material and voids
    double material_volume_mm3 = 0;
    Measured porosity_percent;  ///< voids' share of the part's volume
    glm::dvec3 bbox_min_mm{0}, bbox_max_mm{0};
    bool has_material = false;
    bool cut_by_frame = false;          ///< material touches the volume's border
    std::vector<std::string> warnings;  ///< sentences
};

/// A part measured: the data model of reports, series and the window's inspection panel.
struct PartAnalysis {
    DetectionOptions options;  ///< as asked
    PartFacts part;
    std::vector<Defect> defects;  ///< by id
    LabelVolume labels;           ///< id per voxel
    MaskVolume part_mask;         ///< 1 in the part (its closed voids included), 0 outside
    StabilityCurve stability;
    std::string surface_method, adjacency;  ///< as in RegionTable
};

/// One closed, outward-oriented surface of a defect, in mm: vertices where the values pass Defect::threshold by linear
/// interpolation, then all moved outwards by the same small length (half a voxel at most), so that it encloses the
/// volume of the defect's row and not the one its flat triangles cut off. @throws Error(bad_usage) for an id that is
/// not there; Error(cancelled)
TriangleMesh defect_mesh(const Volume& volume, const PartAnalysis& analysis, std::uint32_t id,
                         const JobContext& job = {});

/// Finds and measures the defects of a part. Deterministic for any number of threads. A volume without material or of
/// one value gives an analysis that says so in part.warnings, with no defects.
/// Memory beyond the volume: at most 8 bytes a voxel.
/// @throws Error(bad_usage) for options out of range; Error(cancelled)
PartAnalysis analyse_part(const Volume& volume, const DetectionOptions& options, const JobContext& job = {});

}  // namespace lacuna
