#include "core/volume/reslice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr float k_none = std::numeric_limits<float>::quiet_NaN();

bool near_whole(const glm::dvec3& v) { return glm::all(glm::lessThan(glm::abs(v - glm::round(v)), glm::dvec3(1e-6))); }

/// A single step along one grid axis, either way.
bool single_step(const glm::dvec3& v) {
    const glm::dvec3 whole = glm::abs(glm::round(v));
    return near_whole(v) && whole.x + whole.y + whole.z == 1;
}

/// Gathers the values of one pixel over the sheets.
struct MeanOf {
    double sum = 0;
    int count = 0;
    void add(float value) {
        if (value == value) sum += double(value), ++count;
    }
    float result() const { return count > 0 ? float(sum / count) : k_none; }
};
struct LargestOf {
    float largest = k_none;
    void add(float value) {
        if (!(value <= largest) && value == value) largest = value;
    }
    float result() const { return largest; }
};
struct SmallestOf {
    float smallest = k_none;
    void add(float value) {
        if (!(value >= smallest) && value == value) smallest = value;
    }
    float result() const { return smallest; }
};

/// One trilinear sample. A neighbour without weight is not read: it may be NaN.
template <class T>
class Trilinear {
public:
    explicit Trilinear(const Volume& volume)
        : view_(volume.view<T>()),
          last_(glm::dvec3(view_.size - 1)),
          stride_y_(view_.size.x),
          stride_z_(std::int64_t(view_.size.x) * view_.size.y) {}

    float operator()(const glm::dvec3& voxel) const {
        constexpr double k_rounding = 1e-6;  // a picture's border may lie on that of the cells
        for (int a = 0; a < 3; ++a)
            if (!(voxel[a] >= -0.5 - k_rounding && voxel[a] <= last_[a] + 0.5 + k_rounding)) return k_none;
        const glm::dvec3 at = glm::clamp(voxel, glm::dvec3(0), last_);
        const glm::ivec3 cell(at);
        const glm::dvec3 f = at - glm::dvec3(cell);
        const std::int64_t dx = f.x > 0 ? 1 : 0, dy = f.y > 0 ? stride_y_ : 0, dz = f.z > 0 ? stride_z_ : 0;
        const T* v = view_.data + cell.z * stride_z_ + cell.y * stride_y_ + cell.x;
        const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
        const double near_side = mix(mix(v[0], v[dx], f.x), mix(v[dy], v[dy + dx], f.x), f.y);
        if (dz == 0) return float(near_side);
        const T* w = v + dz;
        return float(mix(near_side, mix(mix(w[0], w[dx], f.x), mix(w[dy], w[dy + dx], f.x), f.y), f.z));
    }

private:
    VolumeView<T> view_;
    glm::dvec3 last_;
    std::int64_t stride_y_, stride_z_;
};

/// Pixels that are voxels: `sheet` is one slice on.
template <class T, class Gather>
void gather_voxels(const Volume& volume, const VoxelWalk& walk, const glm::dvec3& sheet, const Sheets& sheets,
                   const SliceFrame& frame, std::vector<float>& out, const JobContext& job) {
    const GridGeometry& grid = volume.geometry();
    const T* voxels = volume.view<T>().data;
    const glm::ivec3 first(glm::round(walk.first)), across(glm::round(walk.across)), down(glm::round(walk.down));
    const glm::ivec3 deeper(glm::round(sheet));
    const auto inside = [&](const glm::ivec3& v) {
        return glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, grid.size));
    };
    const std::int64_t step = grid.linear_index(across.x, across.y, across.z);
    parallel_bands(
        0, frame.size.y, 64,
        [&](std::int64_t from, std::int64_t to) {
            std::vector<Gather> row(std::size_t(frame.size.x));
            for (std::int64_t y = from; y < to; ++y) {
                std::fill(row.begin(), row.end(), Gather{});
                for (int j = sheets.first; j <= sheets.last; ++j) {
                    const glm::ivec3 start = first + down * int(y) + deeper * j;
                    const glm::ivec3 end = start + across * (frame.size.x - 1);
                    if (inside(start) && inside(end)) {
                        const T* voxel = voxels + grid.linear_index(start.x, start.y, start.z);
                        for (Gather& pixel : row) pixel.add(float(*voxel)), voxel += step;
                        continue;
                    }
                    for (int x = 0; x < frame.size.x; ++x)
                        if (const glm::ivec3 at = start + across * x; inside(at))
                            row[std::size_t(x)].add(float(voxels[grid.linear_index(at.x, at.y, at.z)]));
                }
                float* line = out.data() + y * frame.size.x;
                for (std::size_t x = 0; x < row.size(); ++x) line[x] = row[x].result();
            }
        },
        job);
}

