#include "core/accel/solid_bits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

/// 64 bytes of 0 or 1 as the bits of a word, the first byte lowest.
std::uint64_t gather_bits(const std::uint8_t* bytes) {
    std::uint64_t word = 0;
    for (int k = 0; k < 8; ++k) {
        std::uint64_t eight;
        std::memcpy(&eight, bytes + 8 * k, 8);
        word |= (eight * 0x0102040810204080u >> 56) << (8 * k);  // each byte's bit moves to its place in the top byte
    }
    return word;
}

template <class T, class Inside>
BitVolume pack(const Volume& volume, Inside&& inside, const JobContext& job) {
    const auto view = volume.view<T>();
    BitVolume bits(view.size);
    parallel_for(
        0, view.size.z,
        [&](std::int64_t z) {
            std::array<std::uint8_t, 64> bytes{};
            for (int y = 0; y < view.size.y; ++y) {
                const T* voxels = view.row(y, int(z));
                std::uint64_t* row = bits.row(y, int(z));
                int x0 = 0;
                for (; x0 + 64 <= view.size.x; x0 += 64) {
                    for (std::size_t b = 0; b < 64; ++b) bytes[b] = inside(voxels[std::size_t(x0) + b]);
                    row[x0 >> 6] = gather_bits(bytes.data());
                }
                for (int x = x0; x < view.size.x; ++x) row[x >> 6] |= std::uint64_t(inside(voxels[x])) << (x & 63);
            }
        },
        job);
    return bits;
}

/// Clears the bits [0, length) of a row where the residual, linear along it, is negative.
void cut_row(std::uint64_t* row, int length, double at_first, double per_bit) {
    if (per_bit == 0) {
        if (!(at_first >= 0)) clear_bits(row, 0, length);
        return;
    }
    const double zero = std::clamp(-at_first / per_bit, -1.0, double(length));
    if (per_bit > 0)
        clear_bits(row, 0, std::clamp(int(std::ceil(zero)), 0, length));
    else
        clear_bits(row, std::clamp(int(std::floor(zero)) + 1, 0, length), length);
}

}  // namespace

BitVolume threshold_bits(const Volume& volume, double iso, const std::vector<ValueRange>& ranges,
                         const JobContext& job) {
    Classification classes;
    for (const ValueRange& range : ranges) classes.ranges.push_back({"", range, std::nullopt});
    return visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        constexpr double lowest = double(std::numeric_limits<T>::lowest()), highest = std::numeric_limits<T>::max();
        if constexpr (std::is_floating_point_v<T>) {
            if (!ranges.empty())
                return pack<T>(
                    volume, [&](T v) { return std::isfinite(v) && iso_measure(classes, iso, double(v)) >= 0; }, job);
            return pack<T>(
                volume, [iso](T v) { return double(v) >= iso && v <= std::numeric_limits<T>::max(); }, job);
        } else {
            if (ranges.empty()) {
                if (!(iso <= highest)) return BitVolume(volume.geometry().size);
                const int least = int(std::ceil(std::max(iso, lowest)));
                return pack<T>(
                    volume, [least](T v) { return int(v) >= least; }, job);
            }
            std::vector<std::uint8_t> table(std::size_t(highest - lowest + 1));
            for (std::size_t i = 0; i < table.size(); ++i)
                table[i] = iso_measure(classes, iso, double(i) + lowest) >= 0;
            return pack<T>(
                volume, [&](T v) { return table[std::size_t(int(v) - int(lowest))]; }, job);
        }
    });
}

CutResidual residual_of(const SolidCut& cut, const GridGeometry& geometry, const SliceDirection& direction) {
    const auto step = [&](int axis) { return glm::dot(cut.normal, geometry.direction[axis]) * geometry.spacing[axis]; };
    return {step(direction.u_axis()), step(direction.v_axis()), step(direction.axis),
            glm::dot(cut.normal, geometry.voxel_to_mm({0, 0, 0})) + cut.offset, cut.cap};
}

