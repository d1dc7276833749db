#include "core/render/shear_warp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/render/shading.h"

namespace lacuna {

namespace {

constexpr std::uint32_t k_no_voxel = std::numeric_limits<std::uint32_t>::max();
constexpr float k_nothing = std::numeric_limits<float>::infinity();

Solid solid_of(const Scene& scene) {
    Solid solid;
    solid.iso = scene.iso;
    for (const SegmentationRange& range : scene.classification.ranges) solid.ranges.push_back(range.range);
    for (const CuttingPlane& cut : scene.cuts) solid.cuts.push_back({cut.normal, cut.offset, cut.cap});
    return solid;
}

/// The shear factorisation of an orthographic view: voxel (u, v) of slice c falls on intermediate pixel
/// (u, v) + offset(c), within half a pixel.
struct Shear {
    SliceDirection direction;
    glm::dvec2 slope{0};                   ///< shift of u and v a slice, at most 1 each way
    glm::dvec2 shift{0};                   ///< puts the leftmost slice at pixel 1
    glm::ivec2 size{0};                    ///< of the intermediate image
    glm::dvec2 at_first{0};                ///< intermediate position of the picture's pixel (0, 0)
    glm::dvec2 per_column{0}, per_row{0};  ///< and its change from pixel to pixel: the warp
    double depth_first = 0;  ///< depth half a slice before voxel (0, 0, 0), mm, and its change along u, v and the axis
    glm::dvec3 depth_per_voxel{0};

    glm::ivec2 offset(int slice) const { return glm::ivec2(glm::floor(shift - double(slice) * slope + 0.5)); }
    glm::dvec2 sheared(const GridGeometry& geometry, const glm::dvec3& mm) const {
        const glm::dvec3 voxel = geometry.mm_to_voxel(mm);
        return glm::dvec2(voxel[direction.u_axis()], voxel[direction.v_axis()]) - voxel[direction.axis] * slope + shift;
    }
};

Shear factor(const ViewRays& rays, const GridGeometry& geometry) {
    const glm::dvec3 along = geometry.vector_to_voxel(rays.forward);
    Shear shear;
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::fabs(along[other]) > std::fabs(along[axis])) axis = other;
    shear.direction = {axis, along[axis] > 0};
    const int u = shear.direction.u_axis(), v = shear.direction.v_axis();
    shear.slope = glm::dvec2(along[u], along[v]) / along[axis];

    const double last = geometry.size[axis] - 1;
    shear.shift = glm::ceil(glm::max(last * shear.slope, glm::dvec2(0))) + 1.0;
    shear.size =
        glm::ivec2(geometry.size[u], geometry.size[v]) + glm::ivec2(glm::ceil(last * glm::abs(shear.slope))) + 3;

    shear.at_first = shear.sheared(geometry, rays.origin(0, 0));
    shear.per_column = shear.sheared(geometry, rays.origin(1, 0)) - shear.at_first;
    shear.per_row = shear.sheared(geometry, rays.origin(0, 1)) - shear.at_first;