template <class T, class Gather>
void gather_samples(const Volume& volume, const VoxelWalk& walk, const glm::dvec3& sheet, const Sheets& sheets,
                    const SliceFrame& frame, std::vector<float>& out, const JobContext& job) {
    const Trilinear<T> sample(volume);
    parallel_bands(
        0, frame.size.y, 64,
        [&](std::int64_t from, std::int64_t to) {
            for (std::int64_t y = from; y < to; ++y)
                for (int x = 0; x < frame.size.x; ++x) {
                    const glm::dvec3 middle = walk.first + walk.across * double(x) + walk.down * double(y);
                    Gather pixel;
                    for (int j = sheets.first; j <= sheets.last; ++j) pixel.add(sample(middle + sheet * double(j)));
                    out[std::size_t(y * frame.size.x + x)] = pixel.result();
                }
        },
        job);
}

template <class Gather>
void gather(const Volume& volume, const SliceFrame& frame, double thickness_mm, std::vector<float>& out,
            const JobContext& job) {
    const GridGeometry& grid = volume.geometry();
    const VoxelWalk walk = voxel_walk(grid, frame);
    const Sheets sheets = sheets_of(grid, frame.normal(), thickness_mm);
    const glm::dvec3 sheet = grid.vector_to_voxel(frame.normal() * sheets.distance_mm);
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        if (walk.on_grid)
            gather_voxels<T, Gather>(volume, walk, sheet, sheets, frame, out, job);
        else
            gather_samples<T, Gather>(volume, walk, sheet, sheets, frame, out, job);
    });
}

}  // namespace

double sheet_distance_mm(const GridGeometry& geometry, const glm::dvec3& normal) {
    return 1 / glm::length(geometry.vector_to_voxel(normal));
}

Sheets sheets_of(const GridGeometry& geometry, const glm::dvec3& normal, double thickness_mm) {
    Sheets sheets;
    sheets.distance_mm = sheet_distance_mm(geometry, normal);
    if (!(thickness_mm > 0)) return sheets;
    // A thickness typed with few digits still counts as the whole slices it means.
    const double half = 0.5 * std::min(thickness_mm, 2 * geometry.diameter_mm()) / sheets.distance_mm;
    sheets.last = int(std::floor(half + 1e-6));
    sheets.first = std::min(0, int(std::floor(-half + 1e-6)) + 1);
    return sheets;
}

VoxelWalk voxel_walk(const GridGeometry& geometry, const SliceFrame& frame) {
    VoxelWalk walk;
    walk.first = geometry.mm_to_voxel(frame.to_mm({0.5, 0.5}));
    walk.across = geometry.vector_to_voxel(frame.right * frame.pixel_mm.x);
    walk.down = geometry.vector_to_voxel(frame.down * frame.pixel_mm.y);
    walk.on_grid = near_whole(walk.first) && single_step(walk.across) && single_step(walk.down);
    return walk;
}

std::vector<float> reslice(const Volume& volume, const SliceFrame& frame, const Slab& slab, const JobContext& job) {
    std::vector<float> out(std::size_t(frame.size.x) * std::size_t(frame.size.y));
    switch (slab.mode) {
        case SlabMode::mean:
            gather<MeanOf>(volume, frame, slab.thickness_mm, out, job);
            break;
        case SlabMode::mip:
            gather<LargestOf>(volume, frame, slab.thickness_mm, out, job);
            break;
        case SlabMode::minip:
            gather<SmallestOf>(volume, frame, slab.thickness_mm, out, job);
            break;
    }
    return out;
}

std::vector<std::uint32_t> reslice_nearest(const GridGeometry& geometry, std::span<const std::uint32_t> voxels,
                                           const SliceFrame& frame, const JobContext& job) {
    std::vector<std::uint32_t> out(std::size_t(frame.size.x) * std::size_t(frame.size.y), 0);
    const VoxelWalk walk = voxel_walk(geometry, frame);
    const glm::dvec3 last(geometry.size - 1);
    parallel_bands(
        0, frame.size.y, 16,
        [&](std::int64_t from, std::int64_t to) {
            for (std::int64_t y = from; y < to; ++y)
                for (int x = 0; x < frame.size.x; ++x) {
                    const glm::dvec3 at = glm::round(walk.first + walk.across * double(x) + walk.down * double(y));
                    if (!glm::all(glm::greaterThanEqual(at, glm::dvec3(0))) || !glm::all(glm::lessThanEqual(at, last)))
                        continue;
                    out[std::size_t(y * frame.size.x + x)] =
                        voxels[std::size_t(geometry.linear_index(int(at.x), int(at.y), int(at.z)))];
                }
        },
        job);
    return out;
}

}  // namespace lacuna
