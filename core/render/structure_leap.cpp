#include "core/render/structure_leap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/accel/leap_volume.h"
#include "core/compute/buffers.h"
#include "core/render/device_volume.h"

namespace lacuna {

namespace {

constexpr int k_kernel_id = 5;
constexpr std::size_t k_tail_bytes = 64;  // readable behind the last entry: neighbours are loaded in pairs

/// What a leap volume depends on besides the voxels and the step.
struct LeapKey {
    double range_width = 0;
    std::int64_t min_voxels = 0;
    LeapWay way = LeapWay::transform;
    double probability = 0, relative_radius = 0;  ///< 0 unless by groups
    std::optional<ValueRange> quantisation;
    std::shared_ptr<const std::vector<std::uint8_t>> voxel_class;  ///< regions are cut where it changes
    friend bool operator==(const LeapKey&, const LeapKey&) = default;
};

LeapKey key_of(const Plan& plan, const Scene& scene) {
    LeapKey key{plan.homogeneity, plan.leap.min_voxels, plan.leap.way, 0, 0, std::nullopt, scene.regions.of_voxel};
    if (key.way == LeapWay::groups) {
        key.probability = plan.leap.groups.probability;
        key.relative_radius = plan.leap.groups.relative_radius;
    }
    if (scene.volume.type() == VoxelType::f32) key.quantisation = plan.leap.quantisation;
    return key;
}

class LeapFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const Volume& volume = context.scene.volume;
        const double step_mm = context.plan.step * volume.geometry().smallest_spacing_mm();
        const LeapKey key = key_of(context.plan, context.scene);
        const bool built = !key_ || *key_ != key || leap_.step_mm < step_mm * (1 - 1e-9);
        if (built) build(context, key, step_mm);

        BoundStructure bound;
        bound.built = built;
        bound.bytes = bytes();
        if (context.plan.leap.kernel != Leaping::lossless) return own_kernel(context, step_mm, bound, params);
        if (flat_) bound.volume = flat_->voxels();
        // Regions too thin to leap in, or a mean of all samples: nothing to gain from asking.
        const ViewMode mode = context.scene.mode;
        const bool useless = mode == ViewMode::mean && context.scene.classification.ranges.empty();
        if (leap_.leap_voxels == 0 || useless) return bound;
        bound.kernel_id = k_kernel_id;
        bound.buffers = {entries_};
        bound.runs = bound.runs_of_class = mode == ViewMode::ea;
        const int kind = mode == ViewMode::ea ? 0 : mode == ViewMode::iso ? 1 : 2;
        bound.options = " -DLACUNA_LEAP_KIND=" + std::to_string(kind);
        put_params(context, step_mm, params);
        return bound;
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override { return leap_.bytes() + (flat_ ? leap_.flat.bytes() : 0); }

private:
    /// The leaping kernel: it reads the leap volume alone.
    BoundStructure own_kernel(const StructureContext& context, double step_mm, BoundStructure& bound,
                              RayParams& params) const {
        bound.kernel_id = k_kernel_id;
        bound.volume = entries_;
        bound.own_kernel = "raycast_leap";
        bound.options = context.plan.leap.kernel == Leaping::published ? " -DLACUNA_LEAPING=2" : " -DLACUNA_LEAPING=1";
        bound.options +=
            context.scene.volume.type() == VoxelType::f32 ? " -DLACUNA_LEAP_NAN=1" : " -DLACUNA_LEAP_NAN=0";
        put_params(context, step_mm, params);
        return bound;
    }

    void build(const StructureContext& context, const LeapKey& key, double step_mm) {
        const Volume& volume = context.scene.volume;
        drop();  // the old one goes before the new one needs the memory
        LeapOptions options;
        options.range_width = key.range_width;
        options.min_voxels = key.min_voxels;
        options.step_mm = step_mm;
        options.way = key.way;
        options.groups = context.plan.leap.groups;
        options.quantisation = key.quantisation;
        if (key.voxel_class) options.voxel_class = key.voxel_class->data();
        LeapVolume made = build_leap_volume(volume, options, context.job);
        entries_ = device_buffer(context.device, made.entries.data(), made.entries.size() + k_tail_bytes);
        if (made.flat.data() != volume.data()) flat_ = std::make_unique<DeviceVolume>(context.device, made.flat);
        leap_ = std::move(made);
        key_ = key;
    }

    void put_params(const StructureContext& context, double step_mm, RayParams& params) const {
        put_cells(params, leap_.size, 0, context);
        params.leap_samples = float(leap_.unit_mm / step_mm);
        // Gradients read a voxel farther than samples do.
        const glm::dvec3 s = context.scene.volume.geometry().spacing;
        const double wide = std::max({s.x, s.y, s.z}), diagonal = glm::length(s);
        const bool gradients =
            context.scene.mode == ViewMode::ea &&
            (context.scene.shading != Shading::none || (context.tables && context.tables->uses_gradient));
        params.leap_margin =
            float(gradients ? (std::sqrt(diagonal * diagonal + 3 * wide * wide) - diagonal) / step_mm : 0.0);
        params.leap_lo = float(leap_.value_lo);
        params.leap_scale = float(leap_.value_scale);
    }

    std::optional<LeapKey> key_;
    LeapVolume leap_;
    cl::Buffer entries_;                  ///< of the leap volume in place, where the device shares the host's memory
    std::unique_ptr<DeviceVolume> flat_;  ///< only where it differs from the volume
};

}  // namespace

std::unique_ptr<StructureFamily> make_leap_family() { return std::make_unique<LeapFamily>(); }

}  // namespace lacuna
