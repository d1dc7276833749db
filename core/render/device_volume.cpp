#include "core/render/device_volume.h"

#include <cstring>

namespace lacuna {

namespace {
constexpr std::size_t k_tail_bytes = 64;  // VoxelBuffer promises as many readable bytes behind the last voxel
}

DeviceVolume::DeviceVolume(ComputeDevice& device, const Volume& volume)
    : source_(volume.buffer()), size_(volume.geometry().size), stored_(glm::max(size_, glm::ivec3(2))) {
    const std::byte* data = source_.data();
    std::size_t bytes = source_.size();
    if (stored_ != size_) {
        const std::size_t voxel = size_of(volume.type());
        bytes = std::size_t(stored_.x) * std::size_t(stored_.y) * std::size_t(stored_.z) * voxel;
        doubled_ = VoxelBuffer(bytes);
        std::byte* out = doubled_.data();
        for (int z = 0; z < stored_.z; ++z)
            for (int y = 0; y < stored_.y; ++y)
                for (int x = 0; x < stored_.x; ++x, out += voxel) {
                    const glm::ivec3 from = glm::min(glm::ivec3(x, y, z), size_ - 1);
                    const auto index = std::size_t(volume.geometry().linear_index(from.x, from.y, from.z));
                    std::memcpy(out, source_.data() + index * voxel, voxel);
                }
        data = doubled_.data();
        extra_bytes_ += bytes;
    }
    voxels_ = device_buffer(device, data, bytes + k_tail_bytes);
    if (!is_zero_copy(device, data)) extra_bytes_ += bytes;
}

}  // namespace lacuna
