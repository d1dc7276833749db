#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>

namespace lacuna {

/// An 8-bit RGB picture (3 bytes a pixel, row 0 on top) as the bytes of a PNG file.
/// @throws Error(bad_input) if the bytes are no picture of that size
std::string encode_png(glm::ivec2 size, std::span<const std::uint8_t> rgb);

/// Writes an 8-bit RGB picture (3 bytes a pixel, row 0 on top) as PNG, all or nothing.
/// @throws Error(io) naming file and reason
void write_png(const std::filesystem::path& target, glm::ivec2 size, std::span<const std::uint8_t> rgb);

}  // namespace lacuna
