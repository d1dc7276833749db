#include "core/render/shear_warp.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/render/shading.h"
#include "core/render/shear_cells.h"

namespace lacuna {

namespace {

constexpr float k_cap_shade = 2;  ///< above any factor of the surface colour

Solid solid_of(const Scene& scene, const Plan& plan) {
    Solid solid;
    solid.iso = scene.iso;
    for (const SegmentationRange& range : scene.classification.ranges) solid.ranges.push_back(range.range);
    for (const CuttingPlane& cut : scene.cuts) solid.cuts.push_back({cut.normal, cut.offset, cut.cap});
    solid.gradient = plan.voxel_gradient;
    return solid;
}

/// A view onto listed voxels, along the grid's axes.
struct Sight {
    glm::vec3 direction;
    int u_axis, v_axis;
    int entered;  ///< sides of the volume rays come in by, as VoxelLook::sides

    Sight(const glm::dvec3& along, const SliceDirection& slices)
        : direction(along), u_axis(slices.u_axis()), v_axis(slices.v_axis()) {
        entered = (along[u_axis] < 0 ? 2 : 1) | (along[v_axis] < 0 ? 8 : 4);
    }
};

float facing(const VoxelLook& look, const Sight& sight) {
    constexpr int k_u_sides = 3;
    if (const int side = look.sides & sight.entered)
        return std::min(std::fabs(sight.direction[side & k_u_sides ? sight.u_axis : sight.v_axis]), 1.0f);
    const glm::vec3 normal(look.normal[0], look.normal[1], look.normal[2]);
    return std::min(std::fabs(glm::dot(normal, sight.direction)) / 32767, 1.0f);
}

/// Paints rows [first, last) back to front, key_of(number of the voxel) into each pixel. Bands of rows never meet, so
/// the picture is the same on any number of threads.
template <class KeyOf>
void paint_band(const VisibleVoxels& lists, const Shear& shear, ShearImage& image, int first, int last, KeyOf&& key_of,
                const JobContext& job) {
    for (int y = first; y < last; ++y)
        std::fill_n(image.painted.begin() + std::ptrdiff_t(image.row(y)), image.size.x, ShearImage::Painted{});
    // The surface lies 0 to 1 slices before the centre of the first voxel inside: half a slice is the best guess.
    const double origin = shear.depth_mm(0, 0, 0) - 0.5 * shear.slice_mm;
    const auto per_column = float(shear.depth_per_voxel_mm.x);
    for (int k = 0; k < lists.slices; ++k) {
        const int c = shear.direction.from_low ? lists.slices - 1 - k : k;
        if (lists.slice_empty(c)) continue;
        job.check();
        const glm::ivec2 offset(glm::floor(shear.place(c) + 0.5));
        const int v_end = std::min(last - offset.y, lists.rows);
        for (int v = std::max(first - offset.y, 0); v < v_end; ++v) {
            const std::size_t row = std::size_t(c) * std::size_t(lists.rows) + std::size_t(v);
            ShearImage::Painted* to = image.painted.data() + image.row(v + offset.y) + offset.x;
            const auto depth = float(origin + v * shear.depth_per_voxel_mm.y + c * shear.depth_per_voxel_mm.z);
            for (std::uint32_t i = lists.row_begin[row]; i < lists.row_begin[row + 1]; ++i) {
                const std::uint16_t u = lists.column[i];
                to[u] = {key_of(i), depth + u * per_column};
            }
        }
    }
}

/// Turns what is painted in rows [first, last) into colours.
template <class ColorOf>
void color_band(ShearImage& image, int first, int last, ColorOf&& color_of) {
    const std::size_t end = image.row(last);
    for (std::size_t at = image.row(first); at < end; ++at) {
        const ShearImage::Painted& painted = image.painted[at];
        image.color[at] = painted.depth_mm < ShearImage::k_nothing ? color_of(painted.key) : glm::vec4(0);
    }
}

}  // namespace

void ShearWarpRenderer::paint_voxels(const VisibleVoxels& lists, const Scene& scene, const glm::dvec3& forward,
                                     const Shear& shear, const JobContext& job) {
    const glm::dvec3 direction_grid = glm::transpose(scene.volume.geometry().direction) * forward;
    const glm::vec3 surface(scene.surface_color);
    const Sight sight(direction_grid, lists.direction);
    const bool deferred = scene.shading == Shading::phong;
    const float ambient = scene.shading == Shading::lambert ? 0.2f : 1.0f, diffuse = 1 - ambient;
    const auto baked_shade = [&](std::uint32_t key) {
        const VoxelLook& look = lists.look[key];
        return std::bit_cast<std::uint32_t>(look.kind == VoxelLook::cap
                                                ? k_cap_shade + float(grey_level(scene.window, look.value))
                                                : ambient + diffuse * facing(look, sight));
    };
    const auto baked_color = [&](std::uint32_t key) {
        const auto shade = std::bit_cast<float>(key);
        return glm::vec4(shade >= k_cap_shade ? glm::vec3(shade - k_cap_shade) : surface * shade, 1);
    };
    const auto phong_color = [&](std::uint32_t key) {
        const VoxelLook& look = lists.look[key];
        if (look.kind == VoxelLook::cap) return glm::vec4(glm::vec3(float(grey_level(scene.window, look.value))), 1);
        const float c = facing(look, sight), c4 = c * c * c * c, c16 = c4 * c4 * c4 * c4;
        return glm::vec4(surface * (0.2f + 0.7f * c) + 0.3f * (c16 * c4), 1);
    };
    parallel_bands(0, image_.size.y, 4 * thread_count(),
                   [&](std::int64_t begin, std::int64_t end) {
                       const int first = int(begin), last = int(end);
                       if (deferred) {
                           paint_band(
                               lists, shear, image_, first, last, [](std::uint32_t i) { return i; }, job);
                           color_band(image_, first, last, phong_color);
                       } else {
                           paint_band(lists, shear, image_, first, last, baked_shade, job);
                           color_band(image_, first, last, baked_color);
                       }
                   },
                   {job.stop, nullptr});
}

Frame ShearWarpRenderer::render(const Scene& scene, const Plan& plan, const JobContext& job, BuildRecord& built) {
    if (scene.camera.fov_deg)
        throw Error(Errc::bad_usage,
                    "Shear-warp is orthographic only; take the perspective away, or use mode iso, ea, mip, lmip, minip "
                    "or mean.");
    const GridGeometry& geometry = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, geometry, scene.size);
    const Shear shear(rays, geometry, plan.directions);
    const Solid solid = solid_of(scene, plan);
    const bool bilinear = plan.sampler != Sampler::nearest;

