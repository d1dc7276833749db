#include "core/io/raw_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <regex>
#include <system_error>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/byte_order.h"
#include "core/io/random_access_file.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_raw_form = "WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET], for example 256x256x128:u16:0.5,0.5,1";

[[noreturn]] void refuse_raw_text(std::string_view text, const std::string& fault) {
    throw Error(Errc::bad_usage, "The raw description '" + std::string(text) + "' is wrong: " + fault + "; write " +
                                     std::string(k_raw_form) + ".");
}

std::optional<VoxelType> type_named(std::string_view name) {
    for (const VoxelType t : {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32})
        if (name == name_of(t)) return t;
    return std::nullopt;
}

void parse_dims(std::string_view text, std::string_view part, RawLayout& layout) {
    const auto dims = numbers_in<std::int64_t>(part, "x");
    if (!dims || dims->size() != 3 || std::count(part.begin(), part.end(), 'x') != 2)
        refuse_raw_text(text, "'" + std::string(part) + "' is not a size WxHxD");
    for (int a = 0; a < 3; ++a) {
        const std::int64_t n = (*dims)[std::size_t(a)];
        if (n < 1 || n > INT32_MAX) refuse_raw_text(text, "the size " + std::to_string(n) + " is out of range");
        layout.geometry.size[a] = int(n);
    }
}

void parse_spacing(std::string_view text, std::string_view part, RawLayout& layout) {
    const auto spacing = numbers_in<double>(part, ",");
    if (!spacing || spacing->size() != 3)
        refuse_raw_text(text, "'" + std::string(part) + "' is neither a spacing SX,SY,SZ nor be nor +OFFSET");
    for (int a = 0; a < 3; ++a) {
        const double s = (*spacing)[std::size_t(a)];
        if (!(s > 0 && std::isfinite(s)))
            refuse_raw_text(text, "the spacing '" + std::string(part) + "' must be positive numbers in mm");
        layout.geometry.spacing[a] = s;
    }
    layout.spacing_known = true;
}

}  // namespace

RawLayout parse_raw_text(std::string_view text) {
    const auto parts = split(text, ":");
    if (parts.size() < 2) refuse_raw_text(text, "size or type is missing");
    RawLayout layout;
    parse_dims(text, parts[0], layout);
    const auto type = type_named(parts[1]);
    if (!type) refuse_raw_text(text, "the type '" + std::string(parts[1]) + "' is none of u8 i8 u16 i16 f32");
    layout.type = *type;
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const std::string_view part = parts[i];
        if (part == "be") {
            layout.big_endian = true;
        } else if (part == "le") {
            layout.big_endian = false;
        } else if (part.front() == '+') {
            const auto offset = number_in<std::uint64_t>(part.substr(1));
            if (!offset) refuse_raw_text(text, "the offset '" + std::string(part) + "' is not +BYTES");
            layout.offset = *offset;
        } else {
            parse_spacing(text, part, layout);
        }
    }
    return layout;
}

std::optional<RawLayout> raw_layout_of_name(const fs::path& file) {
    static const std::regex k_pattern(
        R"((?:^|[^0-9])(\d{1,7})x(\d{1,7})x(\d{1,7})[_.\-](uint8|int8|uint16|int16|float32|float|u8|i8|u16|i16|f32)(?:_(le|be))?(?:[^a-z0-9]|$))",
        std::regex::icase);
    const std::string name = file.filename().string();
    std::smatch found;
    if (!std::regex_search(name, found, k_pattern)) return std::nullopt;
    static const std::pair<std::string_view, VoxelType> k_types[] = {
        {"uint8", VoxelType::u8},  {"int8", VoxelType::i8},     {"uint16", VoxelType::u16},
        {"int16", VoxelType::i16}, {"float32", VoxelType::f32}, {"float", VoxelType::f32}};
    RawLayout layout;
    layout.file = file;
    for (int a = 0; a < 3; ++a) layout.geometry.size[a] = std::stoi(found[std::size_t(a) + 1].str());
    const std::string type = lower_case(found[4].str());
    for (const auto& [word, t] : k_types)
        if (type == word) layout.type = t;
    if (const auto named = type_named(type)) layout.type = *named;
    layout.big_endian = lower_case(found[5].str()) == "be";
    return layout;
}

