#include "core/render/brick_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {

namespace {

constexpr int k_margin_pixels = 2;       // what rounding can move a projected corner by, amply
constexpr double k_margin_voxels = 0.5;  // and a position by

glm::dvec3 vector_of(const s_float (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

BrickView::BrickView(const BrickGrid& grid, const RayParams& p, bool perspective)
    : grid_(grid),
      perspective_(perspective),
      width_(p.width),
      height_(p.height),
      origin_(vector_of(p.origin)),
      origin_dx_(vector_of(p.origin_dx)),
      origin_dy_(vector_of(p.origin_dy)),
      dir_(vector_of(p.dir)),
      dir_dx_(vector_of(p.dir_dx)),
      dir_dy_(vector_of(p.dir_dy)) {}

std::vector<std::int64_t> BrickView::front_to_back() const {
    glm::ivec3 eye{0};  // the brick nearest to where all rays come from
    for (int a = 0; a < 3; ++a) {
        if (perspective_)
            eye[a] = int(std::clamp(std::floor(origin_[a] / grid_.edge), 0.0, double(grid_.count[a] - 1)));
        else
            eye[a] = dir_[a] < 0 ? grid_.count[a] - 1 : 0;
    }
    std::vector<std::int64_t> order(std::size_t(grid_.bricks()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::int64_t(i);
    const auto distance = [&](std::int64_t i) {
        const glm::ivec3 d = glm::abs(grid_.at(i) - eye);
        return d.x + d.y + d.z;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::int64_t a, std::int64_t b) { return distance(a) < distance(b); });
    return order;
}

BrickView::Corners BrickView::box(glm::ivec3 brick, double margin) const {
    const glm::vec3 lo = grid_.lo(brick), hi = grid_.hi(brick);
    Corners c;
    for (int a = 0; a < 3; ++a) {  // the volume's own box ends half a voxel beyond the outer centres
        c.lo[a] = (std::isinf(lo[a]) ? -0.5 : double(lo[a])) - margin;
        c.hi[a] = (std::isinf(hi[a]) ? grid_.size[a] - 0.5 : double(hi[a])) + margin;
    }
    return c;
}

PixelRect BrickView::pixels_of(glm::ivec3 brick) const {
    const Corners b = box(brick, k_margin_voxels);
    // Orthographic: P = origin + x*dx + y*dy + t*dir. Perspective: P - origin = t*dir + (t x)*dx + (t y)*dy.
    const glm::dmat3 inverse =
        glm::inverse(perspective_ ? glm::dmat3(dir_, dir_dx_, dir_dy_) : glm::dmat3(dir_, origin_dx_, origin_dy_));
    glm::dvec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y, corner & 4 ? b.hi.z : b.lo.z);
        const glm::dvec3 solved = inverse * (p - origin_);
        glm::dvec2 pixel(solved.y, solved.z);
        if (perspective_) {
            // A corner behind the eye, or beside it, has no pixel: the brick may fill the picture.
            if (!(solved.x > 1e-6)) return {{0, 0}, {width_, height_}};
            pixel /= solved.x;
        }
        lo = glm::min(lo, pixel);
        hi = glm::max(hi, pixel);
    }
    if (!(std::isfinite(lo.x + lo.y + hi.x + hi.y))) return {{0, 0}, {width_, height_}};
    const auto whole = [](double v, int most) { return int(std::clamp(v, 0.0, double(most))); };
    PixelRect rect;
    rect.first = {whole(std::floor(lo.x) - k_margin_pixels, width_),
                  whole(std::floor(lo.y) - k_margin_pixels, height_)};
    rect.end = {whole(std::ceil(hi.x) + k_margin_pixels + 1, width_),
                whole(std::ceil(hi.y) + k_margin_pixels + 1, height_)};
    return rect;
}

bool BrickView::meets(glm::ivec3 brick, int x, int y, double margin) const {
    const Corners b = box(brick, margin);
    const glm::dvec3 o = origin_ + origin_dx_ * double(x) + origin_dy_ * double(y);
    const glm::dvec3 d = dir_ + dir_dx_ * double(x) + dir_dy_ * double(y);
    double in = perspective_ ? 0.0 : -std::numeric_limits<double>::infinity();
    double out = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
        if (d[a] == 0) {
            if (o[a] < b.lo[a] || o[a] > b.hi[a]) return false;
            continue;
        }
        const double near = ((d[a] > 0 ? b.lo[a] : b.hi[a]) - o[a]) / d[a];
        const double far = ((d[a] > 0 ? b.hi[a] : b.lo[a]) - o[a]) / d[a];
        in = std::max(in, near);
        out = std::min(out, far);
    }
    return in <= out;
}

}  // namespace lacuna
