#include "core/render/reference_renderer.h"

#include <limits>
#include <mutex>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/render/reference_caster.h"

namespace lacuna {

namespace {

void add(Counters& sum, const Counters& part) {
    sum.rays += part.rays;
    sum.samples += part.samples;
    sum.not_converged += part.not_converged;
}

template <class T>
void render_rows(const Scene& scene, const Plan& plan, const JobContext& job, Frame& frame) {
    const GridGeometry& geometry = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, geometry, scene.size);
    // Pre-integrated segments stand for the integral itself: ordinary samples, far closer together.
    const bool fine = scene.mode == ViewMode::ea && plan.integration == Integration::preintegrated;
    const double step_mm = plan.step * geometry.smallest_spacing_mm() / (fine ? k_reference_subdivision : 1);
    std::mutex mutex;
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            reference::Caster<T> caster(scene, plan);
            for (int x = 0; x < frame.size.x; ++x) {
                job.check();
                const auto pixel = caster.trace(reference::cast(rays.origin(x, double(y)), rays.direction(x, double(y)),
                                                                geometry, scene.cuts, step_mm));
                const std::size_t i = std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x);
                frame.color[i] = glm::vec4(pixel.color);
                frame.depth_mm[i] = float(pixel.depth_mm);
            }
            std::lock_guard lock(mutex);
            add(frame.counters, caster.counters);
        },
        job);
}

}  // namespace

Frame render_reference(const Scene& scene, const Plan& plan, const JobContext& job) {
    const Stopwatch watch;
    if (scene.mode == ViewMode::shear_warp)
        throw Error(Errc::unsupported,
                    "The reference renderer casts rays; shear-warp has its own renderer. Use mode iso to compare.");
    check(scene);
    job.check();
    Frame frame;
    frame.size = scene.size;
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels());
    visit_type(scene.volume.type(), [&](auto tag) { render_rows<decltype(tag)>(scene, plan, job, frame); });
    frame.ms = watch.ms();
    return frame;
}

}  // namespace lacuna
