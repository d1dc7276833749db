#include "core/accel/visible_voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

Classification ranges_only(const Solid& solid) {
    Classification classification;
    for (const ValueRange& range : solid.ranges) classification.ranges.push_back({"", range, std::nullopt});
    return classification;
}

template <class T, class Inside>
BitVolume pack(const Volume& volume, Inside&& inside, const JobContext& job) {
    const auto view = volume.view<T>();
    BitVolume bits(view.size);
    parallel_for(
        0, view.size.z,
        [&](std::int64_t z) {
            for (int y = 0; y < view.size.y; ++y) {
                const T* voxels = view.row(y, int(z));
                std::uint64_t* row = bits.row(y, int(z));
                for (int x0 = 0; x0 < view.size.x; x0 += 64) {
                    const int count = std::min(64, view.size.x - x0);
                    std::uint64_t word = 0;
                    for (int b = 0; b < count; ++b) word |= std::uint64_t(inside(voxels[x0 + b])) << b;
                    row[x0 >> 6] = word;
                }
            }
        },
        job);
    return bits;
}

/// Bit set where iso_measure >= 0; a voxel that is not finite is empty.
BitVolume threshold(const Volume& volume, const Solid& solid, const JobContext& job) {
    const Classification classes = ranges_only(solid);
    return visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        if constexpr (std::is_floating_point_v<T>) {
            if (solid.ranges.empty())
                return pack<T>(
                    volume, [&](T v) { return std::isfinite(v) && double(v) >= solid.iso; }, job);
            return pack<T>(
                volume, [&](T v) { return std::isfinite(v) && iso_measure(classes, solid.iso, double(v)) >= 0; }, job);
        } else {
            constexpr int lowest = std::numeric_limits<T>::min(), highest = std::numeric_limits<T>::max();
            std::vector<std::uint8_t> table(std::size_t(highest - lowest + 1));
            for (int v = lowest; v <= highest; ++v)
                table[std::size_t(v - lowest)] = iso_measure(classes, solid.iso, v) >= 0;
            return pack<T>(
                volume, [&](T v) { return table[std::size_t(int(v) - lowest)]; }, job);
        }
    });
}

/// Clears the voxels of a row that a cut takes away; the residual is linear along the row.
void cut_row(std::uint64_t* row, int length, double at_first, double per_voxel) {
    if (per_voxel == 0) {
        if (!(at_first >= 0)) clear_bits(row, 0, length);
        return;
    }
    const double zero = std::clamp(-at_first / per_voxel, -1.0, double(length));
    if (per_voxel > 0)
        clear_bits(row, 0, std::clamp(int(std::ceil(zero)), 0, length));
    else
        clear_bits(row, std::clamp(int(std::floor(zero)) + 1, 0, length), length);
}

enum class Which { capped, all };

void cut_away(BitVolume& bits, const GridGeometry& geometry, const std::vector<SolidCut>& cuts, Which which,
              const JobContext& job) {
    const glm::ivec3 size = bits.size();
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {
            for (int y = 0; y < size.y; ++y) {
                for (const SolidCut& cut : cuts) {
                    if (which == Which::capped && !cut.cap) continue;
                    const double first = glm::dot(cut.normal, geometry.voxel_to_mm({0, y, z})) + cut.offset;
                    const double step = glm::dot(cut.normal, geometry.direction[0]) * geometry.spacing.x;
                    cut_row(bits.row(y, int(z)), size.x, first, step);
                }
            }
        },
        job);
}

BitVolume filled(glm::ivec3 size) {
    BitVolume bits(size);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            std::uint64_t* row = bits.row(y, z);
            std::fill(row, row + bits.words_per_row(), ~std::uint64_t(0));
            clear_bits(row, size.x, bits.words_per_row() * 64);
        }
    }
    return bits;
}

