// What the names of raw files say of their content.
#include <fmt/format.h>

#include <array>
#include <regex>

#include "core/io/raw_guess.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace {

struct TypeWord {
    std::string_view word;
    std::optional<VoxelType> type;
    int bits = 0;
};

constexpr TypeWord k_type_words[] = {
    {"uint8", VoxelType::u8, 8},     {"u8", VoxelType::u8, 8},       {"uchar", VoxelType::u8, 8},
    {"byte", VoxelType::u8, 8},      {"ubyte", VoxelType::u8, 8},    {"int8", VoxelType::i8, 8},
    {"i8", VoxelType::i8, 8},        {"schar", VoxelType::i8, 8},    {"uint16", VoxelType::u16, 16},
    {"u16", VoxelType::u16, 16},     {"ushort", VoxelType::u16, 16}, {"int16", VoxelType::i16, 16},
    {"i16", VoxelType::i16, 16},     {"short", VoxelType::i16, 16},  {"float", VoxelType::f32, 32},
    {"float32", VoxelType::f32, 32}, {"f32", VoxelType::f32, 32},    {"real", VoxelType::f32, 32},
    {"8bit", std::nullopt, 8},       {"8bits", std::nullopt, 8},     {"16bit", std::nullopt, 16},
    {"16bits", std::nullopt, 16},    {"32bit", VoxelType::f32, 32},  {"32bits", VoxelType::f32, 32}};

void read_words(const std::string& name, RawNameHints& hints) {
    for (const std::string_view word : split(name, "_-. ()[]+,")) {
        for (const TypeWord& known : k_type_words)
            if (word == known.word) hints.type = known.type ? known.type : hints.type, hints.bits = known.bits;
        if (word == "le" || word == "little" || word == "lsb" || word == "littleendian" || word == "intel")
            hints.big_endian = false;
        if (word == "be" || word == "big" || word == "msb" || word == "bigendian" || word == "motorola")
            hints.big_endian = true;
    }
}

}  // namespace

RawNameHints raw_name_hints(std::string_view file_name) {
    RawNameHints hints;
    const std::string name = lower_case(file_name);
    read_words(name, hints);
    std::smatch found;
    static const std::regex k_spacing(R"((\d+\.\d+)x(\d+\.\d+)x(\d+\.\d+))");
    std::string rest = name;
    if (std::regex_search(name, found, k_spacing)) {
        glm::dvec3 spacing(0);
        for (int a = 0; a < 3; ++a) spacing[a] = number_in<double>(found[std::size_t(a) + 1].str()).value_or(0);
        if (spacing.x > 0 && spacing.y > 0 && spacing.z > 0) hints.spacing_mm = spacing;
        rest = found.prefix().str() + "_" + found.suffix().str();
    }
    static const std::regex k_three(R"((?:^|[^0-9.])(\d{1,6})x(\d{1,6})x(\d{1,6})(?![0-9]))");
    static const std::regex k_three_under(R"((?:^|[^0-9.])(\d{2,5})_(\d{2,5})_(\d{2,5})(?![0-9]))");
    static const std::regex k_two(R"((?:^|[^0-9.])(\d{2,6})x(\d{2,6})(?![0-9x]))");
    std::size_t axes = 3;
    if (!std::regex_search(rest, found, k_three) && !std::regex_search(rest, found, k_three_under)) {
        if (!std::regex_search(rest, found, k_two)) return hints;
        axes = 2;
    }
    for (std::size_t a = 0; a < axes; ++a) hints.size.push_back(std::stoi(found[a + 1].str()));
    if (std::find(hints.size.begin(), hints.size.end(), 0) != hints.size.end()) hints.size.clear();
    return hints;
}

std::string raw_text(const RawLayout& layout) {
    const glm::ivec3 n = layout.geometry.size;
    std::string text = fmt::format("{}x{}x{}:{}", n.x, n.y, n.z, name_of(layout.type));
    const glm::dvec3 s = layout.geometry.spacing;
    if (layout.spacing_known) text += fmt::format(":{},{},{}", s.x, s.y, s.z);
    if (layout.big_endian) text += ":be";
    if (layout.offset > 0) text += fmt::format(":+{}", layout.offset);
    return text;
}

}  // namespace lacuna
