#include "core/chart/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lacuna {
namespace {

glm::dvec3 linear(glm::dvec3 c) {
    for (int i = 0; i < 3; ++i) c[i] = c[i] <= 0.04045 ? c[i] / 12.92 : std::pow((c[i] + 0.055) / 1.055, 2.4);
    return c;
}

glm::dvec3 lab(const glm::dvec3& rgb) {
    const glm::dvec3 xyz(glm::dot(rgb, {0.4124, 0.3576, 0.1805}), glm::dot(rgb, {0.2126, 0.7152, 0.0722}),
                         glm::dot(rgb, {0.0193, 0.1192, 0.9505}));
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f(xyz.x / 0.9505), y = f(xyz.y), z = f(xyz.z / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// What a colour looks like with one kind of cone missing (Machado, Oliveira & Fernandes 2009, severity 1).
glm::dvec3 seen_by(int kind, const glm::dvec3& c) {
    static const double k[3][9] = {
        {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},   // protanopia
        {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},    // deuteranopia
        {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}};  // tritanopia
    if (kind == 0) return c;
    const double* m = k[kind - 1];
    return glm::clamp(glm::dvec3(m[0] * c.x + m[1] * c.y + m[2] * c.z, m[3] * c.x + m[4] * c.y + m[5] * c.z,
                                 m[6] * c.x + m[7] * c.y + m[8] * c.z),
                      0.0, 1.0);
}

TEST(Palette, ColoursStayApartForEveryKindOfSight) {
    const auto colors = series_colors();
    for (int kind = 0; kind < 4; ++kind)
        for (std::size_t a = 0; a < colors.size(); ++a)
            for (std::size_t b = a + 1; b < colors.size(); ++b) {
                // 2.3 is a just noticeable difference side by side.
                const double apart =
                    glm::length(lab(seen_by(kind, linear(colors[a]))) - lab(seen_by(kind, linear(colors[b]))));
                EXPECT_GT(apart, a < 6 && b < 6 ? 14 : 8) << "sight " << kind << ": " << a << " and " << b;
            }
}

TEST(Palette, ColoursShowOnPaper) {
    for (const glm::dvec3& color : series_colors()) {
        const double luminance = glm::dot(linear(color), {0.2126, 0.7152, 0.0722});
        EXPECT_GT(1.05 / (luminance + 0.05), 1.9);
    }
}

TEST(Palette, SeriesDifferInColourOrMarkerForLong) {
    std::set<std::tuple<double, double, double, int>> seen;
    for (std::size_t i = 0; i < 40; ++i) {
        const glm::dvec3 c = series_color(i);
        EXPECT_TRUE(seen.insert({c.x, c.y, c.z, int(series_marker(i))}).second) << i;
    }
}

}  // namespace
}  // namespace lacuna
