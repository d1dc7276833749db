#include "core/io/raw_guess.h"
#include "core/io/plain_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "../../support/test_data.h"
#include "core/io/open_limit.h"
#include "core/volume/samples.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

/// A volume's values as they would lie in a file of another type, its range brought to [lo, hi].
std::string stored(const Volume& volume, VoxelType type, bool big_endian, double lo, double hi) {
    const glm::ivec3 n = volume.geometry().size;
    std::vector<double> values;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) values.push_back(volume.value(x, y, z));
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double from = *least, scale = (hi - lo) / (*most - *least);
    std::string bytes;
    visit_type(type, [&](auto tag) {
        using T = decltype(tag);
        for (const double v : values) {
            const double wanted = lo + (v - from) * scale;
            const T value = std::is_floating_point_v<T> ? T(wanted) : T(std::round(wanted));
            char word[sizeof(T)];
            std::memcpy(word, &value, sizeof(T));
            if (big_endian) std::reverse(word, word + sizeof(T));
            bytes.append(word, sizeof(T));
        }
    });
    return bytes;
}

Volume sample(const std::string& name, glm::ivec3 dims) {
    SampleOptions options;
    options.dims = dims;
    return make_sample(name, options).volume;
}

std::string described(const std::vector<RawGuess>& guesses) {
    std::string text;
    for (const RawGuess& guess : guesses) {
        text += "  " + raw_text(guess.layout) + "  " + std::to_string(guess.confidence);
        for (const std::string& reason : guess.reasons) text += "; " + reason;
        text += "\n";
    }
    return text;
}

struct Made {
    const char* sample;
    glm::ivec3 size;
    VoxelType type;
    bool big_endian;
    double lo, hi;
};

std::string name_of_case(const Made& made) {
    return std::string(made.sample) + " " + std::to_string(made.size.x) + "x" + std::to_string(made.size.y) + "x" +
           std::to_string(made.size.z) + " " + std::string(name_of(made.type)) + (made.big_endian ? " be" : "");
}

void expect_first(const std::vector<RawGuess>& guesses, const Made& made, std::uint64_t offset, double least_sure) {
    const std::string what = name_of_case(made) + "\n" + described(guesses);
    ASSERT_FALSE(guesses.empty()) << what;
    EXPECT_EQ(guesses[0].layout.geometry.size, made.size) << what;
    EXPECT_EQ(guesses[0].layout.type, made.type) << what;
    EXPECT_EQ(guesses[0].layout.big_endian, made.big_endian) << what;
    EXPECT_EQ(guesses[0].layout.offset, offset) << what;
    EXPECT_TRUE(guesses[0].confidence >= least_sure) << what;
}

}  // namespace

TEST(RawGuess, FindsSizeTypeAndByteOrderFromContentAlone) {
    using enum VoxelType;
    const Made table[] = {
        {"casting", {96, 80, 64}, u16, false, 0, 3000},    {"casting", {96, 80, 64}, u16, true, 0, 60000},
        {"casting", {70, 110, 45}, u8, false, 3, 251},     {"casting", {64, 64, 64}, f32, false, 0, 1},
        {"head", {128, 128, 40}, i16, false, -1024, 2800}, {"head", {128, 128, 40}, i16, true, -1024, 2800},
        {"head", {100, 120, 37}, u16, false, 0, 4095},     {"head", {90, 60, 50}, f32, true, -1000, 3000},
        {"spheres", {80, 72, 60}, u8, false, 0, 255},      {"marschner-lobb", {64, 56, 48}, f32, false, 0, 1}};
    ScratchFolder folder;
    for (const Made& made : table) {
        const auto file = folder / "unknown.raw";
        put_file(file, stored(sample(made.sample, made.size), made.type, made.big_endian, made.lo, made.hi));
        expect_first(guess_raw_layouts(file), made, 0, 0.5);
    }
}

TEST(RawGuess, SaysItIsLessSureOfASparseVolume) {
    const Made made{"vessels", {96, 96, 96}, VoxelType::u8, false, 0, 255};
    ScratchFolder folder;
    put_file(folder / "v.raw", stored(sample(made.sample, made.size), made.type, false, made.lo, made.hi));
    const auto guesses = guess_raw_layouts(folder / "v.raw");
    expect_first(guesses, made, 0, 0.1);
    double sum = 0;
    for (const RawGuess& guess : guesses) sum += guess.confidence;
    EXPECT_TRUE(sum <= 1 + 1e-9);
    EXPECT_TRUE(guesses[0].confidence < 0.9);
}

