#include "core/render/opencl_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "core/base/stopwatch.h"
#include "core/compute/bands.h"
#include "core/compute/buffers.h"
#include "core/compute/device_error.h"
#include "core/render/brick_plan.h"
#include "core/render/brick_stream.h"
#include "core/render/brick_view.h"
#include "core/render/device_volume.h"
#include "core/render/ray_params.h"
#include "core/render/sparse_casting.h"
#include "core/render/sparse_cells.h"

namespace lacuna {

namespace {

constexpr int k_group_pixels = 16;      // a work-group covers 16x16 pixels
constexpr int k_band_pixels = 32;       // rows that are cast together, where there are as many: two of work-groups
constexpr int k_tiles_a_group = 16;     // or so many 4x4 tiles of a list
constexpr cl_uint k_first_row_arg = 2;  // of every ray-casting kernel

bool needs_tables(const Scene& scene) { return scene.mode != ViewMode::iso; }

int round_up(int n, int to) { return (n + to - 1) / to * to; }

}  // namespace

struct OpenClRenderer::Tables {
    Classification classification;
    std::vector<TransferFunction> of_regions;
    double step_mm = 0;
    TransferTables host;
    cl::Buffer opacity, color, gradient, shapes;
    cl::Buffer
        color_opacity;  // red, green, blue, opacity an entry, as floats: for kernels with blocks, made when asked for
};

/// A kernel ready to be given its arguments.
struct OpenClRenderer::Caster {
    cl::Kernel kernel;
    bool blocks = false;  // a work-item casts 16x16 pixels, from blocks
};

/// The region classes of the view drawn last; keeps the bytes alive while the device reads them.
struct OpenClRenderer::Classes {
    std::shared_ptr<const std::vector<std::uint8_t>> of_voxel;
    cl::Buffer buffer;
};

/// Grows to the largest picture cast, so that the two passes of sparse casting share it without allocating anew.
struct OpenClRenderer::Output {
    std::size_t capacity = 0;  // pixels; 0: a frame's own memory, for that frame alone
    glm::ivec2 padded{0};      // of the picture cast last
    cl::Buffer color, depth, counters;
};

OpenClRenderer::OpenClRenderer(std::shared_ptr<ComputeDevice> device, int lanes, bool blocks)
    : device_(device),
      library_(device),
      structures_(device),
      lanes_(lanes ? lanes : (device->info().is_cpu ? 16 : 1)),
      blocks_(blocks && lanes_ == 16) {}

OpenClRenderer::~OpenClRenderer() = default;

std::size_t OpenClRenderer::bytes_held() const {
    std::size_t bytes = structures_.bytes();
    if (volume_) bytes += volume_->extra_bytes();
    if (bricks_) bytes += bricks_->bytes();
    if (output_) bytes += output_->capacity * (sizeof(glm::vec4) + sizeof(float));
    return bytes;
}

void OpenClRenderer::drop_caches() {
    structures_.drop();
    volume_.reset();
    bricks_.reset();
    tables_.reset();
    classes_.reset();
    output_.reset();
}

void OpenClRenderer::hold_volume(const Volume& volume) {
    if (volume_ && volume_->holds(volume)) return;
    structures_.hold(volume);
    tables_.reset();  // how fine they are depends on the voxel type
    volume_.reset();  // the old one goes before the new one needs the memory
    bricks_.reset();
    volume_ = std::make_unique<DeviceVolume>(*device_, volume);
}

void OpenClRenderer::hold_bricks(const Scene& scene, const Plan& plan) {
    const BrickGrid grid(scene.volume.geometry().size, plan.brick, ghost_voxels(scene, plan));
    if (bricks_ && bricks_->serves(scene.volume, grid)) return;
    structures_.drop();
    tables_.reset();
    volume_.reset();
    bricks_.reset();
    bricks_ = std::make_unique<BrickStream>(device_, scene.volume, grid, index_);
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
    if (!host.shapes.empty()) next->shapes = upload(host.shapes);
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

/// Where the kernels with blocks serve: trilinear samples of whole numbers in the modes that take most of them.
bool OpenClRenderer::takes_blocks(const Scene& scene, const Plan& plan, const BoundStructure& structure,
                                  bool tiles) const {
    constexpr int k_least_row = 8, k_macrocells = 1, k_leap = 5;  // voxels copied at once; of LACUNA_STRUCTURE
    if (!blocks_ || tiles || plan.brick > 0 || scene.regions || structure.volume() || structure.own_kernel)
        return false;
    if (scene.volume.type() == VoxelType::f32 || plan.sampler != Sampler::linear) return false;
    if (scene.volume.geometry().size.x < k_least_row) return false;
    if (scene.mode == ViewMode::mip || scene.mode == ViewMode::minip) return structure.kernel_id <= k_macrocells;
    return scene.mode == ViewMode::ea && plan.integration == Integration::riemann && !structure.runs &&
           structure.kernel_id < k_leap && plan.gradient == GradientFilter::central &&
           plan.gradient_store == GradientStore::on_the_fly;
}

OpenClRenderer::Caster& OpenClRenderer::caster(const Scene& scene, const Plan& plan, const BoundStructure& structure,
                                               bool count, bool tiles) {
    const bool blocks = takes_blocks(scene, plan, structure, tiles);
    const bool segments = scene.mode == ViewMode::ea && plan.integration == Integration::preintegrated;
    std::string source = "render/raycast_mip.cl", name = "raycast_mip", extra;
    const bool classes = bool(scene.regions);
    if (structure.own_kernel) {
        source = "render/" + *structure.own_kernel + ".cl", name = *structure.own_kernel;
    } else if (scene.mode == ViewMode::iso) {
        const bool exact = plan.refine == Refinement::cubic;
        source = exact ? "render/raycast_cubic.cl" : "render/raycast_iso.cl";
        name = exact ? "raycast_cubic" : "raycast_iso";
    } else if (segments) {
        source = "render/raycast_segments.cl", name = "raycast_segments";
    } else if (scene.mode == ViewMode::ea) {
        source = "render/raycast_ea.cl", name = "raycast_ea";
        extra = std::string(" -DLACUNA_GRADIENT_OPACITY=") + (tables_->host.uses_gradient ? "1" : "0") +
                (tables_->host.shapes.empty() ? "" : " -DLACUNA_SHAPES=1");
    } else {
        const int projection = scene.mode == ViewMode::mip     ? 0
                               : scene.mode == ViewMode::minip ? 1
                               : scene.mode == ViewMode::mean  ? 2
                                                               : 3;
        extra = " -DLACUNA_PROJECTION=" + std::to_string(projection);
    }
    if (blocks) {
        name += "_blocks";
        source = "render/" + name + ".cl";
    }
    const std::string options =
        "-DLACUNA_LANES=" + std::to_string(lanes_) + " -DLACUNA_VOXEL=" + std::to_string(int(scene.volume.type())) +
        " -DLACUNA_SAMPLER=" + std::to_string(int(plan.sampler)) +
        " -DLACUNA_STRUCTURE=" + std::to_string(structure.kernel_id) + " -DLACUNA_RUNS=" +
        (structure.runs && scene.mode == ViewMode::ea && !segments && (!classes || structure.runs_of_class) ? "1"
                                                                                                            : "0") +
        " -DLACUNA_CLASSES=" + (classes && !structure.own_kernel ? "1" : "0") +
        " -DLACUNA_RANGES=" + (scene.classification.ranges.empty() ? "0" : "1") +
        " -DLACUNA_TILES=" + (tiles ? "1" : "0") + " -DLACUNA_COUNT=" + (count ? "1" : "0") + extra +
        structure.options + (plan.brick > 0 ? " -DLACUNA_CARRY=1" : "");
    const std::string key = name + options;
    auto found = casters_.find(key);
    if (found == casters_.end())
        found = casters_.emplace(key, Caster{library_.kernel(source, name, options), blocks}).first;
    return found->second;
}

void OpenClRenderer::run_bands(Caster& caster, const PixelRect& rect, const JobContext& job, int* height) {
    constexpr double k_band_ms = 8;
    const int item = caster.blocks ? k_group_pixels : lanes_ == 16 ? 4 : 1;  // pixels across and down
    const int group = caster.blocks ? 1 : lanes_ == 16 ? 4 : 8;
    cl::Kernel& kernel = caster.kernel;
    run_in_bands(
        *device_, rect.size().y, k_band_pixels,
        [&](int first, int count, cl::Event& done) {
            kernel.setArg(k_first_row_arg, cl_int(rect.first.y + first));
            device_->queue().enqueueNDRangeKernel(
                kernel, cl::NullRange, cl::NDRange(std::size_t(rect.size().x / item), std::size_t(count / item)),
                cl::NDRange(std::size_t(group), std::size_t(group)), nullptr, &done);
        },
        job, k_band_ms, height);
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
    hold_counters(pixels, count);
}

void OpenClRenderer::hold_counters(std::size_t pixels, bool count) {
    if (!count) return;
    const std::size_t item = sizeof(cl_uint8), lanes = std::size_t(lanes_);
    if (!output_->counters())
        output_->counters = scratch_buffer(*device_, std::max(output_->capacity, pixels) / lanes * item);
    // Packets beyond the picture write none.
    device_->queue().enqueueFillBuffer(output_->counters, cl_uint(0), 0, pixels / lanes * item);
}

Counters OpenClRenderer::read_counters() {
    std::vector<cl_uint8> items(std::size_t(output_->padded.x) * std::size_t(output_->padded.y) / std::size_t(lanes_));
    read_values(*device_, output_->counters, std::span<cl_uint8>(items));
    Counters sum;
    for (const cl_uint8& item : items) {
        sum.rays += item.s[0];
        sum.samples += item.s[1];
        sum.skipped += item.s[2];
        sum.structure_reads += item.s[3];
        sum.trilinear += item.s[4];
        sum.copied += item.s[5];
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
    const cl::Buffer& voxels;
    std::map<std::string, BuildRecord>* build = nullptr;  ///< of the bricks' structures
};

/// One look-up for both, unpacked as the other kernels do it.
const cl::Buffer& OpenClRenderer::colors_and_opacities() {
    if (tables_->color_opacity()) return tables_->color_opacity;
    const TransferTables& host = tables_->host;
    std::vector<glm::vec4> both(host.color.size());
    for (std::size_t i = 0; i < both.size(); ++i) {
        const std::uint32_t c = host.color[i];
        both[i] = {float(c & 2047) * (1.0f / 2047.0f), float(c >> 11 & 2047) * (1.0f / 2047.0f),
                   float(c >> 22) * (1.0f / 1023.0f), host.opacity[i]};
    }
    tables_->color_opacity = uploaded_buffer(*device_, both.data(), both.size() * sizeof both[0]);
    return tables_->color_opacity;
}

void OpenClRenderer::bind(Caster& caster, const Cast& cast, const RayParams& params) {
    cl::Kernel& kernel = caster.kernel;
    // A kernel does not keep its arguments alive: the member does, until the next frame is bound.
    constants_ = cl::Buffer(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof params,
                            const_cast<RayParams*>(&params));
    const bool ea = cast.scene.mode == ViewMode::ea;
    cl_uint arg = 0;
    kernel.setArg(arg++, cast.structure.volume() ? cast.structure.volume : cast.voxels);
    kernel.setArg(arg++, constants_);
    kernel.setArg(arg++, cl_int(0));  // first row or tile: set for each launch
    if (ea) kernel.setArg(arg++, tables_->opacity);
    if (cast.tables) kernel.setArg(arg++, ea && caster.blocks ? colors_and_opacities() : tables_->color);
    kernel.setArg(arg++, output_->color);
    kernel.setArg(arg++, output_->depth);
    if (ea && cast.tables->uses_gradient) kernel.setArg(arg++, tables_->gradient);
    if (ea && !cast.tables->shapes.empty()) kernel.setArg(arg++, tables_->shapes);
    if (cast.scene.regions && !cast.structure.own_kernel) kernel.setArg(arg++, classes_->buffer);
    for (const cl::Buffer& buffer : cast.structure.buffers) kernel.setArg(arg++, buffer);
    if (cast.count) kernel.setArg(arg++, output_->counters);
    if (cast.plan.brick > 0)
        for (const cl::Buffer& buffer : {whole_constants_, brick_constants_, carry_}) kernel.setArg(arg++, buffer);
    tiles_arg_ = arg;
}

void OpenClRenderer::cast(const Cast& cast, const RayParams& params, const cl::Buffer* tiles, int tile_count) {
    if (cast.plan.brick > 0) return cast_bricks(cast, params, tiles, tile_count);
    Caster& caster = this->caster(cast.scene, cast.plan, cast.structure, cast.count, tiles != nullptr);
    bind(caster, cast, params);
    if (!tiles) return run_bands(caster, {{0, 0}, output_->padded}, cast.job);
    caster.kernel.setArg(tiles_arg_, *tiles);
    run_tiles(caster.kernel, tile_count, cast.job);
}

void OpenClRenderer::begin_carrying() {
    const std::size_t pixels = std::size_t(output_->padded.x) * std::size_t(output_->padded.y);
    const std::size_t bytes = pixels * LACUNA_CARRY_PLANES * sizeof(float);
    if (!carry_() || carry_.getInfo<CL_MEM_SIZE>() < bytes) carry_ = scratch_buffer(*device_, bytes);
    device_->queue().enqueueFillBuffer(carry_, cl_uint(0), 0, bytes);
    device_->queue().enqueueFillBuffer(output_->color, cl_float(0), 0, pixels * sizeof(glm::vec4));
    device_->queue().enqueueFillBuffer(output_->depth, std::numeric_limits<cl_float>::infinity(), 0,
                                       pixels * sizeof(float));
}

/// Whether no ray that meets the brick goes on that far: then it need not be loaded. Asks what is carried of each ray.
bool OpenClRenderer::is_hidden(const BrickView& view, std::int64_t brick, const PixelRect& rect, const Cast& cast) {
    const bool iso = cast.scene.mode == ViewMode::iso;
    if (!iso && cast.scene.mode != ViewMode::ea) return false;
    const int edge = lanes_ == 16 ? 4 : 1;  // of a packet
    const std::size_t packet = std::size_t(LACUNA_CARRY_PLANES) * std::size_t(lanes_);
    const glm::ivec2 first = rect.first / edge, count = (rect.end + (edge - 1)) / edge - first;
    std::vector<float> carried(std::size_t(count.x) * std::size_t(count.y) * packet);
    const std::array<std::size_t, 3> from{std::size_t(first.x) * packet * sizeof(float), std::size_t(first.y), 0};
    const std::array<std::size_t, 3> region{std::size_t(count.x) * packet * sizeof(float), std::size_t(count.y), 1};
    device_->queue().enqueueReadBufferRect(carry_, CL_TRUE, from, {0, 0, 0}, region,
                                           std::size_t(output_->padded.x / edge) * packet * sizeof(float), 0, region[0],
                                           0, carried.data());
    const float least = float(cast.plan.ert);
    const glm::ivec3 at = bricks_->grid().at(brick);
    for (int y = rect.first.y; y < rect.end.y; ++y)
        for (int x = rect.first.x; x < rect.end.x; ++x) {
            const glm::ivec2 place = glm::ivec2(x, y) / edge - first;
            const float* slot = &carried[(std::size_t(place.y) * std::size_t(count.x) + std::size_t(place.x)) * packet];
            const int lane = (y % edge) * edge + x % edge;
            // As the kernels carry it: iso plane 2 says done, ea plane 4 is the transmittance.
            const float state = slot[(iso ? 2 : 4) * lanes_ + lane];
            const bool begun = std::bit_cast<std::int32_t>(slot[0]) != 0;
            const bool done = begun && (iso ? std::bit_cast<std::int32_t>(state) != 0 : !(state >= least && state > 0));
            if (!done && view.meets(at, x, y, 0.5)) return false;
        }
    return true;
}

void OpenClRenderer::cast_brick(const Cast& cast, RayParams params, std::int64_t brick, const BrickState& state,
                                const PixelRect& rect, const cl::Buffer* tiles, int tile_count) {
    BrickStream::Brick& held = bricks_->hold(brick, state, cast.plan.brick_bytes, cast.job);
    Scene part = cast.scene;
    part.volume = held.volume;
    Plan plan = cast.plan;
    if (state.content == BrickContent::uniform) plan.structure = Structure::none;
    put_volume(params, held.volume.geometry().size, held.voxels->stored_size());
    std::map<std::string, BuildRecord> build;
    const BoundStructure structure = held.structures->prepare(part, plan, cast.tables, params, build, cast.job);
    bricks_->settle(brick, cast.plan.brick_bytes);
    for (const auto& [name, made] : build) {
        (*cast.build)[name].ms += made.ms;
        (*cast.build)[name].bytes += made.bytes;
    }
    // Rays are the whole volume's, and so is the rounding of their positions.
    params.exit_margin = exit_margin(cast.scene.volume.geometry().size, plan.step);
    BrickParams place = bricks_->place(brick);
    place.first_x = rect.first.x;
    brick_constants_ = cl::Buffer(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof place, &place);
    const Cast own{part, plan, cast.tables, structure, cast.job, cast.count, held.voxels->voxels()};
    Caster& caster = this->caster(part, plan, structure, cast.count, tiles != nullptr);
    bind(caster, own, params);
    if (tiles) {
        caster.kernel.setArg(tiles_arg_, *tiles);
        run_tiles(caster.kernel, tile_count, cast.job);
    } else {
        run_bands(caster, rect, cast.job, &brick_band_);
    }
    ++bricks_->counts.cast;
}

void OpenClRenderer::cast_bricks(const Cast& cast, const RayParams& params, const cl::Buffer* tiles, int tile_count) {
    begin_carrying();
    whole_constants_ = cl::Buffer(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof params,
                                  const_cast<RayParams*>(&params));
    const std::vector<BrickState>& states =
        bricks_->states(cast.scene, cast.plan, cast.tables, {cast.job.stop, nullptr});
    const BrickView view(bricks_->grid(), params, cast.scene.camera.fov_deg.has_value());
    const std::vector<std::int64_t> order = view.front_to_back();
    BrickCounts& counts = bricks_->counts;
    counts.total = int(order.size());
    counts.empty = counts.hidden = counts.uniform = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const BrickState& state = states[std::size_t(order[i])];
        cast.job.checkpoint(i, order.size());
        counts.empty += state.content == BrickContent::empty;
        if (state.content == BrickContent::empty) continue;
        PixelRect rect = view.pixels_of(bricks_->grid().at(order[i]));
        const bool resident = bricks_->resident(order[i]) || state.content == BrickContent::uniform;
        if (rect.empty() || (!resident && !tiles && is_hidden(view, order[i], rect, cast))) {
            ++counts.hidden;
            continue;
        }
        counts.uniform += state.content == BrickContent::uniform;
        rect.first = rect.first / k_group_pixels * k_group_pixels;
        rect.end = {round_up(rect.end.x, k_group_pixels), round_up(rect.end.y, k_group_pixels)};
        const double n = double(order.size());
        const JobContext job = cast.job.part(double(i) / n, double(i + 1) / n);
        const Cast own{cast.scene, cast.plan, cast.tables, cast.structure, job, cast.count, cast.voxels, cast.build};
        cast_brick(own, params, order[i], state, rect, tiles, tile_count);
    }
}

/// Rays that meet the volume's box, counted once: kernels see only those that meet a brick.
std::uint64_t OpenClRenderer::count_rays(const Cast& cast, const RayParams& params, glm::ivec2 size) {
    const BrickGrid whole(cast.scene.volume.geometry().size, 1 << 30, glm::ivec3(0));
    const BrickView view(whole, params, cast.scene.camera.fov_deg.has_value());
    std::uint64_t rays = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) rays += view.meets({0, 0, 0}, x, y, 0.0);
    return rays;
}

/// The kernels write into the frame's own memory: nothing is left to be copied. The picture has no padding and the
/// device is the host.
Frame OpenClRenderer::cast_in_place(const Cast& cast, const RayParams& params) {
    Frame frame;
    frame.size = {params.width, params.height};
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels());
    const auto shared = [&](auto& pixels) {
        return cl::Buffer(device_->context(), CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR,
                          pixels.size() * sizeof(pixels[0]), pixels.data());
    };
    output_ = std::make_unique<Output>(Output{0, frame.size, shared(frame.color), shared(frame.depth_mm), {}});
    hold_counters(frame.pixels(), cast.count);
    this->cast(cast, params, nullptr, 0);
    for (const cl::Buffer& buffer : {output_->color, output_->depth}) {  // by which the pixels become the host's again
        void* const mapped =
            device_->queue().enqueueMapBuffer(buffer, CL_TRUE, CL_MAP_READ, 0, buffer.getInfo<CL_MEM_SIZE>());
        device_->queue().enqueueUnmapMemObject(buffer, mapped);
    }
    device_->queue().finish();
    return frame;
}

