#include "core/render/shear_image.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

/// Narrows [first, last) to the x where lo <= at + x * step < hi.
void narrow(double at, double step, double lo, double hi, int& first, int& last) {
    if (step == 0) {
        if (!(at >= lo && at < hi)) last = first;
        return;
    }
    double from = (lo - at) / step, to = (hi - at) / step;
    if (step < 0) std::swap(from, to);
    first = int(std::clamp(std::ceil(from), double(first), double(last)));
    last = int(std::clamp(std::floor(to) + 1, double(first), double(last)));
    const auto inside = [&](int x) { return at + x * step >= lo && at + x * step < hi; };
    while (first < last && !inside(first)) ++first;
    while (first < last && !inside(last - 1)) --last;
}

/// Interpolated where the corners belong to one surface (they differ by no more than `reach_mm`), else that of the
/// heaviest covered corner.
float depth_of(const ShearImage::Painted* corners[4], float fx, float fy, float reach_mm) {
    const float a = corners[0]->depth_mm, b = corners[1]->depth_mm, c = corners[2]->depth_mm, d = corners[3]->depth_mm;
    if (std::max({a, b, c, d}) - std::min({a, b, c, d}) <= reach_mm) {  // false where one is infinite
        const float upper = a + fx * (b - a), lower = c + fx * (d - c);
        return upper + fy * (lower - upper);
    }
    const int closest = (fx >= 0.5f ? 1 : 0) + (fy >= 0.5f ? 2 : 0);
    float depth = corners[closest]->depth_mm, heaviest = 0;
    if (depth < ShearImage::k_nothing) return depth;
    for (int corner = 0; corner < 4; ++corner) {
        const float weight = (corner & 1 ? fx : 1 - fx) * (corner >> 1 ? fy : 1 - fy);
        if (!(corners[corner]->depth_mm < ShearImage::k_nothing) || !(weight > heaviest)) continue;
        heaviest = weight;
        depth = corners[corner]->depth_mm;
    }
    return depth;
}

}  // namespace

void warp(const ShearImage& image, const Shear& shear, Frame& frame, const JobContext& job) {
    const auto reach_mm = float(3 * shear.slice_mm);
    std::vector<std::uint64_t> met(std::size_t(frame.size.y));
    const auto warp_row = [&](int y) {
        const glm::dvec2 start = shear.at_first + double(y) * shear.per_row;
        int first = 0, last = frame.size.x;
        narrow(start.x, shear.per_column.x, 0, image.size.x - 1, first, last);
        narrow(start.y, shear.per_column.y, 0, image.size.y - 1, first, last);
        glm::vec4* to = frame.color.data() + std::size_t(y) * std::size_t(frame.size.x);
        float* depth = frame.depth_mm.data() + std::size_t(y) * std::size_t(frame.size.x);
        for (int x = first; x < last; ++x) {
            const double at_x = start.x + x * shear.per_column.x, at_y = start.y + x * shear.per_column.y;
            const int ix = int(at_x), iy = int(at_y);  // not negative: the conversion is a floor
            const std::size_t from = image.row(iy) + std::size_t(ix), below = from + std::size_t(image.size.x);
            const glm::vec4 *p = image.color.data() + from, *q = image.color.data() + below;
            if (p[0].a + p[1].a + q[0].a + q[1].a == 0) continue;
            const float fx = float(at_x - ix), fy = float(at_y - iy);
            const glm::vec4 upper = p[0] + fx * (p[1] - p[0]), lower = q[0] + fx * (q[1] - q[0]);
            to[x] = upper + fy * (lower - upper);
            if (to[x].a < 0.5f) continue;
            const ShearImage::Painted* painted = image.painted.data();
            const ShearImage::Painted* corners[4] = {painted + from, painted + from + 1, painted + below,
                                                     painted + below + 1};
            depth[x] = depth_of(corners, fx, fy, reach_mm);
        }
        met[std::size_t(y)] = std::uint64_t(last - first);
    };
    parallel_bands(
        0, frame.size.y, 8 * thread_count(),
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t y = begin; y < end; ++y) warp_row(int(y));
        },
        job);
    for (const std::uint64_t row : met) frame.counters.rays += row;
}

}  // namespace lacuna
