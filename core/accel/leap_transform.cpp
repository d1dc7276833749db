#include <algorithm>
#include <cmath>
#include <limits>

#include "core/accel/leap_distance.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
constexpr std::uint16_t k_unlimited = 65535;  // along z: no other label on this side
constexpr int k_bands = 64;                   // of slices
constexpr int k_tile = 8;                     // columns turned into rows at a time: one cache line of doubles

/// Distances along z, in voxels, from both sides. Longer ones count as 65534.
void distances_along_z(const LabelGrid& grid, std::uint16_t* distance, const JobContext& job) {
    const glm::ivec3 n = grid.size;
    const std::int64_t slice = std::int64_t(n.x) * n.y;
    parallel_for(
        0, n.y,
        [&](std::int64_t y) {
            std::vector<std::uint16_t> run(std::size_t(n.x), k_unlimited);
            const auto step = [&](int z, int before, bool second) {
                const std::uint32_t* label = grid.labels + z * slice + y * n.x;
                std::uint16_t* out = distance + z * slice + y * n.x;
                std::uint16_t* r = run.data();
                if (before < 0 || before >= n.z)
                    std::fill_n(r, n.x, k_unlimited);
                else {
                    const std::uint32_t* other = grid.labels + before * slice + y * n.x;
                    for (int x = 0; x < n.x; ++x)
                        r[x] = std::uint16_t(label[x] == other[x] ? r[x] + (r[x] < k_unlimited - 1) : 1);
                }
                if (second)
                    for (int x = 0; x < n.x; ++x) out[x] = std::min(out[x], r[x]);
                else
                    std::copy_n(r, n.x, out);
            };
            for (int z = 0; z < n.z; ++z) step(z, z - 1, false);
            for (int z = n.z - 1; z >= 0; --z) step(z, z + 1, true);
        },
        job);
}

/// One line of squared distances (in units of the line's spacing) turned into those with this axis too.
class Line {
public:
    explicit Line(int n) : at_(std::size_t(n) + 2), from_(std::size_t(n) + 3), half_inverse_(std::size_t(n) + 2) {
        for (std::size_t d = 1; d < half_inverse_.size(); ++d) half_inverse_[d] = 0.5 / double(d);
    }

    void run(const std::uint32_t* label, const double* in, double* out, int n) {
        for (int a = 0; a < n;) {
            int b = a + 1;
            while (b < n && label[b] == label[a]) ++b;
            if (label[a] == 0)
                std::fill(out + a, out + b, 0.0);
            else
                segment(in, out, a, b, n);
            a = b;
        }
    }

private:
    /// Voxels a..b-1 of one label; those before and behind, where there are any, lie at distance 0 of another.
    void segment(const double* in, double* out, int a, int b, int n) {
        count_ = 0;
        if (a > 0) add(a - 1, 0);
        for (int i = a; i < b; ++i)
            if (in[i] < k_infinite) add(i, in[i]);
        if (b < n) add(b, 0);
        if (count_ == 0) {
            std::fill(out + a, out + b, k_infinite);
            return;
        }
        int k = 0;
        for (int x = a; x < b; ++x) {
            while (k + 1 < count_ && from_[std::size_t(k) + 1] <= x) ++k;
            const double d = x - at_[std::size_t(k)].position;
            out[x] = d * d + at_[std::size_t(k)].height;
        }
    }

    void add(int position, double height) {
        while (count_ > 0) {
            const Parabola& last = at_[std::size_t(count_) - 1];
            const double crossing =
                ((height - last.height) + double(position - last.position) * double(position + last.position)) *
                half_inverse_[std::size_t(position - last.position)];
            if (count_ > 1 && crossing <= from_[std::size_t(count_) - 1]) {
                --count_;
                continue;
            }
            from_[std::size_t(count_)] = crossing;
            break;
        }
        at_[std::size_t(count_++)] = {position, height};
    }

