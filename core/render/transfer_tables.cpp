#include "core/render/transfer_tables.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr int k_gradient_entries = 1024;

std::uint32_t pack_color(const glm::dvec3& c) {
    const auto level = [](double v, double top) { return std::uint32_t(std::lround(std::clamp(v, 0.0, 1.0) * top)); };
    return level(c.r, 2047) | level(c.g, 2047) << 11 | level(c.b, 1023) << 22;
}

void add_row(TransferTables& tables, const TransferFunction& tf, double step_mm) {
    const double lo = tf.points.front().value, hi = tf.points.back().value;
    const double width = hi > lo ? hi - lo : 1.0;
    const double per_entry = width / (tables.entries - 1);
    tables.scale.push_back(float(1 / per_entry));
    tables.lo.push_back(float(lo));
    tables.slack = std::max(tables.slack, per_entry);
    for (int i = 0; i < tables.entries; ++i) {
        const ColorOpacity at = tf.at(lo + i * per_entry);
        tables.color.push_back(pack_color(at.color));
        tables.opacity.push_back(
            float(tables.uses_gradient ? at.opacity : correct_opacity(at.opacity, step_mm, tf.unit_distance_mm)));
    }
    tables.exponent.push_back(float(step_mm / tf.unit_distance_mm));
    if (!tables.uses_gradient) return;
    const double steepest = tf.gradient_opacity.empty() ? 1.0 : std::max(tf.gradient_opacity.back().magnitude, 1e-12);
    tables.gradient_scale.push_back(float((k_gradient_entries - 1) / steepest));
    for (int i = 0; i < k_gradient_entries; ++i)
        tables.gradient_factor.push_back(float(tf.gradient_factor(steepest * i / (k_gradient_entries - 1))));
}

}  // namespace

TransferTables make_transfer_tables(const Classification& classification, VoxelType type, double step_mm,
                                    const std::vector<TransferFunction>& of_regions) {
    TransferTables tables;
    // Fine enough that rounding to an entry stays below half a value for 8 bits, about a value for 16.
    tables.entries = size_of(type) == 1 ? 4096 : 16384;
    tables.uses_gradient = !classification.tf.gradient_opacity.empty();
    for (const SegmentationRange& r : classification.ranges)
        tables.uses_gradient = tables.uses_gradient || (r.tf && !r.tf->gradient_opacity.empty());
    for (const TransferFunction& tf : of_regions)
        tables.uses_gradient = tables.uses_gradient || !tf.gradient_opacity.empty();
    add_row(tables, classification.tf, step_mm);
    for (const SegmentationRange& r : classification.ranges) add_row(tables, r.tf ? *r.tf : classification.tf, step_mm);
    for (const TransferFunction& tf : of_regions) add_row(tables, tf, step_mm);
    return tables;
}

}  // namespace lacuna
