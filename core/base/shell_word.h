#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A word as a POSIX shell reads it back: bare where it holds nothing a shell looks at, else in single quotes.
std::string shell_word(std::string_view word);

}  // namespace lacuna
