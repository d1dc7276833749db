#include <cmath>
#include <numbers>

#include "core/volume/sample_scene.h"

// Samples that look like anatomy: the head and the vessel tree.
namespace lacuna::samples {

namespace {

constexpr double k_head_edge_mm = 230.4, k_vessels_edge_mm = 128.0;

/// The same part on the right and on the left.
template <class Make>
std::vector<Part> both_sides(Make&& make) {
    return {make(-1.0), make(1.0)};
}

void append(std::vector<Part>& to, std::vector<Part> more) {
    for (Part& part : more) to.push_back(std::move(part));
}

Part skin() {
    std::vector<Part> parts{bounded_ellipsoid({0, 8, 28}, {73, 91, 76}), bounded_ellipsoid({0, -28, -32}, {56, 57, 60}),
                            capsule({0, 26, -50}, {0, 34, -150}, 47), bounded_ellipsoid({0, -64, -78}, {25, 20, 17}),
                            capsule({-32, -74, 12}, {32, -74, 12}, 8)};
    append(parts, both_sides([](double s) { return bounded_ellipsoid({s * 40, -52, -34}, {17, 18, 16}); }));
    // Flesh over the cheekbones and along the jaw.
    append(parts, both_sides([](double s) { return capsule({s * 40, -50, -20}, {s * 55, -8, -14}, 13); }));
    append(parts, both_sides([](double s) { return capsule({s * 46, 2, -26}, {s * 43, -6, -62}, 17); }));
    append(parts, both_sides([](double s) { return capsule({s * 43, -6, -62}, {s * 15, -62, -80}, 15); }));
    Part face = unite(std::move(parts), 16);
    std::vector<Part> hollows = both_sides([](double s) { return ball({s * 32, -96, -5}, 15); });
    face = cut(std::move(face), unite(std::move(hollows)), 9);
    std::vector<Part> details{std::move(face), capsule({0, -84, 2}, {0, -98, -26}, 7), ball({0, -98, -29}, 9.5),
                              capsule({-14, -85, -54}, {14, -85, -54}, 4.5),
                              capsule({-11, -84, -63}, {11, -84, -63}, 5)};
    append(details, both_sides([](double s) { return ball({s * 9, -92, -33}, 6); }));
    append(details, both_sides([](double s) { return bounded_ellipsoid({s * 31, -67, -5}, {14, 13, 10}); }));
    append(details, both_sides([](double s) { return bounded_ellipsoid({s * 74, 16, -10}, {6, 15, 26}); }));
    return unite(std::move(details), 6);
}

Part bone() {
    std::vector<Part> parts{bounded_ellipsoid({0, 8, 28}, {67, 85, 70}), bounded_ellipsoid({0, -32, -22}, {44, 44, 36}),
                            bounded_ellipsoid({0, -66, 12}, {42, 12, 7})};
    append(parts, both_sides([](double s) { return capsule({s * 42, -52, -20}, {s * 61, -8, -14}, 5); }));
    append(parts, both_sides([](double s) { return capsule({s * 50, 2, -26}, {s * 47, -6, -64}, 7); }));
    append(parts, both_sides([](double s) { return capsule({s * 47, -6, -64}, {s * 15, -66, -80}, 8); }));
    parts.push_back(capsule({-15, -66, -80}, {15, -66, -80}, 9));
    parts.push_back(capsule({0, -66, 4}, {0, -82, -12}, 4));
    return unite(std::move(parts), 7);
}

/// Teeth on two arcs around the mouth.
Layer teeth() {
    Layer layer{1900, {}};
    for (int i = -6; i <= 6; ++i) {
        const double a = 0.19 * i;
        const glm::dvec3 at{34 * std::sin(a), -38 - 34 * std::cos(a), 0};
        layer.parts.push_back(ellipsoid(at + glm::dvec3(0, 0, -52), {3.3, 3.3, 6.0}));
        layer.parts.push_back(ellipsoid(at + glm::dvec3(0, 1.5, -66), {3.0, 3.0, 5.5}));
    }
    return layer;
}

Layer air_spaces() {
    Layer layer{-1000,
                {ellipsoid({0, -66, -24}, {10, 24, 17}), ellipsoid({0, -20, -16}, {13, 11, 9}),
                 capsule({0, -44, -34}, {0, 0, -48}, 7), capsule({0, 0, -48}, {0, 2, -150}, 8)}};
    append(layer.parts, both_sides([](double s) { return ellipsoid({s * 26, -46, -29}, {10, 13, 12}); }));
    append(layer.parts, both_sides([](double s) { return ellipsoid({s * 13, -69, 13}, {8, 3, 4.5}); }));
    append(layer.parts, both_sides([](double s) { return capsule({s * 6, -78, -30}, {s * 6.5, -97, -41}, 3.2); }));
    append(layer.parts, both_sides([](double s) { return capsule({s * 66, 14, -12}, {s * 90, 14, -12}, 3.0); }));
    return layer;
}

}  // namespace

Scene head(const SampleOptions& options) {
    Scene scene;
    scene.geometry = cube_grid(options.dims, k_head_edge_mm);
    scene.geometry.axis_names = AxisNames::patient;
    scene.type = VoxelType::i16;
    scene.unit = "HU";
    scene.background = -1000;
    scene.material = 40;
    scene.noise = 12;
    scene.blur_voxels = 0.7;
    Layer skull{1250, {bone(), capsule({0, 46, -40}, {0, 56, -150}, 15)}};
    Layer ventricles{10, both_sides([](double s) { return ellipsoid({s * 12, 2, 38}, {6, 30, 9}); })};
    ventricles.parts.push_back(ellipsoid({0, 6, 24}, {3, 12, 9}));
    Layer orbits{30, both_sides([](double s) { return ellipsoid({s * 31, -59, -4}, {16, 20, 15}); })};
    append(orbits.parts, both_sides([](double s) { return capsule({s * 28, -60, -4}, {s * 12, -26, -4}, 5); }));
    Layer calcifications{550, {ball({24, 26, 18}, 3.2), ball({-20, -14, 40}, 2.4), ball({1, 24, 30}, 2.8)}};
    for (const glm::dvec4& c : {glm::dvec4(24, 26, 18, 3.2), glm::dvec4(-20, -14, 40, 2.4), glm::dvec4(1, 24, 30, 2.8)})
        scene.objects.push_back(
            {"inclusion", glm::dvec3(c), glm::dvec3(c.w), 4.0 / 3.0 * std::numbers::pi * c.w * c.w * c.w});
    scene.layers = {{40, {skin()}},
                    std::move(skull),
                    {900, {ellipsoid({0, 8, 28}, {65, 83, 68})}},  // diploe between the two tables of the vault
                    {1350, {ellipsoid({0, 8, 28.5}, {62.5, 80.5, 65.5})}},
                    {37, {ellipsoid({0, 8, 29}, {60.5, 78.5, 63.5})}},
                    {28, {ellipsoid({0, 8, 32}, {49, 66, 46})}},
                    std::move(ventricles),
                    {37, {capsule({0, 44, -26}, {0, 54, -150}, 6)}},  // spinal canal
                    std::move(orbits),
                    {15, both_sides([](double s) {
                         return ball({s * 31, -67, -5}, 10.5);
                     })},
                    teeth(),
                    air_spaces(),
                    std::move(calcifications)};
    return scene;
}

namespace {

struct Tree {
    Dice dice;
    std::vector<Part> parts;
    glm::dvec3 bulge{0};