    const auto depth_of = [&](glm::dvec3 voxel) {
        return glm::dot(geometry.voxel_to_mm(voxel) - rays.eye, rays.forward);
    };
    const double at_origin = depth_of({0, 0, 0});
    for (const int a : {u, v, axis}) {
        glm::dvec3 one(0);
        one[a] = 1;
        shear.depth_per_voxel[a == u ? 0 : a == v ? 1 : 2] = depth_of(one) - at_origin;
    }
    // The surface lies 0 to 1 slices before the centre of the first voxel inside: half a slice is the best guess.
    shear.depth_first = at_origin - 0.5 / std::fabs(along[axis]);
    return shear;
}

/// The intermediate image: which voxel shows in each pixel and how deep it lies.
struct Intermediate {
    explicit Intermediate(glm::ivec2 image_size)
        : size(image_size),
          voxel(std::size_t(size.x) * std::size_t(size.y), k_no_voxel),
          depth_mm(voxel.size(), k_nothing),
          color(voxel.size(), glm::vec4(0)) {}
    glm::ivec2 size;
    std::vector<std::uint32_t> voxel;
    std::vector<float> depth_mm;
    std::vector<glm::vec4> color;
};

/// Paints rows [first, last) back to front. Bands of rows never meet, so the picture is the same on any number of
/// threads.
void paint_band(const VisibleVoxels& lists, const Shear& shear, Intermediate& image, int first, int last,
                const JobContext& job) {
    for (int k = 0; k < lists.slices; ++k) {
        job.check();
        const int c = lists.direction.from_low ? lists.slices - 1 - k : k;
        const glm::ivec2 offset = shear.offset(c);
        const int v_end = std::min(last - offset.y, lists.rows);
        for (int v = std::max(first - offset.y, 0); v < v_end; ++v) {
            const std::size_t row = std::size_t(c) * std::size_t(lists.rows) + std::size_t(v);
            const std::size_t at = std::size_t(v + offset.y) * std::size_t(image.size.x) + std::size_t(offset.x);
            const double depth = shear.depth_first + v * shear.depth_per_voxel.y + c * shear.depth_per_voxel.z;
            for (std::uint32_t i = lists.row_begin[row]; i < lists.row_begin[row + 1]; ++i) {
                const std::uint16_t u = lists.column[i];
                image.voxel[at + u] = i;
                image.depth_mm[at + u] = float(depth + u * shear.depth_per_voxel.x);
            }
        }
    }
}

glm::vec4 look_of(const VoxelLook& look, const Scene& scene, const glm::dvec3& direction_grid) {
    if (look.kind == VoxelLook::cap) return glm::vec4(glm::vec3(float(grey_level(scene.window, look.value))), 1);
    const glm::dvec3 normal = glm::dvec3(look.normal[0], look.normal[1], look.normal[2]) / 32767.0;
    const double c = std::fmin(std::fabs(glm::dot(normal, direction_grid)), 1);
    return glm::vec4(glm::vec3(shade(scene.shading, scene.surface_color, c)), 1);
}

/// The picture's pixel at a position of the intermediate image: bilinear in colour; the depth of the nearest covered
/// corner where at least half of the pixel is covered.
void warp_pixel(const Intermediate& image, const glm::dvec2& at, glm::vec4& color, float& depth) {
    const glm::dvec2 base = glm::floor(at);
    const glm::ivec2 i(base);
    const glm::vec2 f(at - base);
    float heaviest = 0, nearest = k_nothing;
    for (int corner = 0; corner < 4; ++corner) {
        const int x = i.x + (corner & 1), y = i.y + (corner >> 1);
        if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) continue;
        const float weight = (corner & 1 ? f.x : 1 - f.x) * (corner >> 1 ? f.y : 1 - f.y);
        const std::size_t from = std::size_t(y) * std::size_t(image.size.x) + std::size_t(x);
        color += weight * image.color[from];
        if (image.color[from].a > 0 && weight > heaviest) {
            heaviest = weight;
            nearest = image.depth_mm[from];
        }
    }
    if (color.a >= 0.5f) depth = nearest;
}

void warp(const Intermediate& image, const Shear& shear, Frame& frame, const JobContext& job) {
    std::vector<std::uint64_t> met(std::size_t(frame.size.y));
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            for (int x = 0; x < frame.size.x; ++x) {
                const glm::dvec2 at = shear.at_first + double(x) * shear.per_column + double(y) * shear.per_row;
                if (!(at.x > -1 && at.y > -1 && at.x < image.size.x && at.y < image.size.y)) continue;
                const std::size_t to = std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x);
                warp_pixel(image, at, frame.color[to], frame.depth_mm[to]);
                ++met[std::size_t(y)];
            }
        },
        job);
    for (const std::uint64_t row : met) frame.counters.rays += row;
}

}  // namespace

Frame ShearWarpRenderer::render(const Scene& scene, const Plan& plan, const JobContext& job, BuildRecord& built) {
    if (scene.camera.fov_deg)
        throw Error(Errc::bad_usage,
                    "Shear-warp is orthographic only; take the perspective away, or use mode iso, ea, mip, lmip, minip "
                    "or mean.");
    const GridGeometry& geometry = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, geometry, scene.size);
    const Shear shear = factor(rays, geometry);
    const Solid solid = solid_of(scene);

    const Stopwatch build_watch;
    const bool ready = lists_.has(scene.volume, solid, shear.direction);
    const auto lists = lists_.get(scene.volume, solid, shear.direction, job.part(0, 0.5));
    built.ms = ready ? 0 : build_watch.ms();
    built.bytes = lists_.bytes_held();

    const Stopwatch watch;
    Intermediate image(shear.size);
    parallel_bands(
        0, image.size.y, 4 * thread_count(),
        [&](std::int64_t first, std::int64_t last) { paint_band(*lists, shear, image, int(first), int(last), job); },
        {job.stop, nullptr});
    const glm::dvec3 direction_grid = glm::transpose(geometry.direction) * rays.forward;
    parallel_for(0, image.size.y,
                 [&](std::int64_t y) {
                     const std::size_t begin = std::size_t(y) * std::size_t(image.size.x);
                     for (std::size_t i = begin; i < begin + std::size_t(image.size.x); ++i)
                         if (image.voxel[i] != k_no_voxel)
                             image.color[i] = look_of(lists->look[image.voxel[i]], scene, direction_grid);
                 },
                 {job.stop, nullptr});

    Frame frame;
    frame.size = scene.size;
    frame.color.resize(frame.pixels(), glm::vec4(0));
    frame.depth_mm.resize(frame.pixels(), k_nothing);
    warp(image, shear, frame, job.part(0.5, 1));
    frame.counters.samples = lists->column.size();
    frame.counters.skipped = std::uint64_t(geometry.voxel_count()) - frame.counters.samples;
    frame.ms = watch.ms();
    return frame;
}

}  // namespace lacuna
