#include "core/volume/volume.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {
constexpr std::size_t k_tail_bytes = 64;  // kernels load neighbouring voxels in pairs
constexpr std::size_t k_page = 4096, k_huge_page = std::size_t(2) << 20;
}  // namespace

namespace {

[[noreturn]] void refuse_memory(std::size_t bytes) {
    throw Error(Errc::out_of_memory, "Cannot allocate " + std::to_string(bytes) +
                                         " bytes for the voxels; close other programs or use a smaller volume.");
}

/// Pages of their own, from the system and back to it: what bricks and volumes leave behind is not kept on a heap, so
/// that the memory a limit counts is the memory the program has.
std::shared_ptr<std::byte> map_pages(std::size_t total) {
    const std::size_t reserved = total + k_huge_page;
    void* const found = ::mmap(nullptr, reserved, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (found == MAP_FAILED) refuse_memory(total);
    const auto from = reinterpret_cast<std::uintptr_t>(found);
    const std::uintptr_t aligned = (from + k_huge_page - 1) / k_huge_page * k_huge_page;
    auto* const memory = reinterpret_cast<std::byte*>(aligned);
    if (aligned > from) ::munmap(found, aligned - from);
    ::munmap(memory + total, from + reserved - aligned - total);
    ::madvise(memory, total / k_huge_page * k_huge_page, MADV_HUGEPAGE);
    return {memory, [total](std::byte* p) { ::munmap(p, total); }};
}

}  // namespace

VoxelBuffer::VoxelBuffer(std::size_t bytes) : size_(bytes) {
    const std::size_t total = (bytes + k_tail_bytes + k_page - 1) / k_page * k_page;
    if (bytes >= k_huge_page) {
        data_ = map_pages(total);  // all zero
        return;
    }
    auto* const memory = static_cast<std::byte*>(std::aligned_alloc(k_page, total));
    if (!memory) refuse_memory(total);
    std::memset(memory + bytes, 0, total - bytes);
    data_ = std::shared_ptr<std::byte>(memory, [](std::byte* p) { std::free(p); });
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