/// What stands after the cuts. With an open cut, inner voxels stand only where a capped cut lays them bare.
BitVolume apply_cuts(const BitVolume& material, const BitVolume& interior, const GridGeometry& geometry,
                     const std::vector<SolidCut>& cuts, const JobContext& job) {
    BitVolume kept = material;
    if (std::any_of(cuts.begin(), cuts.end(), [](const SolidCut& cut) { return !cut.cap; })) {
        BitVolume capped = filled(material.size());
        cut_away(capped, geometry, cuts, Which::capped, job);
        const BitVolume deep = eroded(capped, job);
        for (int z = 0; z < material.size().z; ++z)
            for (int y = 0; y < material.size().y; ++y)
                for (int w = 0; w < material.words_per_row(); ++w)
                    kept.row(y, z)[w] &= ~(interior.row(y, z)[w] & deep.row(y, z)[w]);
    }
    cut_away(kept, geometry, cuts, Which::all, job);
    return kept;
}

/// Slices of a bit volume: words of row v of slice c.
struct Slices {
    const BitVolume& bits;
    bool rows_are_z;  ///< slices across y of the volume as stored; else across its z

    const std::uint64_t* row(int v, int c) const { return rows_are_z ? bits.row(c, v) : bits.row(v, c); }
};

/// Which of a slice's voxels one can look through onto the next: dilates by 3x3, the world beside the slice being
/// visible and empty.
void spread(std::vector<std::uint64_t>& seen, std::vector<std::uint64_t>& scratch, int columns, int rows, int words) {
    const auto at = [&](int v) { return std::size_t(v) * std::size_t(words); };
    const std::uint64_t last_mask = ~std::uint64_t(0) >> (words * 64 - columns);
    for (int v = 0; v < rows; ++v) {
        const std::uint64_t* in = seen.data() + at(v);
        std::uint64_t* out = scratch.data() + at(v);
        for (int w = 0; w < words; ++w)
            out[w] =
                in[w] | in[w] << 1 | in[w] >> 1 | (w > 0 ? in[w - 1] >> 63 : 0) | (w + 1 < words ? in[w + 1] << 63 : 0);
        out[0] |= 1;
        out[words - 1] |= std::uint64_t(1) << ((columns - 1) & 63);
    }
    for (int v = 0; v < rows; ++v) {
        std::uint64_t* out = seen.data() + at(v);
        const bool side = v == 0 || v == rows - 1;
        for (int w = 0; w < words; ++w)
            out[w] = side ? ~std::uint64_t(0)
                          : scratch[at(v - 1) + std::size_t(w)] | scratch[at(v) + std::size_t(w)] |
                                scratch[at(v + 1) + std::size_t(w)];
        out[words - 1] &= last_mask;
    }
}

/// Bits of the visible voxels of the object, rows of slice c at [(c*rows + v) * words].
std::vector<std::uint64_t> sweep(const Slices& slices, int columns, int rows, int count, int words, bool from_low,
                                 const JobContext& job) {
    const std::size_t slice_words = std::size_t(rows) * std::size_t(words);
    std::vector<std::uint64_t> visible(slice_words * std::size_t(count));
    std::vector<std::uint64_t> seen(slice_words, ~std::uint64_t(0)), scratch(slice_words);
    for (int v = 0; v < rows; ++v)
        seen[std::size_t(v + 1) * std::size_t(words) - 1] &= ~std::uint64_t(0) >> (words * 64 - columns);
    for (int k = 0; k < count; ++k) {
        job.check();
        const int c = from_low ? k : count - 1 - k;
        if (k > 0) spread(seen, scratch, columns, rows, words);
        for (int v = 0; v < rows; ++v) {
            const std::uint64_t* solid = slices.row(v, c);
            std::uint64_t* potential = seen.data() + std::size_t(v) * std::size_t(words);
            std::uint64_t* out = visible.data() + std::size_t(c) * slice_words + std::size_t(v) * std::size_t(words);
            for (int w = 0; w < words; ++w) {
                out[w] = potential[w] & solid[w];
                potential[w] &= ~solid[w];
            }
        }
    }
    return visible;
}

std::array<std::int16_t, 3> packed(const glm::dvec3& normal) {
    return {std::int16_t(std::lround(32767 * normal.x)), std::int16_t(std::lround(32767 * normal.y)),
            std::int16_t(std::lround(32767 * normal.z))};
}

