#include "core/accuracy/closed_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/render/reference_ray.h"
#include "core/render/shading.h"

namespace lacuna {

namespace {

using reference::LatticeRay;

constexpr double k_nothing = std::numeric_limits<double>::infinity();
constexpr double k_finer = 16, k_bracket_voxels = 0.25, k_bisect_voxels = 1e-9, k_gradient_voxels = 1e-4;

struct Pixel {
    glm::dvec4 color{0};
    double depth_mm = k_nothing;
};

class FormulaCaster {
public:
    FormulaCaster(const Scene& scene, const AnalyticSample& sample, double step_mm)
        : scene_(scene),
          sample_(sample),
          voxel_mm_(scene.volume.geometry().smallest_spacing_mm()),
          step_mm_(step_mm),
          smooth_(sample.background == sample.material),
          balls_(!sample.objects.empty() && std::all_of(sample.objects.begin(), sample.objects.end(),
                                                        [](const SampleObject& o) { return o.kind == "ball"; })),
          quadrics_(balls_ && sample.background < scene.iso && scene.iso <= sample.material) {}

    /// A normal is known at every point a shaded picture needs one.
    bool has_normals() const { return smooth_ || (balls_ && scene_.mode == ViewMode::iso); }

    Pixel trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        const LatticeRay ray = reference::cast(origin, direction, scene_.volume.geometry(), {}, step_mm_);
        if (!ray.kept) return {};
        const Line line{origin, direction, ray.from, ray.to, ray.entry_axis, ray.direction_grid};
        switch (scene_.mode) {
            case ViewMode::iso:
                return quadrics_ ? first_quadric(line) : first_turn(line);
            case ViewMode::ea:
                return composite(line);
            default:
                return project(line);
        }
    }

private:
    struct Line {
        glm::dvec3 origin, direction;
        double from, to;
        int entry_axis;
        glm::dvec3 direction_grid;
        glm::dvec3 at(double t) const { return origin + t * direction; }
    };

    double value(const Line& line, double t) const { return sample_.value(line.at(t)); }
    bool inside(const Line& line, double t) const { return value(line, t) >= scene_.iso; }

    Pixel surface(double c, double t) const {
        return {glm::dvec4(shade(scene_.shading, scene_.surface_color, c), 1), t};
    }
    /// Enters through the volume's side inside the object: shaded with that side's normal, as scene.h has it.
    Pixel at_side(const Line& line) const {
        return surface(line.entry_axis < 0 ? 1 : std::fabs(line.direction_grid[line.entry_axis]), line.from);
    }
    static double facing(const Line& line, const glm::dvec3& normal) {
        const double length = glm::length(normal);
        return length > 0 ? std::fmin(std::fabs(glm::dot(normal, line.direction)) / length, 1) : 0;
    }
    glm::dvec3 gradient(const glm::dvec3& p) const {
        const double h = k_gradient_voxels * voxel_mm_;
        glm::dvec3 g;
        for (int a = 0; a < 3; ++a) {
            glm::dvec3 before = p, after = p;
            before[a] -= h;
            after[a] += h;
            g[a] = (sample_.value(after) - sample_.value(before)) / (2 * h);
        }
        return g;
    }

    Pixel first_quadric(const Line& line) const {
        double nearest = k_nothing;
        glm::dvec3 normal(0);
        for (const SampleObject& object : sample_.objects) {
            // |(o + t d - c) / r|^2 = 1
            const glm::dvec3 o = (line.origin - object.centre_mm) / object.radii_mm,
                             d = line.direction / object.radii_mm;
            const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1, root = b * b - a * c;
            if (!(root >= 0)) continue;
            const double q = -b - std::copysign(std::sqrt(root), b);  // no cancellation
            const double one = q / a, two = q == 0 ? 0 : c / q, in = std::min(one, two), out = std::max(one, two);
            if (in <= line.from && out > line.from) return at_side(line);
            if (in < line.from || in > line.to || in >= nearest) continue;
            nearest = in;
            normal = (line.at(in) - object.centre_mm) / (object.radii_mm * object.radii_mm);
        }
        return nearest < k_nothing ? surface(facing(line, normal), nearest) : Pixel{};
    }

    Pixel first_turn(const Line& line) const {
        if (inside(line, line.from)) return at_side(line);
        const double bracket = k_bracket_voxels * voxel_mm_;
        const auto count = std::int64_t(std::ceil((line.to - line.from) / bracket));
        double before = line.from;
        for (std::int64_t k = 1; k <= count; ++k) {
            const double t = std::min(line.from + double(k) * bracket, line.to);
            if (!inside(line, t)) {
                before = t;
                continue;
            }
            double behind = t;
            while (behind - before > k_bisect_voxels * voxel_mm_) {
                const double middle = 0.5 * (before + behind);
                (inside(line, middle) ? behind : before) = middle;
            }
            return surface(smooth_ ? facing(line, gradient(line.at(behind))) : 1, behind);
        }
        return {};
    }

