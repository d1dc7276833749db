#include "core/render/engine.h"

#include <chrono>

#include "core/base/stopwatch.h"
#include "core/render/highlight.h"
#include "core/render/opencl_renderer.h"
#include "core/render/reference_renderer.h"
#include "core/render/shear_warp.h"

namespace lacuna {

Engine::Engine(std::shared_ptr<ComputeDevice> device)
    : device_(std::move(device)), shear_warp_(std::make_unique<ShearWarpRenderer>()) {
    if (device_) opencl_ = std::make_unique<OpenClRenderer>(device_);
}

Engine::~Engine() = default;

RenderResult Engine::render(const Scene& scene, const Plan& plan, const JobContext& job, bool count) {
    check(scene);
    check(plan, scene);
    std::unique_lock lock(mutex_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(10))) job.check();
    job.check();

    const Stopwatch watch;
    RenderResult result;
    if (scene.mode == ViewMode::shear_warp) {
        result.frame = shear_warp_->render(scene, plan, job, result.build["visible"]);
    } else if (opencl_) {
        result = opencl_->render(scene, plan, job, count);
    } else {
        result.frame = render_reference(scene, plan, job);
        result.frame.ms = watch.ms();
    }
    if (!scene.effects.empty()) {
        const Stopwatch effects_watch;
        apply_effects(scene, result.frame, job);
        result.frame.ms += effects_watch.ms();
    }
    for (const Highlight& highlight : scene.highlights) draw_highlight(scene, highlight, result.frame, job);
    return result;
}

std::string Engine::device_name() const {
    return device_ ? device_->info().name : "reference renderer (no OpenCL device)";
}

std::size_t Engine::bytes_held() const {
    std::lock_guard lock(mutex_);
    return shear_warp_->bytes_held() + (opencl_ ? opencl_->bytes_held() : 0);
}

void Engine::drop_caches() {
    std::lock_guard lock(mutex_);
    shear_warp_->drop();
    if (opencl_) opencl_->drop_caches();
}

}  // namespace lacuna
