#include "core/accel/binary_pyramid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

using Answer = VisibilityTable::Answer;
using Kind = BinaryPyramid::Kind;
constexpr int k_block = 8;  // cells a block edge
constexpr int k_block_bytes = 64;
constexpr int k_corners = k_block + 1;
constexpr int k_row = 16;  // bytes a row of corner labels: one vector register
constexpr int k_float_bins = 65536;
constexpr int k_last_label = 255;

/// The value axis cut into pieces, numbered upwards: even pieces are those in which no value matters, odd ones matter.
/// Then nothing between two values matters exactly if both carry the same even label.
struct ValueLabels {
    std::vector<std::uint8_t> of;
    double lo = 0, scale = 0;  // f32: bin = (value - lo) * scale

    template <class T>
    std::uint8_t operator()(T value) const {
        if constexpr (std::is_floating_point_v<T>) {
            const double bin = std::clamp((double(value) - lo) * scale, 0.0, double(k_float_bins - 1));
            return of[std::size_t(bin)];
        } else {
            return of[std::size_t(int(value) - int(std::numeric_limits<T>::min()))];
        }
    }
};

/// Numbers the steps [begin, end) of the value axis. @param at the closed value interval of a step
template <class At>
void number_steps(ValueLabels& labels, int begin, int end, const VisibilityTable& table, double slack, Kind kind,
                  At&& at) {
    const Answer idle = kind == Kind::visible ? Answer::none : Answer::all;
    const auto is_idle = [&](double lo, double hi) { return table.query({lo - slack, hi + slack}) == idle; };
    int label = 0;
    for (int i = begin; i < end; ++i) {
        const ValueRange here = at(i);
        if (!is_idle(here.lo, here.hi)) {
            label |= 1;
        } else if (label & 1) {
            label += 1;
        } else if (i > begin && !is_idle(at(i - 1).lo, here.hi)) {
            label += 2;
        }
        // Too many pieces for a byte: all above count as one that matters.
        if (label >= k_last_label) label = k_last_label - 2;
        labels.of[std::size_t(i)] = std::uint8_t(label);
        if (label == k_last_label - 2) {
            std::fill(labels.of.begin() + i, labels.of.begin() + end, std::uint8_t(k_last_label));
            return;
        }
    }
}

template <class T>
ValueLabels make_labels(const VisibilityTable& table, double slack, ValueRange values, Kind kind) {
    ValueLabels labels;
    if constexpr (std::is_floating_point_v<T>) {
        labels.of.assign(k_float_bins, 1);
        labels.lo = values.lo;
        labels.scale = values.width() > 0 ? k_float_bins / values.width() : 0;
        const double width = values.width() / k_float_bins, guard = width * 1e-3;
        const int used = values.width() > 0 ? k_float_bins : 1;
        number_steps(labels, 0, used, table, slack, kind, [&](int i) {
            return ValueRange{values.lo + i * width - guard, values.lo + (i + 1) * width + guard};
        });
    } else {
        const int least = int(std::numeric_limits<T>::min());
        labels.of.assign(std::size_t(int(std::numeric_limits<T>::max()) - least + 1), 1);
        number_steps(labels, int(values.lo) - least, int(values.hi) - least + 1, table, slack, kind, [&](int i) {
            return ValueRange{double(i + least), double(i + least)};
        });
    }
    return labels;
}

/// Labels of the corners of a block's cells. `low` and `high` differ only where a voxel is not finite: it widens no
/// range (visible), or every range (gap).
struct Corners {
    alignas(64) std::uint8_t low[k_corners][k_corners][k_row];
    alignas(64) std::uint8_t high[k_corners][k_corners][k_row];
};

template <class T>
void label_corners(const VolumeView<T>& view, glm::ivec3 from, const ValueLabels& labels, Kind kind, Corners& out) {
    const int inside = std::min(k_corners, view.size.x - from.x);
    for (int z = 0; z < k_corners; ++z)
        for (int y = 0; y < k_corners; ++y) {
            const T* row =
                view.row(std::min(from.y + y, view.size.y - 1), std::min(from.z + z, view.size.z - 1)) + from.x;
            std::uint8_t* low = out.low[z][y];
            for (int x = 0; x < inside; ++x) {
                if constexpr (std::is_floating_point_v<T>) {
                    const bool finite = std::abs(row[x]) < std::numeric_limits<float>::infinity();
                    const bool gap = kind == Kind::gap;
                    low[x] = finite ? labels(row[x]) : gap ? std::uint8_t(0) : std::uint8_t(k_last_label);
                    out.high[z][y][x] = finite ? low[x] : gap ? std::uint8_t(k_last_label) : std::uint8_t(0);
                } else {
                    low[x] = labels(row[x]);
                }
            }
            for (int x = inside; x < k_corners; ++x) {
                low[x] = low[inside - 1];
                if constexpr (std::is_floating_point_v<T>) out.high[z][y][x] = out.high[z][y][inside - 1];
            }
        }
}

