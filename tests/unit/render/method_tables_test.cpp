// Tables the methods rest on: packed gradients against exact ones, pre-integrated segments against fine integration.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/render/reference_sampler.h"
#include "core/render/segment_tables.h"
#include "core/render/stored_gradients.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

TEST(PackedGradient, KeepsEightBitsOfTheLargestComponent) {
    for (const glm::dvec3& g : {glm::dvec3(0.99, -0.5, 0.001), glm::dvec3(-1e-4, 2e-5, 9e-5), glm::dvec3(0, 0, -0.3),
                                glm::dvec3(1e-7, 1e-7, -1e-7), glm::dvec3(0)}) {
        const glm::dvec3 back = unpack_gradient(pack_gradient(g));
        const double largest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(back[a], g[a], largest / 254) << glm::length(g);
    }
    EXPECT_TRUE(std::isnan(unpack_gradient(pack_gradient(glm::dvec3(k_nan, 0, 0))).x));
}

template <class T>
void expect_gradients(const Volume& volume, ValueRange values) {
    const reference::Field<T> field(volume);
    const glm::ivec3 n = volume.geometry().size, stored = glm::max(n, glm::ivec3(2));
    for (GradientFilter filter : {GradientFilter::central, GradientFilter::sobel}) {
        const VoxelBuffer buffer = make_stored_gradients(volume, filter, values);
        float scale = 0;
        std::memcpy(&scale, buffer.data(), sizeof scale);
        const auto* words = reinterpret_cast<const std::uint32_t*>(buffer.data()) + 1;
        for (int z = 0; z < stored.z; ++z)
            for (int y = 0; y < stored.y; ++y)
                for (int x = 0; x < stored.x; ++x) {
                    const glm::dvec3 g = double(scale) * unpack_gradient(*words++);
                    const glm::dvec3 exact =
                        field.gradient(glm::min(glm::ivec3(x, y, z), n - 1), filter == GradientFilter::sobel);
                    if (std::isnan(g.x) || glm::any(glm::isnan(exact))) {
                        // A sample beside a NaN is NaN too, even with weight 0: the field knows more of them.
                        EXPECT_TRUE(glm::any(glm::isnan(exact)));
                        continue;
                    }
                    EXPECT_LE(glm::length(g - exact), glm::length(exact) / 140 + 1e-6 * values.width())
                        << x << " " << y << " " << z << " " << name_of(filter);
                }
    }
}

TEST(StoredGradients, EqualTheReferencesAtVoxels) {
    const auto wild = [](const glm::dvec3& mm) {
        return 120 + 100 * std::sin(mm.x + 0.3 * mm.y * mm.y) * std::cos(mm.z);
    };
    expect_gradients<std::uint8_t>(sampled<std::uint8_t>(centred({11, 9, 7}, {1, 1, 5}, 20), wild), {20, 220});
    expect_gradients<std::int16_t>(sampled<std::int16_t>(centred({1, 1, 9}), wild), {20, 220});
    expect_gradients<float>(sampled<float>(centred({1, 1, 1}), wild), {20, 220});
    expect_gradients<float>(sampled<float>(centred({8, 6, 5}, {0.3, 0.4, 0.5}),
                                           [&](const glm::dvec3& mm) { return mm.x > 0.8 ? double(k_nan) : wild(mm); }),
                            {20, 220});
    expect_gradients<std::uint16_t>(sampled<std::uint16_t>(centred({5, 5, 5}), [](const glm::dvec3&) { return 9; }),
                                    {9, 9});
}

/// A segment by thousands of layers, straight from the classification.
glm::dvec4 integrated(const Classification& classes, double front, double back, double step_mm) {
    constexpr int k_layers = 4000;
    glm::dvec3 color(0);
    double clear = 1;
    for (int i = 0; i < k_layers; ++i) {
        const double v = front + (i + 0.5) / k_layers * (back - front);
        const ColorOpacity at = classes.at(v);
        const int range = classes.range_of(v);
        const auto& own = range >= 0 ? classes.ranges[std::size_t(range)].tf : std::nullopt;
        const double a =
            correct_opacity(at.opacity, step_mm / k_layers, own ? own->unit_distance_mm : classes.tf.unit_distance_mm);
        color += clear * a * at.color;
        clear *= 1 - a;
    }
    return {color, 1 - clear};
}

