#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna::cli {

/// Strict readers of a flag's text: the whole text must be what is asked for, decimal point whatever the locale, no
/// NaN, no infinity. All throw Error(bad_usage) naming the flag and the text.
double parse_number(std::string_view flag, std::string_view text);
std::int64_t parse_integer(std::string_view flag, std::string_view text, std::int64_t least, std::int64_t most);
/// Exactly `count` numbers separated by commas.
std::vector<double> parse_numbers(std::string_view flag, std::string_view text, std::size_t count);
/// LO,HI with LO <= HI.
ValueRange parse_range(std::string_view flag, std::string_view text);
/// "640x480", each side 1..16384.
glm::ivec2 parse_size(std::string_view flag, std::string_view text);

/// A range end: a number, or one of the words min, otsu, max, whose meaning only the volume's values give.
struct RangeEnd {
    enum class Kind { number, smallest, otsu, largest } kind = Kind::number;
    double number = 0;
    /// The value meant, for a volume with these statistics.
    double resolve(const VolumeStatistics& statistics) const;
};
/// LO,HI where each may also be min, otsu or max.
std::array<RangeEnd, 2> parse_word_range(std::string_view flag, std::string_view text);

/// @throws always: Error(bad_usage) "FLAG: TEXT is not WANTED."
[[noreturn]] void refuse(std::string_view flag, std::string_view text, std::string_view wanted);

/// Runs a reader of core and puts the flag's name before its complaint.
template <class Read>
auto for_flag(const std::string& flag, Read&& read) {
    try {
        return read();
    } catch (const Error& error) {
        if (error.code() != Errc::bad_usage) throw;
        throw Error(Errc::bad_usage, flag + ": " + error.what());
    }
}

}  // namespace lacuna::cli
