#include "core/regions/run_components.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/regions/neighbourhood.h"

namespace lacuna::runs {

namespace {

/// First index at or after x whose mark differs from `mark`; rows are mostly long stretches, taken 8 marks at a time.
int end_of_stretch(const std::uint8_t* marks, int x, int width, std::uint8_t mark) {
    const std::uint64_t eight = mark ? 0x0101010101010101ull : 0;
    while (x + 8 <= width) {
        std::uint64_t word;
        std::memcpy(&word, marks + x, 8);
        if (word != eight) break;
        x += 8;
    }
    while (x < width && marks[x] == mark) ++x;
    return x;
}

void append_runs(const std::uint8_t* marks, int width, std::vector<Run>& out) {
    for (int x = end_of_stretch(marks, 0, width, 0); x < width; x = end_of_stretch(marks, x, width, 0)) {
        const int end = end_of_stretch(marks, x, width, 1);
        out.push_back({x, end - 1});
        x = end;
    }
}

template <class T, class Inside>
MarkRow mark_where(const Volume& volume, Inside inside) {
    const VolumeView<T> view = volume.view<T>();
    return [view, inside](int y, int z, std::uint8_t* __restrict marks) {
        const T* __restrict values = view.row(y, z);
        for (int x = 0; x < view.size.x; ++x) marks[x] = std::uint8_t(inside(values[x]));
    };
}

/// A bound in the type's own numbers, so that rows are compared without conversion. For whole numbers: the smallest one
/// at or above the bound; `beyond` where there is none.
template <class T>
std::int64_t ceiled(double bound) {
    constexpr double lo = double(std::numeric_limits<T>::lowest()), hi = double(std::numeric_limits<T>::max());
    return std::int64_t(std::ceil(std::clamp(bound, lo, hi + 1)));
}

class DisjointRuns {
public:
    explicit DisjointRuns(std::size_t count) : root_(count) {
        for (std::size_t i = 0; i < count; ++i) root_[i] = std::uint32_t(i);
    }
    std::uint32_t find(std::uint32_t run) {
        while (root_[run] != run) run = root_[run] = root_[root_[run]];
        return run;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        if (a < b)
            root_[b] = a;
        else
            root_[a] = b;
    }
    std::vector<std::uint32_t> take() { return std::move(root_); }

private:
    std::vector<std::uint32_t> root_;
};

class Joiner {
public:
    Joiner(const RunList& runs, Connectivity connectivity) : runs_(runs), sets_(runs.count()) {
        for (const auto& [dy, dz] : {std::pair{-1, 0}, {-1, -1}, {0, -1}, {1, -1}})
            if (const int reach = neighbourhood::reach_along_x(connectivity, dy, dz); reach >= 0)
                earlier_.push_back({dy, dz, reach});
    }

    std::vector<std::uint32_t> run(const JobContext& job) {
        const int bands = std::min(runs_.size.z, 64);
        const auto begin_of = [&](std::int64_t band) { return int(std::int64_t(runs_.size.z) * band / bands); };
        parallel_for(
            0, bands,
            [&](std::int64_t band) {  // touches runs of its own slices alone
                for (int z = begin_of(band); z < begin_of(band + 1); ++z) join_slice(z, z > begin_of(band), true);
            },
            job);
        for (int band = 1; band < bands; ++band) join_slice(begin_of(band), true, false);
        return sets_.take();
    }

private:
    struct EarlierRow {
        int dy, dz, reach;
    };

    void join_slice(int z, bool below, bool within) {
        for (int y = 0; y < runs_.size.y; ++y)
            for (const EarlierRow& e : earlier_) {
                if (y + e.dy < 0 || y + e.dy >= runs_.size.y || !(e.dz ? below : within)) continue;
                join_rows(y, z, y + e.dy, z + e.dz, e.reach);
            }
    }

    void join_rows(int y, int z, int other_y, int other_z, int reach) {
        const Slice &slice = runs_.slices[std::size_t(z)], &other = runs_.slices[std::size_t(other_z)];
        const auto base = std::uint32_t(runs_.slice_begin[std::size_t(z)]);
        const auto other_base = std::uint32_t(runs_.slice_begin[std::size_t(other_z)]);
        std::uint32_t a = slice.row_begin[std::size_t(y)], b = other.row_begin[std::size_t(other_y)];
        const std::uint32_t a_end = slice.row_begin[std::size_t(y) + 1];
        const std::uint32_t b_end = other.row_begin[std::size_t(other_y) + 1];
        while (a < a_end && b < b_end) {
            const Run &run = slice.runs[a], &near = other.runs[b];
            if (near.last + reach < run.first)
                ++b;
            else if (run.last + reach < near.first)
                ++a;
            else {
                sets_.unite(base + a, other_base + b);
                if (run.last < near.last)
                    ++a;
                else
                    ++b;
            }
        }
    }

