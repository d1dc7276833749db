#include "core/render/structure_pyramid.h"

#include <algorithm>
#include <optional>

#include "core/accel/binary_pyramid.h"

namespace lacuna {

namespace {

constexpr int k_block_shift = 3;
constexpr int k_kernel_id = 3;

class PyramidFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const MacrocellGrid& blocks = context.cells.grid(context.scene.volume, k_block_shift, context.job);
        bool built = false;
        // Only a ray that starts inside the object can find full cells idle.
        const bool gaps =
            context.scene.mode == ViewMode::iso && std::any_of(context.scene.cuts.begin(), context.scene.cuts.end(),
                                                               [](const CuttingPlane& cut) { return !cut.cap; });
        if (VisibilityKey key = context.key(); !key_ || *key_ != key || (gaps && !has_gaps_)) {
            key_.reset();  // a build that is stopped leaves nothing that looks whole
            build(context, blocks, gaps);
            key_ = std::move(key);
            built = true;
        }
        put_cells(params, visible_.cells, 0, context);
        for (int level = 0; level < visible_.levels(); ++level) {
            params.level_base[level] = int(visible_.first[std::size_t(level)]);
            for (int a = 0; a < 2; ++a) params.level_nodes[level][a] = visible_.stored[std::size_t(level)][a];
        }
        params.top_level = gaps ? std::max(visible_.top, gap_.top) : visible_.top;
        params.cell_gaps = gaps;
        return {k_kernel_id, {visible_bits_, gaps ? gap_bits_ : visible_bits_}, false, built, bytes() + blocks.bytes()};
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override { return visible_.bytes() + gap_.bytes(); }

private:
    void build(const StructureContext& context, const MacrocellGrid& blocks, bool gaps) {
        const ValueRange values = value_range(blocks);
        const VisibilityTable table = context.table(values);
        const double slack = context.slack(values);
        const Volume& volume = context.scene.volume;
        build_binary_pyramid(visible_, volume, blocks, table, slack, values, BinaryPyramid::Kind::visible,
                             context.job.part(0, gaps ? 0.5 : 1));
        put(context, visible_, visible_bits_);
        has_gaps_ = false;
        if (!gaps) return;
        build_binary_pyramid(gap_, volume, blocks, table, slack, values, BinaryPyramid::Kind::gap,
                             context.job.part(0.5, 1));
        put(context, gap_, gap_bits_);
        has_gaps_ = true;
    }

    /// Into the buffer of the last classification where there is one: fresh memory costs more than the copy.
    static void put(const StructureContext& context, const BinaryPyramid& pyramid, cl::Buffer& buffer) {
        if (buffer())
            context.device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, pyramid.bytes(), pyramid.bits.data());
        else
            buffer = context.upload(pyramid.bits.data(), pyramid.bytes());
    }

    BinaryPyramid visible_, gap_;
    cl::Buffer visible_bits_, gap_bits_;
    std::optional<VisibilityKey> key_;
    bool has_gaps_ = false;
};

}  // namespace

std::unique_ptr<StructureFamily> make_pyramid_family() { return std::make_unique<PyramidFamily>(); }

}  // namespace lacuna