    struct Parabola {
        int position;
        double height;
    };
    std::vector<Parabola> at_;
    std::vector<double> from_;  ///< where a parabola becomes the lowest
    std::vector<double> half_inverse_;
    int count_ = 0;
};

struct SliceScratch {
    explicit SliceScratch(glm::ivec3 n)
        : square(std::size_t(n.x) * std::size_t(n.y)),
          column(std::size_t(n.y) * k_tile),
          made(std::size_t(std::max(n.x, n.y))),
          labels(std::size_t(n.y) * k_tile),
          along_y(n.y),
          along_x(n.x) {}
    std::vector<double> square, column, made;
    std::vector<std::uint32_t> labels;
    Line along_y, along_x;
};

void columns_of_slice(const LabelGrid& grid, const std::uint32_t* labels, SliceScratch& s) {
    const int nx = grid.size.x, ny = grid.size.y;
    for (int x0 = 0; x0 < nx; x0 += k_tile) {
        const int width = std::min(k_tile, nx - x0);
        for (int y = 0; y < ny; ++y)
            for (int c = 0; c < width; ++c) {
                const std::size_t from = std::size_t(y) * std::size_t(nx) + std::size_t(x0 + c);
                const std::size_t to = std::size_t(c) * std::size_t(ny) + std::size_t(y);
                s.column[to] = s.square[from];
                s.labels[to] = labels[from];
            }
        for (int c = 0; c < width; ++c) {
            double* column = s.column.data() + std::size_t(c) * std::size_t(ny);
            s.along_y.run(s.labels.data() + std::size_t(c) * std::size_t(ny), column, s.made.data(), ny);
            std::copy_n(s.made.data(), ny, column);
        }
        for (int y = 0; y < ny; ++y)
            for (int c = 0; c < width; ++c)
                s.square[std::size_t(y) * std::size_t(nx) + std::size_t(x0 + c)] =
                    s.column[std::size_t(c) * std::size_t(ny) + std::size_t(y)];
    }
}

void finish_slice(const LabelGrid& grid, const std::uint32_t* labels, double unit_mm, std::uint16_t* distance,
                  SliceScratch& s) {
    const glm::ivec3 n = grid.size;
    const glm::dvec3 unit = grid.spacing_mm;
    const double z_in_y = (unit.z / unit.y) * (unit.z / unit.y), y_in_x = (unit.y / unit.x) * (unit.y / unit.x);
    const std::size_t count = s.square.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double d = distance[i];
        s.square[i] = distance[i] == k_unlimited ? k_infinite : d * d * z_in_y;
    }
    columns_of_slice(grid, labels, s);
    for (double& v : s.square) v *= y_in_x;
    const double scale = unit.x / unit_mm, most = k_leap_limit;
    for (int y = 0; y < n.y; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(n.x);
        s.along_x.run(labels + row, s.square.data() + row, s.made.data(), n.x);
        for (int x = 0; x < n.x; ++x)
            distance[row + std::size_t(x)] =
                std::uint16_t(std::min(std::sqrt(s.made[std::size_t(x)]) * scale + 1e-9, most));
    }
}

}  // namespace

int leap_units(double distance_mm, double unit_mm) {
    return int(std::min(distance_mm / unit_mm + 1e-9, double(k_leap_limit)));
}

void exact_distances(const LabelGrid& grid, double unit_mm, std::uint16_t* distance, const JobContext& job) {
    distances_along_z(grid, distance, job.part(0, 0.2));
    const std::int64_t slice = std::int64_t(grid.size.x) * grid.size.y;
    parallel_bands(
        0, grid.size.z, k_bands,
        [&](std::int64_t first, std::int64_t last) {
            SliceScratch scratch(grid.size);
            for (std::int64_t z = first; z < last; ++z) {
                job.check();
                finish_slice(grid, grid.labels + z * slice, unit_mm, distance + z * slice, scratch);
            }
        },
        job.part(0.2, 1));
}

}  // namespace lacuna
