#include "core/io/tiff_reader.h"

#include <tiffio.h>

#include <cstring>

#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

struct PageStyle {
    std::uint16_t bits = 8, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK,
                  compression = COMPRESSION_NONE;
    std::uint32_t tile = 0;
    const char* mode = "w";
    std::string description{};
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    bool colour_palette = false;
};

/// Writes the volume's slices [first, last) as the pages of one file.
void write_pages(const Volume& v, const std::filesystem::path& file, int first, int last, const PageStyle& s) {
    TIFF* tiff = TIFFOpen(file.c_str(), s.mode);
    const auto w = std::uint32_t(v.geometry().size.x), h = std::uint32_t(v.geometry().size.y);
    const std::size_t row = w * size_of(v.type());
    for (int z = first; z < last; ++z) {
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, w);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, h);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, s.bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, s.format);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, s.photometric);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, s.compression);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, s.orientation);
        if (!s.description.empty()) {
            TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, s.description.c_str());
            TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 4.0);
            TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 2.0);
        }
        std::uint16_t ramp[256], other[256];
        for (int i = 0; i < 256; ++i) ramp[i] = std::uint16_t((255 - i) * 257), other[i] = 7;
        if (s.photometric == PHOTOMETRIC_PALETTE)
            TIFFSetField(tiff, TIFFTAG_COLORMAP, ramp, ramp, s.colour_palette ? other : ramp);
        std::vector<std::byte> line;
        if (s.tile) {
            TIFFSetField(tiff, TIFFTAG_TILEWIDTH, s.tile);
            TIFFSetField(tiff, TIFFTAG_TILELENGTH, s.tile);
            for (std::uint32_t y = 0; y < h; y += s.tile)
                for (std::uint32_t x = 0; x < w; x += s.tile) {
                    line.assign(std::size_t(s.tile) * s.tile * size_of(v.type()), std::byte(0));
                    for (std::uint32_t r = 0; r < s.tile && y + r < h; ++r)
                        std::memcpy(line.data() + r * s.tile * size_of(v.type()),
                                    v.data() + (std::size_t(z) * h + y + r) * row + x * size_of(v.type()),
                                    std::min(s.tile, w - x) * size_of(v.type()));
                    TIFFWriteTile(tiff, line.data(), x, y, 0, 0);
                }
        } else {
            TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 3);
            for (std::uint32_t y = 0; y < h; ++y) {
                const std::byte* from = v.data() + (std::size_t(z) * h + y) * row;
                line.assign(from, from + row);
                TIFFWriteScanline(tiff, line.data(), y, 0);
            }
        }
        TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
}

GridGeometry grid(glm::ivec3 size) {
    GridGeometry g;
    g.size = size;
    return g;
}

PageStyle style_of(VoxelType type) {
    PageStyle s;
    s.bits = std::uint16_t(8 * size_of(type));
    if (type == VoxelType::i8 || type == VoxelType::i16) s.format = SAMPLEFORMAT_INT;
    if (type == VoxelType::f32) s.format = SAMPLEFORMAT_IEEEFP;
    return s;
}

}  // namespace

TEST(TiffReader, EveryTypeByteOrderCompressionAndTiling) {
    const ScratchFolder folder;
    for (const VoxelType type : {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32})
        for (const char* mode : {"wl", "wb", "w8"})
            for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE})
                for (const std::uint32_t tile : {0u, 16u}) {
                    const Volume original = extreme_volume(type, grid({37, 21, 3}));
                    PageStyle s = style_of(type);
                    s.mode = mode, s.compression = compression, s.tile = tile;
                    write_pages(original, folder / "v.tif", 0, 3, s);
                    const Volume read = open_volume((folder / "v.tif").string());
                    EXPECT_EQ(read.geometry().size, original.geometry().size);
                    expect_same_voxels(original, read);
                    EXPECT_TRUE(has_warning(read, "spacing"));
                }
}

