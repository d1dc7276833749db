#include "core/io/image_writer.h"

#include <png.h>

#include <string>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace lacuna {

std::string encode_png(glm::ivec2 size, std::span<const std::uint8_t> rgb) {
    if (size.x < 1 || size.y < 1 || rgb.size() != std::size_t(size.x) * std::size_t(size.y) * 3)
        throw Error(Errc::bad_input, std::to_string(rgb.size()) + " bytes are no picture of " +
                                         std::to_string(size.x) + "x" + std::to_string(size.y) + " RGB pixels.");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(size.x);
    image.height = png_uint_32(size.y);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string png(bytes, '\0');
    if (!png_image_write_to_memory(&image, png.data(), &bytes, 0, rgb.data(), 0, nullptr))
        throw Error(Errc::out_of_memory, std::string("A picture could not be compressed: ") + image.message + ".");
    png.resize(bytes);
    return png;
}

void write_png(const std::filesystem::path& target, glm::ivec2 size, std::span<const std::uint8_t> rgb) {
    std::string png;
    try {
        png = encode_png(size, rgb);
    } catch (const Error& error) {
        throw Error(error.code(), "Cannot write " + target.string() + ": " + error.what());
    }
    write_file(target, png);
}

}  // namespace lacuna
