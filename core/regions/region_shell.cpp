#include "core/regions/region_shell.h"

#include <algorithm>

#include "core/base/vector_clones.h"

namespace lacuna {

namespace {

using Byte = std::uint8_t;

/// What of one row is own (0, else far), beyond (far in the region, else 0) and foreign (0, else far).
/// @param part  0 outside it; null: everything is in it
LACUNA_VECTOR_CLONES void mark_row(const std::uint32_t* __restrict label, const Byte* __restrict part, std::uint32_t id,
                                   Byte far, int n, Byte* __restrict own, Byte* __restrict beyond,
                                   Byte* __restrict foreign) {
    for (int x = 0; x < n; ++x) {
        const bool mine = label[x] == id;
        own[x] = mine ? 0 : far;
        beyond[x] = mine ? far : 0;
        foreign[x] = (!mine) & (label[x] != 0) ? 0 : far;
    }
    if (!part) return;
    for (int x = 0; x < n; ++x) foreign[x] = (own[x] != 0) & (part[x] == 0) ? 0 : foreign[x];
}

/// to[i] becomes the least of itself and, where they lie `apart` steps away, before[i] and after[i].
LACUNA_VECTOR_CLONES void take_nearer(Byte* __restrict to, const Byte* __restrict before, const Byte* __restrict after,
                                      std::size_t n, Byte apart) {
    for (std::size_t i = 0; i < n; ++i) {
        const Byte nearer = before[i] < after[i] ? before[i] : after[i];
        const Byte away = nearer > apart ? nearer : apart;
        to[i] = to[i] < away ? to[i] : away;
    }
}

}  // namespace

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
    // Rows of `far` above and below, and a stretch of it behind each row, let neighbours be taken without a look at
    // where they lie.
    stride_ = std::size_t(extent_.x) + std::size_t(reach_);
    margin_ = (std::size_t(reach_) + 1) * stride_;
    for (auto& flat : {&along_x_, &along_y_})
        flat->assign(2 * margin_ + stride_ * std::size_t(extent_.y), Byte(reach_ + 1));
}

RegionShell::SliceView RegionShell::slice(int z) {
    for (; loaded_ <= z + reach_; ++loaded_) load(loaded_);
    for (Field* field : {&own_, &beyond_, &foreign_}) combine(*field, z);
    return {own_.result.data(), beyond_.result.data(), foreign_.result.data()};
}

/// In-slice distances of window slice z; what lies outside the grid is neither own nor foreign.
void RegionShell::load(int z) {
    const std::size_t slot = std::size_t((z + reach_) % (2 * reach_ + 1));
    const auto far = Byte(reach_ + 1);
    std::vector<Byte>&own = own_.ring[slot], &beyond = beyond_.ring[slot], &foreign = foreign_.ring[slot];
    std::fill(own.begin(), own.end(), far);
    std::fill(beyond.begin(), beyond.end(), Byte(0));
    std::fill(foreign.begin(), foreign.end(), far);
    const glm::ivec3 size = labels_.geometry.size;
    const int at_z = first_.z + z;
    if (at_z < 0 || at_z >= size.z) return;
    const int x0 = std::max(0, -first_.x), x1 = std::min(extent_.x, size.x - first_.x);
    for (int y = std::max(0, -first_.y); y < std::min(extent_.y, size.y - first_.y); ++y) {
        const std::int64_t start = labels_.geometry.linear_index(first_.x + x0, first_.y + y, at_z);
        const std::size_t to = std::size_t(y) * std::size_t(extent_.x) + std::size_t(x0);
        mark_row(labels_.labels->data() + start, part_ ? part_->labels->data() + start : nullptr, id_, far, x1 - x0,
                 own.data() + to, beyond.data() + to, foreign.data() + to);
    }
    for (Field* field : {&own_, &beyond_, &foreign_}) spread(field->ring[slot]);
}

/// From 0 and far to chessboard distances within the slice: along x, then across.
void RegionShell::spread(std::vector<std::uint8_t>& slice) {
    const std::size_t width = std::size_t(extent_.x), inner = stride_ * std::size_t(extent_.y);
    Byte* const x = along_x_.data() + margin_;
    Byte* const y = along_y_.data() + margin_;
    for (std::size_t row = 0; row < std::size_t(extent_.y); ++row)
        std::copy_n(slice.data() + row * width, width, x + row * stride_);
    std::copy_n(x, inner, y);
    for (int d = 1; d <= reach_; ++d) take_nearer(y, x - d, x + d, inner, Byte(d));
    for (std::size_t row = 0; row < std::size_t(extent_.y); ++row) {  // the gaps are no voxels
        std::copy_n(y + row * stride_, width, x + row * stride_);
    }
    for (int d = 1; d <= reach_; ++d) {
        const std::size_t away = std::size_t(d) * stride_;
        take_nearer(y, x - away, x + away, inner, Byte(d));
    }
    for (std::size_t row = 0; row < std::size_t(extent_.y); ++row)
        std::copy_n(y + row * stride_, width, slice.data() + row * width);
}

void RegionShell::combine(Field& field, int z) {
    const std::size_t slots = field.ring.size();
    const auto slice = [&](int dz) { return field.ring[std::size_t(z + dz + reach_) % slots].data(); };
    constexpr std::size_t k_piece = 8192;  // of all slices at once, so that the result stays near
    for (std::size_t begin = 0; begin < plane_; begin += k_piece) {
        const std::size_t n = std::min(k_piece, plane_ - begin);
        Byte* const out = field.result.data() + begin;
        std::copy_n(slice(0) + begin, n, out);
        for (int d = 1; d <= reach_; ++d) take_nearer(out, slice(-d) + begin, slice(d) + begin, n, Byte(d));
    }
}

}  // namespace lacuna
