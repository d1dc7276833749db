#include "core/io/dicom_codestream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/io/random_access_file.h"

namespace lacuna::dicom {

namespace {

constexpr std::string_view k_rle = "1.2.840.10008.1.2.5", k_jpeg_2000 = "1.2.840.10008.1.2.4.9",
                           k_jpeg = "1.2.840.10008.1.2.4.";
constexpr std::uint32_t k_item = 0xE000FFFE;  // group and element as they lie in the file

struct Fragment {
    std::uint64_t offset = 0;
    std::uint32_t length = 0;
};

[[noreturn]] void refuse(const File& file, const std::string& fault) {
    throw Error(Errc::bad_input,
                "Cannot read the pixels of " + file.path.string() + ": " + fault + "; copy or export the file again.",
                file.path.string());
}

std::uint32_t little(const std::byte* at) {
    return std::uint32_t(at[0]) | std::uint32_t(at[1]) << 8 | std::uint32_t(at[2]) << 16 | std::uint32_t(at[3]) << 24;
}

std::uint32_t big(const std::byte* at, int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | std::uint32_t(at[i]);
    return value;
}

/// The items of the pixel sequence (PS3.5 A.4) behind the table of offsets.
std::vector<Fragment> fragments_of(const RandomAccessFile& bytes, const File& file) {
    std::vector<Fragment> found;
    std::array<std::byte, 8> head{};
    std::uint64_t at = file.pixel_offset;
    for (bool first = true; bytes.read(at, head) == head.size() && little(head.data()) == k_item; first = false) {
        const std::uint32_t length = little(head.data() + 4);
        if (length > bytes.bytes() - at - head.size()) refuse(file, "they are cut short");
        if (!first) found.push_back({at + head.size(), length});
        at += head.size() + length;
    }
    return found;
}

void require_size(const File& file, std::uint32_t columns, std::uint32_t rows) {
    const PixelFormat& format = file.pixels;
    // Zero: told elsewhere in the stream, which decoders do not follow.
    if ((columns == 0 || columns == std::uint32_t(format.columns)) && (rows == 0 || rows == std::uint32_t(format.rows)))
        return;
    refuse(file, fmt::format("they are of {} x {} pixels, but the header says {} x {}", columns, rows, format.columns,
                             format.rows));
}

/// Walks the markers to the frame header.
void check_jpeg(const RandomAccessFile& bytes, const File& file, const Fragment& fragment) {
    std::array<std::byte, 10> head{};
    if (bytes.read(fragment.offset, std::span(head).first(2)) != 2 || big(head.data(), 2) != 0xFFD8) return;
    std::uint64_t at = fragment.offset + 2;
    const std::uint64_t end = fragment.offset + fragment.length;
    while (at + 4 <= end) {
        const std::size_t got = bytes.read(at, head);
        if (got < 4 || head[0] != std::byte(0xFF)) break;
        const auto marker = std::uint32_t(head[1]);
        if (marker == 0xFF) {  // fill byte
            ++at;
            continue;
        }
        const bool frame =
            (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) || marker == 0xF7;
        if (frame) {
            if (got < head.size()) break;
            return require_size(file, big(head.data() + 7, 2), big(head.data() + 5, 2));
        }
        if (marker == 0xDA || marker == 0xD9) break;  // the picture itself
        at += 2 + big(head.data() + 2, 2);
    }
    refuse(file, "they have no frame header");
}

void check_jpeg_2000(const RandomAccessFile& bytes, const File& file, const Fragment& fragment) {
    constexpr std::size_t k_searched = 4096, k_siz = 45;  // a JP2 file's boxes may stand before the code stream
    std::vector<std::byte> head(std::min<std::size_t>(k_searched, fragment.length));
    head.resize(bytes.read(fragment.offset, head));
    static constexpr std::array k_start = {std::byte(0xFF), std::byte(0x4F), std::byte(0xFF), std::byte(0x51)};
    const auto found = std::search(head.begin(), head.end(), k_start.begin(), k_start.end());
    if (head.end() - found < std::ptrdiff_t(k_siz)) refuse(file, "they are no JPEG 2000 code stream");
    const std::byte* const siz = &*found + 4;  // Lsiz Rsiz Xsiz Ysiz XOsiz YOsiz XTsiz YTsiz XTOsiz YTOsiz Csiz ...
    const auto number = [&](int at) { return big(siz + at, 4); };
    const std::uint32_t right = number(4), lower = number(8), left = number(12), upper = number(16);
    if (left >= right || upper >= lower) refuse(file, "they are of no size");
    require_size(file, right - left, lower - upper);
    const int samples = int(big(siz + 36, 2)), bits = int(big(siz + 38, 1) & 0x7F) + 1;
    if (samples != file.pixels.samples || siz[39] != std::byte(1) || siz[40] != std::byte(1))
        refuse(file, fmt::format("they have {} samples a pixel, or coarser ones, but the header says {}", samples,
                                 file.pixels.samples));
    if (big(siz + 38, 1) > 0x7F && !file.pixels.is_signed)
        refuse(file, "they are signed numbers, but the header says unsigned");
    if (bits > file.pixels.bits_allocated)
        refuse(file, fmt::format("they are of {} bits, but the header allots {}", bits, file.pixels.bits_allocated));
}

/// Bytes that a PackBits segment unpacks to.
std::uint64_t unpacked_bytes(std::span<const std::byte> packed) {
    std::uint64_t total = 0;
    for (std::size_t at = 0; at < packed.size();) {
        const int head = int(std::int8_t(packed[at++]));
        if (head >= 0) {
            const std::size_t here = std::min<std::size_t>(std::size_t(head) + 1, packed.size() - at);
            total += here;
            at += here;
        } else if (head != -128 && at < packed.size()) {
            total += std::uint64_t(1 - head);
            ++at;
        }
    }
    return total;
}

void check_rle(const RandomAccessFile& bytes, const File& file, const Fragment& fragment) {
    constexpr std::size_t k_head = 64, k_most_segments = 15;
    std::vector<std::byte> packed(fragment.length);
    if (bytes.read(fragment.offset, packed) != packed.size() || packed.size() < k_head)
        refuse(file, "they are cut short");
    const std::uint32_t segments = little(packed.data());
    const auto wanted = std::uint32_t(file.pixels.bits_allocated / 8 * file.pixels.samples);
    if (segments != wanted || segments > k_most_segments)
        refuse(file, fmt::format("they are in {} RLE segments, but the header needs {}", segments, wanted));
    const auto pixels = std::uint64_t(file.pixels.pixels());
    for (std::uint32_t s = 0; s < segments; ++s) {
        const std::uint32_t from = little(&packed[4 + 4 * s]);
        const std::uint32_t to = s + 1 < segments ? little(&packed[8 + 4 * s]) : fragment.length;
        if (from < k_head || from > to || to > fragment.length) refuse(file, "their RLE header is damaged");
        const std::uint64_t have = unpacked_bytes(std::span(packed).subspan(from, to - from));
        // A byte or two more are the writer's padding to an even length.
        if (have < pixels || have > pixels + 2)
            refuse(file, fmt::format("an RLE segment unpacks to {} pixels, but the header says {} x {}", have,
                                     file.pixels.columns, file.pixels.rows));
    }
}

}  // namespace

void check_codestreams(const File& file) {
    const std::string_view syntax = file.syntax_uid;
    const bool rle = syntax == k_rle, jpeg_2000 = syntax.starts_with(k_jpeg_2000);
    if (!rle && !syntax.starts_with(k_jpeg)) return;
    const RandomAccessFile bytes(file.path);
    const std::vector<Fragment> fragments = fragments_of(bytes, file);
    if (fragments.empty()) refuse(file, "there are none");
    for (const Fragment& fragment : fragments) {
        if (rle) {
            check_rle(bytes, file, fragment);
        } else if (!jpeg_2000) {
            check_jpeg(bytes, file, fragment);  // a frame's further fragments do not start like a picture
        } else {
            check_jpeg_2000(bytes, file, fragment);
            if (fragments.size() != file.frames.size()) return;  // one frame in several: the first holds its header
        }
    }
}

}  // namespace lacuna::dicom
