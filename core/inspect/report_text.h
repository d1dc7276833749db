#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/csv.h"
#include "core/base/number_text.h"
#include "core/inspect/report.h"

// What more than one of the report's files says, in one place.
namespace lacuna {

/// "12.3", four significant digits; "none" for infinity, "not measurable" for NaN.
std::string short_number(double value);
/// "12.3 [11.9, 12.8]".
std::string short_interval(const Measured& value);

struct Fact {
    std::string name, value;
};
std::vector<Fact> scan_facts(const InspectionReport& report);
std::vector<Fact> part_facts(const InspectionReport& report);

}  // namespace lacuna
