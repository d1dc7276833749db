#include "core/render/opencl_renderer.h"

#include <algorithm>
#include <array>

#include "core/base/stopwatch.h"
#include "core/compute/bands.h"
#include "core/compute/buffers.h"
#include "core/compute/device_error.h"
#include "core/render/device_volume.h"
#include "core/render/ray_params.h"
#include "core/render/sparse_casting.h"

namespace lacuna {

namespace {

constexpr int k_group_pixels = 16;         // a work-group covers 16x16 pixels
constexpr int k_tiles_a_group = 16;        // or so many 4x4 tiles of a list
constexpr cl_uint k_first_row_arg = 2;     // of every ray-casting kernel
constexpr double k_depth_step_pixels = 4;  // sparse casting: steeper than this between cast pixels is an edge

bool needs_tables(const Scene& scene) { return scene.mode != ViewMode::iso; }

int round_up(int n, int to) { return (n + to - 1) / to * to; }

}  // namespace

struct OpenClRenderer::Tables {
    Classification classification;
    std::vector<TransferFunction> of_regions;
    double step_mm = 0;
    TransferTables host;
    cl::Buffer opacity, color, gradient;
};

/// The region classes of the view drawn last; keeps the bytes alive while the device reads them.
struct OpenClRenderer::Classes {
    std::shared_ptr<const std::vector<std::uint8_t>> of_voxel;
    cl::Buffer buffer;
};

/// Grows to the largest picture cast, so that the two passes of sparse casting share it without allocating anew.
struct OpenClRenderer::Output {
    std::size_t capacity = 0;  // pixels
    glm::ivec2 padded{0};      // of the picture cast last
    cl::Buffer color, depth, counters;
};

OpenClRenderer::OpenClRenderer(std::shared_ptr<ComputeDevice> device, int lanes)
    : device_(device),
      library_(device),
      structures_(device),
      lanes_(lanes ? lanes : (device->info().is_cpu ? 16 : 1)) {}

OpenClRenderer::~OpenClRenderer() = default;

std::size_t OpenClRenderer::bytes_held() const {
    std::size_t bytes = structures_.bytes();
    if (volume_) bytes += volume_->extra_bytes();
    if (output_) bytes += output_->capacity * (sizeof(glm::vec4) + sizeof(float));
    return bytes;
}

void OpenClRenderer::drop_caches() {
    structures_.drop();
    volume_.reset();
    tables_.reset();
    classes_.reset();
    output_.reset();
}

void OpenClRenderer::hold_volume(const Volume& volume) {
    if (volume_ && volume_->holds(volume)) return;
    structures_.hold(volume);
    tables_.reset();  // how fine they are depends on the voxel type
    volume_.reset();  // the old one goes before the new one needs the memory
    volume_ = std::make_unique<DeviceVolume>(*device_, volume);
}

void OpenClRenderer::make_tables(const Scene& scene, double step_mm) {
    if (tables_ && tables_->step_mm == step_mm && tables_->classification == scene.classification &&
        tables_->of_regions == scene.regions.functions)
        return;
    auto next = std::make_unique<Tables>();
    next->classification = scene.classification;
    next->step_mm = step_mm;
    next->of_regions = scene.regions.functions;
    next->host = make_transfer_tables(scene.classification, scene.volume.type(), step_mm, next->of_regions);
    const TransferTables& host = next->host;
    const auto upload = [&](const auto& values) {
        return uploaded_buffer(*device_, values.data(), values.size() * sizeof(values[0]));
    };
    next->opacity = upload(host.opacity);
    next->color = upload(host.color);
    if (host.uses_gradient) next->gradient = upload(host.gradient_factor);
    tables_ = std::move(next);
}

void OpenClRenderer::hold_classes(const Scene& scene) {
    if (!scene.regions) {
        classes_.reset();
        return;
    }
    if (classes_ && classes_->of_voxel == scene.regions.of_voxel) return;
    classes_.reset();
    const std::vector<std::uint8_t>& bytes = *scene.regions.of_voxel;
    classes_ =
        std::make_unique<Classes>(Classes{scene.regions.of_voxel, device_buffer(*device_, bytes.data(), bytes.size())});
}

cl::Kernel& OpenClRenderer::kernel(const Scene& scene, const Plan& plan, const BoundStructure& structure, bool count,
                                   bool tiles) {
    std::string source = "render/raycast_mip.cl", name = "raycast_mip", extra;
    const bool classes = bool(scene.regions);
    if (structure.own_kernel) {
        source = "render/" + *structure.own_kernel + ".cl", name = *structure.own_kernel;
    } else if (scene.mode == ViewMode::iso) {
        source = "render/raycast_iso.cl", name = "raycast_iso";
    } else if (scene.mode == ViewMode::ea) {
        source = "render/raycast_ea.cl", name = "raycast_ea";
        extra = std::string(" -DLACUNA_GRADIENT_OPACITY=") + (tables_->host.uses_gradient ? "1" : "0");
    } else {
        const int projection = scene.mode == ViewMode::mip     ? 0
                               : scene.mode == ViewMode::minip ? 1
                               : scene.mode == ViewMode::mean  ? 2
                                                               : 3;
        extra = " -DLACUNA_PROJECTION=" + std::to_string(projection);
    }
    const std::string options =
        "-DLACUNA_LANES=" + std::to_string(lanes_) + " -DLACUNA_VOXEL=" + std::to_string(int(scene.volume.type())) +
        " -DLACUNA_SAMPLER=" + (plan.sampler == Sampler::linear ? "1" : "0") +
        " -DLACUNA_STRUCTURE=" + std::to_string(structure.kernel_id) + " -DLACUNA_RUNS=" +
        (structure.runs && scene.mode == ViewMode::ea && (!classes || structure.runs_of_class) ? "1" : "0") +
        " -DLACUNA_CLASSES=" + (classes && !structure.own_kernel ? "1" : "0") +
        " -DLACUNA_RANGES=" + (scene.classification.ranges.empty() ? "0" : "1") +
        " -DLACUNA_TILES=" + (tiles ? "1" : "0") + " -DLACUNA_COUNT=" + (count ? "1" : "0") + extra + structure.options;
    const std::string key = name + options;
    auto found = kernels_.find(key);
    if (found == kernels_.end()) found = kernels_.emplace(key, library_.kernel(source, name, options)).first;
    return found->second;
}

void OpenClRenderer::run_bands(cl::Kernel& kernel, glm::ivec2 padded, const JobContext& job) {
    const int packet = lanes_ == 16 ? 4 : 1, group = lanes_ == 16 ? 4 : 8;
    run_in_bands(
        *device_, padded.y, k_group_pixels,
        [&](int first, int count, cl::Event& done) {
            kernel.setArg(k_first_row_arg, cl_int(first));
            device_->queue().enqueueNDRangeKernel(
                kernel, cl::NullRange, cl::NDRange(std::size_t(padded.x / packet), std::size_t(count / packet)),
                cl::NDRange(std::size_t(group), std::size_t(group)), nullptr, &done);
        },
        job);
}

void OpenClRenderer::run_tiles(cl::Kernel& kernel, int tiles, const JobContext& job) {
    const std::size_t items = 16 / std::size_t(lanes_);  // a tile
    run_in_bands(
        *device_, tiles, k_tiles_a_group,
        [&](int first, int count, cl::Event& done) {
            kernel.setArg(k_first_row_arg, cl_int(first));
            device_->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items, std::size_t(count)),
                                                  cl::NDRange(items, std::size_t(k_tiles_a_group)), nullptr, &done);
        },
        job);
}