std::uint64_t checked_bytes(const std::string& what, std::int64_t x, std::int64_t y, std::int64_t z,
                            std::uint64_t bytes_per_voxel) {
    for (const std::int64_t n : {x, y, z})
        if (n < 1 || n > INT32_MAX)
            throw Error(Errc::bad_input,
                        what + " claims an axis of " + std::to_string(n) + " voxels; an axis needs 1 to 2147483647.");
    std::uint64_t total = bytes_per_voxel;
    for (const std::int64_t n : {x, y, z})
        if (__builtin_mul_overflow(total, std::uint64_t(n), &total) || total > (std::uint64_t(1) << 62))
            throw Error(Errc::bad_input, what + " claims " + std::to_string(x) + "x" + std::to_string(y) + "x" +
                                             std::to_string(z) + " voxels, more than any memory holds.");
    return total;
}

namespace {

/// Bytes of the voxels. @throws Error(bad_input) where the file has more or fewer
std::uint64_t checked_file(const RawLayout& layout) {
    const std::string name = layout.file.string();
    const glm::ivec3 n = layout.geometry.size;
    const std::size_t word = size_of(layout.type);
    const std::uint64_t bytes = checked_bytes(name, n.x, n.y, n.z, word);
    std::error_code ec;
    const std::uint64_t have = fs::file_size(layout.file, ec);
    if (ec) throw Error(Errc::io, "Cannot read " + name + ": " + ec.message() + ".");
    std::uint64_t need = 0;
    if (__builtin_add_overflow(bytes, layout.offset, &need))
        throw Error(Errc::bad_input, name + " cannot hold an offset of " + std::to_string(layout.offset) + " bytes.");
    if (layout.exact_size ? have != need : have < need)
        throw Error(Errc::bad_input, name + " has " + std::to_string(have) + " bytes, but " + std::to_string(n.x) +
                                         "x" + std::to_string(n.y) + "x" + std::to_string(n.z) + " voxels of " +
                                         std::string(name_of(layout.type)) +
                                         (layout.offset ? " behind the offset" : "") + " need " + std::to_string(need) +
                                         " bytes; check the size, the type and the offset.");
    return bytes;
}

bool must_swap(const RawLayout& layout) { return layout.big_endian == (std::endian::native == std::endian::little); }

Volume described(Volume volume, const RawLayout& layout) {
    volume.name = layout.file.filename().string();
    if (!layout.spacing_known)
        volume.warnings.push_back({"The voxel spacing is not stated; 1 x 1 x 1 mm is assumed.", 0});
    return volume;
}

class RawFileSource final : public VoxelSource {
public:
    explicit RawFileSource(const RawLayout& layout) : layout_(layout), file_(layout.file) {}

    void read(const VoxelBox& box, std::byte* out, const JobContext& job) const override {
        const std::size_t word = size_of(layout_.type), row = std::size_t(box.size.x) * word;
        const std::size_t slice = row * std::size_t(box.size.y);
        const bool whole_rows = box.size.x == layout_.geometry.size.x;  // then a slice's rows lie together
        parallel_for(
            0, box.size.z,
            [&](std::int64_t z) {
                std::byte* const to = out + std::size_t(z) * slice;
                for (int y = 0; y < (whole_rows ? 1 : box.size.y); ++y) {
                    const std::int64_t at =
                        layout_.geometry.linear_index(box.first.x, box.first.y + y, box.first.z + int(z));
                    file_.read_all(layout_.offset + std::uint64_t(at) * word,
                                   {to + std::size_t(y) * row, whole_rows ? slice : row});
                }
                if (must_swap(layout_)) swap_words({to, slice}, word);
            },
            job);
    }

private:
    RawLayout layout_;
    RandomAccessFile file_;
};

}  // namespace

Volume open_raw(const RawLayout& layout) {
    checked_file(layout);
    return described(Volume(layout.geometry, layout.type, std::make_shared<const RawFileSource>(layout)), layout);
}

Volume read_raw(const RawLayout& layout, const JobContext& job) {
    const std::uint64_t bytes = checked_file(layout);
    const std::size_t word = size_of(layout.type);
    VoxelBuffer voxels{std::size_t(bytes)};
    const RandomAccessFile file(layout.file);
    constexpr std::uint64_t k_chunk = std::uint64_t(8) << 20;  // a multiple of every word size
    parallel_for(
        0, std::int64_t((bytes + k_chunk - 1) / k_chunk),
        [&](std::int64_t c) {
            const std::uint64_t from = std::uint64_t(c) * k_chunk;
            const std::size_t size = std::size_t(std::min(k_chunk, bytes - from));
            const std::span<std::byte> piece(voxels.data() + from, size);
            file.read_all(layout.offset + from, piece);
            if (must_swap(layout)) swap_words(piece, word);
        },
        job);
    return described(Volume(layout.geometry, layout.type, std::move(voxels)), layout);
}

}  // namespace lacuna