    /// Midpoints of steps that divide the line evenly.
    template <class Visit>
    void march(const Line& line, Visit&& visit) const {
        const double length = line.to - line.from;
        const auto count = std::max<std::int64_t>(1, std::int64_t(std::ceil(length / step_mm_)));
        const double step = length / double(count);
        for (std::int64_t k = 0; k < count; ++k) visit(line.from + (double(k) + 0.5) * step, step);
    }

    Pixel composite(const Line& line) const {
        glm::dvec3 color(0);
        double alpha = 0, depth = k_nothing;
        const TransferFunction& tf = scene_.classification.tf;
        march(line, [&](double t, double step) {
            const double v = value(line, t);
            ColorOpacity seen = tf.at(v);
            if (!(seen.opacity > 0)) return;
            double c = 0;
            if (scene_.shading != Shading::none || tf.uses_gradient()) {
                const glm::dvec3 g = gradient(line.at(t));
                if (tf.uses_gradient()) seen = tf.at(v, glm::length(g));
                c = facing(line, g);
            }
            const double a = correct_opacity(seen.opacity, step, tf.unit_distance_mm);
            color += (1 - alpha) * a * shade(scene_.shading, seen.color, c);
            alpha += (1 - alpha) * a;
            if (alpha > 0.5 && depth == k_nothing) depth = t;
        });
        return {glm::dvec4(color, alpha), depth};
    }

    Pixel project(const Line& line) const {
        double best = std::nan(""), sum = 0, length = 0, best_t = k_nothing;
        const bool smallest = scene_.mode == ViewMode::minip, mean = scene_.mode == ViewMode::mean;
        march(line, [&](double t, double step) {
            const double v = value(line, t);
            sum += step * v;
            length += step;
            if (!(smallest ? v >= best : v <= best)) best = v, best_t = t;
        });
        const double shown = mean ? sum / length : best;
        const glm::dvec3 color =
            scene_.color_by_tf ? scene_.classification.at(shown).color : glm::dvec3(grey_level(scene_.window, shown));
        return {glm::dvec4(color, 1), mean ? k_nothing : best_t};
    }

    const Scene& scene_;
    const AnalyticSample& sample_;
    double voxel_mm_, step_mm_;
    bool smooth_;    ///< the value is a smooth formula, not levels of solid parts
    bool balls_;     ///< all there is are ellipsoids of one material
    bool quadrics_;  ///< the isosurface is theirs; else the value is on one side of the isovalue everywhere
};

void check_closed_form(const Scene& scene, const AnalyticSample& sample) {
    const auto refuse = [](const std::string& what) {
        throw Error(Errc::unsupported, "There is no closed form to compare with for " + what +
                                           "; compare with the references 'samples' or 'fine'.");
    };
    if (scene.mode == ViewMode::shear_warp || scene.mode == ViewMode::lmip)
        refuse("the mode '" + std::string(name_of(scene.mode)) + "'");
    if (!scene.cuts.empty()) refuse("a scene with cuts");
    if (!scene.classification.ranges.empty()) refuse("a scene with segmentation ranges");
    if (!scene.effects.empty()) refuse("a scene with effects");
    if (scene.regions) refuse("a scene by regions");
    const bool gradients = scene.shading != Shading::none || scene.classification.uses_gradient();
    if (scene.mode == ViewMode::ea && gradients && sample.background != sample.material)
        refuse("shaded emission-absorption of solid parts (take --shading none)");
}

}  // namespace

TrueFrame render_closed_form(const Scene& scene, const AnalyticSample& sample, const Plan& like,
                             const JobContext& job) {
    check(scene);
    check_closed_form(scene, sample);
    const FormulaCaster caster(scene, sample, like.step / k_finer * scene.volume.geometry().smallest_spacing_mm());
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    TrueFrame made;
    Frame& frame = made.frame;
    frame.size = scene.size;
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels());
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            for (int x = 0; x < frame.size.x; ++x) {
                job.check();
                const Pixel pixel = caster.trace(rays.origin(x, double(y)), rays.direction(x, double(y)));
                const std::size_t i = std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x);
                frame.color[i] = glm::vec4(pixel.color);
                frame.depth_mm[i] = float(pixel.depth_mm);
            }
        },
        job);
    made.has_colors = scene.mode != ViewMode::iso || scene.shading == Shading::none || caster.has_normals();
    made.reference = "closed form of the sample " + scene.volume.name;
    return made;
}

}  // namespace lacuna
