#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/base/parallel.h"
#include "core/render/camera.h"
#include "core/render/effects.h"
#include "core/render/frame.h"
#include "core/render/scene.h"

namespace lacuna::effects {

/// The depth image as a relief in which every plane is flat in the picture's x and y: orthographic minus the depth,
/// perspective distance^2 / depth (1/depth is linear over a projected plane). Differences times `scale` are mm as seen
/// in the plane through the centre: true mm = that times depth / distance.
struct Relief {
    glm::ivec2 size{0};
    std::vector<float> height;    ///< mm, towards the viewer; k_nothing where nothing was met
    std::vector<float> scale;     ///< depth / distance (orthographic: 1); 0 where nothing was met
    std::vector<glm::ivec2> met;  ///< a row's pixels before .x and from .y on have met nothing

    static constexpr float k_nothing = -1e30f;
};

/// Calls body(y) for every row, bands of rows on the worker threads.
template <class Body>
void for_rows(int rows, const JobContext& job, Body&& body) {
    parallel_bands(
        0, rows, 8 * thread_count(),
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t y = first; y < last; ++y) body(int(y));
        },
        job);
}

Relief make_relief(const ViewRays& rays, const Frame& frame, const JobContext& job);

/// Depth along the view direction (not along the ray) of pixel (x, y), mm; infinity where nothing finite was met.
double plane_depth_mm(const ViewRays& rays, const Frame& frame, int x, int y);

/// Averages over 4x4 pixels (weights 1/2 1 1 1 1/2 along rows, then along columns), only over pixels within
/// `reach_mm` of the middle one's height: edges stay. Pixels that met nothing become 0.
void smooth_by_depth(const Relief& relief, double reach_mm, std::vector<float>& image, const JobContext& job);

/// Multiplies colours by 1 - strength * occlusion, at least 0.
void darken(const std::vector<float>& occlusion, double strength, Frame& frame, const JobContext& job);

void screen_space_occlusion(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                            const JobContext& job);
/// @param on_the_way  gets the frame darkened by the samples so far, a copy each; none: no pictures on the way
void ambient_occlusion(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                       const JobContext& job, const FramePreview& on_the_way);
void depth_of_field(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                    const JobContext& job);
/// gamma, tonemap, brightness, contrast
void tone(const Effect& effect, Frame& frame, const JobContext& job);

}  // namespace lacuna::effects
