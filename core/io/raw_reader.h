#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// What a headerless file of voxels holds and where.
struct RawLayout {
    std::filesystem::path file;
    GridGeometry geometry;
    VoxelType type = VoxelType::u8;
    bool big_endian = false;
    std::uint64_t offset = 0;    ///< bytes before the first voxel
    bool spacing_known = false;  ///< false: 1 mm is assumed, and the volume says so
    bool exact_size = true;      ///< false: bytes behind the last voxel are allowed
};

/// Parses `WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET]` (TYPE: u8 i8 u16 i16 f32; spacing in mm).
/// @throws Error(bad_usage) naming the faulty part
RawLayout parse_raw_text(std::string_view text);

/// Reads size and type out of a file name like `engine_256x256x128_uint8.raw`, if they are there.
std::optional<RawLayout> raw_layout_of_name(const std::filesystem::path& file);

/// Reads the sidecar of a raw file: `.dat` (volvis) or `.vgi`. `file` of the result is the data file it names.
/// @throws Error(bad_input) naming the faulty line; Error(unsupported)
RawLayout read_dat(const std::filesystem::path& sidecar);
RawLayout read_vgi(const std::filesystem::path& sidecar);

/// Multiplies with overflow caught: voxels * bytes of a claimed size.
/// @throws Error(bad_input) naming `what` if an axis is < 1 or the product exceeds 2^62
std::uint64_t checked_bytes(const std::string& what, std::int64_t x, std::int64_t y, std::int64_t z,
                            std::uint64_t bytes_per_voxel);

/// Reads the voxels straight into the volume's memory, in parallel chunks, swapping big-endian ones.
/// @throws Error(bad_input) with both byte counts if the file's size does not match; Error(io); Error(cancelled)
Volume read_raw(const RawLayout& layout, const JobContext& job = {});

/// The same volume with its voxels left in the file, where boxes are read from as they are asked for. The file stays
/// open as long as the volume lives. @throws as read_raw
Volume open_raw(const RawLayout& layout);

}  // namespace lacuna
