#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Makes a Cairo SVG fit to stand inside a page beside others: its ids, which Cairo numbers from a counter of the
/// process, become a prefix of the content's own and a running number (so equal drawings are equal bytes and no two
/// share an id), the XML declaration goes, and a title for readers that cannot see comes in.
std::string inline_svg(std::string_view svg, std::string_view title);

/// The text with everything that is not UTF-8, and control characters other than tab and newline, replaced by "?".
std::string valid_utf8(std::string_view text);

/// The text with & < > and quotes escaped for XML.
std::string xml_escaped(std::string_view text);

}  // namespace lacuna