Frame OpenClRenderer::cast_picture(const Cast& cast, RayParams params, glm::ivec2 size) {
    const glm::ivec2 padded(round_up(size.x, k_group_pixels), round_up(size.y, k_group_pixels));
    params.width = size.x;
    params.height = size.y;
    params.out_stride = padded.x;
    Frame frame;
    const bool in_place = size == padded && cast.plan.brick == 0 && cast.plan.sparse < 2 && device_->info().is_cpu;
    if (!in_place) {
        hold_output(padded, cast.count);
        this->cast(cast, params, nullptr, 0);
        frame = read_frame(size);
    } else {
        frame = cast_in_place(cast, params);
    }
    if (cast.count) frame.counters = read_counters();
    if (in_place) output_.reset();
    if (cast.count && cast.plan.brick > 0) frame.counters.rays = count_rays(cast, params, size);
    return frame;
}

void OpenClRenderer::cast_tiles(const Cast& cast, RayParams params, std::vector<glm::ivec2> tiles, Frame& frame) {
    if (tiles.empty()) return;
    const std::size_t wanted = tiles.size();
    while (tiles.size() % k_tiles_a_group) tiles.push_back({0, frame.size.y});  // below the picture: casts nothing
    const glm::ivec2 padded(round_up(frame.size.x, k_group_pixels), round_up(frame.size.y, k_group_pixels));
    params.out_stride = padded.x;
    hold_output(padded, cast.count);
    const cl::Buffer list(device_->context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                          tiles.size() * sizeof(glm::ivec2), tiles.data());
    this->cast(cast, params, &list, int(tiles.size()));
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
    std::vector<std::uint8_t> marked;
    if (cast.plan.sparse_aware) {
        const auto [cells, classes] = structures_.classes(cast.scene, cast.plan, cast.tables, cast.job);
        marked = blocks_with_hidden_cells(cast.scene, every_kth, grid, cells, classes, cast.plan.sparse_gradient,
                                          {cast.job.stop});
    }
    cast_tiles(cast, params,
               tiles_to_recast(every_kth, grid, cast.plan.sparse_gradient, edge_depth_mm(grid, pixel_mm), marked),
               frame);
    return frame;
}