    /// One branch of three slightly bent pieces, then two children by Murray's law (1926): r0^3 = r1^3 + r2^3.
    void grow(glm::dvec3 from, glm::dvec3 along, double radius, double length, int depth) {
        constexpr double k_least_radius_mm = 0.4;
        constexpr int k_pieces = 3;
        for (int i = 0; i < k_pieces; ++i) {
            along = glm::normalize(along + 0.16 * any_direction() - 0.0022 * glm::dvec3(from.x, from.y, 0.0));
            const glm::dvec3 to = from + along * (length / k_pieces);
            const double end = std::max(radius * (1 - 0.04), k_least_radius_mm);
            parts.push_back(tapered(from, to, radius, end));
            from = to;
            radius = end;
        }
        if (depth == 2 && bulge == glm::dvec3(0)) bulge = from;
        if (depth == 9 || radius <= k_least_radius_mm * 1.001) return;
        const glm::dvec3 side = glm::normalize(glm::cross(along, any_direction()));
        const double share = dice.between(0.35, 0.65);
        for (const double s : {-1.0, 1.0}) {
            const double child = std::max(radius * std::cbrt(s < 0 ? share : 1 - share), k_least_radius_mm);
            const double angle = dice.between(0.35, 0.65);
            const glm::dvec3 direction = glm::normalize(along * std::cos(angle) + s * side * std::sin(angle));
            grow(from, direction, child, length * dice.between(0.74, 0.86), depth + 1);
        }
    }

    glm::dvec3 any_direction() {
        const double z = dice.between(-1, 1), a = dice.between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }
};

}  // namespace

Scene vessels(const SampleOptions& options) {
    constexpr double k_bulge_mm = 5.5;
    Scene scene;
    scene.geometry = cube_grid(options.dims, k_vessels_edge_mm);
    scene.geometry.axis_names = AxisNames::patient;
    scene.type = VoxelType::u16;
    scene.background = 200;
    scene.material = 1200;
    scene.noise = 30;
    scene.blur_voxels = 0.7;
    Tree tree{Dice(mix(options.seed)), {}, {}};
    tree.grow({0, 0, -62}, {0, 0, 1}, 3.0, 27, 0);
    scene.objects.push_back({"ball", tree.bulge, glm::dvec3(k_bulge_mm),
                             4.0 / 3.0 * std::numbers::pi * k_bulge_mm * k_bulge_mm * k_bulge_mm});
    scene.layers = {{1200, std::move(tree.parts)}, {1380, {ball(tree.bulge, k_bulge_mm)}}};
    return scene;
}

}  // namespace lacuna::samples
