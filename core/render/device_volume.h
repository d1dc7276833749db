#pragma once

#include <glm/glm.hpp>

#include "core/compute/buffers.h"
#include "core/compute/device.h"
#include "core/volume/volume.h"

namespace lacuna {

/// A volume's voxels where kernels can read them: in place on devices that share the host's memory, copied else. An
/// axis with a single voxel is stored with that layer twice, because kernels read neighbours in pairs.
class DeviceVolume {
public:
    /// @throws Error(out_of_memory) if the device cannot hold it
    DeviceVolume(ComputeDevice& device, const Volume& volume);

    bool holds(const Volume& volume) const {
        return source_.data() == volume.data() && size_ == volume.geometry().size;
    }
    const cl::Buffer& voxels() const { return voxels_; }
    glm::ivec3 stored_size() const { return stored_; }
    /// Bytes taken beyond the volume's own.
    std::size_t extra_bytes() const { return extra_bytes_; }

private:
    VoxelBuffer source_;  // keeps the host's voxels alive while the device reads them
    VoxelBuffer doubled_;
    glm::ivec3 size_{0}, stored_{0};
    cl::Buffer voxels_;
    std::size_t extra_bytes_ = 0;
};

}  // namespace lacuna
