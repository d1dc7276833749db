#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace lacuna::dicom {

/// What PS3.15 Table E.1-1 (2024b), column "Basic Profile", has done to an attribute. Where the table leaves a choice
/// by the attribute's type in the object's definition, the names join what it allows.
enum class ProfileAction : std::uint8_t {
    keep,               ///< not in the table
    dummy,              ///< D: a value of the same kind that means nothing
    zero,               ///< Z: empty
    remove,             ///< X
    uid,                ///< U: another UID, the same for the same UID within an export
    zero_dummy,         ///< Z/D
    remove_zero,        ///< X/Z
    remove_dummy,       ///< X/D
    remove_zero_dummy,  ///< X/Z/D
    remove_uids         ///< X/Z/U*: a sequence of references, of which the UIDs are replaced
};

/// The action on one attribute; curves (group 50xx), overlays (60xx) and private groups are removed. Cost: a binary
/// search.
ProfileAction profile_action(std::uint16_t group, std::uint16_t element);

/// The table's rows by tag (group and element as one number), without the groups that are removed whole.
const std::vector<std::pair<std::uint32_t, ProfileAction>>& profile_table();

}  // namespace lacuna::dicom
