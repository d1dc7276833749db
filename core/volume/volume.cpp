#include "core/volume/volume.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>

#include "core/base/error.h"

namespace lacuna {

namespace {
constexpr std::size_t k_tail_bytes = 64;              // kernels load neighbouring voxels in pairs
constexpr std::size_t k_huge_page = std::size_t(2) << 20;
}  // namespace

VoxelBuffer::VoxelBuffer(std::size_t bytes) : size_(bytes) {
    const std::size_t align = bytes >= k_huge_page ? k_huge_page : 4096;
    const std::size_t total = (bytes + k_tail_bytes + align - 1) / align * align;
    void* memory = std::aligned_alloc(align, total);
    if (!memory)
        throw Error(Errc::out_of_memory, "Cannot allocate " + std::to_string(total) +
                                             " bytes for the voxels; close other programs or use a smaller volume.");
    if (align == k_huge_page) ::madvise(memory, total, MADV_HUGEPAGE);
    std::memset(static_cast<std::byte*>(memory) + bytes, 0, total - bytes);
    data_ = std::shared_ptr<std::byte>(static_cast<std::byte*>(memory), [](std::byte* p) { std::free(p); });
}

Volume::Volume(GridGeometry geometry, VoxelType type, VoxelBuffer voxels)
    : geometry_(geometry), type_(type), voxels_(std::move(voxels)) {
    if (const char* fault = fault_of(geometry_); *fault)
        throw Error(Errc::bad_input, std::string("The volume's geometry is unsound: ") + fault + ".");
    const auto expected = std::size_t(geometry_.voxel_count()) * size_of(type_);
    if (expected != voxels_.size())
        throw Error(Errc::bad_input, "The volume needs " + std::to_string(expected) + " bytes but has " +
                                         std::to_string(voxels_.size()) + ".");
}

double Volume::value(int x, int y, int z) const {
    return visit_type(type_, [&](auto tag) { return double(view<decltype(tag)>()(x, y, z)); });
}

}  // namespace lacuna
