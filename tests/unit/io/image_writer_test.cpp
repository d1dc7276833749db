#include "core/io/image_writer.h"

#include <png.h>

#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

TEST(PngWriter, KeepsEveryPixelWithTheFirstRowOnTop) {
    const ScratchFolder folder;
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(7, 5), glm::ivec2(1, 300)}) {
        std::vector<std::uint8_t> rgb(std::size_t(size.x * size.y * 3));
        for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = std::uint8_t(i * 37 + i / 256);
        write_png(folder / "p.png", size, rgb);
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        ASSERT_TRUE(png_image_begin_read_from_file(&image, (folder / "p.png").c_str()));
        EXPECT_EQ(glm::ivec2(image.width, image.height), size);
        image.format = PNG_FORMAT_RGB;
        std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
        ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
        EXPECT_EQ(read, rgb);
    }
}

TEST(PngWriter, FaultsAreNamedAndNothingIsWritten) {
    const ScratchFolder folder;
    const std::vector<std::uint8_t> rgb(12);
    expect_error(Errc::bad_input, {"p.png", "12 bytes"}, [&] { write_png(folder / "p.png", {2, 3}, rgb); });
    expect_error(Errc::bad_input, {"p.png"}, [&] { write_png(folder / "p.png", {0, 0}, {}); });
    expect_error(Errc::io, {"none"}, [&] { write_png(folder / "none/p.png", {2, 2}, rgb); });
    EXPECT_EQ(folder.entries(), 0u);
}
