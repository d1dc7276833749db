#include "core/volume/voxel_type.h"

namespace lacuna {

VoxelType smallest_type(double lo, double hi, bool whole) {
    if (!whole) return VoxelType::f32;
    if (lo >= 0 && hi <= 255) return VoxelType::u8;
    if (lo >= -128 && hi <= 127) return VoxelType::i8;
    if (lo >= 0 && hi <= 65535) return VoxelType::u16;
    if (lo >= -32768 && hi <= 32767) return VoxelType::i16;
    return VoxelType::f32;
}

}  // namespace lacuna