TEST(RawGuess, FindsAHeaderBeforeTheVoxels) {
    const Made made{"casting", {96, 80, 50}, VoxelType::u16, false, 0, 3000};
    const std::string voxels = stored(sample(made.sample, made.size), made.type, false, made.lo, made.hi);
    ScratchFolder folder;
    for (const std::size_t header : {512u, 1024u, 348u}) {
        put_file(folder / "unknown.raw", std::string(header, 'h') + voxels);
        const auto guesses = guess_raw_layouts(folder / "unknown.raw");
        expect_first(guesses, made, header, 0.3);
        EXPECT_NE(described(guesses).find(std::to_string(header) + " bytes are left over for a header"),
                  std::string::npos);
    }
    // One of any length, where the name states the size.
    put_file(folder / "casting 96x80x50.raw", std::string(777, 'h') + voxels);
    expect_first(guess_raw_layouts(folder / "casting 96x80x50.raw"), made, 777, 0.5);
    // A header that states the size: three shorts, as in the Vienna volume files.
    std::string stated("\x60\x00\x50\x00\x32\x00", 6);
    put_file(folder / "stated.vol", stated + voxels);
    expect_first(guess_raw_layouts(folder / "stated.vol"), made, 6, 0.8);
}

TEST(RawGuess, TheNameDecidesWhatTheContentLeavesOpen) {
    ScratchFolder folder;
    const std::string flat(24 * 20 * 10 * 2, '\0');
    put_file(folder / "part_24x20x10_int16_be_0.5x0.5x1.25mm.raw", flat);
    const auto guesses = guess_raw_layouts(folder / "part_24x20x10_int16_be_0.5x0.5x1.25mm.raw");
    ASSERT_FALSE(guesses.empty());
    EXPECT_EQ(raw_text(guesses[0].layout), "24x20x10:i16:0.5,0.5,1.25:be");
    put_file(folder / "part 24x20 short.raw", flat);
    const auto two = guess_raw_layouts(folder / "part 24x20 short.raw");
    ASSERT_FALSE(two.empty());
    EXPECT_EQ(two[0].layout.geometry.size, glm::ivec3(24, 20, 10));
}

TEST(RawGuess, NoiseAndFlatFilesAreNotClaimedToBeKnown) {
    ScratchFolder folder;
    std::string noise(64 * 64 * 32, '\0');
    unsigned state = 1;
    for (char& c : noise) c = char((state = state * 1664525u + 1013904223u) >> 24);
    put_file(folder / "noise.raw", noise);
    for (const RawGuess& guess : guess_raw_layouts(folder / "noise.raw"))
        EXPECT_TRUE(guess.confidence < 0.35) << raw_text(guess.layout) << " " << guess.confidence;
    put_file(folder / "flat.raw", std::string(4096, '\x07'));
    for (const RawGuess& guess : guess_raw_layouts(folder / "flat.raw"))
        EXPECT_TRUE(guess.confidence < 0.35) << raw_text(guess.layout) << " " << guess.confidence;
    put_file(folder / "empty.raw", "");
    EXPECT_TRUE(guess_raw_layouts(folder / "empty.raw").empty());
    for (const std::size_t bytes : {1u, 2u, 3u, 7u, 31u, 97u}) {
        put_file(folder / "tiny.raw", std::string(bytes, 'x'));
        for (const RawGuess& guess : guess_raw_layouts(folder / "tiny.raw"))
            EXPECT_NO_THROW(parse_raw_text(raw_text(guess.layout)));
    }
    expect_error(Errc::io, {"missing.raw"}, [&] { guess_raw_layouts(folder / "missing.raw"); });
}

TEST(RawGuess, EveryGuessFitsTheFileAndReadsBack) {
    ScratchFolder folder;
    put_file(folder / "unknown.raw",
             std::string(12, 'h') + stored(sample("head", {60, 48, 30}), VoxelType::f32, true, 0, 1));
    const std::uint64_t bytes = std::filesystem::file_size(folder / "unknown.raw");
    for (const RawGuess& guess : guess_raw_layouts(folder / "unknown.raw")) {
        RawLayout layout = parse_raw_text(raw_text(guess.layout));
        layout.file = guess.layout.file;
        EXPECT_EQ(std::uint64_t(layout.geometry.voxel_count()) * size_of(layout.type) + layout.offset, bytes);
        EXPECT_NO_THROW(read_raw(layout));
    }
}

TEST(RawGuess, TinyFilesAndOddNamesDoNoHarm) {
    const ScratchFolder f;
    std::uint32_t state = 1;
    for (std::size_t size = 0; size < 150; size += size < 20 ? 1 : 7)
        for (const char* name : {"a.raw", "999999x999999x999999_uint16.raw", "2x2_float.raw", "1x1x1.raw"}) {
            std::string bytes(size, '\0');
            for (char& c : bytes) c = char((state = state * 1664525u + 1013904223u) >> 24);
            put_file(f / name, bytes);
            for (const RawGuess& guess : guess_raw_layouts(f / name)) EXPECT_NO_THROW(read_raw(guess.layout)) << size;
        }
}

