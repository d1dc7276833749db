#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/volume/samples.h"

// What the built-in samples are made of; used by the sample_*.cpp files alone.
namespace lacuna::samples {

/// Signed distance to a surface in mm, negative inside. The sign and the zero set are exact; away from the surface the
/// magnitude may be too small by any factor and too large by at most Part::lipschitz.
using Distance = std::function<double(const glm::dvec3& mm)>;

struct Part {
    Distance distance;
    /// Bounds how fast `distance` changes, and how much too large it can be. Parts of a unite() or cut() need 1.
    double lipschitz = 1;
    /// The part as seen from inside a ball of space: the same distances there, with less to evaluate. Null: itself.
    std::function<Part(const glm::dvec3& centre, double radius_mm)> near = nullptr;
};

/// Parts of one material; the layer is their union. Later layers are painted over earlier ones.
struct Layer {
    double level = 0;
    std::vector<Part> parts;
};

struct Scene {
    GridGeometry geometry;
    VoxelType type = VoxelType::u16;
    std::string name, unit;
    double background = 0, material = 0;
    std::vector<Layer> layers;
    Distance formula;  ///< instead of layers: the value itself at a position in mm
    std::vector<SampleObject> objects;
    double noise = 0, blur_voxels = 0;
    unsigned seed = 1;
};

/// Samples a scene on its grid. An edge is the surface's signed distance through the error function (blur) or, with
/// no blur, through a ramp one voxel wide: halfway between the two levels lies exactly the true surface, which a
/// convolution would move wherever the surface is curved.
AnalyticSample paint(Scene scene, const JobContext& job);

/// The same volume, painted box by box as it is read.
Volume paint_in_parts(Scene scene);

/// A cube `edge_mm` long, its middle at the origin of space, cut into n voxels.
GridGeometry cube_grid(glm::ivec3 n, double edge_mm);

/// Random numbers that depend on nothing but the seed and how many were drawn; uniform in [0, 1).
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double operator()();
    double between(double lo, double hi) { return lo + (hi - lo) * (*this)(); }

private:
    std::uint64_t state_;
};
std::uint64_t mix(std::uint64_t x);  ///< splitmix64 (Steele, Lea and Flood 2014): one step and its scrambling

// Distances
Part ball(glm::dvec3 centre, double radius);
/// Precise near the surface; its lipschitz is the ratio of the longest to the shortest semi-axis.
Part ellipsoid(glm::dvec3 centre, glm::dvec3 radii);
/// The same surface with a distance that is too small towards the long axes: fit for unite() and cut().
Part bounded_ellipsoid(glm::dvec3 centre, glm::dvec3 radii);
Part capsule(glm::dvec3 from, glm::dvec3 to, double radius);
Part tapered(glm::dvec3 from, glm::dvec3 to, double radius_from, double radius_to);
/// Cylinder along axis 0, 1 or 2 with rounded rims.
Part cylinder(glm::dvec3 centre, int axis, double radius, double half_length, double rounding = 0);
/// Union and difference; `fillet_mm` is the width of the rounding where two surfaces meet.
Part unite(std::vector<Part> parts, double fillet_mm = 0);
Part cut(Part from, Part what, double fillet_mm = 0);

Scene casting(const SampleOptions& options);
Scene head(const SampleOptions& options);
Scene vessels(const SampleOptions& options);
Scene spheres(const SampleOptions& options);
Scene marschner_lobb(const SampleOptions& options);

}  // namespace lacuna::samples
