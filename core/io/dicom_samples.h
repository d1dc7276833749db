#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/io/dicom_header.h"

// The arithmetic on the samples of one slice, free of files: stored bits to stored value, value scale, padding.
namespace lacuna::dicom {

/// Samples [first, first + count) of a slice that are padding.
struct PaddingRun {
    std::uint32_t first = 0, count = 0;
};

/// One slice between reading and its final type. Its samples lie in unsigned words T in one of two forms, both of
/// which lose nothing: the stored value (two's complement), or, with `shifted`, stored value + intercept modulo 2^bits.
/// The second is the final form already where that has T's width, so most slices are touched only once.
struct SliceState {
    double slope = 1, intercept = 0;
    bool is_signed = false;
    bool shifted = false;
    std::int64_t lo = std::numeric_limits<std::int64_t>::max();  ///< stored values that are no padding
    std::int64_t hi = std::numeric_limits<std::int64_t>::min();
    bool whole = true;  ///< every real value is a whole number
    std::vector<PaddingRun> padding;
    std::int64_t padding_voxels = 0;
    double padding_value = 0;  ///< real value of a padding sample

    double real(std::int64_t stored) const { return double(stored) * slope + intercept; }
    bool all_padding() const { return hi < lo; }
};

/// Padding that lies within the stored bits is compared after masking, padding outside them with the raw word.
template <class T>
void find_padding(std::span<const T> raw, const PixelFormat& format, const Padding& padding, SliceState& state) {
    using S = std::make_signed_t<T>;
    const int unused = int(sizeof(T)) * 8 - format.bits_stored, low = format.high_bit + 1 - format.bits_stored;
    const std::int64_t least = format.is_signed ? -(std::int64_t(1) << (format.bits_stored - 1)) : 0;
    const std::int64_t most = least + (std::int64_t(1) << format.bits_stored) - 1;
    const bool inside = padding.lo >= least && padding.hi <= most;
    const auto value = [&](T word) -> std::int64_t {
        if (!inside) return format.is_signed ? std::int64_t(S(word)) : std::int64_t(word);
        const T left = T(word << (unused - low));
        return format.is_signed ? std::int64_t(S(left) >> unused) : std::int64_t(T(left >> unused));
    };
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const std::int64_t v = value(raw[i]);
        if (v < padding.lo || v > padding.hi) continue;
        if (!state.padding.empty() && state.padding.back().first + state.padding.back().count == i)
            ++state.padding.back().count;
        else
            state.padding.push_back({std::uint32_t(i), 1});
        ++state.padding_voxels;
    }
    state.padding_value = double(padding.lo) * state.slope + state.intercept;
}

/// Masks garbage above the high bit, extends the sign, finds the range, and shifts by the intercept where that is
/// exact. S: the stored value's type, signed or unsigned of T's width.
template <class S, class T>
void settle_span(T* samples, std::size_t count, const PixelFormat& format, T shift, S& lo, S& hi) {
    const int unused = int(sizeof(T)) * 8 - format.bits_stored, low = format.high_bit + 1 - format.bits_stored;
    S least = lo, most = hi;
    if (unused == 0) {
        for (std::size_t i = 0; i < count; ++i) {
            const S v = S(samples[i]);
            least = v < least ? v : least;
            most = v > most ? v : most;
            samples[i] = T(T(v) + shift);
        }
    } else {
        const int left = unused - low;
        for (std::size_t i = 0; i < count; ++i) {
            const S v = S(S(T(samples[i] << left)) >> unused);
            least = v < least ? v : least;
            most = v > most ? v : most;
            samples[i] = T(T(v) + shift);
        }
    }
    lo = least;
    hi = most;
}

template <class S, class T>
void settle_as(std::span<T> samples, const PixelFormat& format, SliceState& state) {
    const T shift = state.shifted ? T(std::int64_t(state.intercept)) : T(0);
    S lo = std::numeric_limits<S>::max(), hi = std::numeric_limits<S>::lowest();
    std::size_t at = 0;
    for (const PaddingRun& run : state.padding) {
        settle_span<S, T>(samples.data() + at, run.first - at, format, shift, lo, hi);
        S unused_lo = 0, unused_hi = 0;
        settle_span<S, T>(samples.data() + run.first, run.count, format, shift, unused_lo, unused_hi);
        at = std::size_t(run.first) + run.count;
    }
    settle_span<S, T>(samples.data() + at, samples.size() - at, format, shift, lo, hi);
    if (state.padding_voxels < std::int64_t(samples.size())) {
        state.lo = lo;
        state.hi = hi;
    }
}

/// Raw words as stored in the file, native byte order, to the form SliceState describes.
template <class T>
void settle_samples(std::span<T> samples, const PixelFormat& format, const std::optional<Padding>& padding,
                    SliceState& state) {
    state.is_signed = format.is_signed;
    if (padding) find_padding<T>(samples, format, *padding, state);
    state.shifted =
        state.slope == 1 && state.intercept == std::floor(state.intercept) && std::abs(state.intercept) < 1e9;
    if (format.is_signed)
        settle_as<std::make_signed_t<T>, T>(samples, format, state);
    else
        settle_as<T, T>(samples, format, state);
    const auto is_whole = [](double v) { return v == std::floor(v); };
    if (is_whole(state.slope) && is_whole(state.intercept)) return;
    for (std::size_t i = 0; state.whole && i < samples.size(); ++i) {
        const std::int64_t v = format.is_signed ? std::int64_t(std::make_signed_t<T>(samples[i])) : samples[i];
        state.whole = is_whole(state.real(v));
    }
}

/// The stored value of a settled sample.
template <class T>
std::int64_t stored_value(T sample, const SliceState& state) {
    const T word = state.shifted ? T(sample - T(std::int64_t(state.intercept))) : sample;
    return state.is_signed ? std::int64_t(std::make_signed_t<T>(word)) : std::int64_t(word);
}

/// Settled samples to real values of the final type, padding to `air`. `in` and `out` may be the same memory.
template <class T, class Out>
void finish_samples(const T* in, Out* out, std::size_t count, const SliceState& state, double air) {
    const bool done = sizeof(T) == sizeof(Out) && state.shifted && static_cast<const void*>(in) == out;
    if (!done) {
        for (std::size_t i = 0; i < count; ++i) {
            const double value = state.real(stored_value(in[i], state));
            if constexpr (std::is_floating_point_v<Out>)
                out[i] = Out(value);
            else
                out[i] = Out(std::int64_t(std::llrint(value)));
        }
    }
    for (const PaddingRun& run : state.padding)
        for (std::uint32_t i = 0; i < run.count; ++i) out[run.first + i] = Out(air);
}

}  // namespace lacuna::dicom
