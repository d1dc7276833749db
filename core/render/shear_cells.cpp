#include "core/render/shear_cells.h"

#include <algorithm>
#include <cmath>

#include "core/render/reference_sampler.h"
#include "core/render/shading.h"

namespace lacuna {

namespace {

template <class T, bool Ranges>
class CellPainter {
public:
    CellPainter(const VisibleCells& cells, const Scene& scene, const glm::dvec3& forward, const Shear& shear,
                ShearImage& image)
        : cells_(cells),
          scene_(scene),
          shear_(shear),
          image_(image),
          field_(scene.volume),
          view_(scene.volume.view<T>()),
          direction_grid_(glm::transpose(scene.volume.geometry().direction) * forward) {
        const SliceDirection& direction = shear.direction;
        u_ = direction.u_axis();
        v_ = direction.v_axis();
        axis_ = direction.axis;
        const glm::i64vec3 stride(1, view_.size.x, std::int64_t(view_.size.x) * view_.size.y);
        stride_ = {stride[u_], stride[v_], stride[axis_]};
        per_slice_[u_] = shear.slope.x;
        per_slice_[v_] = shear.slope.y;
        per_slice_[axis_] = 1;
        if (!direction.from_low) per_slice_ = -per_slice_;
        for (const CuttingPlane& cut : scene.cuts) {
            cuts_.push_back(residual_of({cut.normal, cut.offset, cut.cap}, scene.volume.geometry(), shear.direction));
            open_ = open_ || !cut.cap;
        }
    }

    void paint(int first, int last, const JobContext& job) {
        for (int y = first; y < last; ++y)
            std::fill_n(image_.painted.begin() + std::ptrdiff_t(image_.row(y)), image_.size.x, ShearImage::Painted{});
        for (int k = 0; k < cells_.slices; ++k) {
            const int c = shear_.direction.from_low ? cells_.slices - 1 - k : k;
            if (cells_.slice_empty(c)) continue;
            job.check();
            paint_slice(c, first, last);
        }
        for (int y = first; y < last; ++y) {
            if (y % 16 == 0) job.check();
            for (int x = 0; x < image_.size.x; ++x) {
                const std::size_t at = image_.row(y) + std::size_t(x);
                image_.color[at] = glm::vec4(0);
                if (image_.painted[at].depth_mm < ShearImage::k_nothing) finish(x, y, at);
            }
        }
    }

private:
    double measure(double value) const {
        return Ranges ? iso_measure(scene_.classification, scene_.iso, value) : value - scene_.iso;
    }

    /// The measure between voxels, NaN where one of them is not finite.
    double measure_at(const glm::dvec3& p) const {
        if constexpr (!Ranges) return field_.linear(p) - scene_.iso;
        const glm::dvec3 inside = glm::clamp(p, glm::dvec3(0), glm::dvec3(view_.size - 1));
        const glm::ivec3 i(inside), next = glm::min(i + 1, view_.size - 1);
        const glm::dvec3 f = inside - glm::dvec3(i);
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::bvec3 far(corner & 1, corner & 2, corner & 4);
            const double value = double(view_(far.x ? next.x : i.x, far.y ? next.y : i.y, far.z ? next.z : i.z));
            sum += (far.x ? f.x : 1 - f.x) * (far.y ? f.y : 1 - f.y) * (far.z ? f.z : 1 - f.z) *
                   (std::isfinite(value) ? measure(value) : std::numeric_limits<double>::quiet_NaN());
        }
        return sum;
    }

    void paint_slice(int c, int first, int last) {
        const glm::dvec2 place = shear_.place(c), corner = glm::ceil(place), f = corner - place;
        const glm::ivec2 offset = glm::ivec2(corner) - 1;  // cell (i, j) falls on pixel (i, j) + offset
        const int columns = cells_.columns - 1, rows = cells_.rows - 1;
        const double w00 = (1 - f.x) * (1 - f.y), w10 = f.x * (1 - f.y), w01 = (1 - f.x) * f.y, w11 = f.x * f.y;
        for (int j = std::max(first - offset.y, 0); j < std::min(last - offset.y, cells_.rows); ++j) {
            if ((j == 0 && f.y < 0.5) || (j == rows && f.y > 0.5)) continue;  // beyond the volume's side
            const std::size_t row = std::size_t(c) * std::size_t(cells_.rows) + std::size_t(j);
            const T* upper = view_.data + c * stride_.z + std::max(j - 1, 0) * stride_.y;
            const T* lower = view_.data + c * stride_.z + std::min(j, rows - 1) * stride_.y;
            for (std::uint32_t n = cells_.row_begin[row]; n < cells_.row_begin[row + 1]; ++n) {
                const int i = cells_.column[n];
                if ((i == 0 && f.x < 0.5) || (i == columns && f.x > 0.5)) continue;
                const std::int64_t left = std::max(i - 1, 0) * stride_.x, right = std::min(i, columns - 1) * stride_.x;
                const double g = w00 * measure(double(upper[left])) + w10 * measure(double(upper[right])) +
                                 w01 * measure(double(lower[left])) + w11 * measure(double(lower[right]));
                if (open_ ? std::isnan(g) : !(g >= 0 && std::isfinite(g))) continue;
                if (!kept(i - 1 + f.x, j - 1 + f.y, c)) continue;
                const std::size_t at = image_.row(j + offset.y) + std::size_t(i + offset.x);
                if (open_ && !resolve(place_of(i + offset.x, j + offset.y, c)).hit) continue;
                image_.painted[at] = {std::uint32_t(c), 0};
            }
        }
    }

