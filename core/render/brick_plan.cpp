#include "core/render/brick_plan.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/volume/brick_grid.h"

namespace lacuna {

namespace {

constexpr std::array k_edges{256, 128, 64, 32};
constexpr std::uint64_t k_bricks_at_once = 6;  // fewer, and neighbours on the way of one ray push each other out
constexpr std::int64_t k_most_voxels = std::int64_t(1) << 32;  // kernels number those of a buffer with 32 bits
constexpr std::uint64_t k_mb = std::uint64_t(1) << 20;

/// Of a pixel: colour and depth on device and host, carried state, an 8-bit picture, and the same once more while
/// effects work.
constexpr std::uint64_t k_pixel_bytes = 2 * (2 * 20 + 3) + 40;
/// What the index takes of a voxel. The pieces read while it is made are gone before the first brick comes.
constexpr double k_index_bytes = 10.0 / 4096;

/// Bytes of a structure, and of what it is built from, for a voxel.
double structure_bytes(const Plan& plan) {
    switch (plan.structure) {
        case Structure::none:
            return 0;
        case Structure::pc:
        case Structure::acd:
        case Structure::eacd:
            return plan.cells == 1 ? 18 : 0.5;
        case Structure::leap:
            return 10;  // 2 to 6 when it is made, and what making it takes
        default:
            return 0.5;
    }
}

std::uint64_t brick_cost(const Scene& scene, const Plan& plan, int edge, const MemoryBudget& budget) {
    const BrickGrid grid(scene.volume.geometry().size, edge, ghost_voxels(scene, plan));
    const double voxel = double(size_of(scene.volume.type())) * (budget.device_total ? 2 : 1) + structure_bytes(plan);
    return std::uint64_t(double(grid.largest_stored()) * voxel);
}

bool one_buffer(const Scene& scene, const Plan& plan, int edge, const MemoryBudget& budget) {
    const BrickGrid grid(scene.volume.geometry().size, edge, ghost_voxels(scene, plan));
    return !budget.device_allocation ||
           std::uint64_t(grid.largest_stored()) * size_of(scene.volume.type()) + 64 <= budget.device_allocation;
}

/// Everything but bricks.
std::uint64_t fixed_bytes(const Scene& scene, const MemoryBudget& budget) {
    const std::uint64_t program = std::min(k_program_bytes, budget.total / 2);
    const std::uint64_t picture = std::uint64_t(scene.size.x) * std::uint64_t(scene.size.y) * k_pixel_bytes;
    const std::uint64_t held = scene.volume.in_memory() ? scene.volume.total_bytes() : 0;
    return program + picture + held + std::uint64_t(double(scene.volume.geometry().voxel_count()) * k_index_bytes);
}

bool too_many_voxels(const Scene& scene) { return scene.volume.geometry().voxel_count() > k_most_voxels; }

std::string mb(std::uint64_t bytes) { return std::to_string((bytes + k_mb - 1) / k_mb) + " MB"; }

std::string reason(const Scene& scene, int edge, const MemoryBudget& budget) {
    const std::string size = mb(scene.volume.total_bytes());
    if (!scene.volume.in_memory())
        return "Bricks of " + std::to_string(edge) + " voxels, streamed from disk: the volume's " + size +
               " do not go into " + mb(budget.total) + ".";
    if (budget.device_allocation && scene.volume.total_bytes() + 64 > budget.device_allocation)
        return "Bricks of " + std::to_string(edge) + " voxels: the device takes at most " +
               mb(budget.device_allocation) + " at once, the volume has " + size + ".";
    if (too_many_voxels(scene))
        return "Bricks of " + std::to_string(edge) + " voxels: the volume has more than " +
               std::to_string(k_most_voxels) + " of them, which is the most that are drawn in one piece.";
    return "Bricks of " + std::to_string(edge) + " voxels: the volume's " + size + " exceed what the device may hold.";
}

}  // namespace

std::uint64_t default_memory_limit() {
    return std::uint64_t(::sysconf(_SC_PHYS_PAGES)) * std::uint64_t(::sysconf(_SC_PAGE_SIZE)) / 4 * 3;
}

glm::ivec3 ghost_voxels(const Scene& scene, const Plan& plan) {
    const GridGeometry& grid = scene.volume.geometry();
    const double step_mm = plan.step * grid.smallest_spacing_mm();
    return 2 + glm::ivec3(glm::ceil(glm::dvec3(step_mm) / grid.spacing));
}

bool takes_whole_volume(const Plan& plan, const Scene& scene) {
    if (scene.regions) return true;
    // Equal voxels next to each other are a region of any brick they lie in; what else is one only the whole tells.
    return plan.structure == Structure::leap && (plan.leap.kernel != Leaping::lossless || plan.homogeneity > 0);
}

bool fits_whole(const Scene& scene, const MemoryBudget& budget) {
    const std::uint64_t bytes = scene.volume.total_bytes();
    if (!scene.volume.in_memory() || too_many_voxels(scene)) return false;
    if (budget.device_allocation && bytes + 64 > budget.device_allocation) return false;
    return !budget.device_total || bytes + bytes / 4 <= budget.device_total;
}

Plan with_bricks(const Plan& plan, const Scene& scene, const MemoryBudget& budget) {
    Plan out = plan;
    const bool asked = plan.brick > 0;
    if (!asked && fits_whole(scene, budget)) return out;
    if (takes_whole_volume(plan, scene))
        throw Error(Errc::unsupported, std::string("Regions are those of the whole volume, and this one ") +
                                           (too_many_voxels(scene) ? "has too many voxels to be drawn whole: "
                                                                   : "does not fit whole: raise --memory-limit, or ") +
                                           "take another structure, or leap with homogeneity 0, and show all regions.");
    const std::uint64_t fixed = fixed_bytes(scene, budget);
    std::uint64_t left = budget.total > fixed ? budget.total - fixed : 0;
    if (budget.device_total) left = std::min(left, budget.device_total / 4 * 3);
    if (!asked) {
        out.brick = k_edges.back();
        for (const int edge : k_edges)
            if (one_buffer(scene, plan, edge, budget) &&
                brick_cost(scene, plan, edge, budget) * k_bricks_at_once <= left) {
                out.brick = edge;
                break;
            }
    }
    const std::uint64_t least = 2 * brick_cost(scene, out, out.brick, budget);
    if (left < least)
        throw Error(Errc::out_of_memory, "Drawing this volume brick by brick takes at least " + mb(fixed + least) +
                                             " and the limit is " + mb(budget.total) +
                                             "; raise --memory-limit or make a smaller picture.");
    check(out, scene);  // not every method works on bricks
    out.brick_bytes = left;
    if (!asked) out.why.push_back(reason(scene, out.brick, budget));
    return out;
}

}  // namespace lacuna
