#include "core/regions/part_outline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna::outline {

namespace {

using runs::Run;

/// Which faces of the frame a run lies on, by axis; axes of one voxel have none.
struct FrameContact {
    bool face = false, edge = false;
};

FrameContact contact_of(const glm::ivec3& size, int y, int z, const Run& run) {
    const int across = int(size.y > 1 && (y == 0 || y == size.y - 1)) + int(size.z > 1 && (z == 0 || z == size.z - 1));
    const bool at_end = size.x > 1 && (run.first == 0 || run.last == size.x - 1);
    const int axes = int(size.x > 1) + int(size.y > 1) + int(size.z > 1);
    const int met = across + int(at_end);
    // Of a single slice the sides are what edges are to a volume; of a row, its ends.
    return {met > 0, met >= std::min(2, std::max(1, axes - 1))};
}

}  // namespace

bool fills_frame(const Volume& volume, double threshold) {
    const glm::ivec3 size = volume.geometry().size;
    bool any_face = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] == 1) continue;
        any_face = true;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const int side : {0, size[axis] - 1}) {
            std::int64_t material = 0;
            for (int b = 0; b < size[v]; ++b)
                for (int a = 0; a < size[u]; ++a) {
                    glm::ivec3 p;
                    p[axis] = side, p[u] = a, p[v] = b;
                    material += volume.value(p.x, p.y, p.z) >= threshold;
                }
            if (2 * material < std::int64_t(size[u]) * size[v]) return false;
        }
    }
    return any_face;
}

VoidScan scan_voids(const Volume& volume, double threshold, bool filled, Connectivity connectivity,
                    const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    VoidScan scan;
    scan.list = runs::find_runs(size, runs::mark_below(volume, threshold), job.part(0, 0.7));
    scan.components = runs::join(scan.list, connectivity, job.part(0.7, 1));
    scan.kind.assign(scan.components.count(), Space::closed);
    for (int z = 0; z < size.z; ++z)
        runs::for_runs(scan.list, z, [&](int y, int at_z, const Run& run, std::size_t k) {
            const FrameContact contact = contact_of(size, y, at_z, run);
            Space& kind = scan.kind[scan.components.of_run[k]];
            if (contact.face && kind == Space::closed) kind = Space::cut;
            if (contact.edge && !filled) kind = Space::outside;
        });
    return scan;
}

PartRuns find_part(const VoidScan& scan, Connectivity connectivity, const JobContext& job) {
    const glm::ivec3 size = scan.list.size;
    PartRuns part;
    part.list.size = size;
    part.list.slices.resize(std::size_t(size.z));
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {  // the gaps between outside runs
            runs::Slice& slice = part.list.slices[std::size_t(z)];
            const runs::Slice& voids = scan.list.slices[std::size_t(z)];
            const std::size_t base = std::size_t(scan.list.slice_begin[std::size_t(z)]);
            std::vector<Run> found;
            for (int y = 0; y < size.y; ++y) {
                slice.row_begin.push_back(std::uint32_t(found.size()));
                int next = 0;
                for (std::uint32_t k = voids.row_begin[std::size_t(y)]; k < voids.row_begin[std::size_t(y) + 1]; ++k) {
                    if (!scan.is_outside(base + k)) continue;
                    if (voids.runs[k].first > next) found.push_back({next, voids.runs[k].first - 1});
                    next = voids.runs[k].last + 1;
                }
                if (next < size.x) found.push_back({next, size.x - 1});
            }
            slice.row_begin.push_back(std::uint32_t(found.size()));
            slice.runs.assign(found.begin(), found.end());
        },
        job.part(0, 0.5));
    part.list.slice_begin.assign(std::size_t(size.z) + 1, 0);
    for (std::size_t z = 0; z < part.list.slices.size(); ++z)
        part.list.slice_begin[z + 1] = part.list.slice_begin[z] + part.list.slices[z].runs.size();

    const Connectivity solid = connectivity == Connectivity::c26 ? Connectivity::c6 : Connectivity::c26;
    part.components = runs::join(part.list, solid, job.part(0.5, 1));
    std::uint64_t largest = 0;
    for (const std::uint64_t n : part.components.voxels) largest = std::max(largest, n);
    part.speck.assign(part.components.count(), 0);
    for (std::size_t c = 0; c < part.speck.size(); ++c) {
        part.speck[c] = part.components.voxels[c] * 1000 < largest;
        if (!part.speck[c]) part.voxels += std::int64_t(part.components.voxels[c]);
    }
    return part;
}

