#include "core/render/highlight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

struct Mask {
    const Highlight& source;
    bool at(glm::ivec3 v) const {
        v -= source.first;
        if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, source.size))) return false;
        return (*source.inside)[(std::size_t(v.z) * std::size_t(source.size.y) + std::size_t(v.y)) *
                                    std::size_t(source.size.x) +
                                std::size_t(v.x)] != 0;
    }
    /// Outward direction of the mask near a voxel, per voxel: differences of its 3x3x3 neighbourhood.
    glm::dvec3 outward(glm::ivec3 v) const {
        glm::dvec3 sum(0);
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    if (at(v + glm::ivec3(x, y, z))) sum -= glm::dvec3(x, y, z);
        return sum;
    }
};

/// First set voxel along the ray o + t*d (voxel coordinates, t >= t_min), or x = -1.
glm::ivec3 first_hit(const Mask& mask, const glm::dvec3& o, const glm::dvec3& d, double t_min) {
    const glm::dvec3 lo = glm::dvec3(mask.source.first) - 0.5, hi = lo + glm::dvec3(mask.source.size);
    double t_in = t_min, t_out = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
        if (d[a] == 0) {
            if (o[a] < lo[a] || o[a] > hi[a]) return glm::ivec3(-1);
            continue;
        }
        const double ta = (lo[a] - o[a]) / d[a], tb = (hi[a] - o[a]) / d[a];
        t_in = std::max(t_in, std::min(ta, tb));
        t_out = std::min(t_out, std::max(ta, tb));
    }
    if (!(t_out > t_in)) return glm::ivec3(-1);
    const glm::dvec3 start = o + d * t_in;
    glm::ivec3 voxel =
        glm::clamp(glm::ivec3(glm::floor(start + 0.5)), mask.source.first, mask.source.first + mask.source.size - 1);
    glm::dvec3 next, per_voxel;
    for (int a = 0; a < 3; ++a) {
        per_voxel[a] = d[a] == 0 ? std::numeric_limits<double>::infinity() : std::abs(1 / d[a]);
        next[a] = d[a] == 0 ? per_voxel[a] : (voxel[a] + (d[a] > 0 ? 0.5 : -0.5) - o[a]) / d[a];
    }
    const glm::ivec3 end = mask.source.first + mask.source.size;
    while (glm::all(glm::greaterThanEqual(voxel, mask.source.first)) && glm::all(glm::lessThan(voxel, end))) {
        if (mask.at(voxel)) return voxel;
        const int a = next.x <= next.y ? (next.x <= next.z ? 0 : 2) : (next.y <= next.z ? 1 : 2);
        voxel[a] += d[a] > 0 ? 1 : -1;
        next[a] += per_voxel[a];
    }
    return glm::ivec3(-1);
}

struct PixelBox {
    glm::ivec2 first{0}, last{0};
};

/// Pixels the highlight's box can touch.
PixelBox project_box(const ViewRays& rays, const GridGeometry& grid, const Highlight& highlight) {
    glm::dvec2 lo(1e30), hi(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at = glm::dvec3(highlight.first) - 0.5 +
                              glm::dvec3(corner & 1, (corner >> 1) & 1, corner >> 2) * glm::dvec3(highlight.size);
        const glm::dvec3 mm = grid.voxel_to_mm(at);
        if (rays.perspective && glm::dot(mm - rays.eye, rays.forward) <= 1e-6) return {{0, 0}, rays.size - 1};
        const glm::dvec2 pixel = rays.project(mm);
        lo = glm::min(lo, pixel);
        hi = glm::max(hi, pixel);
    }
    const glm::dvec2 size(rays.size);
    return {glm::ivec2(glm::clamp(lo, glm::dvec2(-1), size)),
            glm::ivec2(glm::clamp(hi + 1.0, glm::dvec2(-1), size - 1.0))};
}

}  // namespace

void draw_highlight(const Scene& scene, const Highlight& highlight, Frame& frame, const JobContext& job) {
    if (!highlight.inside || highlight.inside->empty()) return;
    const GridGeometry& grid = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, grid, scene.size);
    const PixelBox box = project_box(rays, grid, highlight);
    const Mask mask{highlight};
    const auto draw_row = [&](std::int64_t y) {
        for (int x = std::max(0, box.first.x); x <= box.last.x; ++x) {
            const glm::dvec3 along = rays.direction(x, double(y));
            const glm::ivec3 voxel =
                first_hit(mask, grid.mm_to_voxel(rays.origin(x, double(y))), grid.vector_to_voxel(along), 0);
            if (voxel.x < 0) continue;
            const glm::dvec3 normal = mask.outward(voxel) / grid.spacing;
            const double length = glm::length(normal);
            const double facing =
                length > 0 ? std::abs(glm::dot(normal, glm::transpose(grid.direction) * along)) / length : 1.0;
            const glm::vec3 color = glm::vec3(highlight.color * (0.35 + 0.65 * facing));
            glm::vec4& pixel = frame.color[std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x)];
            const float over = float(highlight.opacity);
            pixel = glm::vec4(glm::vec3(pixel) * (1 - over) + color * over, pixel.a * (1 - over) + over);
        }
    };
    const int first_row = std::max(0, box.first.y), rows = box.last.y + 1 - first_row;
    // Thousands of small highlights must not start threads each.
    const int bands = std::int64_t(rows) * (box.last.x - box.first.x) < 4096 ? 1 : rows;
    parallel_bands(
        first_row, box.last.y + 1, bands,
        [&](std::int64_t first, std::int64_t end) {
            for (std::int64_t y = first; y < end; ++y) draw_row(y);
        },
        JobContext{job.stop, nullptr});
}

}  // namespace lacuna