    const Stopwatch build_watch;
    const bool ready = bilinear ? lists_.has_cells(scene.volume, solid, shear.direction)
                                : lists_.has(scene.volume, solid, shear.direction);
    std::shared_ptr<const VisibleVoxels> voxels;
    std::shared_ptr<const VisibleCells> cells;
    if (bilinear)
        cells = lists_.get_cells(scene.volume, solid, shear.direction, job.part(0, 0.5));
    else
        voxels = lists_.get(scene.volume, solid, shear.direction, job.part(0, 0.5));
    built.ms = ready ? 0 : build_watch.ms();

    const Stopwatch watch;
    image_.resize(shear.size);
    if (bilinear)
        parallel_bands(
            0, image_.size.y, 8 * thread_count(),
            [&](std::int64_t first, std::int64_t last) {
                paint_cells(*cells, scene, rays.forward, shear, image_, int(first), int(last), job);
            },
            job.part(0.5, 0.9));
    else
        paint_voxels(*voxels, scene, rays.forward, shear, job);

    Frame frame;
    frame.size = scene.size;
    frame.color.resize(frame.pixels(), glm::vec4(0));
    frame.depth_mm.resize(frame.pixels(), ShearImage::k_nothing);
    warp(image_, shear, frame, job.part(0.9, 1));
    frame.counters.samples = bilinear ? cells->column.size() : voxels->column.size();
    const auto all = std::uint64_t(geometry.voxel_count());
    frame.counters.skipped = all - std::min(all, frame.counters.samples);
    frame.ms = watch.ms();
    built.bytes = bytes_held();
    return frame;
}

std::size_t ShearWarpRenderer::bytes_held() const { return lists_.bytes_held() + image_.bytes(); }

}  // namespace lacuna
