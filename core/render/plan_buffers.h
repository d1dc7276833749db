#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/render/engine.h"
#include "core/render/segment_tables.h"
#include "core/render/structure_family.h"

namespace lacuna {

/// What a plan's kernels read beside voxels, transfer functions and structure: tables of pre-integrated segments,
/// stored gradients, the adaptive sampler's steady blocks. Each is made when a plan first asks for it and kept while
/// what it depends on stays the same.
class PlanBuffers {
public:
    /// Puts the buffers, in the order the kernels take them, in front of the structure's, and the options that go with
    /// them behind its own; what it took goes into `build` as "segments", "gradients", "steady blocks".
    /// @throws Error(out_of_memory) where gradients do not fit the device
    void add_to(BoundStructure& bound, const StructureContext& context, std::map<std::string, BuildRecord>& build);

    std::size_t bytes() const;
    void drop() { *this = {}; }

private:
    struct SegmentKey {
        Classification classification;
        double step_mm = 0;
        friend bool operator==(const SegmentKey&, const SegmentKey&) = default;
    };

    BuildRecord hold_segments(const StructureContext& context);
    BuildRecord hold_gradients(const StructureContext& context);
    BuildRecord hold_steady(const StructureContext& context);

    std::optional<SegmentKey> segment_key_;
    cl::Buffer segment_opacity_, segment_color_, segment_visible_, segment_axis_;
    std::size_t segment_bytes_ = 0;

    std::optional<GradientFilter> stored_filter_;
    VoxelBuffer stored_;  ///< read in place by devices that share the host's memory
    cl::Buffer stored_gradients_;

    std::optional<VisibilityKey> steady_key_;
    cl::Buffer steady_;
    std::size_t steady_bytes_ = 0;
};

/// Whether a picture shows gradients: shading, or opacity by gradient.
bool reads_gradients(const Scene& scene, const TransferTables* tables);

}  // namespace lacuna
