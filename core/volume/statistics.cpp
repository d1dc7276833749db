#include "core/volume/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>

#include "core/base/parallel.h"
#include "core/volume/volume_pieces.h"

namespace lacuna {

namespace {

constexpr std::size_t k_float_bins = 4096;
/// Float sums are made per band and added in band order: a fixed number of bands keeps them the same for any number
/// of threads.
constexpr int k_float_bands = 64;

template <class T>
constexpr std::size_t k_values = std::size_t(1) << (8 * sizeof(T));

/// Counts of every value of an integer type; two tables in turn, because air repeats one value and an increment would
/// wait for the store of the one before it.
template <class T>
struct ValueCounter {
    std::vector<std::uint32_t> even = std::vector<std::uint32_t>(k_values<T>, 0), odd = even;

    void add(const T* p, std::int64_t count) {
        constexpr int k_offset = -int(std::numeric_limits<T>::min());
        std::int64_t i = 0;
        for (; i + 1 < count; i += 2) {
            ++even[std::size_t(int(p[i]) + k_offset)];
            ++odd[std::size_t(int(p[i + 1]) + k_offset)];
        }
        if (i < count) ++even[std::size_t(int(p[i]) + k_offset)];
    }
    void add_to(std::vector<std::uint64_t>& counts) const {
        for (std::size_t v = 0; v < k_values<T>; ++v) counts[v] += std::uint64_t(even[v]) + odd[v];
    }
};

template <class T>
std::vector<std::uint64_t> count_values(std::span<const T> voxels, const JobContext& job) {
    std::vector<std::uint64_t> counts(k_values<T>, 0);
    std::mutex mutex;
    const auto total = std::int64_t(voxels.size());
    // A table is 512 KiB at most: bands large enough that adding the tables up costs little beside counting.
    const int bands = int(std::clamp<std::int64_t>(total / (std::int64_t(1) << 22), 1, 256));
    parallel_bands(
        0, total, bands,
        [&](std::int64_t first, std::int64_t last) {
            ValueCounter<T> counter;
            counter.add(voxels.data() + first, last - first);
            std::lock_guard lock(mutex);  // whole numbers: the order of adding cannot be seen
            counter.add_to(counts);
        },
        job);
    return counts;
}

/// @param counts  of every value of T, the smallest first
template <class T>
VolumeStatistics statistics_of_counts(const std::vector<std::uint64_t>& counts) {
    VolumeStatistics out;
    const auto used = [](std::uint64_t n) { return n > 0; };
    const auto first = std::find_if(counts.begin(), counts.end(), used);
    if (first == counts.end()) return out;
    const auto last = std::find_if(counts.rbegin(), counts.rend(), used).base();
    const double lo = double(first - counts.begin()) + double(std::numeric_limits<T>::min());
    out.histogram.assign(first, last);
    out.range = {lo, lo + double(out.histogram.size() - 1)};
    out.histogram_range = {out.range.lo - 0.5, out.range.hi + 0.5};

    double n = 0, sum = 0, squares = 0;
    for (std::size_t b = 0; b < out.histogram.size(); ++b) {
        n += double(out.histogram[b]);
        sum += double(out.histogram[b]) * double(b);
    }
    for (std::size_t b = 0; b < out.histogram.size(); ++b) {
        const double d = double(b) - sum / n;
        squares += double(out.histogram[b]) * d * d;
    }
    out.mean = lo + sum / n;
    out.stddev = std::sqrt(squares / n);
    return out;
}

template <class T>
VolumeStatistics integer_statistics(std::span<const T> voxels, const JobContext& job) {
    return statistics_of_counts<T>(count_values(voxels, job));
}

struct FloatBand {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
    double sum = 0, squares = 0;
    std::int64_t finite = 0, bad = 0;
    std::vector<std::uint64_t> histogram;
};

void first_pass(FloatBand& band, const float* p, const float* end) {
    float lo = std::numeric_limits<float>::infinity(), hi = -lo;
    for (; p != end; ++p) {
        if (!std::isfinite(*p)) {
            ++band.bad;
            continue;
        }
        ++band.finite;
        lo = std::min(lo, *p);
        hi = std::max(hi, *p);
        band.sum += double(*p);
    }
    band.lo = lo;
    band.hi = hi;
}

void second_pass(FloatBand& band, const float* p, const float* end, ValueRange range, double mean) {
    band.histogram.assign(k_float_bins, 0);
    const double scale = double(k_float_bins) / range.width();
    for (; p != end; ++p) {
        if (!std::isfinite(*p)) continue;
        const auto bin = std::size_t((double(*p) - range.lo) * scale);
        ++band.histogram[std::min(bin, k_float_bins - 1)];
        const double d = double(*p) - mean;
        band.squares += d * d;
    }
}

VolumeStatistics float_statistics(std::span<const float> voxels, const JobContext& job) {
    const auto total = std::int64_t(voxels.size());
    const auto bands = std::clamp<std::int64_t>(total, 1, k_float_bands);
    std::vector<FloatBand> parts(static_cast<std::size_t>(bands));
    const auto begin_of = [&](std::int64_t b) { return voxels.data() + total * b / bands; };
    parallel_for(
        0, bands, [&](std::int64_t b) { first_pass(parts[std::size_t(b)], begin_of(b), begin_of(b + 1)); },
        job.part(0.0, 0.5));

    VolumeStatistics out;
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    std::int64_t finite = 0;
    double sum = 0, squares = 0;
    for (const FloatBand& part : parts) {
        range = {std::min(range.lo, part.lo), std::max(range.hi, part.hi)};
        finite += part.finite;
        out.nan_count += part.bad;
        sum += part.sum;
    }
    if (finite == 0) return out;
    out.range = out.histogram_range = range;
    out.mean = std::clamp(sum / double(finite), range.lo, range.hi);
    if (!(range.width() > 0)) {
        out.histogram = {std::uint64_t(finite)};
        return out;
    }
    parallel_for(
        0, bands,
        [&](std::int64_t b) { second_pass(parts[std::size_t(b)], begin_of(b), begin_of(b + 1), range, out.mean); },
        job.part(0.5, 1.0));
    out.histogram.assign(k_float_bins, 0);
    for (const FloatBand& part : parts) {
        squares += part.squares;
        for (std::size_t b = 0; b < k_float_bins; ++b) out.histogram[b] += part.histogram[b];
    }
    out.stddev = std::sqrt(squares / double(finite));
    return out;
}

/// A piece's own voxels of one slice: whole rows, so they lie together.
template <class T>
std::span<const T> own_voxels(const VolumePiece& piece, int z) {
    return {piece.volume.view<T>().row(0, z), std::size_t(piece.own.x) * std::size_t(piece.own.y)};
}

void add_up(FloatBand& sum, const FloatBand& part) {
    sum.lo = std::min(sum.lo, part.lo);
    sum.hi = std::max(sum.hi, part.hi);
    sum.sum += part.sum;
    sum.finite += part.finite;
    sum.bad += part.bad;
}

}  // namespace

struct StatisticsGatherer::State {
    VoxelType type;
    std::vector<std::uint64_t> counts;  // integers
    FloatBand floats;
    bool second = false;
    double mean() const {
        return floats.finite ? std::clamp(floats.sum / double(floats.finite), floats.lo, floats.hi) : 0;
    }
};

StatisticsGatherer::StatisticsGatherer(VoxelType type) : state_(std::make_unique<State>(State{type, {}, {}, false})) {}
StatisticsGatherer::~StatisticsGatherer() = default;

void StatisticsGatherer::add(const VolumePiece& piece) {
    State& s = *state_;
    visit_type(s.type, [&](auto tag) {
        using T = decltype(tag);
        if constexpr (std::is_same_v<T, float>) {
            std::vector<FloatBand> slices(std::size_t(piece.own.z));
            parallel_for(0, piece.own.z, [&](std::int64_t z) {
                const std::span<const float> voxels = own_voxels<float>(piece, int(z));
                const float *from = voxels.data(), *to = from + voxels.size();
                FloatBand& band = slices[std::size_t(z)];
                if (s.second)
                    second_pass(band, from, to, {s.floats.lo, s.floats.hi}, s.mean());
                else
                    first_pass(band, from, to);
            });
            for (const FloatBand& band : slices) {
                if (!s.second) {
                    add_up(s.floats, band);
                    continue;
                }
                s.floats.squares += band.squares;
                for (std::size_t b = 0; b < k_float_bins; ++b) s.floats.histogram[b] += band.histogram[b];
            }
        } else {
            s.counts.resize(k_values<T>, 0);
            std::mutex mutex;
            parallel_bands(0, piece.own.z, std::min(thread_count(), piece.own.z),
                           [&](std::int64_t first, std::int64_t last) {
                               ValueCounter<T> counter;
                               for (std::int64_t z = first; z < last; ++z) {
                                   const std::span<const T> v = own_voxels<T>(piece, int(z));
                                   counter.add(v.data(), std::int64_t(v.size()));
                               }
                               std::lock_guard lock(mutex);
                               counter.add_to(s.counts);
                           });
        }
    });
}

bool StatisticsGatherer::needs_second_pass() const {
    return state_->type == VoxelType::f32 && !state_->second && state_->floats.hi > state_->floats.lo;
}

void StatisticsGatherer::begin_second_pass() {
    state_->second = true;
    state_->floats.histogram.assign(k_float_bins, 0);
}

VolumeStatistics StatisticsGatherer::finish() const {
    const State& s = *state_;
    if (s.type != VoxelType::f32)
        return visit_type(s.type, [&](auto tag) {
            using T = decltype(tag);
            if constexpr (std::is_same_v<T, float>)
                return VolumeStatistics{};
            else
                return s.counts.empty() ? VolumeStatistics{} : statistics_of_counts<T>(s.counts);
        });
    VolumeStatistics out;
    out.nan_count = s.floats.bad;
    if (s.floats.finite == 0) return out;
    out.range = out.histogram_range = {s.floats.lo, s.floats.hi};
    out.mean = s.mean();
    out.stddev = std::sqrt(s.floats.squares / double(s.floats.finite));
    out.histogram = s.second ? s.floats.histogram : std::vector<std::uint64_t>{std::uint64_t(s.floats.finite)};
    return out;
}

namespace {
VolumeStatistics streamed_statistics(const Volume& volume, const JobContext& job) {
    StatisticsGatherer gatherer(volume.type());
    const bool twice = volume.type() == VoxelType::f32;
    const auto take = [&](const VolumePiece& piece) { gatherer.add(piece); };
    for_each_piece(volume, 1, take, job.part(0, twice ? 0.5 : 1));
    if (gatherer.needs_second_pass()) {
        gatherer.begin_second_pass();
        for_each_piece(volume, 1, take, job.part(0.5, 1));
    }
    return gatherer.finish();
}
}  // namespace

double VolumeStatistics::percentile(double share) const {
    if (histogram.empty() || !(share > 0)) return range.lo;
    if (share >= 1) return range.hi;
    double total = 0, below = 0;
    for (const std::uint64_t n : histogram) total += double(n);
    for (std::size_t b = 0; b < histogram.size(); ++b) {
        below += double(histogram[b]);
        if (below >= share * total && histogram[b] > 0) return std::clamp(bin_centre(b), range.lo, range.hi);
    }
    return range.hi;
}

VolumeStatistics compute_statistics(const Volume& volume, const JobContext& job) {
    job.check();
    if (volume.empty()) return {};
    if (!volume.in_memory()) return streamed_statistics(volume, job);
    VolumeStatistics statistics = visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        if constexpr (std::is_same_v<T, float>)
            return float_statistics(volume.view<T>().voxels(), job);
        else
            return integer_statistics<T>(volume.view<T>().voxels(), job);
    });
    job.check();
    return statistics;
}

