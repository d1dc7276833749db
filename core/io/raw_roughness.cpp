#include "core/io/raw_roughness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr std::size_t k_window = 16;  // bytes of a place: 16, 8 or 4 words
constexpr std::size_t k_most_places = 8000, k_lag_places = 4000;
constexpr std::size_t k_most_tries = 1 << 19;
constexpr double k_odd_floats = 0.1;  // share of values that no detector measures, above which floats are out
constexpr float k_smallest = 1e-18f, k_largest = 1e18f;

template <class T>
T word_at(const std::byte* at, bool big_endian) {
    T raw;
    std::memcpy(&raw, at, sizeof(T));
    if (big_endian == (std::endian::native == std::endian::little)) {
        if constexpr (sizeof(T) == 2) raw = T(__builtin_bswap16(std::uint16_t(raw)));
        if constexpr (sizeof(T) == 4) raw = T(__builtin_bswap32(std::uint32_t(raw)));
    }
    return raw;
}

/// A float as a number of which equal steps are equal shares, so that differences of floats cost what those of their
/// stored bits do; linear around zero.
double log_scale(float x) {
    constexpr double k_steps_an_octave = 1 << 23;
    if (!std::isfinite(x)) return 0;
    const double size = std::log2(1 + std::abs(double(x)) * 1e4);
    return std::copysign(size * k_steps_an_octave, x);
}

template <class Read>
auto with_reader(RawWords words, Read&& read) {
    const bool be = words.big_endian;
    switch (words.type) {
        case VoxelType::u8:
            return read([](const std::byte* p) { return double(std::uint8_t(*p)); });
        case VoxelType::i8:
            return read([](const std::byte* p) { return double(std::int8_t(*p)); });
        case VoxelType::u16:
            return read([be](const std::byte* p) { return double(word_at<std::uint16_t>(p, be)); });
        case VoxelType::i16:
            return read([be](const std::byte* p) { return double(std::int16_t(word_at<std::uint16_t>(p, be))); });
        case VoxelType::f32:
            break;
    }
    return read([be](const std::byte* p) { return log_scale(std::bit_cast<float>(word_at<std::uint32_t>(p, be))); });
}

double bits(double difference) { return double(std::log2(1.0f + float(std::abs(difference)))); }

/// Of bytes 0 and 255 alone: a mask, of which 65535 is not -1.
bool is_mask(std::uint16_t word) {
    const auto end = [](int byte) { return byte == 0 || byte == 255; };
    return end(word >> 8) && end(word & 255);
}

bool is_odd(float x) { return !std::isfinite(x) || std::abs(x) > k_largest || (x != 0 && std::abs(x) < k_smallest); }

}  // namespace

RawRoughness::RawRoughness(std::span<const std::byte> bytes, std::size_t phase) : bytes_(bytes) {
    if (bytes.size() < phase + 4 * k_window) return;
    const std::size_t first = phase + 4, end = bytes.size() - k_window, words = (end - first) / 4;
    std::mt19937_64 random(1);  // a fixed seed: the same file is read the same way every time
    // Evenly spread, each at random within its stretch: no row or slice length can be in step with it.
    const std::size_t tries = std::min(words, k_most_tries);
    for (std::size_t i = 0; i < tries; ++i) {
        const std::size_t from = words * i / tries, to = std::max(from + 1, words * (i + 1) / tries);
        const std::size_t place = first + 4 * (from + random() % (to - from));
        if (std::memcmp(bytes.data() + place, bytes.data() + place - 4, k_window) != 0) places_.push_back(place);
    }
    std::shuffle(places_.begin(), places_.end(), random);
    if (places_.size() > k_most_places) places_.resize(k_most_places);
}

double RawRoughness::of_neighbours(RawWords words) const {
    if (places_.empty()) return 0;
    const std::size_t word = size_of(words.type);
    std::size_t odd = 0, values = 0;
    if (words.type == VoxelType::f32) {
        for (const std::size_t place : places_)
            for (std::size_t k = 0; k < k_window; k += 4, ++values)
                odd += is_odd(std::bit_cast<float>(word_at<std::uint32_t>(&bytes_[place + k], words.big_endian)));
        if (double(odd) > k_odd_floats * double(values)) return std::numeric_limits<double>::infinity();
    }
    return with_reader(words, [&](auto value) {
        double sum = 0;
        for (const std::size_t place : places_)
            for (std::size_t k = 0; k < k_window; k += word)
                sum += bits(value(&bytes_[place + k]) - value(&bytes_[place + k - word]));
        return sum / double(k_window * places_.size());
    });
}

double RawRoughness::at_lag(RawWords words, std::int64_t lag) const {
    const std::size_t away = std::size_t(lag) * size_of(words.type), count = std::min(k_lag_places, places_.size());
    return with_reader(words, [&](auto value) {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t place = places_[i];
            const std::size_t other = place >= away ? place - away : place + away;
            sum += bits(value(&bytes_[place]) - value(&bytes_[other]));
        }
        return count == 0 ? 0.0 : sum / double(count);
    });
}

std::vector<double> RawRoughness::at_lags(RawWords words, const std::vector<std::int64_t>& lags,
                                          const JobContext& job) const {
    std::vector<double> found(lags.size());
    parallel_for(0, std::int64_t(lags.size()),
                 [&](std::int64_t i) { found[std::size_t(i)] = at_lag(words, lags[std::size_t(i)]); },
                 {job.stop, nullptr});
    return found;
}

bool RawRoughness::words_have_sign(bool big_endian) const {
    std::size_t over_zero = 0, over_middle = 0;
    for (const std::size_t place : places_)
        for (std::size_t k = 0; k < k_window; k += 2) {
            const auto a = word_at<std::uint16_t>(&bytes_[place + k], big_endian);
            const auto b = word_at<std::uint16_t>(&bytes_[place + k - 2], big_endian);
            if (is_mask(a) || is_mask(b)) continue;
            const int plain = std::abs(int(a) - int(b)), with_sign = std::abs(int(std::int16_t(a)) - std::int16_t(b));
            over_zero += 4 * with_sign < plain;
            over_middle += 4 * plain < with_sign;
        }
    return over_zero > 3 * over_middle;
}

}  // namespace lacuna
