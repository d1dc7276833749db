#pragma once

#include <cstdlib>
#include <filesystem>

namespace lacuna::test {

/// A path inside the folder of real data sets, or an empty path when the sets are not there.
inline std::filesystem::path real_data(const std::filesystem::path& relative) {
    const char* set = std::getenv("LACUNA_TEST_DATA");
    const std::filesystem::path root =
        set ? std::filesystem::path(set) : std::filesystem::path(LACUNA_SOURCE_DIR) / ".." / "shared" / "data";
    std::error_code ec;
    return std::filesystem::exists(root / relative, ec) ? root / relative : std::filesystem::path();
}

}  // namespace lacuna::test

/// Skips the test, saying so, when a real data set is missing.
#define LACUNA_NEEDS_DATA(variable, relative)                              \
    const std::filesystem::path variable = ::lacuna::test::real_data(relative); \
    if (variable.empty()) GTEST_SKIP() << "skipped: real data set " << (relative) << " is not there (LACUNA_TEST_DATA)"
