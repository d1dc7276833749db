#pragma once

#include <memory>

#include "core/volume/volume.h"

namespace lacuna::test {

/// Hands out a volume's voxels as if they lay elsewhere.
class MemorySource final : public VoxelSource {
public:
    explicit MemorySource(Volume volume) : volume_(std::move(volume)) {}
    void read(const VoxelBox& box, std::byte* out, const JobContext& job) const override {
        read_box(volume_, box, out, job);
    }

private:
    Volume volume_;
};

/// The same volume, to be read in parts.
inline Volume elsewhere(const Volume& volume) {
    return Volume(volume.geometry(), volume.type(), std::make_shared<const MemorySource>(volume));
}

}  // namespace lacuna::test