TEST(RawGuess, ReadsNamesAsPeopleWriteThem) {
    const auto hints = [](const char* name) { return raw_name_hints(name); };
    EXPECT_EQ(hints("engine_256x256x128_uint8.raw").size, (std::vector<int>{256, 256, 128}));
    EXPECT_EQ(hints("engine_256x256x128_uint8.raw").type, VoxelType::u8);
    EXPECT_EQ(hints("Scan 512X512X300 16bit LE.vol").size, (std::vector<int>{512, 512, 300}));
    EXPECT_EQ(hints("Scan 512X512X300 16bit LE.vol").bits, 16);
    EXPECT_EQ(hints("Scan 512X512X300 16bit LE.vol").big_endian, false);
    EXPECT_EQ(hints("foot_256_256_128.raw").size, (std::vector<int>{256, 256, 128}));
    EXPECT_EQ(hints("slices 640x480 float msb.img").size, (std::vector<int>{640, 480}));
    EXPECT_EQ(hints("slices 640x480 float msb.img").big_endian, true);
    EXPECT_TRUE(hints("part_0.5x0.5x1.0.raw").size.empty());
    EXPECT_EQ(hints("part_0.5x0.5x1.0.raw").spacing_mm->z, 1.0);
    EXPECT_TRUE(hints("2026-11-22 scan.raw").size.empty());
    EXPECT_TRUE(hints("0x0x0.raw").size.empty());
}

TEST(RawGuess, KnowsTheRealSetsWithoutTheirHeaders) {
    LACUNA_NEEDS_DATA(root, "industrial");
    const std::pair<std::string, double> sets[] = {
        {"engine/engine.mhd", 0.5},          {"am_struts/strut30_a.mhd", 0.5},   {"am_struts/strut60_b.mhd", 0.5},
        {"bonsai/bonsai.nhdr", 0.3},         {"ketton_binary/ketton.nhdr", 0.5}, {"../medical/aneurism.nrrd", 0.0},
        {"../medical/torso_ct.nii.gz", 0.5}, {"../medical/ct_head_vhf", 0.5},    {"fiberform/fiberform_100.tif", 0.5}};
    ScratchFolder folder;
    for (const auto& [name, least_sure] : sets) {
        const Volume volume = open_volume((root / name).string());
        put_file(folder / "unknown.raw", {reinterpret_cast<const char*>(volume.data()), volume.bytes()});
        const auto guesses = guess_raw_layouts(folder / "unknown.raw");
        ASSERT_FALSE(guesses.empty()) << name;
        EXPECT_EQ(guesses[0].layout.geometry.size, volume.geometry().size) << name << "\n" << described(guesses);
        EXPECT_EQ(guesses[0].layout.type, volume.type()) << name << "\n" << described(guesses);
        EXPECT_TRUE(guesses[0].confidence >= least_sure) << name << "\n" << described(guesses);
    }
}

TEST(RawGuess, StopsWhenAsked) {
    ScratchFolder folder;
    put_file(folder / "unknown.raw", std::string(1 << 20, 'x'));
    std::stop_source stop;
    stop.request_stop();
    expect_error(Errc::cancelled, {}, [&] { guess_raw_layouts(folder / "unknown.raw", {stop.get_token(), nullptr}); });
}

TEST(RawGuess, AFileNeedsALayoutOnlyWhereNothingElseTellsIt) {
    ScratchFolder folder;
    for (const char* name : {"a.raw", "b.IMG", "c.vol"}) {
        put_file(folder / name, "12345678");
        EXPECT_TRUE(needs_raw_layout(folder / name)) << name;
    }
    put_file(folder / "d_2x2x2_uint8.raw", "12345678");
    EXPECT_FALSE(needs_raw_layout(folder / "d_2x2x2_uint8.raw"));
    put_file(folder / "a.dat", "ObjectFileName: a.raw\nResolution: 2 2 2\nFormat: UCHAR\n");
    EXPECT_FALSE(needs_raw_layout(folder / "a.raw"));
    put_file(folder / "e.nrrd", "NRRD");
    EXPECT_FALSE(needs_raw_layout(folder / "e.nrrd"));
    EXPECT_FALSE(needs_raw_layout(folder / "missing.raw"));
    EXPECT_FALSE(needs_raw_layout(folder.path()));
}

TEST(OpenVolume, RefusesWhatIsLargerThanAllowedBeforeReadingIt) {
    ScratchFolder folder;
    put_file(folder / "large_1024x1024x8_uint8.raw", "");
    std::filesystem::resize_file(folder / "large_1024x1024x8_uint8.raw", 8 << 20);
    expect_error(Errc::out_of_memory, {"8 MB", "1 MB"},
                 [&] { open_volume_within((folder / "large_1024x1024x8_uint8.raw").string(), {}, 1 << 20); });
    expect_error(Errc::out_of_memory, {"1 MB"}, [&] { open_volume_within("sample:casting@256", {}, 1 << 20); });
    EXPECT_NO_THROW(open_volume_within((folder / "large_1024x1024x8_uint8.raw").string(), {}, 8 << 20));
}
