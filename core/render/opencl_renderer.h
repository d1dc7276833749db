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

class DeviceVolume;

/// Runs the ray-casting kernels on one device: iso, EA and the MIP family, by any structure that serves them. Keeps the
/// volume on the device and the structures built from it until another volume comes. Not thread-safe: one frame at a
/// time (Engine sees to that).
class OpenClRenderer {
public:
    /// @param lanes  rays a work-item: 16 or 1; 0 takes 16 on CPU devices, else 1
    explicit OpenClRenderer(std::shared_ptr<ComputeDevice> device, int lanes = 0);
    ~OpenClRenderer();

    /// @pre check(scene) and check(plan, scene) passed; the mode is not shear_warp
    /// @param count  run the counting variant of the kernel and fill the frame's counters
    RenderResult render(const Scene& scene, const Plan& plan, const JobContext& job, bool count);

    std::size_t bytes_held() const;
    void drop_caches();

private:
    struct Tables;
    struct Output;
    struct Classes;
    struct Cast;

    void hold_volume(const Volume& volume);
    void hold_classes(const Scene& scene);
    void make_tables(const Scene& scene, double step_mm);
    cl::Kernel& kernel(const Scene& scene, const Plan& plan, const BoundStructure& structure, bool count, bool tiles);
    void hold_output(glm::ivec2 padded, bool count);
    Counters read_counters();
    void bind(cl::Kernel& kernel, const Cast& cast, const RayParams& params);
    void run_bands(cl::Kernel& kernel, glm::ivec2 padded, const JobContext& job);
    void run_tiles(cl::Kernel& kernel, int tiles, const JobContext& job);
    Frame read_frame(glm::ivec2 size);
    Frame cast_picture(const Cast& cast, RayParams params, glm::ivec2 size);
    void cast_tiles(const Cast& cast, RayParams params, std::vector<glm::ivec2> tiles, Frame& frame);
    Frame cast_sparsely(const Cast& cast, const RayParams& params);

    std::shared_ptr<ComputeDevice> device_;
    ProgramLibrary library_;
    StructureCache structures_;
    int lanes_;
    std::map<std::string, cl::Kernel> kernels_;
    std::unique_ptr<DeviceVolume> volume_;
    std::unique_ptr<Tables> tables_;
    std::unique_ptr<Output> output_;
    std::unique_ptr<Classes> classes_;
    cl::Buffer constants_;
    cl_uint tiles_arg_ = 0;  ///< of the kernel bound last: where a tile list goes
};

}  // namespace lacuna