/// Eight bytes of 0 or 1 to the bits of one byte, the first to the lowest.
std::uint8_t packed(const std::uint8_t* flags) {
    std::uint64_t word;
    std::memcpy(&word, flags, sizeof word);
    return std::uint8_t((word * 0x0102040810204080ull) >> 56);
}

/// Extreme of each cell's eight corner labels along a row of cells.
template <class Pick>
void over_corners(const std::uint8_t (&labels)[k_corners][k_corners][k_row], int y, int z, Pick&& pick,
                  std::uint8_t* out) {
    std::uint8_t edge[k_row];
    const std::uint8_t *a = labels[z][y], *b = labels[z][y + 1], *c = labels[z + 1][y], *d = labels[z + 1][y + 1];
    for (int x = 0; x < k_row; ++x) edge[x] = pick(pick(a[x], b[x]), pick(c[x], d[x]));
    for (int x = 0; x < k_block; ++x) out[x] = pick(edge[x], edge[x + 1]);
}

template <class T>
void pack_block(const Corners& corners, std::uint8_t* block) {
    const auto least = [](std::uint8_t a, std::uint8_t b) { return a < b ? a : b; };
    const auto most = [](std::uint8_t a, std::uint8_t b) { return a > b ? a : b; };
    for (int z = 0; z < k_block; ++z)
        for (int y = 0; y < k_block; ++y) {
            std::uint8_t low[k_block], high[k_block], matters[k_block];
            over_corners(corners.low, y, z, least, low);
            if constexpr (std::is_floating_point_v<T>) {
                over_corners(corners.high, y, z, most, high);
            } else {
                over_corners(corners.low, y, z, most, high);
            }
            for (int x = 0; x < k_block; ++x)
                matters[x] = std::uint8_t((low[x] <= high[x]) & ((low[x] != high[x]) | (low[x] & 1)));
            block[z * k_block + y] = packed(matters);
        }
}

/// Sets to 0 what lies beyond the volume's last cell.
void clip_block(std::uint8_t* block, glm::ivec3 inside) {
    if (inside.x >= k_block && inside.y >= k_block && inside.z >= k_block) return;
    const auto row = std::uint8_t(inside.x >= k_block ? 0xff : (1 << inside.x) - 1);
    for (int z = 0; z < k_block; ++z)
        for (int y = 0; y < k_block; ++y)
            block[z * k_block + y] &= z < inside.z && y < inside.y ? row : std::uint8_t(0);
}

/// Sets the level's bit of a cell. Planes of blocks never share a byte, so that threads may take a plane each.
void set_bit(BinaryPyramid& pyramid, int level, glm::ivec3 cell) {
    const glm::ivec3 n = pyramid.stored[std::size_t(level)];
    const std::size_t bit =
        (std::size_t(cell.z) * std::size_t(n.y) + std::size_t(cell.y)) * std::size_t(n.x) + std::size_t(cell.x);
    pyramid.bits[pyramid.first[std::size_t(level)] + (bit >> 3)] |= std::uint8_t(1u << (bit & 7));
}

/// Levels 1 and 2 of a block, from its cells.
void raise_block(BinaryPyramid& pyramid, const std::uint8_t* block, glm::ivec3 at) {
    for (int z = 0; z < k_block; z += 2) {
        std::uint64_t a, b;
        std::memcpy(&a, block + z * k_block, sizeof a);
        std::memcpy(&b, block + (z + 1) * k_block, sizeof b);
        std::uint64_t both = a | b;  // row y in byte y
        if (both == 0) continue;
        both |= both >> 8;
        both |= both >> 1;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                if (both >> (16 * y + 2 * x) & 1) {
                    const glm::ivec3 cell = at * 4 + glm::ivec3(x, y, z / 2);
                    set_bit(pyramid, 1, cell);
                    set_bit(pyramid, 2, cell / 2);
                }
    }
}

