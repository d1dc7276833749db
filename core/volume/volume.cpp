#include "core/volume/volume.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>

#include "core/base/error.h"
#include "core/base/parallel.h"

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

namespace {
void require_sound(const GridGeometry& geometry) {
    if (const char* fault = fault_of(geometry); *fault)
        throw Error(Errc::bad_input, std::string("The volume's geometry is unsound: ") + fault + ".");
}
}  // namespace

Volume::Volume(GridGeometry geometry, VoxelType type, std::shared_ptr<const VoxelSource> source)
    : geometry_(geometry), type_(type), source_(std::move(source)) {
    require_sound(geometry_);
}

Volume::Volume(GridGeometry geometry, VoxelType type, VoxelBuffer voxels)
    : geometry_(geometry), type_(type), voxels_(std::move(voxels)) {
    require_sound(geometry_);
    const auto expected = std::size_t(geometry_.voxel_count()) * size_of(type_);
    if (expected != voxels_.size())
        throw Error(Errc::bad_input, "The volume needs " + std::to_string(expected) + " bytes but has " +
                                         std::to_string(voxels_.size()) + ".");
}

void read_box(const Volume& volume, const VoxelBox& box, std::byte* out, const JobContext& job) {
    if (volume.source()) return volume.source()->read(box, out, job);
    const std::size_t voxel = size_of(volume.type()), row = std::size_t(box.size.x) * voxel;
    parallel_for(
        0, box.size.z,
        [&](std::int64_t z) {
            for (int y = 0; y < box.size.y; ++y) {
                const std::int64_t from =
                    volume.geometry().linear_index(box.first.x, box.first.y + y, box.first.z + int(z));
                const std::size_t to = (std::size_t(z) * std::size_t(box.size.y) + std::size_t(y)) * row;
                std::memcpy(out + to, volume.data() + std::size_t(from) * voxel, row);
            }
        },
        job);
}

Volume extract_box(const Volume& volume, const VoxelBox& box, const JobContext& job) {
    GridGeometry grid = volume.geometry();
    grid.origin = grid.voxel_to_mm(glm::dvec3(box.first));
    grid.size = box.size;
    VoxelBuffer voxels(std::size_t(box.voxels()) * size_of(volume.type()));
    read_box(volume, box, voxels.data(), job);
    return Volume(grid, volume.type(), std::move(voxels));
}

double Volume::value(int x, int y, int z) const {
    return visit_type(type_, [&](auto tag) { return double(view<decltype(tag)>()(x, y, z)); });
}

}  // namespace lacuna