/// Sobel's gradient over 3x3x3 voxels (clamped at the border), as a unit vector; 0 where it is zero or unknown. A voxel
/// behind a sharp edge may see nothing of it along its own three lines; its neighbours do.
template <class T>
glm::dvec3 normal_at(const VolumeView<T>& view, const glm::dvec3& spacing, const glm::ivec3& p) {
    constexpr int smooth[3] = {1, 2, 1};
    glm::dvec3 gradient(0);
    for (int dz = -1; dz <= 1; ++dz) {
        const int z = std::clamp(p.z + dz, 0, view.size.z - 1);
        for (int dy = -1; dy <= 1; ++dy) {
            const T* row = view.row(std::clamp(p.y + dy, 0, view.size.y - 1), z);
            for (int dx = -1; dx <= 1; ++dx) {
                const double value = double(row[std::clamp(p.x + dx, 0, view.size.x - 1)]);
                const int wx = smooth[dx + 1], wy = smooth[dy + 1], wz = smooth[dz + 1];
                gradient += value * glm::dvec3(dx * wy * wz, dy * wx * wz, dz * wx * wy);
            }
        }
    }
    gradient /= spacing;
    const double length = glm::length(gradient);
    return length > 0 && std::isfinite(length) ? gradient / length : glm::dvec3(0);
}

/// Fills the lists' columns and looks from the visible bits.
template <class T>
class Lister {
public:
    Lister(const Volume& volume, const BitVolume& kept, const BitVolume& interior, VisibleVoxels& lists)
        : view_(volume.view<T>()),
          spacing_(volume.geometry().spacing),
          kept_(kept),
          interior_(interior),
          lists_(lists),
          front_(lists.direction.from_low ? 0 : lists.slices - 1) {}

    void list_row(int v, int c, const std::uint64_t* words, int word_count) {
        std::size_t to = lists_.row_begin[std::size_t(c) * std::size_t(lists_.rows) + std::size_t(v)];
        for (int w = 0; w < word_count; ++w) {
            for (std::uint64_t left = words[w]; left != 0; left &= left - 1) {
                const int u = w * 64 + std::countr_zero(left);
                lists_.column[to] = std::uint16_t(u);
                lists_.look[to++] = look(u, v, c);
            }
        }
    }

private:
    VoxelLook look(int u, int v, int c) const {
        const SliceDirection& direction = lists_.direction;
        glm::ivec3 p;
        p[direction.u_axis()] = u;
        p[direction.v_axis()] = v;
        p[direction.axis] = c;
        VoxelLook look;
        look.value = float(view_(p.x, p.y, p.z));
        if (interior_.bytes() > 0 && interior_(p.x, p.y, p.z)) {
            look.kind = VoxelLook::cap;
            return look;
        }
        if (const int face = face_of(u, v, c, p); face >= 0) {
            look.normal[std::size_t(face)] = 32767;
        } else {
            look.normal = packed(normal_at(view_, spacing_, p));
        }
        return look;
    }

    /// The axis of the volume's own side through which the voxel is looked at, or -1: a voxel of the first slice, or
    /// one at a side that another voxel hides from the front.
    int face_of(int u, int v, int c, glm::ivec3 p) const {
        const SliceDirection& direction = lists_.direction;
        if (c == front_) return direction.axis;
        const bool u_side = u == 0 || u == lists_.columns - 1, v_side = v == 0 || v == lists_.rows - 1;
        if (!u_side && !v_side) return -1;
        p[direction.axis] += direction.from_low ? -1 : 1;
        if (!kept_(p.x, p.y, p.z)) return -1;
        return u_side ? direction.u_axis() : direction.v_axis();
    }

    VolumeView<T> view_;
    glm::dvec3 spacing_;
    const BitVolume& kept_;
    const BitVolume& interior_;
    VisibleVoxels& lists_;
    int front_;
};

void count_rows(VisibleVoxels& lists, const std::vector<std::uint64_t>& visible, int words) {
    const std::size_t rows = std::size_t(lists.slices) * std::size_t(lists.rows);
    lists.row_begin.resize(rows + 1);
    std::uint64_t total = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        lists.row_begin[row] = std::uint32_t(total);
        for (int w = 0; w < words; ++w)
            total += std::uint64_t(std::popcount(visible[row * std::size_t(words) + std::size_t(w)]));
        if (total >= std::numeric_limits<std::uint32_t>::max())
            throw Error(
                Errc::unsupported,
                "More than 2^32 voxels are visible; use mode iso, or an isovalue that gives a simpler surface.");
    }
    lists.row_begin[rows] = std::uint32_t(total);
    lists.column.resize(total);
    lists.look.resize(total);
}

