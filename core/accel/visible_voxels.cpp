#include "core/accel/visible_voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

/// Calls visit(column) for each set bit of a row, ascending.
template <class Visit>
void for_each_bit(const std::uint64_t* words, int count, Visit&& visit) {
    for (int w = 0; w < count; ++w)
        for (std::uint64_t left = words[w]; left != 0; left &= left - 1) visit(w * 64 + std::countr_zero(left));
}

/// Fills row_begin and makes room in column.
void count_rows(SliceLists& lists, const std::vector<std::uint64_t>& bits, int words) {
    const std::size_t rows = std::size_t(lists.slices) * std::size_t(lists.rows);
    lists.row_begin.resize(rows + 1);
    std::uint64_t total = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        lists.row_begin[row] = std::uint32_t(total);
        const std::uint64_t* word = bits.data() + row * std::size_t(words);
        for (int w = 0; w < words; ++w)
            if (word[w] != 0) total += std::uint64_t(std::popcount(word[w]));
        if (total >= std::numeric_limits<std::uint32_t>::max())
            throw Error(
                Errc::unsupported,
                "More than 2^32 voxels are visible; use mode iso, or an isovalue that gives a simpler surface.");
    }
    lists.row_begin[rows] = std::uint32_t(total);
    lists.column.resize(total);
}

std::array<std::int16_t, 3> packed(const glm::dvec3& normal) {
    const glm::ivec3 n(glm::floor(32767.0 * normal + 0.5));
    return {std::int16_t(n.x), std::int16_t(n.y), std::int16_t(n.z)};
}

/// Says how listed voxels look.
template <class T>
class Looks {
public:
    Looks(const Volume& volume, VoxelGradient filter, const SliceRows& slices)
        : view_(volume.view<T>()),
          normals_(volume, filter),
          slices_(slices),
          front_(slices.direction.from_low ? 0 : slices.slices - 1) {}

    VoxelLook operator()(int u, int v, int c) const {
        const SliceDirection& direction = slices_.direction;
        glm::ivec3 p;
        p[direction.u_axis()] = u;
        p[direction.v_axis()] = v;
        p[direction.axis] = c;
        VoxelLook look;
        look.value = float(view_(p.x, p.y, p.z));
        if (slices_.inner(u, v, c)) {
            look.kind = VoxelLook::cap;
        } else if (c == front_) {
            look.normal[std::size_t(direction.axis)] = 32767;
        } else {
            look.normal = packed(normals_.at(p));
            look.sides = sides_of(u, v, c);
        }
        return look;
    }

private:
    /// Which of them rays enter by is the view's to say: lists for every lean say the same of a voxel.
    std::uint8_t sides_of(int u, int v, int c) const {
        const int sides =
            (u == 0 ? 1 : 0) | (u == slices_.columns - 1 ? 2 : 0) | (v == 0 ? 4 : 0) | (v == slices_.rows - 1 ? 8 : 0);
        if (sides == 0 || !slices_.voxel(u, v, slices_.direction.from_low ? c - 1 : c + 1)) return 0;
        return std::uint8_t(sides);
    }

    VolumeView<T> view_;
    VoxelNormals<T> normals_;
    const SliceRows& slices_;
    int front_;
};

void fill_voxels(VisibleVoxels& lists, const Volume& volume, const Solid& solid, const SliceRows& slices,
                 const std::vector<std::uint64_t>& bits, const JobContext& job) {
    lists.look.resize(lists.column.size());
    visit_type(volume.type(), [&](auto tag) {
        const Looks<decltype(tag)> look(volume, solid.gradient, slices);
        const auto list_row = [&](int v, int c) {
            const std::size_t row = std::size_t(c) * std::size_t(lists.rows) + std::size_t(v);
            std::size_t to = lists.row_begin[row];
            if (to == lists.row_begin[row + 1]) return;
            for_each_bit(bits.data() + row * std::size_t(slices.words), slices.words, [&](int u) {
                lists.column[to] = std::uint16_t(u);
                lists.look[to++] = look(u, v, c);
            });
        };
        // Slices across x are walked a z at a time, so that neighbours are still in the cache.
        const bool across_x = lists.direction.axis == 0;
        const int outer = across_x ? lists.rows : lists.slices, inner = across_x ? lists.slices : lists.rows;
        parallel_for(
            0, outer,
            [&](std::int64_t o) {
                for (int i = 0; i < inner; ++i) across_x ? list_row(int(o), i) : list_row(i, int(o));
            },
            job);
    });
}

glm::dmat4 placement(const GridGeometry& geometry) {
    glm::dmat4 placed(1);
    for (int axis = 0; axis < 3; ++axis)
        placed[axis] = glm::dvec4(geometry.direction[axis] * geometry.spacing[axis], geometry.size[axis]);
    placed[3] = glm::dvec4(geometry.origin, 1);
    return placed;
}

}  // namespace