Frame OpenClRenderer::read_frame(glm::ivec2 size) {
    Frame frame;
    frame.size = size;
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels());
    const auto read = [&](const cl::Buffer& buffer, void* target, std::size_t pixel) {
        const std::array<std::size_t, 3> origin{0, 0, 0};
        const std::array<std::size_t, 3> region{std::size_t(size.x) * pixel, std::size_t(size.y), 1};
        device_->queue().enqueueReadBufferRect(buffer, CL_TRUE, origin, origin, region,
                                               std::size_t(output_->padded.x) * pixel, 0, std::size_t(size.x) * pixel,
                                               0, target);
    };
    read(output_->color, frame.color.data(), sizeof(glm::vec4));
    read(output_->depth, frame.depth_mm.data(), sizeof(float));
    return frame;
}

void OpenClRenderer::hold_output(glm::ivec2 padded, bool count) {
    const std::size_t pixels = std::size_t(padded.x) * std::size_t(padded.y);
    if (!output_ || output_->capacity < pixels)
        output_ = std::make_unique<Output>(Output{pixels,
                                                  padded,
                                                  scratch_buffer(*device_, pixels * sizeof(glm::vec4)),
                                                  scratch_buffer(*device_, pixels * sizeof(float)),
                                                  {}});
    output_->padded = padded;
    if (!count) return;
    const std::size_t item = sizeof(cl_uint4), lanes = std::size_t(lanes_);
    if (!output_->counters()) output_->counters = scratch_buffer(*device_, output_->capacity / lanes * item);
    // Packets beyond the picture write none.
    device_->queue().enqueueFillBuffer(output_->counters, cl_uint(0), 0, pixels / lanes * item);
}

