#include "core/volume/volume_pieces.h"

#include <algorithm>

namespace lacuna {

namespace {

constexpr std::uint64_t k_piece_bytes = std::uint64_t(16) << 20;
constexpr int k_largest_edge = 64;

/// Rows and slices of a piece: the most that stay near k_piece_bytes.
int piece_edge(const Volume& volume, int granule) {
    const std::uint64_t row = std::uint64_t(volume.geometry().size.x) * size_of(volume.type());
    int edge = k_largest_edge;
    while (edge > granule && row * std::uint64_t(edge) * std::uint64_t(edge) > k_piece_bytes) edge /= 2;
    return std::max(edge, granule);
}

}  // namespace

void for_each_piece(const Volume& volume, int granule, const std::function<void(const VolumePiece&)>& take,
                    const JobContext& job) {
    job.check();
    const GridGeometry& grid = volume.geometry();
    const int edge = piece_edge(volume, granule);
    VoxelBuffer buffer;
    for (int z = 0; z < grid.size.z; z += edge)
        for (int y = 0; y < grid.size.y; y += edge) {
            VolumePiece piece;
            piece.box.first = {0, y, z};
            piece.own = {grid.size.x, std::min(edge, grid.size.y - y), std::min(edge, grid.size.z - z)};
            piece.box.size = {grid.size.x, std::min(edge + 1, grid.size.y - y), std::min(edge + 1, grid.size.z - z)};
            const std::size_t bytes = std::size_t(piece.box.voxels()) * size_of(volume.type());
            if (buffer.size() != bytes) {
                buffer = {};
                buffer = VoxelBuffer(bytes);
            }
            read_box(volume, piece.box, buffer.data(), {job.stop, nullptr});
            GridGeometry own = grid;
            own.size = piece.box.size;
            own.origin = grid.voxel_to_mm(glm::dvec3(piece.box.first));
            piece.volume = Volume(own, volume.type(), buffer);
            take(piece);
            const auto done =
                std::size_t(z) * std::size_t(grid.size.y) + std::size_t(y + piece.own.y) * std::size_t(piece.own.z);
            job.checkpoint(done, std::size_t(grid.size.z) * std::size_t(grid.size.y));
        }
}

}  // namespace lacuna
