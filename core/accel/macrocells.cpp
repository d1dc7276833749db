#include "core/accel/macrocells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"

namespace lacuna {

namespace {

constexpr float k_infinity = std::numeric_limits<float>::infinity();

template <class T>
struct RowRange {
    std::vector<T> least, most;
    std::vector<std::uint8_t> nan;  // f32 only

    explicit RowRange(int width) : least(std::size_t(width)), most(std::size_t(width)) {
        if constexpr (std::is_floating_point_v<T>) nan.resize(std::size_t(width));
    }
    void reset() {
        if constexpr (std::is_floating_point_v<T>) {
            std::fill(least.begin(), least.end(), k_infinity);
            std::fill(most.begin(), most.end(), -k_infinity);
            std::fill(nan.begin(), nan.end(), std::uint8_t(0));
        } else {
            std::fill(least.begin(), least.end(), std::numeric_limits<T>::max());
            std::fill(most.begin(), most.end(), std::numeric_limits<T>::lowest());
        }
    }
    /// Plain loops over whole rows: the compiler turns them into vector instructions.
    void add(const T* row) {
        const std::size_t width = least.size();
        T* lo = least.data();
        T* hi = most.data();
        if constexpr (std::is_floating_point_v<T>) {
            for (std::size_t x = 0; x < width; ++x) {
                const bool finite = std::abs(row[x]) < k_infinity;
                nan[x] = std::uint8_t(nan[x] | !finite);
                lo[x] = finite && row[x] < lo[x] ? row[x] : lo[x];
                hi[x] = finite && row[x] > hi[x] ? row[x] : hi[x];
            }
        } else {
            for (std::size_t x = 0; x < width; ++x) lo[x] = row[x] < lo[x] ? row[x] : lo[x];
            for (std::size_t x = 0; x < width; ++x) hi[x] = row[x] > hi[x] ? row[x] : hi[x];
        }
    }
};

template <class T>
void reduce_row(const RowRange<T>& rows, MacrocellGrid& grid, std::size_t first_cell) {
    const int width = int(rows.least.size()), edge = 1 << grid.shift;
    for (int c = 0; c < grid.cells.x; ++c) {
        float lo = k_infinity, hi = -k_infinity;
        bool nan = false;
        for (int x = c * edge; x <= std::min(c * edge + edge, width - 1); ++x) {
            lo = std::min(lo, float(rows.least[std::size_t(x)]));
            hi = std::max(hi, float(rows.most[std::size_t(x)]));
            if constexpr (std::is_floating_point_v<T>) nan = nan || rows.nan[std::size_t(x)];
        }
        grid.ranges[first_cell + std::size_t(c)] = {lo, hi};
        if constexpr (std::is_floating_point_v<T>) grid.has_nan[first_cell + std::size_t(c)] = nan;
    }
}

}  // namespace

MacrocellGrid build_macrocells(const Volume& volume, int shift, const JobContext& job) {
    MacrocellGrid grid;
    grid.shift = shift;
    const glm::ivec3 size = volume.geometry().size;
    grid.cells = ((size - 1) >> shift) + 1;
    const std::size_t count = std::size_t(grid.cells.x) * std::size_t(grid.cells.y) * std::size_t(grid.cells.z);
    grid.ranges.resize(count);
    if (volume.type() == VoxelType::f32) grid.has_nan.resize(count);
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const auto view = volume.view<T>();
        parallel_for(
            0, grid.cells.z,
            [&](std::int64_t cz) {
                RowRange<T> rows(size.x);
                const int edge = 1 << shift, z0 = int(cz) * edge, z1 = std::min(z0 + edge, size.z - 1);
                for (int cy = 0; cy < grid.cells.y; ++cy) {
                    rows.reset();
                    for (int z = z0; z <= z1; ++z)
                        for (int y = cy * edge; y <= std::min(cy * edge + edge, size.y - 1); ++y)
                            rows.add(view.row(y, z));
                    reduce_row(
                        rows, grid,
                        (std::size_t(cz) * std::size_t(grid.cells.y) + std::size_t(cy)) * std::size_t(grid.cells.x));
                }
            },
            job);
    });
    return grid;
}

std::vector<std::uint8_t> classify_macrocells(const MacrocellGrid& grid, const VisibilityTable& table, double slack) {
    std::vector<std::uint8_t> classes(grid.ranges.size());
    parallel_bands(0, std::int64_t(classes.size()), 2 * thread_count(), [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) {
            const auto c = std::size_t(i);
            const glm::vec2 range = grid.ranges[c];
            auto answer = range.x > range.y ? VisibilityTable::Answer::none
                                            : table.query({double(range.x) - slack, double(range.y) + slack});
            if (answer == VisibilityTable::Answer::all && !grid.has_nan.empty() && grid.has_nan[c])
                answer = VisibilityTable::Answer::some;
            classes[c] = std::uint8_t(answer);
        }
    });
    return classes;
}

namespace {

/// What cells of these ranges, lo hi lo hi .., are to a threshold: nothing of theirs reaches it below `none_below`, all
/// does from `all_from` on. A cell without values has lo > hi.
LACUNA_VECTOR_CLONES void compare_ranges(const float* __restrict range, std::uint8_t* __restrict answer, std::int64_t n,
                                         float none_below, float all_from) {
    using Answer = VisibilityTable::Answer;
    static_assert(int(Answer::none) == 0 && int(Answer::all) == 1 && int(Answer::some) == 2);
    for (std::int64_t i = 0; i < n; ++i) {
        const float lo = range[2 * i], hi = range[2 * i + 1];
        const int none = hi < none_below, all = (lo >= all_from) & (lo <= hi);
        answer[i] = std::uint8_t(all | (((all | none) ^ 1) << 1));
    }
}

}  // namespace

std::vector<std::uint8_t> classify_macrocells(const MacrocellGrid& grid, double iso, double slack) {
    using Answer = VisibilityTable::Answer;
    // Rounded outwards: a range that may reach the isovalue does.
    const float none_below = std::nextafter(float(iso - slack), -k_infinity);
    const float all_from = std::nextafter(float(iso + slack), k_infinity);
    std::vector<std::uint8_t> classes(grid.ranges.size());
    parallel_bands(0, std::int64_t(classes.size()), thread_count(), [&](std::int64_t first, std::int64_t last) {
        std::uint8_t* out = classes.data();
        compare_ranges(&grid.ranges[std::size_t(first)].x, out + first, last - first, none_below, all_from);
        if (grid.has_nan.empty()) return;
        for (std::int64_t i = first; i < last; ++i)
            if (out[i] == std::uint8_t(Answer::all) && grid.has_nan[std::size_t(i)])
                out[i] = std::uint8_t(Answer::some);
    });
    return classes;
}

}  // namespace lacuna
