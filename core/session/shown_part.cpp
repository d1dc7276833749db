#include "core/session/shown_part.h"

namespace lacuna {

VolumePart shown_part(const ViewSettings& settings) {
    VolumePart part;
    for (const CutSetting& cut : settings.cuts)
        if (cut.enabled) part.half_spaces.push_back({cut.plane.normal, cut.plane.offset});
    for (const RangeSetting& range : settings.ranges)
        if (range.enabled) part.ranges.push_back(range.range.range);
    return part;
}

}  // namespace lacuna
