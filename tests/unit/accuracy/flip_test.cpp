#include "core/accuracy/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "tests/unit/accuracy/pictures.h"

namespace lacuna {
namespace {

using namespace test;

double flip(const Frame& a, const Frame& b, double ppd = k_flip_pixels_per_degree) {
    return mean_flip(FlipPicture(a, glm::dvec3(0), ppd), FlipPicture(b, glm::dvec3(0), ppd));
}

Frame one_color(glm::vec3 c, glm::ivec2 size = {9, 7}) { return flat(size, glm::vec4(c, 1)); }

TEST(Flip, EqualPicturesDoNotFlicker) {
    EXPECT_EQ(flip(waves({31, 17}, 0.3), waves({31, 17}, 0.3)), 0);
    EXPECT_EQ(flip(one_color({0, 0, 0}, {1, 1}), one_color({0, 0, 0}, {1, 1})), 0);
}

TEST(Flip, GreenAgainstBlueIsTheLargestThereIs) {
    EXPECT_NEAR(flip(one_color({0, 1, 0}), one_color({0, 0, 1})), 1, 1e-5);
    const glm::vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                 {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    for (const glm::vec3& a : corners)
        for (const glm::vec3& b : corners) {
            const double f = flip(one_color(a), one_color(b));
            EXPECT_LE(f, 1 + 1e-6);
            EXPECT_EQ(f > 0, a != b);
        }
}

TEST(Flip, FlatPicturesFollowTheColourMetricAlone) {
    // Black and white lie 100 apart in HyAB; green and blue, the farthest, 203.3 after the Hunt adjustment.
    const double most = std::pow(203.302, 0.7), d = std::pow(100.0, 0.7);
    const double expected = d < 0.4 * most ? d * 0.95 / (0.4 * most) : 0.95 + 0.05 * (d - 0.4 * most) / (0.6 * most);
    EXPECT_NEAR(flip(one_color({0, 0, 0}), one_color({1, 1, 1})), expected, 2e-3);
}

TEST(Flip, IsSymmetricAndGrowsWithTheDifference) {
    const Frame a = waves({40, 30}, 0.2), b = waves({40, 30}, 0.2, 0.8);
    EXPECT_DOUBLE_EQ(flip(a, b), flip(b, a));
    double before = 0;
    for (const float offset : {0.01f, 0.03f, 0.1f, 0.3f}) {
        Frame brighter = a;
        for (auto& pixel : brighter.color) pixel += glm::vec4(glm::vec3(offset), 0);
        const double f = flip(a, brighter);
        EXPECT_GT(f, before);
        EXPECT_LT(f, 1);
        before = f;
    }
}

TEST(Flip, FineStructureFadesWithDistance) {
    const glm::ivec2 size(64, 64);
    const Frame grey = one_color({0.5f, 0.5f, 0.5f}, size), fine = waves(size, 0.2, 0, 2.9),
                coarse = waves(size, 0.2, 0, 0.1);
    EXPECT_LT(flip(grey, fine), 0.7 * flip(grey, coarse)) << "contrast sensitivity falls with frequency";
    EXPECT_LT(flip(grey, fine, 134), flip(grey, fine, 67)) << "and with the distance from the screen";
}

TEST(Flip, AnIsolatedPointShowsMoreThanItsColourAlone) {
    const glm::ivec2 size(61, 61);
    const Frame grey = one_color({0.3f, 0.3f, 0.3f}, size);
    Frame spot = grey;
    spot.color[30 * 61 + 30] = glm::vec4(1);
    const std::vector<float> map = flip_map(FlipPicture(grey, glm::dvec3(0)), FlipPicture(spot, glm::dvec3(0)));
    EXPECT_EQ(std::max_element(map.begin(), map.end()) - map.begin(), 30 * 61 + 30);
    EXPECT_GT(map[30 * 61 + 30], 0.1);
    EXPECT_LT(map[0], 1e-4);
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 61; ++x) EXPECT_NEAR(map[y * 61 + x], map[x * 61 + y], 1e-5) << "isotropic";
}

// The paper's formulas written down once more, with whole two-dimensional kernels in double precision.
namespace direct {

glm::dvec3 xyz(const glm::dvec3& c) {
    return {(10135552 * c.r + 8788810 * c.g + 4435075 * c.b) / 24577794,
            (2613072 * c.r + 8788810 * c.g + 887015 * c.b) / 12288897,
            (1425312 * c.r + 8788810 * c.g + 70074185 * c.b) / 73733382};
}
const glm::dvec3 k_white = xyz(glm::dvec3(1));

template <class Weight>
double sum_2d(const Frame& f, const std::vector<double>& plane, int x, int y, int radius, Weight&& weight) {
    double sum = 0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) {
            const int sx = std::clamp(x + dx, 0, f.size.x - 1), sy = std::clamp(y + dy, 0, f.size.y - 1);
            sum += weight(dx, dy) * plane[std::size_t(sy * f.size.x + sx)];
        }
    return sum;
}

struct Features {
    std::vector<glm::dvec3> lab;
    std::vector<double> edge, point;
};

Features features(const Frame& f, double ppd) {
    const double pi = std::numbers::pi;
    std::vector<double> planes[3], luminance;
    for (const glm::vec4& pixel : f.color) {
        glm::dvec3 c(pixel);
        for (int k = 0; k < 3; ++k) c[k] = c[k] <= 0.04045 ? c[k] / 12.92 : std::pow((c[k] + 0.055) / 1.055, 2.4);
        const glm::dvec3 n = xyz(c) / k_white;
        planes[0].push_back(116 * n.y - 16);
        planes[1].push_back(500 * (n.x - n.y));
        planes[2].push_back(200 * (n.y - n.z));
        luminance.push_back(n.y);
    }
    const double a[3][2] = {{1, 0}, {1, 0}, {34.1, 13.5}}, b[3][2] = {{0.0047, 1e-5}, {0.0053, 1e-5}, {0.04, 0.025}};
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    const double w = 0.082, sd = 0.5 * w * ppd;
    const int r = int(std::ceil(3 * sd));
    const auto gauss = [&](int x, int y) { return std::exp(-0.5 * (x * x + y * y) / (sd * sd)); };
    double edge_norm = 0, point_plus = 0, point_minus = 0;
    for (int y = -r; y <= r; ++y)
        for (int x = -r; x <= r; ++x) {
            edge_norm += std::max(0.0, -x * gauss(x, y));
            const double p = (x * x / (sd * sd) - 1) * gauss(x, y);
            (p > 0 ? point_plus : point_minus) += std::fabs(p);
        }
    const auto edge = [&](int x, int y) { return -x * gauss(x, y) / edge_norm; };
    const auto point = [&](int x, int y) {
        const double p = (x * x / (sd * sd) - 1) * gauss(x, y);
        return p / (p > 0 ? point_plus : point_minus);
    };
    Features out;
    for (int y = 0; y < f.size.y; ++y)
        for (int x = 0; x < f.size.x; ++x) {
            glm::dvec3 filtered;
            for (int k = 0; k < 3; ++k) {
                const auto csf = [&](int dx, int dy) {
                    const double z = (dx * dx + dy * dy) / (ppd * ppd);
                    return a[k][0] * std::sqrt(pi / b[k][0]) * std::exp(-pi * pi * z / b[k][0]) +
                           a[k][1] * std::sqrt(pi / b[k][1]) * std::exp(-pi * pi * z / b[k][1]);
                };
                double norm = 0;
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx) norm += csf(dx, dy);
                filtered[k] = sum_2d(f, planes[k], x, y, radius, csf) / norm;
            }
            const double fy = (filtered.x + 16) / 116;
            const glm::dvec3 t = glm::dvec3(fy + filtered.y / 500, fy, fy - filtered.z / 200) * k_white;
            glm::dmat3 m;
            for (int k = 0; k < 3; ++k) m[k] = xyz({double(k == 0), double(k == 1), double(k == 2)});
            const glm::dvec3 n = xyz(glm::clamp(glm::inverse(m) * t, 0.0, 1.0)) / k_white;
            const auto g = [](double v) { return v > 216.0 / 24389 ? std::cbrt(v) : v * 841 / 108 + 4.0 / 29; };
            const double l = 116 * g(n.y) - 16;
            out.lab.push_back({l, 0.01 * l * 500 * (g(n.x) - g(n.y)), 0.01 * l * 200 * (g(n.y) - g(n.z))});
            const auto across = [](const auto& kernel) { return [&](int dx, int dy) { return kernel(dy, dx); }; };
            out.edge.push_back(
                std::hypot(sum_2d(f, luminance, x, y, r, edge), sum_2d(f, luminance, x, y, r, across(edge))));
            out.point.push_back(
                std::hypot(sum_2d(f, luminance, x, y, r, point), sum_2d(f, luminance, x, y, r, across(point))));
        }
    return out;
}

}  // namespace direct

