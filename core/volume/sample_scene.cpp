#include "core/volume/sample_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <type_traits>

#include "core/base/parallel.h"

namespace lacuna::samples {

namespace {

constexpr int k_block = 8;             ///< voxels along a block's edge: layers are culled per block
constexpr int k_super_block = 32;      ///< the unit of parallel work: layers are culled here first
constexpr double k_edge_sigmas = 4.5;  ///< beyond it the error function is 1 to a part in 10^5

double union_distance(const std::vector<Part>& parts, const glm::dvec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Part& part : parts) least = std::min(least, part.distance(p));
    return least;
}

/// Layers that matter inside a ball of space: what is far away is left out, and where a layer covers the ball whole,
/// so is everything beneath it.
struct Painting {
    double base = 0;
    std::vector<Layer> layers;

    Painting near(const glm::dvec3& centre, double radius_mm, double edge_mm) const {
        Painting out{base, {}};
        for (const auto& [level, parts] : layers) {
            std::vector<Part> kept;
            bool covered = false;
            for (const Part& part : parts) {
                const double d = part.distance(centre);
                const double reach = part.lipschitz * (radius_mm + part.lipschitz * edge_mm);
                if (d > reach) continue;
                covered = covered || d < -reach;
                kept.push_back(part.near ? part.near(centre, radius_mm) : part);
            }
            if (covered)
                out = {level, {}};
            else if (!kept.empty())
                out.layers.push_back({level, std::move(kept)});
        }
        return out;
    }

    double at(const glm::dvec3& p, double sigma_mm, double ramp_mm) const {
        double v = base;
        for (const auto& [level, parts] : layers) {
            const double d = union_distance(parts, p);
            const double share = sigma_mm > 0 ? 0.5 * std::erfc(d / (std::numbers::sqrt2 * sigma_mm))
                                              : std::clamp(0.5 - d / ramp_mm, 0.0, 1.0);
            v += share * (level - v);
        }
        return v;
    }
};

/// Standard normal noise of a voxel from its index and the seed alone (Box and Muller 1958): neighbours in a pair
/// share one draw.
class Noise {
public:
    Noise(double sigma, unsigned seed) : sigma_(float(sigma)), seed_(mix(seed)) {}
    float at(std::int64_t index) {
        if (!(sigma_ > 0)) return 0;
        if (const auto pair = std::uint64_t(index) >> 1; pair != pair_) {
            pair_ = pair;
            const std::uint64_t bits = mix(pair ^ seed_);
            const float u = (float(bits >> 40) + 1.0f) * 0x1p-24f, angle = float(bits & 0xffffff) * 0x1p-24f;
            const float radius = sigma_ * std::sqrt(-2.0f * std::log(u));
            const float turn = 2.0f * std::numbers::pi_v<float> * angle;
            even_ = radius * std::cos(turn);
            odd_ = radius * std::sin(turn);
        }
        return index & 1 ? odd_ : even_;
    }

private:
    float sigma_;
    std::uint64_t seed_, pair_ = ~std::uint64_t(0);
    float even_ = 0, odd_ = 0;
};

template <class T>
T quantised(double v) {
    if constexpr (std::is_same_v<T, float>)
        return float(v);
    else
        return T(std::clamp(std::floor(v + 0.5), double(std::numeric_limits<T>::min()),
                            double(std::numeric_limits<T>::max())));
}

struct Box {
    glm::ivec3 lo, hi;  ///< voxels [lo, hi)
    bool empty() const { return lo.x >= hi.x || lo.y >= hi.y || lo.z >= hi.z; }
    Box within(const Box& other) const { return {glm::max(lo, other.lo), glm::min(hi, other.hi)}; }
};

template <class T>
class Painter {
public:
    /// @param target  the box to paint, its voxels without gaps at `voxels`
    Painter(const Scene& scene, const Box& target, T* voxels)
        : scene_(scene), grid_(scene.geometry), target_(target), voxels_(voxels) {
        all_ = {scene.background, scene.layers};
        ramp_mm_ = grid_.smallest_spacing_mm();
        sigma_mm_ = scene.blur_voxels * ramp_mm_;
        edge_mm_ = std::max(k_edge_sigmas * sigma_mm_, 0.5 * ramp_mm_);
    }

    /// Blocks lie where they lie in the whole volume, so that any box of it has the same voxels.
    void paint(const JobContext& job) {
        const glm::ivec3 from = target_.lo / k_super_block;
        const glm::ivec3 n = (target_.hi + (k_super_block - 1)) / k_super_block - from;
        parallel_for(
            0, std::int64_t(n.x) * n.y * n.z,
            [&](std::int64_t i) {
                const glm::ivec3 at(int(i % n.x), int(i / n.x % n.y), int(i / n.x / n.y));
                const Box box = box_at((from + at) * k_super_block, k_super_block, grid_.size);
                if (scene_.formula) return fill(box, [&](const glm::dvec3& p) { return scene_.formula(p); });
                paint_super_block(box);
            },
            job);
    }

private:
    static Box box_at(glm::ivec3 lo, int edge, glm::ivec3 limit) { return {lo, glm::min(lo + edge, limit)}; }

