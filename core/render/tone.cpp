// Effects that look at one pixel's colour alone, on colour not premultiplied.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"
#include "core/render/effect_passes.h"

namespace lacuna::effects {

namespace {

/// x^power for x in (0, 3e38), relative error below 2e-6 for powers up to 10 of colours; free of branches and calls, so
/// that loops over it vectorise. log2 by the series of atanh on [sqrt(1/2), sqrt(2)], 2^f by its Taylor series about 0.
inline float power_of(float x, float power) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;  // 0x3f3504f3: sqrt(1/2)
    const float mantissa = std::bit_cast<float>(bits - exponent * (1 << 23));
    const float s = (mantissa - 1) / (mantissa + 1), s2 = s * s;
    const float log2 =
        float(exponent) + s * (2.885390082f + s2 * (0.961796694f + s2 * (0.577078016f + s2 * 0.412198583f)));
    float e = log2 * power;
    e = e < -125.0f ? -125.0f : e;
    e = e > 127.0f ? 127.0f : e;
    const auto whole = std::int32_t(e + 128.5f) - 128;  // rounds: the sum is positive
    const float f = e - float(whole);
    const float p =
        1 + f * (0.693147181f +
                 f * (0.240226507f +
                      f * (0.0555041087f + f * (0.00961812911f + f * (0.00133335581f + f * 0.000154035304f)))));
    return p * std::bit_cast<float>((whole + 127) * (1 << 23));
}

/// Calls change(pixel, opacity) for every pixel that is not fully transparent.
template <class Change>
void for_each_pixel(Frame& frame, const JobContext& job, Change&& change) {
    for_rows(frame.size.y, job, [&](int y) {
        glm::vec4* row = &frame.color[std::size_t(y) * std::size_t(frame.size.x)];
        for (int x = 0; x < frame.size.x; ++x)
            if (row[x].a > 0) change(row[x]);
    });
}

/// (value / opacity)^power * opacity for n floats of pixels with that opacity, in place; left alone where the opacity
/// is not above 0. Colours at or below 0 (or NaN) have no power: black. Opacities themselves come out as they are: 1^p
/// = 1.
LACUNA_VECTOR_CLONES void raise(float* __restrict value, const float* __restrict opacity, int n, float power) {
    for (int i = 0; i < n; ++i) {
        const float color = value[i] / opacity[i];
        const float bounded = color < 1e30f ? color : 1e30f;
        const float raised = power_of(bounded > 1e-30f ? bounded : 1.0f, power) * opacity[i];
        const float seen = color > 1e-30f ? raised : 0.0f;
        value[i] = opacity[i] > 0 ? seen : value[i];
    }
}

void gamma_curve(double gamma, Frame& frame, const JobContext& job) {
    const float power = float(1 / gamma);
    const int n = 4 * frame.size.x;
    for_rows(frame.size.y, job, [&](int y) {
        glm::vec4* row = &frame.color[std::size_t(y) * std::size_t(frame.size.x)];
        constexpr int k_piece = 64;  // floats at a time
        float opacity[k_piece];
        for (int first = 0; first < n; first += k_piece) {
            const int count = std::min(k_piece, n - first);
            for (int i = 0; i < count; ++i) opacity[i] = row[(first + i) / 4].a;
            raise(&row[0].x + first, opacity, count, power);
        }
    });
}

/// Reinhard et al., "Photographic Tone Reproduction for Digital Images" (2002), equation 4, on Rec. 709 luma of the
/// coded colours: l' = l (1 + l/white^2) / (1 + l).
void reinhard(double white, Frame& frame, const JobContext& job) {
    const float per_white2 = float(1 / (white * white));
    for_each_pixel(frame, job, [=](glm::vec4& pixel) {
        const float luma = std::max(0.0f, (0.2126f * pixel.r + 0.7152f * pixel.g + 0.0722f * pixel.b) / pixel.a);
        const float factor = (1 + luma * per_white2) / (1 + luma);
        for (int c = 0; c < 3; ++c) pixel[c] *= factor;
    });
}

/// factor * colour + added, on premultiplied colour.
void line(double factor, double added, Frame& frame, const JobContext& job) {
    const float f = float(factor), b = float(added);
    for_each_pixel(frame, job, [=](glm::vec4& pixel) {
        for (int c = 0; c < 3; ++c) pixel[c] = pixel[c] * f + b * pixel.a;
    });
}

}  // namespace

void tone(const Effect& effect, Frame& frame, const JobContext& job) {
    const double v = effect.value(0);
    switch (effect.kind) {
        case EffectKind::gamma:
            if (v != 1) gamma_curve(v, frame, job);
            break;
        case EffectKind::tonemap:
            if (v != 1) reinhard(v, frame, job);
            break;
        case EffectKind::brightness:
            if (v != 0) line(1, v, frame, job);
            break;
        case EffectKind::contrast:
            if (v != 1) line(v, 0.5 * (1 - v), frame, job);
            break;
        default:
            break;
    }
}

}  // namespace lacuna::effects