glm::dvec3 unpacked(std::uint32_t c) {
    return {double(c & 2047) / 2047, double(c >> 11 & 2047) / 2047, double(c >> 22 & 1023) / 1023};
}

void expect_segments(const Classification& classes, ValueRange values, double step_mm) {
    const SegmentTables tables = make_segment_tables(classes, values, step_mm);
    constexpr int n = SegmentTables::k_nodes;
    ASSERT_EQ(tables.opacity.size(), std::size_t(n) * n);
    double most = 0;
    for (int f = 0; f < n; f += 37)
        for (int b = 0; b < n; b += 29) {
            if (f == b) continue;
            const double front = tables.lo + f / tables.nodes_per_unit, back = tables.lo + b / tables.nodes_per_unit;
            const glm::dvec4 exact = integrated(classes, front, back, step_mm);
            const std::size_t at = std::size_t(f) * n + std::size_t(b);
            EXPECT_NEAR(tables.opacity[at], exact.a, 3e-3) << front << " to " << back;
            const glm::dvec3 color = unpacked(tables.color[at]) * double(tables.opacity[at]);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], exact[c], 6e-3) << front << " to " << back;
            EXPECT_EQ(tables.opacity[at] > 0,
                      tables.visible[std::size_t(std::max(f, b))] > tables.visible[std::size_t(std::min(f, b))]);
            most = std::max(most, exact.a);
        }
    EXPECT_GT(most, 0.2);
}

TEST(SegmentTables, EqualFineIntegrationItsOwnAttenuationIncluded) {
    Classification classes;
    classes.tf = {
        "dense", 0.5, {{10, {1, 0, 0}, 0}, {40, {0, 1, 0}, 0.7}, {60, {0, 0, 1}, 0.95}, {90, {1, 1, 0}, 0}}, {}};
    expect_segments(classes, {0, 100}, 1.0);
    expect_segments(classes, {30, 65}, 0.3);
    classes.ranges = {{"a", {20, 35}, {}}, {"b", {50, 80}, TransferFunction{"own", 2, {{0, {1, 1, 1}, 0.9}}, {}}}};
    expect_segments(classes, {0, 100}, 1.0);
}

TEST(SegmentTables, AJumpAndAConstantAreNoTrouble) {
    Classification classes;
    classes.tf = {"jump", 1, {{50, {1, 0, 0}, 0}, {50, {1, 0, 0}, 0.6}}, {}};
    const SegmentTables tables = make_segment_tables(classes, {0, 100}, 1.0);
    for (const float a : tables.opacity) ASSERT_TRUE(a >= 0 && a <= 1);
    classes.tf.points = {{0, glm::dvec3(1), 1.0}};  // opaque everywhere
    const SegmentTables opaque = make_segment_tables(classes, {5, 5}, 1.0);
    for (const float a : opaque.opacity) ASSERT_GT(a, 0.999);
}

TEST(SegmentTables, OrderMattersForColourNotForOpacity) {
    Classification classes;
    classes.tf = {
        "two", 1, {{0, {1, 0, 0}, 0.99}, {50, {1, 0, 0}, 0.99}, {50, {0, 0, 1}, 0.99}, {100, {0, 0, 1}, 0.99}}, {}};
    const SegmentTables tables = make_segment_tables(classes, {0, 100}, 2.0);
    constexpr std::size_t n = SegmentTables::k_nodes, lo = 20, hi = 490;
    EXPECT_FLOAT_EQ(tables.opacity[lo * n + hi], tables.opacity[hi * n + lo]);
    EXPECT_GT(unpacked(tables.color[lo * n + hi]).r, 0.9);
    EXPECT_GT(unpacked(tables.color[hi * n + lo]).b, 0.9);
}

}  // namespace
}  // namespace lacuna
