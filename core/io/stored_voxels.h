#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/job.h"

namespace lacuna {

/// Number types that voxels are stored as in files; wider ones than a volume holds among them.
enum class StoredType { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

constexpr std::size_t size_of(StoredType type) {
    switch (type) {
        case StoredType::u8:
        case StoredType::i8:
            return 1;
        case StoredType::u16:
        case StoredType::i16:
            return 2;
        case StoredType::u32:
        case StoredType::i32:
        case StoredType::f32:
            return 4;
        case StoredType::u64:
        case StoredType::i64:
        case StoredType::f64:
            break;
    }
    return 8;
}

/// Where a volume's voxels lie: in one file, as they are or in a zlib or gzip stream.
struct StoredVoxels {
    std::filesystem::path file;
    std::uint64_t offset = 0;   ///< bytes before the first voxel, or before the stream
    std::uint64_t skip = 0;     ///< of a stream: unpacked bytes before the first voxel
    std::uint64_t bytes = 0;    ///< of all voxels
    bool packed = false;        ///< in a stream
    bool more_allowed = false;  ///< bytes behind the last voxel in the stream are no fault
    bool big_endian = false;
};

/// Reads all voxels into `to`, in the machine's byte order. Plain ones by all threads; a stream by one, its length and
/// checksum compared: the image libraries fill up what is missing with zeros without a word.
/// @param named  the file a person opened, for messages
/// @pre to.size() == voxels.bytes
/// @throws Error(bad_input) naming `named` and the fault; Error(io); Error(cancelled)
void read_stored(const std::filesystem::path& named, const StoredVoxels& voxels, std::size_t word,
                 std::span<std::byte> to, const JobContext& job = {});

}  // namespace lacuna
