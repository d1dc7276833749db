#include "core/io/output_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace lacuna {

OutputFile::OutputFile(const std::filesystem::path& target) : target_(target), file_(target) {
    fd_ = ::open(file_.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
    if (fd_ >= 0) ::close(fd_);
}

void OutputFile::fail(int code) const { throw_cannot_write(target_, code); }

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) fail(n == 0 ? EIO : errno);
        bytes = bytes.subspan(std::size_t(n));
    }
}

void OutputFile::commit() {
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0) fail(errno);
    file_.commit();
}

void write_plain(OutputFile& file, std::span<const std::byte> bytes, const JobContext& job) {
    constexpr std::size_t k_piece = std::size_t(4) << 20;
    for (std::size_t at = 0; at < bytes.size(); at += k_piece) {
        const std::size_t size = std::min(k_piece, bytes.size() - at);
        file.write(bytes.subspan(at, size));
        job.checkpoint(at + size, bytes.size());
    }
    job.check();  // the last moment at which a stop leaves nothing behind
}

namespace {

constexpr std::size_t k_chunk = std::size_t(2) << 20;
constexpr int k_level = 2;  // CT compresses hardly better at higher levels, but several times slower

struct Chunk {
    std::vector<std::byte> packed;
    uLong crc = 0;
    std::size_t size = 0;
};

Chunk deflate_chunk(std::span<const std::byte> bytes, bool last) {
    Chunk chunk;
    chunk.size = bytes.size();
    auto* source = reinterpret_cast<const Bytef*>(bytes.data());
    chunk.crc = crc32(0, source, uInt(bytes.size()));
    z_stream stream{};
    constexpr int k_raw_deflate = -15;
    if (deflateInit2(&stream, k_level, Z_DEFLATED, k_raw_deflate, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw Error(Errc::out_of_memory, "Not enough memory to compress.");
    chunk.packed.resize(deflateBound(&stream, uLong(bytes.size())) + 16);
    stream.next_in = const_cast<Bytef*>(source);
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(chunk.packed.data());
    stream.avail_out = uInt(chunk.packed.size());
    const int code = deflate(&stream, last ? Z_FINISH : Z_SYNC_FLUSH);
    const bool done = (code == Z_STREAM_END || (code == Z_OK && !last)) && stream.avail_in == 0;
    chunk.packed.resize(chunk.packed.size() - stream.avail_out);
    deflateEnd(&stream);
    if (!done) throw Error(Errc::io, "Compression failed.");
    return chunk;
}

}  // namespace

void write_gzip(OutputFile& file, std::span<const std::byte> head, std::span<const std::byte> bytes,
                const JobContext& job) {
    static constexpr unsigned char k_member[10] = {0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3};
    file.write(std::as_bytes(std::span(k_member)));
    uLong crc = crc32(0, nullptr, 0);
    std::uint64_t total = 0;
    const auto put = [&](const Chunk& chunk) {
        file.write(chunk.packed);
        crc = crc32_combine(crc, chunk.crc, z_off_t(chunk.size));
        total += chunk.size;
    };
    if (!head.empty()) put(deflate_chunk(head, false));
    const auto count = std::int64_t((bytes.size() + k_chunk - 1) / k_chunk);
    const std::int64_t batch = 4 * std::int64_t(thread_count());  // bounds the memory of packed chunks
    for (std::int64_t first = 0; first < count; first += batch) {
        const std::int64_t end = std::min(count, first + batch);
        std::vector<Chunk> chunks(std::size_t(end - first));
        parallel_for(first, end,
                     [&](std::int64_t c) {
                         const std::size_t at = std::size_t(c) * k_chunk;
                         chunks[std::size_t(c - first)] =
                             deflate_chunk(bytes.subspan(at, std::min(k_chunk, bytes.size() - at)), c + 1 == count);
                     },
                     {job.stop, nullptr});
        for (const Chunk& chunk : chunks) put(chunk);
        job.checkpoint(std::size_t(end), std::size_t(count));
    }
    if (count == 0) put(deflate_chunk({}, true));
    unsigned char tail[8];
    for (int i = 0; i < 4; ++i) {
        tail[i] = static_cast<unsigned char>(crc >> (8 * i));
        tail[4 + i] = static_cast<unsigned char>(total >> (8 * i));
    }
    file.write(std::as_bytes(std::span(tail)));
    job.check();
}

}  // namespace lacuna
