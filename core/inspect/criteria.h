#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/inspect/part_analysis.h"
#include "core/volume/volume.h"

namespace lacuna {

/// The rules a part is judged by, in the manner of VDG/BDG P 203 (porosity of castings).
enum class Rule {
    porosity_percent,        ///< voids' share of the volume, at most
    defect_volume_mm3,       ///< of the largest defect, at most
    defect_diameter_mm,      ///< of the circumscribed sphere of the largest defect, at most
    count,                   ///< number of defects, at most
    min_gap_mm,              ///< between two defects, at least
    min_surface_distance_mm  ///< from a defect to the part's surface, at least
};
constexpr std::array k_rules{Rule::porosity_percent,   Rule::defect_volume_mm3,
                             Rule::defect_diameter_mm, Rule::count,
                             Rule::min_gap_mm,         Rule::min_surface_distance_mm};

/// The rule's key in the criteria, which ends in its unit.
std::string_view name_of(Rule rule);
/// "%", "mm3", "mm", or "" for a count.
std::string_view unit_of(Rule rule);
/// True where the limit is the largest value allowed, false where it is the smallest.
bool limits_from_above(Rule rule);

/// The limits of a part or a zone; a rule without a limit is not judged.
struct Limits {
    std::array<std::optional<double>, k_rules.size()> values{};

    std::optional<double>& operator[](Rule rule) { return values[std::size_t(rule)]; }
    const std::optional<double>& operator[](Rule rule) const { return values[std::size_t(rule)]; }
    bool empty() const;
    friend bool operator==(const Limits&, const Limits&) = default;
};

/// A piece of the part with limits of its own: a box, or the voxels a label volume marks.
struct Zone {
    std::string name;
    bool is_box = true;
    glm::dvec3 box_min_mm{0}, box_max_mm{0};
    std::filesystem::path labels;  ///< file of a label volume on the part's grid; absolute or as the criteria name it
    std::optional<std::uint32_t> label;  ///< which id of it; none: every voxel that is not 0
    Limits limits;
};

/// What `--criteria` says: material, defects, limits.
struct Criteria {
    DetectionOptions detection;
    Limits limits;
    std::vector<Zone> zones;
    std::string json;  ///< what was read, in a normal form: keys as given, no spaces
};

/// Reads the contract's criteria JSON (docs/schemas/criteria.schema.json).
/// @param folder  what relative names of label files count from
/// @throws Error(bad_input) naming the key: unknown or repeated keys, a missing unit, a wrong type, lo > hi, a negative
/// or non-finite limit, two zones of one name
Criteria parse_criteria(std::string_view json, const std::string& file_name, const std::filesystem::path& folder = {});
/// @throws as parse_criteria; Error(io)
Criteria read_criteria(const std::filesystem::path& file);
/// The criteria as JSON without spaces that parse_criteria reads back to the same.
/// @pre voids or inclusions are looked for
std::string criteria_to_json(const Criteria& criteria);

/// A zone laid over a part's grid, ready to be asked.
class ZoneMask {
public:
    /// Reads the label volume where the zone names one; boxes cost nothing. Call before any long work.
    /// @throws Error(bad_input) naming the zone: a box without a voxel of the volume, labels on another grid or without
    /// a voxel of the label asked for; what open_volume throws
    ZoneMask(const Zone& zone, const GridGeometry& geometry, const JobContext& job = {});

    bool contains(int x, int y, int z) const;
    /// Voxels outside lie in no zone: the box of voxels to look at, both ends included.
    glm::ivec3 first() const { return first_; }
    glm::ivec3 last() const { return last_; }
    /// True if the zone reaches beyond the volume, so that a piece of it was never seen.
    bool reaches_out() const { return reaches_out_; }

private:
    void lay_box(const Zone& zone);
    void read_labels(const Zone& zone, const JobContext& job);

    GridGeometry geometry_;
    bool is_box_ = true;
    glm::dvec3 min_{0}, max_{0};
    glm::ivec3 first_{0}, last_{0};
    bool reaches_out_ = false;
    std::vector<bool> inside_;  ///< over first_..last_, x fastest; empty for boxes
};

/// All zones of the criteria over a grid. @throws as ZoneMask
std::vector<ZoneMask> lay_zones(const Criteria& criteria, const GridGeometry& geometry, const JobContext& job = {});

}  // namespace lacuna