TEST(TiffReader, AStackIsTakenInNaturalOrderAndNamesItsHoles) {
    const ScratchFolder folder;
    const Volume original = extreme_volume<std::uint16_t>(grid({5, 4, 12}));
    for (int z = 0; z < 12; ++z)
        write_pages(original, folder / ("s" + std::to_string(z + 1) + ".tif"), z, z + 1, style_of(VoxelType::u16));
    const Volume read = open_volume(folder.path().string());
    expect_same_voxels(original, read);
    EXPECT_FALSE(has_warning(read, "missing"));
    EXPECT_EQ(read.name, folder.path().filename().string());
    EXPECT_EQ(list_series(folder.path().string()).at(0).slices, 12);
    EXPECT_EQ(open_volume(folder.path().string() + "/").name, read.name);
    std::filesystem::remove(folder / "s7.tif");
    EXPECT_TRUE(has_warning(open_volume(folder.path().string()), "6 to 8"));
}

TEST(TiffReader, AGreyPaletteIsResolvedAndAColouredOneRefused) {
    const ScratchFolder folder;
    const Volume original = extreme_volume<std::uint8_t>(grid({4, 4, 1}));
    PageStyle s;
    s.photometric = PHOTOMETRIC_PALETTE;
    write_pages(original, folder / "v.tif", 0, 1, s);
    const Volume read = open_volume((folder / "v.tif").string());
    for (int i = 0; i < 16; ++i) EXPECT_EQ(read.value(i % 4, i / 4, 0), 255 - original.value(i % 4, i / 4, 0));
    s.colour_palette = true;
    write_pages(original, folder / "v.tif", 0, 1, s);
    expect_error(Errc::unsupported, {"v.tif", "colour palette"}, [&] { open_volume((folder / "v.tif").string()); });
}

TEST(TiffReader, PixelsOfOneBitAreNoughtAndOne) {
    const ScratchFolder folder;
    constexpr std::uint32_t k_wide = 37, k_high = 21;
    const auto set = [](std::uint32_t x, std::uint32_t y) { return (x * y + x / 3 + y) % 3 == 0; };
    for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_CCITTFAX4})
        for (const std::uint32_t tile : {0u, 16u})
            for (const std::uint16_t order : {FILLORDER_MSB2LSB, FILLORDER_LSB2MSB}) {
                TIFF* tiff = TIFFOpen((folder / "v.tif").c_str(), "w");
                TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, k_wide);
                TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, k_high);
                TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
                TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
                TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
                TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
                TIFFSetField(tiff, TIFFTAG_FILLORDER, order);
                if (tile) {
                    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tile);
                    TIFFSetField(tiff, TIFFTAG_TILELENGTH, tile);
                } else {
                    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 4);
                }
                // Rows of `wide` pixels from (x0, y0) on, eight a byte.
                const auto bits = [&](std::uint32_t x0, std::uint32_t y0, std::uint32_t wide, std::uint32_t high) {
                    std::vector<std::uint8_t> bytes(high * ((wide + 7) / 8), 0);
                    for (std::uint32_t y = 0; y < high; ++y)
                        for (std::uint32_t x = 0; x < wide; ++x)
                            if (x0 + x < k_wide && y0 + y < k_high && set(x0 + x, y0 + y))
                                bytes[y * ((wide + 7) / 8) + x / 8] |= std::uint8_t(0x80 >> (x % 8));
                    return bytes;
                };
                if (tile) {
                    for (std::uint32_t y = 0; y < k_high; y += tile)
                        for (std::uint32_t x = 0; x < k_wide; x += tile)
                            TIFFWriteTile(tiff, bits(x, y, tile, tile).data(), x, y, 0, 0);
                } else {
                    for (std::uint32_t y = 0; y < k_high; ++y)
                        TIFFWriteScanline(tiff, bits(0, y, k_wide, 1).data(), y, 0);
                }
                TIFFClose(tiff);
                const Volume read = open_volume((folder / "v.tif").string());
                ASSERT_EQ(read.geometry().size, glm::ivec3(k_wide, k_high, 1));
                for (std::uint32_t y = 0; y < k_high; ++y)
                    for (std::uint32_t x = 0; x < k_wide; ++x)
                        ASSERT_EQ(read.value(int(x), int(y), 0), set(x, y))
                            << x << " " << y << " " << compression << " " << tile << " " << order;
            }
}

