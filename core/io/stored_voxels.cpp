#include "core/io/stored_voxels.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/byte_order.h"
#include "core/io/random_access_file.h"

namespace lacuna {

namespace {

constexpr std::size_t k_piece = std::size_t(4) << 20;  // a multiple of every word's size

/// zlib's state for reading zlib and gzip streams.
class Inflater {
public:
    Inflater() {
        constexpr int k_zlib_or_gzip = 15 + 32;
        if (inflateInit2(&stream, k_zlib_or_gzip) != Z_OK)
            throw Error(Errc::out_of_memory, "Not enough memory to unpack.");
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    z_stream stream{};
};

void to_native(std::span<std::byte> bytes, const StoredVoxels& voxels, std::size_t word) {
    if (voxels.big_endian == (std::endian::native == std::endian::little)) swap_words(bytes, word);
}

[[noreturn]] void refuse_length(const std::filesystem::path& named, std::uint64_t need, std::uint64_t have) {
    throw Error(Errc::bad_input, "Cannot read " + named.string() + ": its voxels need " + std::to_string(need) +
                                     " bytes, but unpack to " + std::to_string(have) +
                                     "; the file is cut or its sizes are wrong.");
}

/// Unpacks to where the bytes belong; those before the first voxel and behind the last are thrown away.
void unpack(const std::filesystem::path& named, const StoredVoxels& voxels, std::span<std::byte> to,
            const JobContext& job) {
    const RandomAccessFile in(voxels.file);
    constexpr std::size_t k_input = std::size_t(256) << 10;
    std::vector<std::byte> input(k_input), beside(std::size_t(64) << 10);
    Inflater inflater;
    z_stream& z = inflater.stream;
    const std::uint64_t need = voxels.skip + voxels.bytes;
    std::uint64_t total = 0, at = voxels.offset;
    int code = Z_OK;
    for (bool ended = false; !ended;) {
        job.checkpoint(std::size_t(std::min(total, need)), std::size_t(need));
        if (z.avail_in == 0) {
            const std::size_t got = in.read(at, input);
            at += got;
            z.next_in = reinterpret_cast<Bytef*>(input.data());
            z.avail_in = uInt(got);
            if (got == 0) break;
        }
        if (code == Z_STREAM_END) inflateReset(&z);  // gzip allows several members in a row
        const bool inside = total >= voxels.skip && total < need;
        std::span<std::byte> here = beside;
        if (inside) here = to.subspan(std::size_t(total - voxels.skip));
        if (total < voxels.skip && voxels.skip - total < here.size()) here = here.first(voxels.skip - total);
        here = here.first(std::min(here.size(), k_piece));
        z.next_out = reinterpret_cast<Bytef*>(here.data());
        z.avail_out = uInt(here.size());
        code = inflate(&z, Z_NO_FLUSH);
        total += here.size() - z.avail_out;
        if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) break;
        ended = code == Z_STREAM_END && total >= need;
        if (total > need && !voxels.more_allowed) refuse_length(named, need, total);
    }
    if (code != Z_STREAM_END)
        throw Error(Errc::bad_input, "Cannot read " + named.string() +
                                         ": its compressed voxels are damaged or cut short after " +
                                         std::to_string(total) + " bytes.");
    if (total < need) refuse_length(named, need, total);
}

}  // namespace

void read_stored(const std::filesystem::path& named, const StoredVoxels& voxels, std::size_t word,
                 std::span<std::byte> to, const JobContext& job) {
    const auto pieces = std::int64_t((to.size() + k_piece - 1) / k_piece);
    const auto piece = [&](std::int64_t p) {
        const std::size_t from = std::size_t(p) * k_piece;
        return to.subspan(from, std::min(k_piece, to.size() - from));
    };
    if (voxels.packed) {
        unpack(named, voxels, to, job.part(0, 0.95));
        parallel_for(
            0, pieces, [&](std::int64_t p) { to_native(piece(p), voxels, word); }, job.part(0.95, 1));
        return;
    }
    const RandomAccessFile in(voxels.file);
    parallel_for(
        0, pieces,
        [&](std::int64_t p) {
            const std::span<std::byte> here = piece(p);
            if (in.read(voxels.offset + std::uint64_t(p) * k_piece, here) != here.size())
                throw Error(Errc::bad_input, "Cannot read " + named.string() + ": its voxels are cut short.");
            to_native(here, voxels, word);
        },
        job);
}

}  // namespace lacuna
