#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/base/job.h"
#include "core/compute/device.h"
#include "core/compute/program.h"
#include "core/render/engine.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/render/structure_cache.h"
#include "core/render/transfer_tables.h"

namespace lacuna {

class BrickStream;
class BrickView;
class DeviceVolume;
struct BrickIndex;
struct BrickState;
struct PixelRect;

/// Runs the ray-casting kernels on one device: iso, EA and the MIP family, by any structure that serves them. Keeps the
/// volume on the device and the structures built from it until another volume comes. Not thread-safe: one frame at a
/// time (Engine sees to that).
class OpenClRenderer {
public:
    /// How the kernels are written; no picture depends on it.
    /// @param lanes   rays a work-item: 16 or 1; 0 takes 16 on CPU devices, else 1
    /// @param blocks  16 rays may sample from copies of the voxels around them (kernels/include/block.clh)
    explicit OpenClRenderer(std::shared_ptr<ComputeDevice> device, int lanes = 0, bool blocks = true);
    ~OpenClRenderer();

    /// @pre check(scene) and check(plan, scene) passed; the mode is not shear_warp
    /// @param count  run the counting variant of the kernel and fill the frame's counters
    RenderResult render(const Scene& scene, const Plan& plan, const JobContext& job, bool count);

    /// What is known of a volume that will be drawn brick by brick.
    void adopt(std::shared_ptr<const BrickIndex> index) { index_ = std::move(index); }

    std::size_t bytes_held() const;
    void drop_caches();

private:
    struct Tables;
    struct Output;
    struct Classes;
    struct Cast;
    struct Caster;

    void hold_volume(const Volume& volume);
    void hold_classes(const Scene& scene);
    void make_tables(const Scene& scene, double step_mm);
    bool takes_blocks(const Scene& scene, const Plan& plan, const BoundStructure& structure, bool tiles) const;
    Caster& caster(const Scene& scene, const Plan& plan, const BoundStructure& structure, bool count, bool tiles);
    void hold_bricks(const Scene& scene, const Plan& plan);
    void hold_output(glm::ivec2 padded, bool count);
    void hold_counters(std::size_t pixels, bool count);
    Frame cast_in_place(const Cast& cast, const RayParams& params);
    Counters read_counters();
    const cl::Buffer& colors_and_opacities();
    void bind(Caster& caster, const Cast& cast, const RayParams& params);
    void run_bands(Caster& caster, const PixelRect& rect, const JobContext& job, int* height = nullptr);
    void run_tiles(cl::Kernel& kernel, int tiles, const JobContext& job);
    Frame read_frame(glm::ivec2 size);
    /// Casts the picture, or the tiles of a list, through whole volume or bricks, into the output held.
    void cast(const Cast& cast, const RayParams& params, const cl::Buffer* tiles, int tile_count);
    void cast_bricks(const Cast& cast, const RayParams& params, const cl::Buffer* tiles, int tile_count);
    void begin_carrying();
    void cast_brick(const Cast& cast, RayParams params, std::int64_t brick, const BrickState& state,
                    const PixelRect& rect, const cl::Buffer* tiles, int tile_count);
    std::uint64_t count_rays(const Cast& cast, const RayParams& params, glm::ivec2 size);
    bool is_hidden(const BrickView& view, std::int64_t brick, const PixelRect& rect, const Cast& cast);
    Frame cast_picture(const Cast& cast, RayParams params, glm::ivec2 size);
    void cast_tiles(const Cast& cast, RayParams params, std::vector<glm::ivec2> tiles, Frame& frame);
    Frame cast_sparsely(const Cast& cast, const RayParams& params);

    std::shared_ptr<ComputeDevice> device_;
    ProgramLibrary library_;
    StructureCache structures_;
    int lanes_;
    bool blocks_;
    std::map<std::string, Caster> casters_;
    std::unique_ptr<DeviceVolume> volume_;  ///< of the volume held whole
    std::unique_ptr<BrickStream> bricks_;   ///< or in bricks
    std::shared_ptr<const BrickIndex> index_;
    std::unique_ptr<Tables> tables_;
    std::unique_ptr<Output> output_;
    std::unique_ptr<Classes> classes_;
    cl::Buffer constants_, whole_constants_, brick_constants_, carry_;
    int brick_band_ = 1;     ///< height of bands, in groups, that a brick's launch starts with
    cl_uint tiles_arg_ = 0;  ///< of the kernel bound last: where a tile list goes
};

}  // namespace lacuna
