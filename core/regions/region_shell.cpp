#include "core/regions/region_shell.h"

#include <algorithm>

namespace lacuna {

RegionShell::RegionShell(const LabelVolume& labels, const MaskVolume* part, std::uint32_t id,
                         const glm::ivec3& bbox_first, const glm::ivec3& bbox_last, int reach)
    : labels_(labels),
      part_(part),
      id_(id),
      reach_(reach),
      loaded_(-reach),
      first_(bbox_first - reach - 1),
      extent_(bbox_last - bbox_first + 1 + 2 * (reach + 1)),
      plane_(std::size_t(extent_.x) * std::size_t(extent_.y)) {
    for (Field* field : {&own_, &beyond_, &foreign_}) {
        field->ring.assign(std::size_t(2 * reach + 1), std::vector<std::uint8_t>(plane_));
        field->result.resize(plane_);
    }
    scratch_.resize(plane_);
}

RegionShell::SliceView RegionShell::slice(int z) {
    for (; loaded_ <= z + reach_; ++loaded_) load(loaded_);
    for (Field* field : {&own_, &beyond_, &foreign_}) combine(*field, z);
    return {own_.result.data(), beyond_.result.data(), foreign_.result.data()};
}

/// In-slice distances of window slice z; what lies outside the grid is neither own nor foreign.
void RegionShell::load(int z) {
    const std::size_t slot = std::size_t((z + reach_) % (2 * reach_ + 1));
    const auto far = std::uint8_t(reach_ + 1);
    std::vector<std::uint8_t>&own = own_.ring[slot], &beyond = beyond_.ring[slot], &foreign = foreign_.ring[slot];
    std::fill(own.begin(), own.end(), far);
    std::fill(beyond.begin(), beyond.end(), 0);
    std::fill(foreign.begin(), foreign.end(), far);
    const glm::ivec3 size = labels_.geometry.size;
    const int at_z = first_.z + z;
    if (at_z < 0 || at_z >= size.z) return;
    const int x0 = std::max(0, -first_.x), x1 = std::min(extent_.x, size.x - first_.x);
    for (int y = std::max(0, -first_.y); y < std::min(extent_.y, size.y - first_.y); ++y) {
        const std::int64_t start = labels_.geometry.linear_index(0, first_.y + y, at_z);
        const std::uint32_t* row = labels_.labels->data() + start + first_.x;
        const std::uint8_t* part = part_ ? part_->labels->data() + start + first_.x : nullptr;
        const std::size_t to = std::size_t(y) * std::size_t(extent_.x);
        for (int x = x0; x < x1; ++x) {
            const bool mine = row[x] == id_;
            own[to + std::size_t(x)] = mine ? 0 : far;
            beyond[to + std::size_t(x)] = mine ? far : 0;
            foreign[to + std::size_t(x)] = !mine && (row[x] != 0 || (part && part[x] == 0)) ? 0 : far;
        }
    }
    for (Field* field : {&own_, &beyond_, &foreign_}) spread(field->ring[slot]);
}

/// From 0 and far to chessboard distances within the slice: along x by two sweeps, then across.
void RegionShell::spread(std::vector<std::uint8_t>& slice) {
    const std::size_t width = std::size_t(extent_.x);
    const auto far = std::uint8_t(reach_ + 1);
    for (int y = 0; y < extent_.y; ++y) {
        std::uint8_t* row = slice.data() + std::size_t(y) * width;
        for (std::size_t x = 1; x < width; ++x)
            row[x] = std::min(row[x], std::uint8_t(std::min<int>(row[x - 1], reach_) + 1));
        for (std::size_t x = width - 1; x-- > 0;)
            row[x] = std::min(row[x], std::uint8_t(std::min<int>(row[x + 1], reach_) + 1));
    }
    std::copy(slice.begin(), slice.end(), scratch_.begin());
    for (int y = 0; y < extent_.y; ++y)
        for (int dy = -reach_; dy <= reach_; ++dy) {
            if (dy == 0 || y + dy < 0 || y + dy >= extent_.y) continue;
            const auto apart = std::uint8_t(std::abs(dy));
            const std::uint8_t* __restrict from = scratch_.data() + std::size_t(y + dy) * width;
            std::uint8_t* __restrict row = slice.data() + std::size_t(y) * width;
            for (std::size_t x = 0; x < width; ++x) row[x] = std::min(row[x], std::max(from[x], apart));
        }
    for (std::uint8_t& d : slice) d = std::min(d, far);
}

void RegionShell::combine(Field& field, int z) {
    const std::size_t slots = field.ring.size();
    std::uint8_t* __restrict out = field.result.data();
    std::copy(field.ring[std::size_t(z + reach_) % slots].begin(), field.ring[std::size_t(z + reach_) % slots].end(),
              field.result.begin());
    for (int dz = -reach_; dz <= reach_; ++dz) {
        if (dz == 0) continue;
        const std::uint8_t* __restrict from = field.ring[std::size_t(z + dz + reach_) % slots].data();
        const auto apart = std::uint8_t(std::abs(dz));
        for (std::size_t i = 0; i < plane_; ++i) out[i] = std::min(out[i], std::max(from[i], apart));
    }
}

}  // namespace lacuna