SliceRows::SliceRows(const SolidBits& bits, const GridGeometry& geometry, const std::vector<SolidCut>& cuts,
                     const SliceDirection& slices_direction)
    : direction(slices_direction),
      columns(geometry.size[direction.u_axis()]),
      rows(geometry.size[direction.v_axis()]),
      slices(geometry.size[direction.axis]),
      words((columns + 63) / 64),
      cell_words((columns + 64) / 64),
      material_(direction.axis == 0 ? bits.material_turned : bits.material),
      interior_(cuts.empty()          ? nullptr
                : direction.axis == 0 ? &bits.interior_turned
                                      : &bits.interior) {
    for (const SolidCut& cut : cuts) {
        cuts_.push_back(residual_of(cut, geometry, direction));
        open_ = open_ || !cut.cap;
    }
}

const std::uint64_t* SliceRows::voxels(int v, int c, std::uint64_t* scratch) const {
    const std::uint64_t* material = row(material_, v, c);
    if (cuts_.empty()) return material;
    std::copy(material, material + words, scratch);
    if (open_) {
        std::uint64_t* buried = scratch + words;
        const std::uint64_t* interior = row(*interior_, v, c);
        std::copy(interior, interior + words, buried);
        for (const CutResidual& cut : cuts_) {
            const double reach = std::fabs(cut.a) + std::fabs(cut.b) + std::fabs(cut.c);  // to any of 26 neighbours
            if (cut.cap) cut_row(buried, columns, cut.at(0, v, c) - reach, cut.a);
        }
        for (int w = 0; w < words; ++w) scratch[w] &= ~buried[w];
    }
    for (const CutResidual& cut : cuts_) cut_row(scratch, columns, cut.at(0, v, c), cut.a);
    return scratch;
}

bool SliceRows::voxel(int u, int v, int c) const {
    if (!bit(material_, u, v, c)) return false;
    bool buried = open_ && bit(*interior_, u, v, c);
    for (const CutResidual& cut : cuts_) {
        const double residual = cut.at(u, v, c);
        if (!(residual >= 0)) return false;
        if (cut.cap) buried = buried && residual >= std::fabs(cut.a) + std::fabs(cut.b) + std::fabs(cut.c);
    }
    return !buried;
}

void SliceRows::cells(int j, int c, std::uint64_t* any, std::uint64_t* full) const {
    const std::uint64_t* before = row(material_, std::max(j - 1, 0), c);
    const std::uint64_t* behind = row(material_, std::min(j, rows - 1), c);
    const bool side = j == 0 || j == rows;
    std::uint64_t any_carry = 0, full_carry = 0;
    for (int w = 0; w < cell_words; ++w) {
        const std::uint64_t either = w < words ? before[w] | behind[w] : 0,
                            both = w < words ? before[w] & behind[w] : 0;
        any[w] = either | either << 1 | any_carry;
        full[w] = side ? 0 : both & (both << 1 | full_carry);
        any_carry = either >> 63;
        full_carry = both >> 63;
    }
}

void SliceRows::cut_cells(int j, int c, std::uint64_t* any, std::uint64_t* full) const {
    for (const CutResidual& cut : cuts_) {
        const double first = cut.at(-1, j - 1, c);
        const double slack = 1e-9 * (std::fabs(first) + std::fabs(cut.a) * columns + std::fabs(cut.b));
        cut_row(any, columns + 1, first + std::fmax(cut.a, 0) + std::fmax(cut.b, 0) + slack, cut.a);
        cut_row(full, columns + 1, first + std::fmin(cut.a, 0) + std::fmin(cut.b, 0) - slack, cut.a);
    }
}

void SliceRows::far_from_caps(int j, int c, std::uint64_t* cells) const {
    for (const CutResidual& cut : cuts_) {
        const double reach = 2 * (std::fabs(cut.a) + std::fabs(cut.b) + std::fabs(cut.c));
        if (cut.cap) cut_row(cells, columns + 1, cut.at(-1, j - 1, c) - reach, cut.a);
    }
}

}  // namespace lacuna
