#include "core/io/compressed_check.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#include "core/base/error.h"

namespace lacuna {

namespace {

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

}  // namespace

void check_compressed(const std::filesystem::path& named, const CompressedData& data, const JobContext& job) {
    std::ifstream in(data.file, std::ios::binary);
    if (!in) throw Error(Errc::io, "Cannot read " + data.file.string() + ": " + std::strerror(errno) + ".");
    in.seekg(std::streamoff(data.offset));
    constexpr std::size_t k_input = std::size_t(256) << 10, k_output = std::size_t(1) << 20;
    std::vector<char> input(k_input), output(k_output);
    Inflater inflater;
    z_stream& z = inflater.stream;
    std::uint64_t total = 0;
    int code = Z_OK;
    const auto unpacked_all = [&] { return data.need && total >= *data.need; };
    for (bool ended = false; !ended;) {
        if (z.avail_in == 0) {
            job.check();
            in.read(input.data(), std::streamsize(k_input));
            z.next_in = reinterpret_cast<Bytef*>(input.data());
            z.avail_in = uInt(in.gcount());
            if (z.avail_in == 0) break;
        }
        if (code == Z_STREAM_END) inflateReset(&z);  // gzip allows several members in a row
        z.next_out = reinterpret_cast<Bytef*>(output.data());
        z.avail_out = uInt(k_output);
        code = inflate(&z, Z_NO_FLUSH);
        total += k_output - z.avail_out;
        if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) break;
        ended = code == Z_STREAM_END && (unpacked_all() || !data.need);
    }
    if (code != Z_STREAM_END)
        throw Error(Errc::bad_input, "Cannot read " + named.string() +
                                         ": its compressed voxels are damaged or cut short after " +
                                         std::to_string(total) + " bytes.");
    if (data.need && (total < *data.need || (total > *data.need && !data.more_allowed)))
        throw Error(Errc::bad_input, "Cannot read " + named.string() + ": its voxels need " +
                                         std::to_string(*data.need) + " bytes, but unpack to " + std::to_string(total) +
                                         "; the file is cut or its sizes are wrong.");
}

}  // namespace lacuna