    Painting near(const Painting& from, const Box& box) const {
        const glm::dvec3 half = 0.5 * glm::dvec3(box.hi - box.lo - 1);
        return from.near(grid_.voxel_to_mm(glm::dvec3(box.lo) + half), glm::length(half * grid_.spacing), edge_mm_);
    }

    void paint_super_block(const Box& outer) {
        const Painting here = near(all_, outer);
        for (int z = outer.lo.z; z < outer.hi.z; z += k_block)
            for (int y = outer.lo.y; y < outer.hi.y; y += k_block)
                for (int x = outer.lo.x; x < outer.hi.x; x += k_block) {
                    const Box box = box_at({x, y, z}, k_block, outer.hi);
                    if (box.within(target_).empty()) continue;
                    const Painting painting = here.layers.empty() ? here : near(here, box);
                    if (painting.layers.empty())
                        fill(box, [&](const glm::dvec3&) { return painting.base; });
                    else
                        fill(box, [&](const glm::dvec3& p) { return painting.at(p, sigma_mm_, ramp_mm_); });
                }
    }

    template <class Value>
    void fill(const Box& block, Value&& value) {
        Noise noise(scene_.noise, scene_.seed);
        const Box box = block.within(target_);
        const glm::ivec3 size = target_.hi - target_.lo;
        for (int z = box.lo.z; z < box.hi.z; ++z)
            for (int y = box.lo.y; y < box.hi.y; ++y)
                for (int x = box.lo.x; x < box.hi.x; ++x) {
                    const std::int64_t i = grid_.linear_index(x, y, z);
                    const double v = value(grid_.voxel_to_mm({x, y, z}));
                    const glm::ivec3 at = glm::ivec3(x, y, z) - target_.lo;
                    voxels_[(std::int64_t(at.z) * size.y + at.y) * size.x + at.x] =
                        quantised<T>(v + double(noise.at(i)));
                }
    }

    const Scene& scene_;
    const GridGeometry& grid_;
    Box target_;
    T* voxels_;
    Painting all_;
    double sigma_mm_ = 0, ramp_mm_ = 1, edge_mm_ = 1;
};

class PaintedSource final : public VoxelSource {
public:
    explicit PaintedSource(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}
    void read(const VoxelBox& box, std::byte* out, const JobContext& job) const override {
        visit_type(scene_->type, [&](auto tag) {
            using T = decltype(tag);
            Painter<T>(*scene_, {box.first, box.first + box.size}, reinterpret_cast<T*>(out)).paint(job);
        });
    }

private:
    std::shared_ptr<const Scene> scene_;
};

double exact_value(const Scene& scene, const glm::dvec3& p) {
    if (scene.formula) return scene.formula(p);
    for (auto layer = scene.layers.rbegin(); layer != scene.layers.rend(); ++layer)
        for (const Part& part : layer->parts)
            if (part.distance(p) <= 0) return layer->level;
    return scene.background;
}

}  // namespace

AnalyticSample paint(Scene made, const JobContext& job) {
    const auto scene = std::make_shared<const Scene>(std::move(made));
    AnalyticSample sample;
    sample.volume = visit_type(scene->type, [&](auto tag) {
        using T = decltype(tag);
        return make_volume<T>(scene->geometry, [&](std::span<T> voxels) {
            Painter<T>(*scene, {glm::ivec3(0), scene->geometry.size}, voxels.data()).paint(job);
        });
    });
    sample.volume.name = scene->name;
    sample.volume.unit = scene->unit;
    sample.value = [scene](const glm::dvec3& p) { return exact_value(*scene, p); };
    sample.objects = scene->objects;
    sample.background = scene->formula ? 0 : scene->background;
    sample.material = scene->material;
    return sample;
}

Volume paint_in_parts(Scene made) {
    const auto scene = std::make_shared<const Scene>(std::move(made));
    Volume volume(scene->geometry, scene->type, std::make_shared<const PaintedSource>(scene));
    volume.name = scene->name;
    volume.unit = scene->unit;
    return volume;
}

GridGeometry cube_grid(glm::ivec3 n, double edge_mm) {
    GridGeometry grid;
    grid.size = n;
    grid.spacing = edge_mm / glm::dvec3(n);
    grid.origin = -0.5 * edge_mm + 0.5 * grid.spacing;
    return grid;
}

std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double Dice::operator()() {
    const std::uint64_t bits = mix(state_);
    state_ += 0x9e3779b97f4a7c15u;
    return double(bits >> 11) * 0x1p-53;
}

Part ball(glm::dvec3 centre, double radius) {
    return {[=](const glm::dvec3& p) { return glm::length(p - centre) - radius; }};
}