/// Lays the levels out; true where the memory fits already.
void lay_out(BinaryPyramid& pyramid, glm::ivec3 size) {
    pyramid.cells = size;
    pyramid.stored.clear();
    pyramid.first.clear();
    const glm::ivec3 blocks = (size - 1) / k_block + 1;
    std::size_t next = 0;
    for (int level = 0;; ++level) {
        const glm::ivec3 n = level <= 3 ? blocks * (k_block >> level) : ((blocks - 1) >> (level - 3)) + 1;
        pyramid.stored.push_back(n);
        pyramid.first.push_back(next);
        next += (std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z) + 7) / 8;
        if (level >= 3 && n == glm::ivec3(1)) break;
    }
    pyramid.bits.resize(next);
    std::fill(pyramid.bits.begin() + std::ptrdiff_t(pyramid.first[1]), pyramid.bits.end(), std::uint8_t(0));
}

/// Calls each(cell) for the cells of a level that reach into the volume.
template <class Each>
void for_cells(const BinaryPyramid& pyramid, int level, Each&& each) {
    const glm::ivec3 n = ((pyramid.cells - 1) >> level) + 1;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x)
                if (!each(glm::ivec3(x, y, z))) return;
}

int start_level(const BinaryPyramid& pyramid) {
    const int size = std::max({pyramid.cells.x, pyramid.cells.y, pyramid.cells.z});
    int whole = 0;  // M: the level that is one cell
    while ((1 << whole) < size) ++whole;
    for (int level = std::max(whole - 2, 2); level >= 2; --level) {
        bool has_empty = false;
        for_cells(pyramid, level, [&](glm::ivec3 cell) {
            has_empty = !pyramid(level, cell);
            return !has_empty;
        });
        if (has_empty) return level;
    }
    return -1;
}

}  // namespace

bool BinaryPyramid::operator()(int level, glm::ivec3 cell) const {
    const glm::ivec3 n = stored[std::size_t(level)];
    if (level == 0) {
        const glm::ivec3 block = cell >> 3, in = cell & 7, blocks = n >> 3;
        const std::size_t at =
            (std::size_t(block.z) * std::size_t(blocks.y) + std::size_t(block.y)) * std::size_t(blocks.x) +
            std::size_t(block.x);
        return bits[at * k_block_bytes + std::size_t(in.z * k_block + in.y)] >> in.x & 1;
    }
    const std::size_t bit =
        (std::size_t(cell.z) * std::size_t(n.y) + std::size_t(cell.y)) * std::size_t(n.x) + std::size_t(cell.x);
    return bits[first[std::size_t(level)] + (bit >> 3)] >> (bit & 7) & 1;
}

void build_binary_pyramid(BinaryPyramid& pyramid, const Volume& volume, const MacrocellGrid& blocks,
                          const VisibilityTable& table, double slack, ValueRange values, Kind kind,
                          const JobContext& job) {
    lay_out(pyramid, volume.geometry().size);
    const std::vector<std::uint8_t> classes = classify_macrocells(blocks, table, slack);
    const auto all = std::uint8_t(kind == Kind::visible ? Answer::all : Answer::none);
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const auto view = volume.view<T>();
        const ValueLabels labels = make_labels<T>(table, slack, values, kind);
        parallel_for(
            0, blocks.cells.z,
            [&](std::int64_t bz) {
                Corners corners{};
                std::size_t i = std::size_t(bz) * std::size_t(blocks.cells.y) * std::size_t(blocks.cells.x);
                for (int by = 0; by < blocks.cells.y; ++by)
                    for (int bx = 0; bx < blocks.cells.x; ++bx, ++i) {
                        std::uint8_t* block = pyramid.bits.data() + i * k_block_bytes;
                        const glm::ivec3 at(bx, by, int(bz));
                        if (classes[i] == std::uint8_t(Answer::some)) {
                            label_corners(view, at * k_block, labels, kind, corners);
                            pack_block<T>(corners, block);
                        } else {
                            std::memset(block, classes[i] == all ? 0xff : 0, k_block_bytes);
                            if (classes[i] != all) continue;
                        }
                        clip_block(block, view.size - at * k_block);
                        raise_block(pyramid, block, at);
                    }
            },
            job);
    });
    for (int level = 3; level < pyramid.levels(); ++level)
        for_cells(pyramid, level - 1, [&](glm::ivec3 cell) {
            if (pyramid(level - 1, cell)) set_bit(pyramid, level, cell / 2);
            return true;
        });
    pyramid.top = start_level(pyramid);
}

}  // namespace lacuna
