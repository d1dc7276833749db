#include <array>
#include <cmath>
#include <numbers>

#include "core/volume/sample_scene.h"

// Samples of machined and test parts: the casting, the balls and the published test signal.
namespace lacuna::samples {

namespace {

constexpr double k_casting_edge_mm = 51.2;
constexpr double k_air = 3000, k_metal = 30000, k_dense = 45000;

glm::dvec3 on_circle(double radius, double degrees, double z) {
    const double a = degrees * std::numbers::pi / 180;
    return {radius * std::cos(a), radius * std::sin(a), z};
}

/// Six stiffening ribs between body and flange, their upper edges falling outwards. The plane is folded onto one sixth
/// of itself, so that one plate stands for all six.
Part ribs() {
    constexpr double k_sixth = std::numbers::pi / 3;
    return {[](const glm::dvec3& p) {
        const double radius = std::hypot(p.x, p.y), turn = std::atan2(p.y, p.x);
        const double angle = turn - (std::floor(turn / k_sixth) + 0.5) * k_sixth;
        const double along = radius * std::cos(angle), across = std::abs(radius * std::sin(angle)) - 1.7;
        const double slope = (along - 14.5) * 0.8 + (p.z + 1) * 0.6;  // a unit normal
        return std::max({across, slope, 8 - along, along - 21.5, -19 - p.z, p.z - 12});
    }};
}

/// A bearing housing before drilling: hub, flange, ribs and a side boss, their joints filleted.
Part housing() {
    return unite({cylinder({0, 0, 3}, 2, 15.5, 18, 1.2), cylinder({0, 0, -16.5}, 2, 22.8, 4.5, 1.0),
                  cylinder({11, 0, 6}, 0, 7.5, 11.5, 1.0), ribs()},
                 2.5);
}

/// Through bore, counterbores at both ends, the boss's bore and six bolt holes with their seats.
std::vector<Part> drillings() {
    std::vector<Part> holes{cylinder({0, 0, 0}, 2, 6, 40), cylinder({0, 0, 22}, 2, 9.5, 7, 0.6),
                            cylinder({15, 0, 6}, 0, 3.2, 11), cylinder({0, 0, -22}, 2, 8.5, 3.5, 0.6)};
    for (int i = 0; i < 6; ++i) {
        holes.push_back(cylinder(on_circle(18.8, 60.0 * i, -16), 2, 1.9, 12));
        holes.push_back(cylinder(on_circle(18.8, 60.0 * i, -9.5), 2, 3.0, 3.5));
    }
    return holes;
}

struct Placer {
    const Part& part;
    Dice& dice;
    std::vector<SampleObject>& objects;

    /// Puts one ellipsoid where it lies `clear_mm` inside the metal and away from all others; after many misses none.
    bool place(const char* kind, double longest_mm, double least_aspect) {
        constexpr double k_clear_mm = 1.0;
        for (int attempt = 0; attempt < 20000; ++attempt) {
            const glm::dvec3 at{dice.between(-23, 23), dice.between(-23, 23), dice.between(-21, 21)};
            // The distance of a cut part never promises more room than there is.
            if (part.distance(at) > -(longest_mm + k_clear_mm)) continue;
            bool free = true;
            for (const SampleObject& other : objects) {
                const double reach = std::max({other.radii_mm.x, other.radii_mm.y, other.radii_mm.z});
                free = free && glm::length(other.centre_mm - at) > reach + longest_mm + k_clear_mm;
            }
            if (!free) continue;
            glm::dvec3 radii(longest_mm);
            const int kept = int(dice() * 3) % 3;
            for (int a = 0; a < 3; ++a)
                if (a != kept) radii[a] *= dice.between(least_aspect, 1.0);
            objects.push_back({kind, at, radii, 4.0 / 3.0 * std::numbers::pi * radii.x * radii.y * radii.z});
            return true;
        }
        return false;
    }
};

}  // namespace

Scene casting(const SampleOptions& options) {
    Scene scene;
    scene.geometry = cube_grid(options.dims, k_casting_edge_mm);
    scene.type = VoxelType::u16;
    scene.background = k_air;
    scene.material = k_metal;
    scene.noise = 500;
    scene.blur_voxels = 0.7;
    const Part part = cut(housing(), unite(drillings()));
    Dice dice(mix(options.seed));
    Placer placer{part, dice, scene.objects};
    struct Batch {
        double longest_mm;
        int count;
    };
    // Largest first: it is the one that finds room last. 1 to 6 % of the edge.
    for (const Batch& batch :
         {Batch{3.0, 1}, Batch{2.3, 2}, Batch{1.8, 3}, Batch{1.4, 5}, Batch{1.0, 8}, Batch{0.75, 9}})
        for (int i = 0; i < batch.count; ++i) placer.place("void", batch.longest_mm, 0.65);
    for (int i = 0; i < 8; ++i) placer.place("void", 0.58, 0.88);
    placer.place("inclusion", 1.2, 0.8);
    placer.place("inclusion", 0.7, 0.8);

    Layer voids{k_air, {}}, inclusions{k_dense, {}};
    for (const SampleObject& o : scene.objects)
        (o.kind == "void" ? voids : inclusions).parts.push_back(ellipsoid(o.centre_mm, o.radii_mm));
    scene.layers = {{k_metal, {housing()}}, {k_air, drillings()}, std::move(voids), std::move(inclusions)};
    return scene;
}

Scene spheres(const SampleOptions& options) {
    Scene scene;
    scene.geometry = cube_grid(options.dims, 64.0);
    scene.type = VoxelType::u8;
    scene.background = 20;
    scene.material = 200;
    Layer balls{200, {}};
    const std::array<glm::dvec4, 7> k_balls{
        glm::dvec4(-10, -8, -6, 14), {14, 12, 10, 9},  {12, -16, 14, 6},  {-16, 16, 14, 7},
        {16, -10, -18, 5},           {-2, 20, -18, 3}, {24, 20, -24, 1.5}};
    for (const glm::dvec4& b : k_balls) {
        scene.objects.push_back(
            {"ball", glm::dvec3(b), glm::dvec3(b.w), 4.0 / 3.0 * std::numbers::pi * b.w * b.w * b.w});
        balls.parts.push_back(ball(glm::dvec3(b), b.w));
    }
    scene.layers = {std::move(balls)};
    return scene;
}

// Marschner and Lobb 1994, "An evaluation of reconstruction filters for volume rendering", equation 2: f_M = 6,
// alpha = 0.25, samples on the faces of [-1, 1]^3 included (40 steps of 0.05 as published).
Scene marschner_lobb(const SampleOptions& options) {
    Scene scene;
    scene.geometry.size = options.dims;
    scene.geometry.spacing = 2.0 / glm::dvec3(options.dims - 1);
    scene.geometry.origin = glm::dvec3(-1);
    scene.type = VoxelType::f32;
    scene.formula = [](const glm::dvec3& p) {
        constexpr double k_frequency = 6, k_alpha = 0.25, k_pi = std::numbers::pi;
        const double r = std::sqrt(p.x * p.x + p.y * p.y);
        const double rings = std::cos(2 * k_pi * k_frequency * std::cos(0.5 * k_pi * r));
        return (1 - std::sin(0.5 * k_pi * p.z) + k_alpha * (1 + rings)) / (2 * (1 + k_alpha));
    };
    return scene;
}

}  // namespace lacuna::samples
