#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/job.h"

namespace lacuna {

/// A zlib or gzip stream inside a file.
struct CompressedData {
    std::filesystem::path file;
    std::uint64_t offset = 0;             ///< bytes before the stream
    std::optional<std::uint64_t> need{};  ///< bytes it must unpack to; absent: unknown
    bool more_allowed = false;            ///< bytes behind those needed are no fault
};

/// Unpacks the stream and checks length and checksum, keeping nothing: the image libraries fill up what is missing with
/// zeros without a word. Costs one pass of decompression on one thread.
/// @throws Error(bad_input) naming `named` and the fault; Error(io); Error(cancelled)
void check_compressed(const std::filesystem::path& named, const CompressedData& data, const JobContext& job = {});

}  // namespace lacuna
