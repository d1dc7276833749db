#include "core/render/packet_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr std::size_t k_most_cells = 24000;  // projecting more costs more than the finer cells save
constexpr int k_packet = 4;                  // pixels
constexpr double k_margin_px = 0.05, k_infinity = std::numeric_limits<double>::infinity();
constexpr std::uint8_t k_empty = 1;  // the region a ray sees nothing in

glm::dvec3 of(const s_float (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Blocks of 2^3 cells: empty where all of them are.
RegionGrid halved(const RegionGrid& fine) {
    RegionGrid coarse{(fine.size + 1) / 2, {}};
    coarse.region.assign(std::size_t(coarse.size.x) * std::size_t(coarse.size.y) * std::size_t(coarse.size.z), k_empty);
    const std::uint8_t* from = fine.region.data();
    for (int z = 0; z < fine.size.z; ++z)
        for (int y = 0; y < fine.size.y; ++y, from += fine.size.x) {
            std::uint8_t* to = &coarse.region[std::size_t(coarse.size.x) *
                                              (std::size_t(z / 2) * std::size_t(coarse.size.y) + std::size_t(y / 2))];
            for (int x = 0; x < fine.size.x; ++x)
                if (from[x] != k_empty) to[x / 2] = 0;
        }
    return coarse;
}

/// Calls met(x, y, z) for cells that are not empty and have an empty neighbour across a face, or the grid's end.
template <class Met>
void for_each_frontier_cell(const RegionGrid& grid, Met&& met) {
    const glm::ivec3 n = grid.size;
    const std::size_t dy = std::size_t(n.x), dz = dy * std::size_t(n.y);
    std::vector<std::uint8_t> marked(std::size_t(n.x) + 8);
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y) {
            const std::uint8_t* row = grid.region.data() + std::size_t(z) * dz + std::size_t(y) * dy;
            const bool outer = y == 0 || z == 0 || y + 1 == n.y || z + 1 == n.z;
            // Rows beside the row; an outer one counts as all frontier.
            const std::uint8_t *a = outer ? row : row - dy, *b = outer ? row : row + dy, *c = outer ? row : row - dz,
                               *d = outer ? row : row + dz;
            std::uint8_t* mark = marked.data();
            const auto all = std::uint8_t(outer);
            for (int x = 0; x < n.x; ++x) {
                const auto beside =
                    std::uint8_t((a[x] == k_empty) | (b[x] == k_empty) | (c[x] == k_empty) | (d[x] == k_empty));
                mark[x] = std::uint8_t((row[x] != k_empty) & (beside | all));
            }
            for (int x = 1; x + 1 < n.x; ++x)
                mark[x] =
                    std::uint8_t(mark[x] | ((row[x] != k_empty) & ((row[x - 1] == k_empty) | (row[x + 1] == k_empty))));
            mark[0] = std::uint8_t(mark[0] | (row[0] != k_empty));
            mark[n.x - 1] = std::uint8_t(mark[n.x - 1] | (row[n.x - 1] != k_empty));
            for (int x = 0; x < n.x; ++x)
                if (mark[x]) met(x, y, z);
        }
}

/// A number that is linear over space.
struct Linear {
    glm::dvec3 slope{0};
    double at_zero = 0;
    double at(const glm::dvec3& p) const { return glm::dot(slope, p) + at_zero; }
    /// Half the width of its values over a box with these half edges.
    double reach(const glm::dvec3& half) const { return glm::dot(glm::abs(slope), half); }
};

/// From a point in voxels to the picture: the point lies on the ray of pixel (x, y) / w at depth `along`, w being 1 in
/// parallel projection and `along` in perspective.
struct Projection {
    Linear x, y, along;
    glm::dvec3 origin{0}, spacing{1};
    double mm_per_along = 1;
    bool perspective = false;

    explicit Projection(const RayParams& rays) : origin(of(rays.origin)), spacing(of(rays.spacing)) {
        perspective = of(rays.origin_dx) == glm::dvec3(0) && of(rays.origin_dy) == glm::dvec3(0);
        const glm::dvec3 dir = of(rays.dir);
        const glm::dmat3 axes = perspective ? glm::dmat3(of(rays.dir_dx), of(rays.dir_dy), dir)
                                            : glm::dmat3(of(rays.origin_dx), of(rays.origin_dy), dir);
        const glm::dmat3 inverse = glm::inverse(axes);
        Linear* rows[3] = {&x, &y, &along};
        for (int i = 0; i < 3; ++i) {
            rows[i]->slope = {inverse[0][i], inverse[1][i], inverse[2][i]};
            rows[i]->at_zero = -glm::dot(rows[i]->slope, origin);
        }
        mm_per_along = glm::length(dir * spacing);
    }
};

struct Footprint {
    double x0, x1, y0, y1;     // pixels
    double nearest, farthest;  // ray parameter, mm
};

/// A little more than what the box covers. @return false where the eye is too near to tell
bool project_box(const Projection& view, const glm::dvec3& middle, const glm::dvec3& half, Footprint& print) {
    const double x = view.x.at(middle), y = view.y.at(middle), s = view.along.at(middle);
    const double xr = view.x.reach(half), yr = view.y.reach(half), sr = view.along.reach(half);
    if (!view.perspective) {
        print = {x - xr, x + xr, y - yr, y + yr, (s - sr) * view.mm_per_along, (s + sr) * view.mm_per_along};
        return true;
    }
    const double least = s - sr, most = s + sr;
    if (!(least > 1e-3 * most)) return most <= 0;  // behind the eye altogether: met by no ray
    const double near_w = 1 / least, far_w = 1 / most;
    const double x0 = x - xr, x1 = x + xr, y0 = y - yr, y1 = y + yr;
    const double away = glm::length((middle - view.origin) * view.spacing), radius = glm::length(half * view.spacing);
    print = {x0 * (x0 < 0 ? near_w : far_w),
             x1 * (x1 > 0 ? near_w : far_w),
             y0 * (y0 < 0 ? near_w : far_w),
             y1 * (y1 > 0 ? near_w : far_w),
             away - radius,
             away + radius};
    return true;
}

}  // namespace