Counters OpenClRenderer::read_counters() {
    std::vector<cl_uint4> items(std::size_t(output_->padded.x) * std::size_t(output_->padded.y) / std::size_t(lanes_));
    read_values(*device_, output_->counters, std::span<cl_uint4>(items));
    Counters sum;
    for (const cl_uint4& item : items) {
        sum.rays += item.s[0];
        sum.samples += item.s[1];
        sum.skipped += item.s[2];
        sum.structure_reads += item.s[3];
    }
    return sum;
}

/// What the frames of one call have in common.
struct OpenClRenderer::Cast {
    const Scene& scene;
    const Plan& plan;
    const TransferTables* tables;
    const BoundStructure& structure;
    const JobContext& job;
    bool count;
};

void OpenClRenderer::bind(cl::Kernel& kernel, const Cast& cast, const RayParams& params) {
    // A kernel does not keep its arguments alive: the member does, until the next frame is bound.
    constants_ = cl::Buffer(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof params,
                            const_cast<RayParams*>(&params));
    const bool ea = cast.scene.mode == ViewMode::ea;
    cl_uint arg = 0;
    kernel.setArg(arg++, cast.structure.volume() ? cast.structure.volume : volume_->voxels());
    kernel.setArg(arg++, constants_);
    kernel.setArg(arg++, cl_int(0));  // first row or tile: set for each launch
    if (ea) kernel.setArg(arg++, tables_->opacity);
    if (cast.tables) kernel.setArg(arg++, tables_->color);
    kernel.setArg(arg++, output_->color);
    kernel.setArg(arg++, output_->depth);
    if (ea && cast.tables->uses_gradient) kernel.setArg(arg++, tables_->gradient);
    if (cast.scene.regions && !cast.structure.own_kernel) kernel.setArg(arg++, classes_->buffer);
    for (const cl::Buffer& buffer : cast.structure.buffers) kernel.setArg(arg++, buffer);
    if (cast.count) kernel.setArg(arg++, output_->counters);
    tiles_arg_ = arg;
}

