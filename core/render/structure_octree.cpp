#include "core/render/structure_octree.h"

#include <optional>

#include "core/accel/minmax_octree.h"

namespace lacuna {

namespace {

constexpr int k_shift = 3;
constexpr int k_kernel_id = 2;

/// What the node bytes depend on beside the voxels.
struct ClassKey {
    VisibilityKey visible;
    double homogeneity = 0;
    bool gradients = false;  ///< samples read gradients too, so that homogeneous nodes must be so one voxel farther
    friend bool operator==(const ClassKey&, const ClassKey&) = default;
};

class OctreeFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const MacrocellGrid& leaves = context.cells.grid(context.scene.volume, k_shift, context.job);
        bool built = false;
        if (!ranges_()) {
            build(context, leaves);
            built = true;
        }
        if (ClassKey key = class_key(context); !key_ || *key_ != key) {
            classify(context, leaves, key);
            key_ = std::move(key);
            built = true;
        }
        put_cells(params, leaves.cells, k_shift, context);
        for (int level = 0; level <= layout_.root(); ++level) {
            params.level_base[level] = int(layout_.first[std::size_t(level)]);
            for (int a = 0; a < 2; ++a) params.level_nodes[level][a] = layout_.nodes[std::size_t(level)][a];
        }
        // Ranges of values decide in the MIP family, whatever the class: any node may lose against the best so far.
        const ViewMode mode = context.scene.mode;
        const bool by_range = mode == ViewMode::mip || mode == ViewMode::minip || mode == ViewMode::lmip;
        params.top_level = by_range ? layout_.root() : top_;
        return {k_kernel_id, {classes_, ranges_, averages_}, any_flat_, built, bytes() + leaves.bytes()};
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override {
        return class_bytes_ + tree_bytes_ + gradient_ranges_.size() * sizeof(glm::vec2);
    }

private:
    static ClassKey class_key(const StructureContext& context) {
        ClassKey key{context.key(), 0, false};
        if (context.scene.mode != ViewMode::ea) return key;
        key.homogeneity = context.plan.homogeneity;
        key.gradients = context.scene.shading != Shading::none || (context.tables && context.tables->uses_gradient);
        return key;
    }

    void build(const StructureContext& context, const MacrocellGrid& leaves) {
        MinMaxOctree tree = build_minmax_octree(context.scene.volume, leaves, context.job);
        layout_ = tree.layout;
        values_ = value_range(leaves);
        tree_bytes_ = tree.bytes();
        averages_ = context.upload(tree.averages.data(), tree.averages.size() * sizeof(float));
        ranges_ = context.upload(tree.ranges.data(), tree.ranges.size() * sizeof(glm::vec2));
    }

    void classify(const StructureContext& context, const MacrocellGrid& leaves, const ClassKey& key) {
        const bool opacity = key.visible.kind == VisibilityKey::Kind::opacity;
        std::optional<FlatRule> flat;
        if (opacity)
            flat = {key.homogeneity, key.gradients ? &flat_ranges(context, leaves, key.homogeneity) : &leaves.ranges};
        const OctreeClasses made =
            classify_octree(layout_, leaves, context.table(values_), context.slack(values_), opacity, flat);
        classes_ = context.upload(made.nodes.data(), made.nodes.size());
        class_bytes_ = made.nodes.size();
        top_ = made.top;
        any_flat_ = made.any_flat;
    }

    const std::vector<glm::vec2>& flat_ranges(const StructureContext& context, const MacrocellGrid& leaves,
                                              double threshold) {
        if (gradient_ranges_.empty() || gradient_threshold_ != threshold) {
            gradient_ranges_ = gradient_ranges(context.scene.volume, leaves, threshold, context.job);
            gradient_threshold_ = threshold;
        }
        return gradient_ranges_;
    }

    OctreeLayout layout_;
    ValueRange values_;
    cl::Buffer ranges_, averages_, classes_;
    std::size_t tree_bytes_ = 0, class_bytes_ = 0;
    std::optional<ClassKey> key_;
    int top_ = -1;
    bool any_flat_ = false;
    std::vector<glm::vec2> gradient_ranges_;
    double gradient_threshold_ = 0;
};

}  // namespace

std::unique_ptr<StructureFamily> make_octree_family() { return std::make_unique<OctreeFamily>(); }

}  // namespace lacuna
