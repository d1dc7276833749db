#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lacuna {

/// Scalar types a volume may hold. Integer types stay what they are: u8 stays u8.
enum class VoxelType : std::uint8_t { u8, i8, u16, i16, f32 };

constexpr std::size_t size_of(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
        case VoxelType::i8: return 1;
        case VoxelType::u16:
        case VoxelType::i16: return 2;
        case VoxelType::f32: return 4;
    }
    return 0;
}

constexpr std::string_view name_of(VoxelType type) {
    switch (type) {
        case VoxelType::u8: return "u8";
        case VoxelType::i8: return "i8";
        case VoxelType::u16: return "u16";
        case VoxelType::i16: return "i16";
        case VoxelType::f32: return "f32";
    }
    return "";
}

template <class T> constexpr VoxelType voxel_type_of();
template <> constexpr VoxelType voxel_type_of<std::uint8_t>() { return VoxelType::u8; }
template <> constexpr VoxelType voxel_type_of<std::int8_t>() { return VoxelType::i8; }
template <> constexpr VoxelType voxel_type_of<std::uint16_t>() { return VoxelType::u16; }
template <> constexpr VoxelType voxel_type_of<std::int16_t>() { return VoxelType::i16; }
template <> constexpr VoxelType voxel_type_of<float>() { return VoxelType::f32; }

/// Calls fn with a value-initialised scalar of the given type: `visit_type(t, [&](auto tag){ using T = decltype(tag); })`.
template <class Fn> decltype(auto) visit_type(VoxelType type, Fn&& fn) {
    switch (type) {
        case VoxelType::u8: return fn(std::uint8_t{});
        case VoxelType::i8: return fn(std::int8_t{});
        case VoxelType::u16: return fn(std::uint16_t{});
        case VoxelType::i16: return fn(std::int16_t{});
        case VoxelType::f32: break;
    }
    return fn(float{});
}

/// The smallest voxel type that holds every value of [lo, hi] exactly, given whether all values are whole numbers.
VoxelType smallest_type(double lo, double hi, bool whole);

}  // namespace lacuna