    bool kept(double u, double v, int c) const {
        return std::all_of(cuts_.begin(), cuts_.end(), [&](const CutResidual& cut) { return cut.at(u, v, c) >= 0; });
    }

    /// Where the ray of an intermediate pixel meets a slice, in voxels.
    glm::dvec3 place_of(int x, int y, int c) const {
        const glm::dvec2 at = glm::dvec2(x, y) - shear_.place(c);
        glm::dvec3 p;
        p[u_] = at.x;
        p[v_] = at.y;
        p[axis_] = c;
        return p;
    }

    struct Hit {
        bool hit = false;
        double slices = 0;  ///< from the slice, backwards along the ray: -1 .. 0
        int face = -1;      ///< axis of the volume's side that is hit
        bool cap = false;
    };

    /// What the ray meets between the slice before and this one, where its sample is at p.
    Hit resolve(const glm::dvec3& p) const {
        Hit start{false, -1, -1, false};
        bool by_cut = false;
        for (int a = 0; a < 3; ++a) {
            if (per_slice_[a] == 0) continue;
            const double side = per_slice_[a] > 0 ? -0.5 : view_.size[a] - 0.5, s = (side - p[a]) / per_slice_[a];
            if (s > start.slices) start = {false, s, a, false};
        }
        for (const CutResidual& cut : cuts_) {
            const double along = cut.a * per_slice_[u_] + cut.b * per_slice_[v_] + cut.c * per_slice_[axis_];
            const double s = along > 0 ? -cut.at(p[u_], p[v_], p[axis_]) / along : -2;
            if (!(s > start.slices)) continue;
            start = {false, s, -1, cut.cap};
            by_cut = true;
        }
        start.slices = std::fmin(start.slices, 0);
        const double before = measure_at(p + start.slices * per_slice_);
        const bool in_object = before >= 0, entered = by_cut || start.face >= 0;
        if (in_object && entered && (start.face >= 0 || start.cap)) {
            start.hit = true;
            return start;
        }
        const double here = measure_at(p);
        if (in_object && open_) return here < 0 ? Hit{true, sharpened(p, start.slices, -before, -here, -1)} : Hit{};
        if (open_ && !(here >= 0)) return {};
        // Painted as inside: a rounding error of `here` or of a `before` that had to be outside must not make a hole.
        if (!(before < 0)) return {true, in_object ? start.slices : 0};
        return {true, sharpened(p, start.slices, before, std::fmax(here, 0), 1)};
    }

    /// One step of regula falsi between s = from (g_from < 0) and s = 0 (g_to >= 0), then linear in the part left.
    double sharpened(const glm::dvec3& p, double from, double g_from, double g_to, double sign) const {
        const double s = from * g_to / (g_to - g_from), g = sign * measure_at(p + s * per_slice_);
        if (std::isnan(g)) return s;
        return g >= 0 ? from + (s - from) * (g_from / (g_from - g)) : s * g_to / (g_to - g);
    }

    void finish(int x, int y, std::size_t at) {
        const glm::dvec3 p = place_of(x, y, int(image_.painted[at].key));
        const Hit hit = resolve(p);
        const glm::dvec3 where = p + hit.slices * per_slice_;
        image_.painted[at].depth_mm = float(shear_.depth_mm(where[u_], where[v_], where[axis_]));
        glm::dvec3 color;
        if (hit.cap && hit.face < 0) {
            color = glm::dvec3(grey_level(scene_.window, field_.linear(where)));
        } else {
            double c = 0;
            if (hit.face >= 0) {
                c = std::fabs(direction_grid_[hit.face]);
            } else if (scene_.shading != Shading::none) {
                const glm::dvec3 gradient = field_.gradient(where);
                const double length = glm::length(gradient);
                if (length > 0) c = std::fmin(std::fabs(glm::dot(gradient, direction_grid_)) / length, 1);
            }
            color = shade(scene_.shading, scene_.surface_color, c);
        }
        image_.color[at] = glm::vec4(color, 1);
    }

    const VisibleCells& cells_;
    const Scene& scene_;
    const Shear& shear_;
    ShearImage& image_;
    reference::Field<T> field_;
    VolumeView<T> view_;
    glm::dvec3 direction_grid_, per_slice_{0};  ///< per_slice_: voxels along the ray from slice to slice
    glm::i64vec3 stride_{0};                    ///< voxels from one to the next along u, v and the axis
    int u_ = 0, v_ = 1, axis_ = 2;
    std::vector<CutResidual> cuts_;
    bool open_ = false;
};

}  // namespace

void paint_cells(const VisibleCells& cells, const Scene& scene, const glm::dvec3& forward, const Shear& shear,
                 ShearImage& image, int first, int last, const JobContext& job) {
    visit_type(scene.volume.type(), [&](auto tag) {
        using T = decltype(tag);
        if (scene.classification.ranges.empty())
            CellPainter<T, false>(cells, scene, forward, shear, image).paint(first, last, job);
        else
            CellPainter<T, true>(cells, scene, forward, shear, image).paint(first, last, job);
    });
}

}  // namespace lacuna