PartMask mask_of(const PartRuns& part, const GridGeometry& geometry) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(std::size_t(geometry.voxel_count()), std::uint8_t(0));
    PartMask made{{geometry, bytes}, glm::ivec3(std::numeric_limits<int>::max()), glm::ivec3(-1)};
    for (int z = 0; z < geometry.size.z; ++z)
        runs::for_runs(part.list, z, [&](int y, int at_z, const Run& run, std::size_t k) {
            if (!part.kept(k)) return;
            std::uint8_t* row = bytes->data() + geometry.linear_index(0, y, at_z);
            std::fill(row + run.first, row + run.last + 1, std::uint8_t(1));
            made.first = glm::min(made.first, glm::ivec3(run.first, y, at_z));
            made.last = glm::max(made.last, glm::ivec3(run.last, y, at_z));
        });
    return made;
}

namespace {

/// The outer surface's points in slices [begin, end).
template <class T>
void surface_points(const Volume& volume, const MaskVolume& part, double threshold, int begin, int end,
                    std::vector<PointTree::Point>& points) {
    const GridGeometry& g = volume.geometry();
    const VolumeView<T> view = volume.view<T>();
    const std::uint8_t* mask = part.labels->data();
    const std::int64_t step[3] = {1, g.size.x, std::int64_t(g.size.x) * g.size.y};
    const auto add = [&](const glm::ivec3& p, int axis, double offset) {
        glm::dvec3 at(p);
        at[axis] += offset;
        points.push_back({glm::vec3(g.voxel_to_mm(at) - g.origin), 0});
    };
    for (int z = begin; z < end; ++z)
        for (int y = 0; y < g.size.y; ++y)
            for (int x = 0; x < g.size.x; ++x) {
                const std::int64_t i = g.linear_index(x, y, z);
                if (!mask[i]) continue;
                const glm::ivec3 p(x, y, z);
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {-1, 1}) {
                        if (g.size[axis] == 1) continue;
                        const int next = p[axis] + side;
                        if (next < 0 || next >= g.size[axis]) {
                            add(p, axis, 0.5 * side);
                            continue;
                        }
                        const std::int64_t k = i + side * step[axis];
                        if (mask[k]) continue;
                        const double a = double(view.data[i]), b = double(view.data[k]);
                        const double share = a >= threshold && b < threshold ? (a - threshold) / (a - b) : 0.5;
                        add(p, axis, side * (std::isfinite(share) ? share : 0.5));
                    }
            }
}

}  // namespace

