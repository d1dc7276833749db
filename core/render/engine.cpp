#include "core/render/engine.h"

#include <chrono>
#include <mutex>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "core/base/stopwatch.h"
#include "core/render/brick_plan.h"
#include "core/render/highlight.h"
#include "core/render/opencl_renderer.h"
#include "core/render/reference_renderer.h"
#include "core/render/shear_warp.h"

namespace lacuna {

namespace {

/// Every frame takes and frees pictures of some megabytes. The C library would give each back to the system and have
/// the next made of fresh pages, which takes longer than an effect on it: blocks up to a 2048^2 picture's depth stay at
/// hand, 96 MiB of free memory at the most. Volumes and bricks have pages of their own (VoxelBuffer).
void keep_pictures_at_hand() {
#ifdef __GLIBC__
    static std::once_flag once;
    std::call_once(once, [] {
        mallopt(M_MMAP_THRESHOLD, 16 << 20);
        mallopt(M_TRIM_THRESHOLD, 96 << 20);
    });
#endif
}

}  // namespace

Engine::Engine(std::shared_ptr<ComputeDevice> device, bool blocks)
    : device_(std::move(device)), shear_warp_(std::make_unique<ShearWarpRenderer>()) {
    keep_pictures_at_hand();
    if (device_) opencl_ = std::make_unique<OpenClRenderer>(device_, 0, blocks);
}

Engine::~Engine() = default;

namespace {

/// What needs all voxels at hand.
void refuse_outside_memory(const Scene& scene, bool has_device) {
    if (scene.volume.in_memory()) return;
    const auto refuse = [](const std::string& what) {
        throw Error(Errc::unsupported, what +
                                           " needs the whole volume in memory, and this one is read in parts; "
                                           "raise --memory-limit or leave it out.");
    };
    if (scene.mode == ViewMode::shear_warp) refuse("Shear-warp");
    if (!has_device) refuse("The reference renderer, used where no OpenCL device works,");
    for (const Effect& effect : scene.effects)
        if (effect.kind == EffectKind::ao) refuse("The effect 'ao'");
}

void draw_highlights(const Scene& scene, Frame& frame, const JobContext& job) {
    for (const Highlight& highlight : scene.highlights) draw_highlight(scene, highlight, frame, job);
}

}  // namespace

/// Counts anew what is held, however the work under the engine's lock ends.
struct Engine::CountsBytes {
    Engine& engine;
    void now() const {
        engine.bytes_held_ =
            engine.shear_warp_->bytes_held() + (engine.opencl_ ? engine.opencl_->bytes_held() : std::size_t(0));
    }
    ~CountsBytes() { now(); }
};

Plan Engine::fitted(const Plan& plan, const Scene& scene) const {
    refuse_outside_memory(scene, device_ != nullptr);
    if (!opencl_ || scene.mode == ViewMode::shear_warp) return plan;
    MemoryBudget budget;
    budget.total = memory_limit_ ? memory_limit_ : default_memory_limit();
    budget.device_allocation = device_->info().max_allocation_bytes;
    budget.device_total = device_->unified_memory() ? 0 : device_->info().memory_bytes;
    return with_bricks(plan, scene, budget);
}

void Engine::adopt(std::shared_ptr<const BrickIndex> index) {
    std::lock_guard lock(mutex_);
    if (opencl_) opencl_->adopt(std::move(index));
}

RenderResult Engine::render(const Scene& scene, const Plan& asked, const JobContext& job, bool count,
                            const FramePreview& preview) {
    check(scene);
    check(asked, scene);
    const Plan plan = asked.brick > 0 && asked.brick_bytes > 0 ? asked : fitted(asked, scene);
    std::unique_lock lock(mutex_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(10))) job.check();
    job.check();

    const CountsBytes counts_bytes{*this};
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
        counts_bytes.now();  // pictures on the way are told with it
        const Stopwatch effects_watch;
        const auto on_the_way = [&](Frame frame) {
            draw_highlights(scene, frame, job);
            frame.ms += effects_watch.ms();
            preview(std::move(frame));
        };
        apply_effects(scene, result.frame, job, preview ? FramePreview(on_the_way) : nullptr);
        result.frame.ms += effects_watch.ms();
    }
    draw_highlights(scene, result.frame, job);
    return result;
}

std::string Engine::device_name() const {
    return device_ ? device_->info().name : "reference renderer (no OpenCL device)";
}

void Engine::drop_caches() {
    std::lock_guard lock(mutex_);
    const CountsBytes counts_bytes{*this};
    shear_warp_->drop();
    if (opencl_) opencl_->drop_caches();
}

}  // namespace lacuna
