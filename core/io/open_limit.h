#pragma once

#include <cstdint>

#include "core/io/volume_reader.h"

namespace lacuna {

/// open_volume, but what its header says is larger than `most_bytes` is refused before its voxels are read.
/// @throws as open_volume; Error(out_of_memory) naming both numbers
Volume open_volume_within(const std::string& input, const OpenOptions& options, std::uint64_t most_bytes,
                          const JobContext& job = {});

}  // namespace lacuna