    const RunList& runs_;
    DisjointRuns sets_;
    std::vector<EarlierRow> earlier_;
};

}  // namespace

std::int64_t RunList::voxels() const {
    std::int64_t sum = 0;
    for (const Slice& slice : slices)
        for (const Run& run : slice.runs) sum += run.last - run.first + 1;
    return sum;
}

RunList find_runs(const glm::ivec3& size, const MarkRow& mark, const JobContext& job) {
    RunList list;
    list.size = size;
    list.slices.resize(std::size_t(size.z));
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {
            std::vector<std::uint8_t> marks(std::size_t(size.x) + 8);
            Slice& slice = list.slices[std::size_t(z)];
            slice.row_begin.reserve(std::size_t(size.y) + 1);
            std::vector<Run> found;
            for (int y = 0; y < size.y; ++y) {
                slice.row_begin.push_back(std::uint32_t(found.size()));
                mark(y, int(z), marks.data());
                append_runs(marks.data(), size.x, found);
            }
            slice.row_begin.push_back(std::uint32_t(found.size()));
            slice.runs.assign(found.begin(), found.end());  // without the room a growing list keeps
        },
        job);
    list.slice_begin.assign(std::size_t(size.z) + 1, 0);
    for (std::size_t z = 0; z < list.slices.size(); ++z)
        list.slice_begin[z + 1] = list.slice_begin[z] + list.slices[z].runs.size();
    return list;
}

MarkRow mark_in_range(const Volume& volume, const ValueRange& range) {
    constexpr double k_finite = std::numeric_limits<double>::max();  // an open range still leaves infinite values out
    const double lo = std::max(range.lo, -k_finite), hi = std::min(range.hi, k_finite);
    return visit_type(volume.type(), [&](auto tag) -> MarkRow {
        using T = decltype(tag);
        if constexpr (std::is_integral_v<T>) {
            if (!(lo <= hi)) return mark_where<T>(volume, [](T) { return false; });
            const auto first = std::int32_t(ceiled<T>(lo));
            const auto last = std::int32_t(std::floor(
                std::clamp(hi, double(std::numeric_limits<T>::lowest()) - 1, double(std::numeric_limits<T>::max()))));
            return mark_where<T>(volume, [=](T v) { return bool(int(v >= first) & int(v <= last)); });
        } else {
            return mark_where<T>(volume, [=](T v) { return bool(int(double(v) >= lo) & int(double(v) <= hi)); });
        }
    });
}

MarkRow mark_below(const Volume& volume, double threshold) {
    return visit_type(volume.type(), [&](auto tag) -> MarkRow {
        using T = decltype(tag);
        if constexpr (std::is_integral_v<T>) {
            const auto first = std::int32_t(ceiled<T>(threshold));
            return mark_where<T>(volume, [=](T v) { return v < first; });
        } else {
            return mark_where<T>(volume, [=](T v) { return !(double(v) >= threshold); });
        }
    });
}

MarkRow mark_above(const Volume& volume, double threshold) {
    return mark_in_range(volume, {std::nextafter(threshold, std::numeric_limits<double>::infinity()),
                                  std::numeric_limits<double>::infinity()});
}

Components join(const RunList& runs, Connectivity connectivity, const JobContext& job) {
    if (runs.count() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(Errc::out_of_memory,
                    "The volume falls into too many pieces to be counted; smooth or crop it first.");
    Components result;
    result.of_run = Joiner(runs, connectivity).run(job);
    std::vector<std::uint32_t>& id = result.of_run;
    for (int z = 0; z < runs.size.z; ++z)
        for_runs(runs, z, [&](int, int, const Run& run, std::size_t k) {
            if (id[k] == k) {  // a root comes before its runs
                id[k] = result.count();
                result.voxels.push_back(0);
            } else {
                id[k] = id[id[k]];
            }
            result.voxels[id[k]] += std::uint64_t(run.last - run.first + 1);
        });
    return result;
}

}  // namespace lacuna::runs