TEST(Flip, SeparableFiltersGiveWhatTheFormulasSay) {
    const glm::ivec2 size(19, 14);
    Frame a = waves(size, 0.4), b = waves(size, 0.35, 0.5, 0.9);
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        a.color[i].r = std::min(1.f, 0.9f * a.color[i].r + 0.1f);
        b.color[i].b *= 0.6f;
        if (i % 17 == 3) b.color[i] = glm::vec4(1, 0.2f, 0, 1);
    }
    const double ppd = 67.0206432765823, most = std::pow(203.302, 0.7), knee = 0.4 * most;
    const direct::Features fa = direct::features(a, ppd), fb = direct::features(b, ppd);
    const std::vector<float> map = flip_map(FlipPicture(a, glm::dvec3(0)), FlipPicture(b, glm::dvec3(0)));
    for (std::size_t i = 0; i < map.size(); ++i) {
        const glm::dvec3 d = fa.lab[i] - fb.lab[i];
        const double distance = std::pow(std::fabs(d.x) + std::hypot(d.y, d.z), 0.7);
        const double color = distance < knee ? distance * 0.95 / knee : 0.95 + 0.05 * (distance - knee) / (most - knee);
        const double feature = std::max(std::fabs(fa.edge[i] - fb.edge[i]), std::fabs(fa.point[i] - fb.point[i]));
        EXPECT_NEAR(map[i], std::pow(color, 1 - std::sqrt(feature / std::numbers::sqrt2)), 2e-3) << i;
    }
}

TEST(Flip, NaNIsTheWorst) {
    Frame broken = waves({20, 20}, 0.3);
    broken.color[77].g = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(flip(broken, waves({20, 20}, 0.3)), 1);
    EXPECT_EQ(flip(waves({20, 20}, 0.3), broken), 1);
}

TEST(Flip, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(flip(waves({4, 4}, 0.1), waves({4, 5}, 0.1)), Error);
    EXPECT_THROW(FlipPicture(waves({4, 4}, 0.1), glm::dvec3(0), 0), Error);
}

}  // namespace
}  // namespace lacuna
