#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/job.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/scene.h"

namespace lacuna {

class ComputeDevice;
struct BrickIndex;
class OpenClRenderer;
class ShearWarpRenderer;

/// What it took to build the structures the last frame used.
struct BuildRecord {
    double ms = 0;  ///< 0 when the cached one served
    std::size_t bytes = 0;
};

struct RenderResult {
    Frame frame;
    std::map<std::string, BuildRecord> build;  ///< by structure name; of bricks all together
    std::optional<BrickCounts> bricks;         ///< only where the plan cut the volume into bricks
};

/// Executes plans: the one door to all renderers. Holds the device and the cached structures. Thread-safe: one frame
/// at a time, others wait; a waiting or running frame whose job is stopped ends within 30 ms as Error(cancelled).
class Engine {
public:
    /// @param device  none: iso, EA and the MIP family run on the reference renderer
    /// @param blocks  as OpenClRenderer's: off, methods compare by themselves
    explicit Engine(std::shared_ptr<ComputeDevice> device, bool blocks = true);
    ~Engine();

    /// @param count  fill the frame's counters (costs time)
    /// @param preview  gets pictures on the way where an effect takes long (apply_effects), on the calling thread
    /// @throws Error(bad_usage) if check(scene) or check(plan, scene) does; Error(cancelled), Error(out_of_memory)
    RenderResult render(const Scene& scene, const Plan& plan, const JobContext& job = {}, bool count = false,
                        const FramePreview& preview = nullptr);

    /// The plan with bricks where the volume needs them (with_bricks), as render() would add them itself.
    /// @throws Error(out_of_memory), and Error(unsupported) for what cannot be drawn of a volume not in memory
    Plan fitted(const Plan& plan, const Scene& scene) const;
    /// Bytes of host and device memory to stay within; 0: 75 % of the machine's.
    void set_memory_limit(std::uint64_t bytes) { memory_limit_ = bytes; }
    /// Makes known what was already learnt of a volume, so that its bricks need not be gone through again.
    void adopt(std::shared_ptr<const BrickIndex> index);

    /// "pthread-AMD EPYC ..." or "reference renderer (no OpenCL device)".
    std::string device_name() const;
    /// Bytes held by cached structures and device copies after the last frame; answers at once while one is drawn.
    std::size_t bytes_held() const { return bytes_held_; }
    /// Drops all cached structures and device copies.
    void drop_caches();

private:
    struct CountsBytes;

    std::shared_ptr<ComputeDevice> device_;
    std::unique_ptr<OpenClRenderer> opencl_;
    std::unique_ptr<ShearWarpRenderer> shear_warp_;
    std::uint64_t memory_limit_ = 0;
    std::atomic<std::size_t> bytes_held_ = 0;
    std::timed_mutex mutex_;
};

}  // namespace lacuna
