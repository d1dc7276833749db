#include "core/render/structure_macrocells.h"

#include <optional>

namespace lacuna {

namespace {

constexpr int k_shift = 3;

class MacrocellFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const MacrocellGrid& grid = context.cells.grid(context.scene.volume, k_shift, context.job);
        bool built = false;
        if (!ranges_()) {
            ranges_ = context.upload(grid.ranges.data(), grid.ranges.size() * sizeof(glm::vec2));
            values_ = value_range(grid);
            built = true;
        }
        if (VisibilityKey key = context.key(); !key_ || *key_ != key) {
            const auto classes = classify_macrocells(grid, context.table(values_), context.slack(values_));
            classes_ = context.upload(classes.data(), classes.size());
            bytes_ = classes.size();
            key_ = std::move(key);
            built = true;
        }
        put_cells(params, grid.cells, k_shift, context);
        return {1, {classes_, ranges_}, false, built, bytes_ + grid.bytes()};
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override { return bytes_; }

private:
    cl::Buffer ranges_, classes_;
    ValueRange values_;
    std::optional<VisibilityKey> key_;
    std::size_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<StructureFamily> make_macrocell_family() { return std::make_unique<MacrocellFamily>(); }

}  // namespace lacuna