double otsu_threshold(const VolumeStatistics& statistics) {
    const std::vector<std::uint64_t>& histogram = statistics.histogram;
    if (histogram.size() < 2) return statistics.range.lo;
    double total = 0, total_sum = 0;
    for (std::size_t b = 0; b < histogram.size(); ++b) {
        total += double(histogram[b]);
        total_sum += double(histogram[b]) * double(b);
    }
    // The between-class variance times total^2 is (sum0*total - total_sum*n0)^2 / (n0*n1), with class 0 the bins up
    // to and including `b`. Empty bins leave n0 and sum0 as they are, so a tie is a tie to the last bit.
    double n0 = 0, sum0 = 0, best = -1;
    std::size_t first = 0, last = 0;
    bool in_tie = false;
    for (std::size_t b = 0; b + 1 < histogram.size(); ++b) {
        n0 += double(histogram[b]);
        sum0 += double(histogram[b]) * double(b);
        const double n1 = total - n0;
        if (!(n0 > 0) || !(n1 > 0)) continue;
        const double gap = sum0 - total_sum * (n0 / total);
        const double variance = gap * gap / (n0 * n1);
        if (variance > best) {
            best = variance;
            first = last = b;
            in_tie = true;
        } else if (in_tie && variance == best) {
            last = b;
        } else {
            in_tie = false;
        }
    }
    if (best < 0) return statistics.range.lo;
    // The edge above bin b is lo + (b+1)*w; the middle of the edges of the first and the last tied bin.
    return statistics.histogram_range.lo + (0.5 * double(first + last) + 1.0) * statistics.bin_width();
}

}  // namespace lacuna