std::vector<PointTree::Point> outer_surface(const Volume& volume, const MaskVolume& part, double threshold,
                                            const JobContext& job) {
    const int depth = volume.geometry().size.z, bands = std::min(depth, 64);
    std::vector<std::vector<PointTree::Point>> pieces(static_cast<std::size_t>(bands));
    parallel_for(
        0, bands,
        [&](std::int64_t b) {
            const int begin = int(depth * b / bands), end = int(depth * (b + 1) / bands);
            visit_type(volume.type(), [&](auto tag) {
                surface_points<decltype(tag)>(volume, part, threshold, begin, end, pieces[std::size_t(b)]);
            });
        },
        job);
    std::size_t count = 0;
    for (const auto& piece : pieces) count += piece.size();
    // An open foam has surface everywhere; a share of it keeps the tree within a byte or two a voxel.
    const auto most = std::size_t(std::max<std::int64_t>(volume.geometry().voxel_count() / 16, 100'000));
    const std::size_t stride = (count + most - 1) / most;
    std::vector<PointTree::Point> all;
    all.reserve(count / std::max<std::size_t>(1, stride) + 1);
    std::size_t i = 0;
    for (auto& piece : pieces) {
        for (const PointTree::Point& point : piece)
            if (stride <= 1 || i++ % stride == 0) all.push_back(point);
        std::vector<PointTree::Point>().swap(piece);
    }
    return all;
}

namespace {

using BitRow = std::vector<std::uint64_t>;

std::int64_t count_runs(const std::uint64_t* bits, std::size_t words) {
    std::int64_t count = 0;
    std::uint64_t carry = 0;
    for (std::size_t w = 0; w < words; ++w) {
        count += std::popcount(bits[w] & ~(bits[w] << 1 | carry));
        carry = bits[w] >> 63;
    }
    return count;
}

void set_bits(std::uint64_t* bits, int first, int last) {
    for (int x = first; x <= last;) {
        const int word = x / 64, end = std::min(last, word * 64 + 63);
        const std::uint64_t upto = end % 64 == 63 ? ~0ull : (1ull << (end % 64 + 1)) - 1;
        bits[word] |= upto & ~((1ull << (x % 64)) - 1);
        x = end + 1;
    }
}

/// The void rows of one slice as bits, with an empty row before the first and behind the last.
struct BitSlice {
    std::vector<std::uint64_t> bits;
    bool empty = true;

    void load(const VoidScan& scan, int z, std::size_t words, std::int64_t min_voxels) {
        const glm::ivec3 size = scan.list.size;
        bits.assign(words * std::size_t(size.y + 2), 0);
        empty = true;
        if (z < 0 || z >= size.z) return;
        runs::for_runs(scan.list, z, [&](int y, int, const Run& run, std::size_t k) {
            const std::uint32_t c = scan.components.of_run[k];
            if (scan.kind[c] == Space::outside || scan.components.voxels[c] < std::uint64_t(min_voxels)) return;
            empty = false;
            set_bits(bits.data() + words * std::size_t(y + 1), run.first, run.last);
        });
    }
};

}  // namespace

std::int64_t euler_of_voids(const VoidScan& scan, Connectivity connectivity, std::int64_t min_voxels) {
    const glm::ivec3 size = scan.list.size;
    const std::size_t words = std::size_t(size.x) / 64 + 1;
    const bool join = connectivity != Connectivity::c6;
    const int bands = std::min(size.z + 1, 32);
    std::vector<std::int64_t> sums(std::size_t(bands), 0);
    parallel_for(0, bands, [&](std::int64_t band) {
        const int begin = int((size.z + 1) * band / bands), end = int((size.z + 1) * (band + 1) / bands);
        BitSlice lower, upper;
        lower.load(scan, begin - 1, words, min_voxels);
        BitRow across_y(words), across_z(words), all(words);
        std::int64_t sum = 0;
        for (int z = begin; z < end; ++z) {
            upper.load(scan, z, words, min_voxels);
            for (int y = 0; y <= size.y && !(lower.empty && upper.empty); ++y) {
                const std::uint64_t *c = upper.bits.data() + words * std::size_t(y), *a = c + words;
                const std::uint64_t *d = lower.bits.data() + words * std::size_t(y), *b = d + words;
                for (std::size_t w = 0; w < words; ++w) {
                    across_y[w] = join ? a[w] | c[w] : a[w] & c[w];
                    across_z[w] = join ? a[w] | b[w] : a[w] & b[w];
                    all[w] = join ? across_y[w] | b[w] | d[w] : across_y[w] & b[w] & d[w];
                }
                sum += count_runs(a, words) - count_runs(across_y.data(), words) - count_runs(across_z.data(), words) +
                       count_runs(all.data(), words);
            }
            std::swap(lower, upper);
        }
        sums[std::size_t(band)] = sum;
    });
    std::int64_t total = 0;
    for (const std::int64_t s : sums) total += s;
    return total;
}

}  // namespace lacuna::outline
