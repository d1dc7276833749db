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

/// What of a stretch of values can be seen: above 0 where any of it can at some magnitude.
double most_opacity(const TransferFunction& tf, ValueRange values) {
    double most = std::max(tf.at(values.lo).opacity, tf.at(values.hi).opacity);
    most = std::max(most, tf.at(0.5 * (values.lo + values.hi)).opacity);
    for (const TransferShape& shape : tf.shapes)  // one that lies between two entries
        for (const double corner : {shape.at_lo.lo, shape.at_lo.hi, shape.at_hi.lo, shape.at_hi.hi})
            if (values.contains(corner)) most = std::max(most, tf.at(corner).opacity);
    return most;
}

/// As kernels/include/shapes.clh reads them.
void add_shapes(TransferTables& tables, const TransferFunction& tf, std::size_t row) {
    if (tables.shapes.empty()) tables.shapes.push_back(0);
    tables.shapes[0] += float(tf.shapes.size());
    for (const TransferShape& s : tf.shapes)
        for (const double v :
             {double(row), s.magnitude.lo, 1 / s.magnitude.width(), s.at_lo.lo, s.at_hi.lo - s.at_lo.lo, s.at_lo.hi,
              s.at_hi.hi - s.at_lo.hi, s.opacity, 0.5 * s.softness, s.color.r, s.color.g, s.color.b})
            tables.shapes.push_back(float(v));
}

void add_row(TransferTables& tables, const TransferFunction& tf, double step_mm) {
    ValueRange extent = tf.extent();
    // Shapes end sharply; the entries at either end stand for all values beyond and must be clear.
    if (tf.is_2d()) extent = {extent.lo - 0.01 * extent.width() - 1e-6, extent.hi + 0.01 * extent.width() + 1e-6};
    const double lo = extent.lo, width = extent.width() > 0 ? extent.width() : 1.0;
    const double per_entry = width / (tables.entries - 1);
    tables.scale.push_back(float(1 / per_entry));
    tables.lo.push_back(float(lo));
    tables.slack = std::max(tables.slack, per_entry);
    for (int i = 0; i < tables.entries; ++i) {
        ColorOpacity at = tf.at(lo + i * per_entry);
        if (tf.is_2d()) at.opacity = most_opacity(tf, {lo + (i - 0.5) * per_entry, lo + (i + 0.5) * per_entry});
        tables.color.push_back(pack_color(at.color));
        tables.opacity.push_back(
            float(tables.uses_gradient ? at.opacity : correct_opacity(at.opacity, step_mm, tf.unit_distance_mm)));
    }
    tables.exponent.push_back(float(step_mm / tf.unit_distance_mm));
    if (!tables.uses_gradient) return;
    if (tf.is_2d()) add_shapes(tables, tf, tables.rows() - 1);
    const bool curve = !tf.is_2d() && !tf.gradient_opacity.empty();
    const double steepest = curve ? std::max(tf.gradient_opacity.back().magnitude, 1e-12) : 1.0;
    tables.gradient_scale.push_back(float((k_gradient_entries - 1) / steepest));
    for (int i = 0; i < k_gradient_entries; ++i)
        tables.gradient_factor.push_back(
            float(curve ? tf.gradient_factor(steepest * i / (k_gradient_entries - 1)) : 1));
}

}  // namespace

TransferTables make_transfer_tables(const Classification& classification, VoxelType type, double step_mm,
                                    const std::vector<TransferFunction>& of_regions) {
    TransferTables tables;
    // Fine enough that rounding to an entry stays below half a value for 8 bits, about a value for 16.
    tables.entries = size_of(type) == 1 ? 4096 : 16384;
    tables.uses_gradient = classification.uses_gradient();
    for (const TransferFunction& tf : of_regions) tables.uses_gradient = tables.uses_gradient || tf.uses_gradient();
    add_row(tables, classification.tf, step_mm);
    for (const SegmentationRange& r : classification.ranges) add_row(tables, r.tf ? *r.tf : classification.tf, step_mm);
    for (const TransferFunction& tf : of_regions) add_row(tables, tf, step_mm);
    return tables;
}

}  // namespace lacuna