glm::dmat4 placement(const GridGeometry& geometry) {
    glm::dmat4 placed(1);
    for (int axis = 0; axis < 3; ++axis)
        placed[axis] = glm::dvec4(geometry.direction[axis] * geometry.spacing[axis], geometry.size[axis]);
    placed[3] = glm::dvec4(geometry.origin, 1);
    return placed;
}

}  // namespace

std::size_t VisibleVoxels::bytes() const {
    return row_begin.size() * sizeof(row_begin[0]) + column.size() * sizeof(column[0]) + look.size() * sizeof(look[0]);
}

bool VisibleVoxelCache::has(const Volume& volume, const Solid& solid, SliceDirection direction) const {
    return volume.data() == voxels_.data() && solid_ == solid && placed_ == placement(volume.geometry()) &&
           lists_[direction.index()];
}

/// Makes the bits those of the solid, as far as they are not.
void VisibleVoxelCache::use(const Volume& volume, const Solid& solid, const JobContext& job) {
    const GridGeometry& geometry = volume.geometry();
    const bool same_material = solid_ && volume.data() == voxels_.data() && placed_ == placement(geometry) &&
                               solid_->iso == solid.iso && solid_->ranges == solid.ranges;
    if (same_material && solid_->cuts == solid.cuts) return;
    if (!same_material) {
        drop();
        material_ = threshold(volume, solid, job.part(0, 0.4));
    }
    solid_.reset();  // a build that is stopped half-way leaves nothing that looks whole
    lists_ = {};
    kept_turned_ = {};
    if (solid.cuts.empty()) {
        interior_ = kept_ = {};
    } else {
        if (interior_.bytes() == 0) interior_ = eroded(material_, job.part(0.4, 0.5));
        kept_ = apply_cuts(material_, interior_, geometry, solid.cuts, {job.stop, nullptr});
    }
    voxels_ = volume.buffer();
    placed_ = placement(geometry);
    solid_ = solid;
}

std::shared_ptr<const VisibleVoxels> VisibleVoxelCache::get(const Volume& volume, const Solid& solid,
                                                            SliceDirection direction, const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    if (std::max({size.x, size.y, size.z}) > 65535)
        throw Error(Errc::unsupported, "Shear-warp takes at most 65535 voxels along an axis; use mode iso.");
    use(volume, solid, job);
    auto& slot = lists_[direction.index()];
    if (slot) return slot;

    const BitVolume& kept = solid.cuts.empty() ? material_ : kept_;
    if (direction.axis == 0 && kept_turned_.bytes() == 0) kept_turned_ = turned(kept, job.part(0.5, 0.6));
    auto lists = std::make_shared<VisibleVoxels>();
    lists->direction = direction;
    lists->columns = size[direction.u_axis()];
    lists->rows = size[direction.v_axis()];
    lists->slices = size[direction.axis];
    const BitVolume& sliced = direction.axis == 0 ? kept_turned_ : kept;
    const int words = sliced.words_per_row();
    const auto visible = sweep({sliced, direction.axis == 1}, lists->columns, lists->rows, lists->slices, words,
                               direction.from_low, job);
    count_rows(*lists, visible, words);
    visit_type(volume.type(), [&](auto tag) {
        Lister<decltype(tag)> lister(volume, kept, interior_, *lists);
        parallel_for(
            0, lists->slices,
            [&](std::int64_t c) {
                for (int v = 0; v < lists->rows; ++v) {
                    const std::size_t row = std::size_t(c) * std::size_t(lists->rows) + std::size_t(v);
                    lister.list_row(v, int(c), visible.data() + row * std::size_t(words), words);
                }
            },
            job.part(0.6, 1));
    });
    slot = lists;
    return lists;
}

std::size_t VisibleVoxelCache::bytes_held() const {
    std::size_t bytes = material_.bytes() + interior_.bytes() + kept_.bytes() + kept_turned_.bytes();
    for (const auto& lists : lists_) bytes += lists ? lists->bytes() : 0;
    return bytes;
}

}  // namespace lacuna