RenderResult OpenClRenderer::render(const Scene& scene, const Plan& plan, const JobContext& job, bool count) {
    return with_device_errors("rendering", [&] {
        const Stopwatch call;
        RenderResult result;
        const bool whole = plan.brick == 0;
        whole ? hold_volume(scene.volume) : hold_bricks(scene, plan);
        if (needs_tables(scene)) make_tables(scene, plan.step * scene.volume.geometry().smallest_spacing_mm());
        const TransferTables* tables = needs_tables(scene) ? &tables_->host : nullptr;
        hold_classes(scene);
        const glm::ivec3 size = scene.volume.geometry().size;
        RayParams params = make_ray_params(scene, plan, whole ? volume_->stored_size() : size, tables);
        BoundStructure structure;  // bricks have each their own
        if (whole) structure = structures_.prepare(scene, plan, tables, params, result.build, job);
        const bool built =
            std::any_of(result.build.begin(), result.build.end(), [](const auto& made) { return made.second.ms > 0; });
        const double prepared_ms = built ? 0 : call.ms();  // what is done for every picture
        const Cast cast{scene,        plan, tables, structure, job, count, whole ? volume_->voxels() : constants_,
                        &result.build};
        if (whole) caster(scene, plan, structure, count, false);  // compiled before the clock starts
        if (whole && plan.sparse >= 2) caster(scene, plan, structure, count, true);
        if (!whole) bricks_->counts = {};

        const Stopwatch watch;
        result.frame = plan.sparse >= 2 ? cast_sparsely(cast, params) : cast_picture(cast, params, scene.size);
        result.frame.ms = prepared_ms + watch.ms();
        if (!whole) result.bricks = bricks_->counts;
        return result;
    });
}

}  // namespace lacuna