Frame OpenClRenderer::cast_picture(const Cast& cast, RayParams params, glm::ivec2 size) {
    const glm::ivec2 padded(round_up(size.x, k_group_pixels), round_up(size.y, k_group_pixels));
    params.width = size.x;
    params.height = size.y;
    params.out_stride = padded.x;
    hold_output(padded, cast.count);
    cl::Kernel& caster = kernel(cast.scene, cast.plan, cast.structure, cast.count, false);
    bind(caster, cast, params);
    run_bands(caster, padded, cast.job);
    Frame frame = read_frame(size);
    if (cast.count) frame.counters = read_counters();
    return frame;
}

void OpenClRenderer::cast_tiles(const Cast& cast, RayParams params, std::vector<glm::ivec2> tiles, Frame& frame) {
    if (tiles.empty()) return;
    const std::size_t wanted = tiles.size();
    while (tiles.size() % k_tiles_a_group) tiles.push_back({0, frame.size.y});  // below the picture: casts nothing
    const glm::ivec2 padded(round_up(frame.size.x, k_group_pixels), round_up(frame.size.y, k_group_pixels));
    params.out_stride = padded.x;
    hold_output(padded, cast.count);
    cl::Kernel& caster = kernel(cast.scene, cast.plan, cast.structure, cast.count, true);
    bind(caster, cast, params);
    cl::Buffer list(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, tiles.size() * sizeof(glm::ivec2),
                    tiles.data());
    caster.setArg(tiles_arg_, list);
    run_tiles(caster, int(tiles.size()), cast.job);
    const Frame again = read_frame(frame.size);
    for (std::size_t i = 0; i < wanted; ++i)
        for (int y = tiles[i].y; y < std::min(tiles[i].y + 4, frame.size.y); ++y)
            for (int x = tiles[i].x; x < std::min(tiles[i].x + 4, frame.size.x); ++x) {
                const std::size_t at = std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x);
                frame.color[at] = again.color[at];
                frame.depth_mm[at] = again.depth_mm[at];
            }
    if (cast.count) frame.counters += read_counters();
}

Frame OpenClRenderer::cast_sparsely(const Cast& cast, const RayParams& params) {
    const SparseGrid grid{cast.plan.sparse, cast.scene.size};
    RayParams coarse = params;
    for (int a = 0; a < 3; ++a) {
        const auto k = s_float(grid.k);
        coarse.origin_dx[a] *= k;
        coarse.origin_dy[a] *= k;
        coarse.dir_dx[a] *= k;
        coarse.dir_dy[a] *= k;
    }
    const Frame every_kth = cast_picture(cast, coarse, grid.size());
    Frame frame = interpolate(every_kth, grid);
    frame.counters = every_kth.counters;
    const double pixel_mm = resolve(cast.scene.camera, cast.scene.volume.geometry(), cast.scene.size).pixel_mm;
    cast_tiles(cast, params,
               tiles_to_recast(every_kth, grid, cast.plan.sparse_gradient, k_depth_step_pixels * grid.k * pixel_mm),
               frame);
    return frame;
}

RenderResult OpenClRenderer::render(const Scene& scene, const Plan& plan, const JobContext& job, bool count) {
    return with_device_errors("rendering", [&] {
        RenderResult result;
        hold_volume(scene.volume);
        if (needs_tables(scene)) make_tables(scene, plan.step * scene.volume.geometry().smallest_spacing_mm());
        const TransferTables* tables = needs_tables(scene) ? &tables_->host : nullptr;
        hold_classes(scene);
        RayParams params = make_ray_params(scene, plan, volume_->stored_size(), tables);
        const BoundStructure structure = structures_.prepare(scene, plan, tables, params, result.build, job);
        const Cast cast{scene, plan, tables, structure, job, count};
        kernel(scene, plan, structure, count, false);  // compiled before the clock starts
        if (plan.sparse >= 2) kernel(scene, plan, structure, count, true);

        const Stopwatch watch;
        result.frame = plan.sparse >= 2 ? cast_sparsely(cast, params) : cast_picture(cast, params, scene.size);
        result.frame.ms = watch.ms();
        return result;
    });
}

}  // namespace lacuna
