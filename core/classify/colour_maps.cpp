#include "core/classify/colour_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

namespace lacuna {

namespace {

/// A place on a map's path.
struct Stop {
    double lightness, chroma, hue_deg;
};

struct Map {
    std::string_view name;
    std::span<const Stop> stops;  ///< evenly spaced; empty: a formula of its own
};

constexpr std::array k_grey{Stop{0, 0, 0}, Stop{1, 0, 0}};
constexpr std::array k_heat{Stop{0.05, 0.02, 10}, Stop{0.30, 0.15, 22}, Stop{0.53, 0.20, 32}, Stop{0.76, 0.17, 65},
                            Stop{0.98, 0.05, 105}};
constexpr std::array k_meadow{Stop{0.22, 0.10, 300}, Stop{0.40, 0.09, 250}, Stop{0.56, 0.09, 195},
                              Stop{0.73, 0.15, 145}, Stop{0.91, 0.18, 105}};
constexpr std::array k_dusk{Stop{0.18, 0.10, 275}, Stop{0.36, 0.17, 300}, Stop{0.54, 0.20, 350}, Stop{0.72, 0.16, 40},
                            Stop{0.92, 0.14, 95}};
constexpr std::array k_ocean{Stop{0.15, 0.06, 265}, Stop{0.40, 0.12, 255}, Stop{0.65, 0.11, 220},
                             Stop{0.95, 0.03, 190}};
constexpr std::array k_bone{Stop{0.25, 0.08, 30}, Stop{0.48, 0.10, 45}, Stop{0.72, 0.08, 70}, Stop{0.97, 0.03, 95}};
constexpr std::array k_blood{Stop{0.15, 0.08, 20}, Stop{0.42, 0.17, 27}, Stop{0.68, 0.17, 35}, Stop{0.94, 0.06, 80}};
constexpr std::array k_cold_warm{Stop{0.40, 0.15, 262}, Stop{0.66, 0.10, 255}, Stop{0.93, 0.01, 100},
                                 Stop{0.66, 0.12, 35}, Stop{0.40, 0.16, 25}};

constexpr std::array k_maps{Map{"grey", k_grey},   Map{"heat", k_heat},   Map{"meadow", k_meadow},
                            Map{"dusk", k_dusk},   Map{"ocean", k_ocean}, Map{"bone", k_bone},
                            Map{"blood", k_blood}, Map{"cubehelix", {}},  Map{"cold-warm", k_cold_warm}};

constexpr double k_close = 0.02;  // OKLab distance that is not told apart at a glance
constexpr std::size_t k_most_points = 24;

double to_linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double to_srgb(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

glm::dvec3 oklab_of(const glm::dvec3& srgb) {
    const double r = to_linear(srgb.r), g = to_linear(srgb.g), b = to_linear(srgb.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// Linear RGB; parts outside 0..1 where the colour cannot be shown.
glm::dvec3 linear_of_oklab(const glm::dvec3& lab) {
    const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3);
    const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3);
    const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

glm::dvec3 shown(const Stop& at) {
    const double a = std::cos(at.hue_deg * std::numbers::pi / 180), b = std::sin(at.hue_deg * std::numbers::pi / 180);
    const auto linear = [&](double chroma) { return linear_of_oklab({at.lightness, chroma * a, chroma * b}); };
    const auto fits = [](const glm::dvec3& c) {
        return std::min({c.r, c.g, c.b}) >= -1e-6 && std::max({c.r, c.g, c.b}) <= 1 + 1e-6;
    };
    double chroma = at.chroma;
    if (!fits(linear(chroma))) {
        double lo = 0, hi = chroma;
        for (int i = 0; i < 30; ++i) (fits(linear(0.5 * (lo + hi))) ? lo : hi) = 0.5 * (lo + hi);
        chroma = lo;
    }
    const glm::dvec3 c = linear(chroma);
    const auto part = [](double v) { return std::clamp(to_srgb(std::clamp(v, 0.0, 1.0)), 0.0, 1.0); };
    return {part(c.r), part(c.g), part(c.b)};
}

glm::dvec3 along(std::span<const Stop> stops, double t) {
    const double at = t * double(stops.size() - 1);
    const auto i = std::min(std::size_t(at), stops.size() - 2);
    const double f = at - double(i);
    const Stop &a = stops[i], &b = stops[i + 1];
    const double turn = std::remainder(b.hue_deg - a.hue_deg, 360.0);  // the short way round
    return shown(
        {a.lightness + f * (b.lightness - a.lightness), a.chroma + f * (b.chroma - a.chroma), a.hue_deg + f * turn});
}

/// Green 2011 with start 0.5, 1.5 turns backwards, hue 1, gamma 1.
glm::dvec3 cubehelix(double t) {
    const double angle = 2 * std::numbers::pi * (0.5 / 3 + 1 - 1.5 * t), strength = t * (1 - t) / 2;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto part = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return {part(t + strength * (-0.14861 * c + 1.78277 * s)), part(t + strength * (-0.29227 * c - 0.90649 * s)),
            part(t + strength * 1.97294 * c)};
}

}  // namespace

std::vector<std::string> colour_map_names() {
    std::vector<std::string> names;
    for (const Map& map : k_maps) names.emplace_back(map.name);
    return names;
}

glm::dvec3 colour_map_at(const std::string& name, double t) {
    const auto* map = std::find_if(k_maps.begin(), k_maps.end(), [&](const Map& m) { return m.name == name; });
    if (map == k_maps.end()) {
        std::string known;
        for (const Map& m : k_maps) known += (known.empty() ? "" : ", ") + std::string(m.name);
        throw Error(Errc::bad_usage, "There is no colour map '" + name + "'; known are " + known + ".");
    }
    t = t > 0 ? std::min(t, 1.0) : 0.0;
    return map->stops.empty() ? cubehelix(t) : along(map->stops, t);
}

double lightness_of(const glm::dvec3& srgb) { return oklab_of(srgb).x; }

TransferFunction with_colour_map(const TransferFunction& tf, const std::string& map, std::size_t first,
                                 std::size_t last) {
    TransferFunction made = tf;
    const double lo = tf.points[first].value, width = tf.points[last].value - lo;
    const auto color_at = [&](double v) { return colour_map_at(map, width > 0 ? (v - lo) / width : 0.5); };
    for (std::size_t i = first; i <= last; ++i) made.points[i].color = color_at(made.points[i].value);
    for (std::size_t i = first; i < last && made.points.size() < k_most_points;) {
        const TransferPoint &a = made.points[i], &b = made.points[i + 1];
        const double middle = 0.5 * (a.value + b.value);
        const glm::dvec3 wanted = color_at(middle), straight = 0.5 * (a.color + b.color);
        const bool apart = middle > a.value && middle < b.value;
        if (apart && glm::length(oklab_of(wanted) - oklab_of(straight)) > k_close) {
            made.points.insert(made.points.begin() + std::ptrdiff_t(i + 1),
                               {middle, wanted, 0.5 * (a.opacity + b.opacity)});
            ++last;
        } else {
            ++i;
        }
    }
    return made;
}

TransferFunction with_colours_reversed(const TransferFunction& tf) {
    TransferFunction made = tf;
    for (std::size_t i = 0; i < tf.points.size(); ++i) made.points[i].color = tf.points[tf.points.size() - 1 - i].color;
    return made;
}

}  // namespace lacuna