bool VisibleVoxelCache::serves(const Volume& volume, const Solid& solid) const {
    return volume.data() == voxels_.data() && solid_ == solid && placed_ == placement(volume.geometry());
}

bool VisibleVoxelCache::has(const Volume& volume, const Solid& solid, const SliceDirection& direction) const {
    return serves(volume, solid) && voxel_lists_[direction.index()];
}

bool VisibleVoxelCache::has_cells(const Volume& volume, const Solid& solid, const SliceDirection& direction) const {
    return serves(volume, solid) && cell_lists_[direction.index()];
}

/// Makes the bits those of the solid, as far as they are not.
void VisibleVoxelCache::use(const Volume& volume, const Solid& solid, const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    if (std::max({size.x, size.y, size.z}) > 65534)
        throw Error(Errc::unsupported, "Shear-warp takes at most 65534 voxels along an axis; use mode iso.");
    if (serves(volume, solid)) return;
    const bool same_material = solid_ && volume.data() == voxels_.data() && placed_ == placement(volume.geometry()) &&
                               solid_->iso == solid.iso && solid_->ranges == solid.ranges;
    if (!same_material) {
        drop();
        bits_.material = threshold_bits(volume, solid.iso, solid.ranges, job);
    }
    solid_.reset();  // a build that is stopped half-way leaves nothing that looks whole
    voxel_lists_ = {};
    cell_lists_ = {};
    voxels_ = volume.buffer();
    placed_ = placement(volume.geometry());
    solid_ = solid;
}

/// The rows of a region's slices; makes the bits they read.
SliceRows VisibleVoxelCache::slices(const Volume& volume, const Solid& solid, const SliceDirection& direction,
                                    const JobContext& job) {
    use(volume, solid, job.part(0, 0.4));
    const bool cut = !solid.cuts.empty(), turn = direction.axis == 0;
    const JobContext quiet{job.stop, nullptr};
    if (cut && bits_.interior.bytes() == 0) bits_.interior = eroded(bits_.material, quiet);
    if (turn && bits_.material_turned.bytes() == 0) bits_.material_turned = turned(bits_.material, quiet);
    if (turn && cut && bits_.interior_turned.bytes() == 0) bits_.interior_turned = turned(bits_.interior, quiet);
    return {bits_, volume.geometry(), solid.cuts, direction};
}

std::shared_ptr<const VisibleVoxels> VisibleVoxelCache::get(const Volume& volume, const Solid& solid,
                                                            const SliceDirection& direction, const JobContext& job) {
    const SliceRows rows = slices(volume, solid, direction, job);
    auto& slot = voxel_lists_[direction.index()];
    if (slot) return slot;
    auto lists = std::make_shared<VisibleVoxels>();
    lists->direction = direction;
    lists->columns = rows.columns;
    lists->rows = rows.rows;
    lists->slices = rows.slices;
    const auto bits = visible_voxel_bits(rows, job);
    count_rows(*lists, bits, rows.words);
    fill_voxels(*lists, volume, solid, rows, bits, job.part(0.6, 1));
    slot = lists;
    return lists;
}

std::shared_ptr<const VisibleCells> VisibleVoxelCache::get_cells(const Volume& volume, const Solid& solid,
                                                                 const SliceDirection& direction,
                                                                 const JobContext& job) {
    const SliceRows rows = slices(volume, solid, direction, job);
    auto& slot = cell_lists_[direction.index()];
    if (slot) return slot;
    auto lists = std::make_shared<VisibleCells>();
    lists->direction = direction;
    lists->columns = rows.columns + 1;
    lists->rows = rows.rows + 1;
    lists->slices = rows.slices;
    const auto bits = visible_cell_bits(rows, job);
    count_rows(*lists, bits, rows.cell_words);
    std::size_t to = 0;
    for (std::size_t row = 0; row + 1 < lists->row_begin.size(); ++row) {
        if (lists->row_begin[row] == lists->row_begin[row + 1]) continue;
        for_each_bit(bits.data() + row * std::size_t(rows.cell_words), rows.cell_words,
                     [&](int i) { lists->column[to++] = std::uint16_t(i); });
    }
    slot = lists;
    return lists;
}

std::size_t VisibleVoxelCache::bytes_held() const {
    std::size_t bytes = bits_.bytes();
    for (const auto& lists : voxel_lists_) bytes += lists ? lists->bytes() : 0;
    for (const auto& lists : cell_lists_) bytes += lists ? lists->bytes() : 0;
    return bytes;
}

}  // namespace lacuna