TEST(TiffReader, ImageJsSpacingIsUsedWhereItsUnitIsALength) {
    const ScratchFolder folder;
    const Volume original = extreme_volume<std::uint8_t>(grid({4, 4, 2}));
    PageStyle s;
    s.description = "ImageJ=1.52p\nimages=2\nslices=2\nunit=um\nspacing=1.5\n";
    write_pages(original, folder / "v.tif", 0, 2, s);
    const Volume read = open_volume((folder / "v.tif").string());
    EXPECT_NEAR(glm::length(read.geometry().spacing - glm::dvec3(0.25e-3, 0.5e-3, 1.5e-3)), 0, 1e-9);
    EXPECT_FALSE(has_warning(read, "spacing"));
    s.description = "ImageJ=1.52p\nimages=2\nunit=inch\n";
    write_pages(original, folder / "v.tif", 0, 2, s);
    EXPECT_EQ(open_volume((folder / "v.tif").string()).geometry().spacing, glm::dvec3(1));
    s.description = "ImageJ=1.52p\nimages=5000\nunit=um\n";
    write_pages(original, folder / "v.tif", 0, 1, s);
    expect_error(Errc::unsupported, {"5000 slices"}, [&] { open_volume((folder / "v.tif").string()); });
}

TEST(TiffReader, PagesThatDifferAndFilesThatAreCutAreRefused) {
    const ScratchFolder folder;
    write_pages(extreme_volume<std::uint8_t>(grid({4, 4, 1})), folder / "a1.tif", 0, 1, {});
    write_pages(extreme_volume<std::uint8_t>(grid({5, 4, 1})), folder / "a2.tif", 0, 1, {});
    expect_error(Errc::bad_input, {"a2.tif", "5x4", "4x4"}, [&] { open_volume(folder.path().string()); });
    write_pages(extreme_volume<std::uint8_t>(grid({50, 40, 3})), folder / "m.tif", 0, 3, {});
    const std::string whole = get_file(folder / "m.tif");
    testing::internal::CaptureStderr();
    for (std::size_t keep = 0; keep < whole.size(); keep += 97) {
        put_file(folder / "m.tif", whole.substr(0, keep));
        try {
            // A cut behind a page's link may leave fewer whole pages; never a wrong or partial one.
            EXPECT_LT(open_volume((folder / "m.tif").string()).geometry().size.z, 3);
        } catch (const Error& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(TiffReader, AListOfPagesThatBreaksOffIsRefused) {
    const ScratchFolder f;
    const Volume v = extreme_volume<std::uint8_t>(grid({5, 4, 3}));
    write_pages(v, f / "v.tif", 0, 3, style_of(v.type()));
    expect_same_voxels(v, open_volume((f / "v.tif").string()));
    const std::string bytes = get_file(f / "v.tif");
    for (std::size_t cut = 1; cut < bytes.size() / 2; cut += 7) {
        put_file(f / "cut.tif", bytes.substr(0, bytes.size() - cut));
        try {
            const Volume read = open_volume((f / "cut.tif").string());
            expect_same_voxels(v, read);  // what is gone was needed by nobody
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Errc::bad_input) << e.what();
        }
    }
}

TEST(TiffReader, PagesThatAreNoSlicesAreRefused) {
    const ScratchFolder f;
    const Volume v = extreme_volume<std::uint8_t>(grid({5, 4, 4}));
    PageStyle style = style_of(v.type());
    const auto open_with = [&](const std::string& more) {
        style.description = "ImageJ=1.53t\nimages=4\n" + more;
        write_pages(v, f / "v.tif", 0, 4, style);
        return open_volume((f / "v.tif").string());
    };
    EXPECT_EQ(open_with("slices=4\n").geometry().size.z, 4);
    EXPECT_EQ(open_with("frames=4\n").geometry().size.z, 4);
    expect_error(Errc::unsupported, {"v.tif", "channels"}, [&] { open_with("channels=2\nslices=2\n"); });
    expect_error(Errc::unsupported, {"v.tif", "time"}, [&] { open_with("slices=2\nframes=2\n"); });
}

TEST(TiffReader, MirroredPagesAreWarnedOf) {
    const ScratchFolder f;
    const Volume v = extreme_volume<std::uint8_t>(grid({5, 4, 2}));
    PageStyle style = style_of(v.type());
    write_pages(v, f / "v.tif", 0, 2, style);
    EXPECT_FALSE(has_warning(open_volume((f / "v.tif").string()), "mirrored"));
    style.orientation = ORIENTATION_BOTLEFT;
    write_pages(v, f / "v.tif", 0, 2, style);
    EXPECT_TRUE(has_warning(open_volume((f / "v.tif").string()), "mirrored"));
}
