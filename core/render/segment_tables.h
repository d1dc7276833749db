#pragma once

#include <cstdint>
#include <vector>

#include "core/classify/classification.h"

namespace lacuna {

/// Pre-integrated transfer functions (Engel, Kraus & Ertl 2001), opacity-exact: what a segment of one step shows when
/// the value changes linearly from `front` to `back`, for all pairs of k_nodes values. The segment's own attenuation is
/// integrated too, not left out as in the paper's faster form. Ranges and their own functions are part of it.
struct SegmentTables {
    static constexpr int k_nodes = 512;

    double lo = 0, nodes_per_unit = 1;   ///< node i stands for the value lo + i/nodes_per_unit
    std::vector<float> opacity;          ///< k_nodes x k_nodes, row = front
    std::vector<std::uint32_t> color;    ///< the same, 11-11-10 bits, not premultiplied
    std::vector<std::uint32_t> visible;  ///< a node: bins (value intervals between nodes) in front of it with opacity
};

/// How far beside a value the tables may look: a node's distance, in the values' unit.
double segment_slack(const Classification& classification, ValueRange values);

/// @param values   the values that occur; the table spans what of them the classification tells apart
/// @param step_mm  length of a segment
/// The classification is integrated over each of the k_nodes - 1 bins (Gauss, cut at its points); bins are composited
/// by the over operator, sliding windows of every length in constant time an entry. Cost: some 20 ms on two
/// threads, 2 MiB.
SegmentTables make_segment_tables(const Classification& classification, ValueRange values, double step_mm);

}  // namespace lacuna