Part ellipsoid(glm::dvec3 centre, glm::dvec3 radii) {
    const double shortest = std::min({radii.x, radii.y, radii.z}), longest = std::max({radii.x, radii.y, radii.z});
    // First-order distance: with f = |q/r|, (f - 1) / |grad f| is exact to second order near the surface, and
    // between |f-1| times the shortest and the longest semi-axis everywhere.
    const auto distance = [=](const glm::dvec3& p) {
        const glm::dvec3 scaled = (p - centre) / radii;
        const double f = glm::length(scaled), slope = glm::length(scaled / radii);
        return slope > 0 ? (f - 1) * f / slope : -shortest;
    };
    return {distance, longest / shortest};
}

Part bounded_ellipsoid(glm::dvec3 centre, glm::dvec3 radii) {
    const double shortest = std::min({radii.x, radii.y, radii.z});
    return {[=](const glm::dvec3& p) { return (glm::length((p - centre) / radii) - 1) * shortest; }};
}

Part capsule(glm::dvec3 from, glm::dvec3 to, double radius) { return tapered(from, to, radius, radius); }

Part tapered(glm::dvec3 from, glm::dvec3 to, double radius_from, double radius_to) {
    const glm::dvec3 axis = to - from;
    const double length2 = std::max(glm::dot(axis, axis), 1e-30);
    const double slope = std::abs(radius_to - radius_from) / std::sqrt(length2);
    // The distance to the axis less a radius that changes along it; its slope adds to the distance's own.
    return {[=](const glm::dvec3& p) {
                const double t = std::clamp(glm::dot(p - from, axis) / length2, 0.0, 1.0);
                return glm::length(p - from - t * axis) - (radius_from + t * (radius_to - radius_from));
            },
            1 + slope};
}

Part cylinder(glm::dvec3 centre, int axis, double radius, double half_length, double rounding) {
    return {[=](const glm::dvec3& at) {
        const glm::dvec3 p = at - centre;
        const double u = p[(axis + 1) % 3], w = p[(axis + 2) % 3];
        const double radial = std::sqrt(u * u + w * w) - (radius - rounding);
        const double axial = std::abs(p[axis]) - (half_length - rounding);
        const double outside = glm::length(glm::max(glm::dvec2(radial, axial), 0.0));
        return std::min(std::max(radial, axial), 0.0) + outside - rounding;
    }};
}

namespace {

/// Polynomial smooth minimum: rounds the edge where two surfaces meet with about `k` mm; at most k/4 below the minimum.
double smooth_min(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * h * h * k;
}

using SharedParts = std::shared_ptr<const std::vector<Part>>;

Part united(const SharedParts& parts, double fillet_mm) {
    if (parts->size() == 1) return parts->front();
    Part out;
    for (const Part& part : *parts) out.lipschitz = std::max(out.lipschitz, part.lipschitz);
    out.distance = [parts, fillet_mm](const glm::dvec3& p) {
        double least = parts->front().distance(p);
        for (std::size_t i = 1; i < parts->size(); ++i) {
            const double d = (*parts)[i].distance(p);
            least = fillet_mm > 0 ? smooth_min(least, d, fillet_mm) : std::min(least, d);
        }
        return least;
    };
    // A part further than the nearest by more than the fillet leaves the smooth minimum as it is, to the last bit.
    out.near = [parts, fillet_mm](const glm::dvec3& centre, double radius_mm) {
        std::vector<double> distances;
        for (const Part& part : *parts) distances.push_back(part.distance(centre));
        const double least = *std::min_element(distances.begin(), distances.end());
        std::vector<Part> kept;
        for (std::size_t i = 0; i < parts->size(); ++i) {
            const Part& part = (*parts)[i];
            if (distances[i] > least + 2 * radius_mm + fillet_mm) continue;
            kept.push_back(part.near ? part.near(centre, radius_mm) : part);
        }
        return united(std::make_shared<const std::vector<Part>>(std::move(kept)), fillet_mm);
    };
    return out;
}

}  // namespace

Part unite(std::vector<Part> parts, double fillet_mm) {
    return united(std::make_shared<const std::vector<Part>>(std::move(parts)), fillet_mm);
}

Part cut(Part from, Part what, double fillet_mm) {
    const auto both = std::make_shared<const std::array<Part, 2>>(std::array{std::move(from), std::move(what)});
    Part out;
    out.lipschitz = std::max((*both)[0].lipschitz, (*both)[1].lipschitz);
    out.distance = [both, fillet_mm](const glm::dvec3& p) {
        const double a = (*both)[0].distance(p), b = (*both)[1].distance(p);
        return fillet_mm > 0 ? -smooth_min(-a, b, fillet_mm) : std::max(a, -b);
    };
    out.near = [both, fillet_mm](const glm::dvec3& centre, double radius_mm) {
        const auto& [kept, removed] = *both;
        const auto seen = [&](const Part& part) { return part.near ? part.near(centre, radius_mm) : part; };
        const bool out_of_reach = removed.distance(centre) > -kept.distance(centre) + 2 * radius_mm + fillet_mm;
        return out_of_reach ? seen(kept) : cut(seen(kept), seen(removed), fillet_mm);
    };
    return out;
}

}  // namespace lacuna::samples