OctantSet octants_of_rays(const RayParams& rays, int margin_px) {
    const double lo = -margin_px, hi_x = rays.width + margin_px, hi_y = rays.height + margin_px;
    OctantSet octants = k_all_octants;
    // Where single precision may see another sign, or none, both count: told by the length of the whole direction.
    double rounding = 0;
    for (int a = 0; a < 3; ++a)
        rounding = std::max(rounding, 1e-5 * (std::abs(rays.dir[a]) + std::abs(rays.dir_dx[a]) * hi_x +
                                              std::abs(rays.dir_dy[a]) * hi_y));
    for (int a = 0; a < 3; ++a) {
        const double at = rays.dir[a], dx = rays.dir_dx[a], dy = rays.dir_dy[a];
        const double least = at + std::min(dx * lo, dx * hi_x) + std::min(dy * lo, dy * hi_y);
        const double most = at + std::max(dx * lo, dx * hi_x) + std::max(dy * lo, dy * hi_y);
        OctantSet falling = 0;
        for (int octant = 0; octant < 8; ++octant) falling |= OctantSet(octant >> a & 1) << octant;
        if (least > rounding) octants &= ~falling;
        if (most < -rounding) octants &= falling;
    }
    return octants;
}

void PacketSpans::hold(const RegionGrid& grid, int shift) {
    const RegionGrid* source = &grid;
    RegionGrid coarse;
    for (edge_ = 1 << shift;; edge_ *= 2) {
        cells_.clear();
        for_each_frontier_cell(*source, [&](int x, int y, int z) { cells_.push_back(Place(x, y, z)); });
        if (cells_.size() <= k_most_cells) return;
        coarse = halved(*source);
        source = &coarse;
    }
}

void PacketSpans::project(const RayParams& rays, glm::ivec2 packets, glm::vec2* spans) const {
    const std::size_t count = std::size_t(packets.x) * std::size_t(packets.y);
    const glm::vec2 nothing(std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity());
    std::fill_n(spans, count, nothing);
    const Projection view(rays);
    const glm::dvec3 last = of(rays.last);
    const int parts = cells_.size() > 2000 ? thread_count() : 1;
    std::vector<std::vector<glm::vec2>> own(std::size_t(parts) - 1, std::vector<glm::vec2>(count, nothing));
    std::vector<std::uint8_t> too_near(std::size_t(parts), 0);
    const auto project_some = [&](std::int64_t part) {
        glm::vec2* out = part == 0 ? spans : own[std::size_t(part) - 1].data();
        const std::size_t first = cells_.size() * std::size_t(part) / std::size_t(parts);
        const std::size_t end = cells_.size() * (std::size_t(part) + 1) / std::size_t(parts);
        for (std::size_t i = first; i < end; ++i) {
            glm::dvec3 lo = glm::dvec3(cells_[i]) * double(edge_), hi = lo + double(edge_);
            for (int a = 0; a < 3; ++a) {  // the outer ones reach to the volume's faces
                if (cells_[i][a] == 0) lo[a] = -0.5;
                if (hi[a] > last[a]) hi[a] = last[a] + 0.5;
            }
            Footprint print{0, -1, 0, -1, 0, 0};
            if (!project_box(view, 0.5 * (lo + hi), 0.5 * (hi - lo), print)) {
                too_near[std::size_t(part)] = 1;
                return;
            }
            const double scale = 1.0 / k_packet;
            const auto place = [](double v, int n) { return int(std::clamp(std::floor(v), -1.0, double(n))); };
            const int x0 = std::max(place((print.x0 - k_margin_px) * scale, packets.x), 0);
            const int x1 = std::min(place((print.x1 + k_margin_px) * scale, packets.x), packets.x - 1);
            const int y0 = std::max(place((print.y0 - k_margin_px) * scale, packets.y), 0);
            const int y1 = std::min(place((print.y1 + k_margin_px) * scale, packets.y), packets.y - 1);
            const auto nearest = float(print.nearest), farthest = float(print.farthest);
            for (int y = y0; y <= y1; ++y) {
                glm::vec2* row = out + std::size_t(y) * std::size_t(packets.x);
                for (int x = x0; x <= x1; ++x) {
                    row[x].x = std::min(row[x].x, nearest);
                    row[x].y = std::max(row[x].y, farthest);
                }
            }
        }
    };
    parallel_for(0, parts, project_some);
    if (std::find(too_near.begin(), too_near.end(), 1) != too_near.end()) {
        std::fill_n(spans, count, glm::vec2(float(-k_infinity), float(k_infinity)));
        return;
    }
    for (const std::vector<glm::vec2>& other : own)
        for (std::size_t i = 0; i < count; ++i)
            spans[i] = {std::min(spans[i].x, other[i].x), std::max(spans[i].y, other[i].y)};
}

}  // namespace lacuna
