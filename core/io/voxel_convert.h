#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>

#include "core/base/parallel.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Voxels after a change of type, and what the change could not keep (empty: nothing).
struct ConvertedVoxels {
    VoxelType type = VoxelType::u8;
    VoxelBuffer voxels;
    std::string warning;
};

namespace detail {

constexpr std::int64_t k_convert_chunk = 1 << 20;

/// Smallest and largest value, and whether all are finite whole numbers.
struct WideRange {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
    bool whole = true;
};

template <class Body>
void in_chunks(std::int64_t count, const JobContext& job, Body&& body) {
    parallel_for(
        0, (count + k_convert_chunk - 1) / k_convert_chunk,
        [&](std::int64_t c) { body(c * k_convert_chunk, std::min(count, (c + 1) * k_convert_chunk)); }, job);
}

template <class T>
WideRange wide_range(std::span<const T> source, const JobContext& job) {
    WideRange all;
    std::mutex mutex;
    in_chunks(std::int64_t(source.size()), job, [&](std::int64_t from, std::int64_t to) {
        WideRange part;
        for (std::int64_t i = from; i < to; ++i) {
            const double v = double(source[std::size_t(i)]);
            if constexpr (std::is_floating_point_v<T>)
                part.whole = part.whole && std::isfinite(v) && v == std::floor(v);
            part.lo = v < part.lo ? v : part.lo;
            part.hi = v > part.hi ? v : part.hi;
        }
        std::lock_guard lock(mutex);
        all = {std::min(all.lo, part.lo), std::max(all.hi, part.hi), all.whole && part.whole};
    });
    return all;
}

}  // namespace detail

/// Turns wide voxels into the smallest type that holds every value exactly; into f32 where whole numbers do not fit 16
/// bits, or where `whole_may_shrink` is false. Warns if whole numbers beyond 2^24 lose digits in f32.
template <class T>
ConvertedVoxels to_smallest(std::span<const T> source, bool whole_may_shrink, const JobContext& job = {}) {
    ConvertedVoxels out{VoxelType::f32, {}, {}};
    const detail::WideRange range = detail::wide_range(source, job.part(0.0, 0.5));
    if (whole_may_shrink) out.type = smallest_type(range.lo, range.hi, range.whole);
    const double largest = std::max(std::abs(range.lo), std::abs(range.hi));
    if (std::is_integral_v<T> && out.type == VoxelType::f32 && largest > 16777216.0)
        out.warning = "Values beyond 16777216 were rounded to 24 significant bits.";
    if (std::isfinite(largest) && largest > double(std::numeric_limits<float>::max()))
        out.warning = "Values beyond the range of 32 bit floats became infinite.";
    out.voxels = VoxelBuffer(source.size() * size_of(out.type));
    visit_type(out.type, [&](auto tag) {
        using To = decltype(tag);
        To* to = reinterpret_cast<To*>(out.voxels.data());
        detail::in_chunks(std::int64_t(source.size()), job.part(0.5, 1.0), [&](std::int64_t from, std::int64_t end) {
            for (std::int64_t i = from; i < end; ++i) to[i] = static_cast<To>(source[std::size_t(i)]);
        });
    });
    return out;
}

}  // namespace lacuna
