#pragma once

#include <cstdint>
#include <vector>

#include "core/classify/classification.h"
#include "core/volume/voxel_type.h"

namespace lacuna {

/// Transfer functions as the kernels read them: rows of `entries` values; row 0 is the classification's own function,
/// row 1+i that of its range i (the same function where the range has none of its own), then those of regions. A
/// value's entry is round((value - lo)*scale), clamped: tables cover the points of their function, beyond which it is
/// constant.
struct TransferTables {
    int entries = 0;
    std::vector<float> opacity;          ///< of one step, opacity-corrected; with gradient opacity per unit distance
    std::vector<std::uint32_t> color;    ///< red 11 bits (lowest), green 11, blue 10
    std::vector<float> scale, lo;        ///< a row
    bool uses_gradient = false;          ///< any row has a gradient-opacity curve or shapes
    std::vector<float> gradient_factor;  ///< 1024 a row; entry = round(magnitude * gradient_scale)
    std::vector<float> gradient_scale, exponent;  ///< a row; exponent = step over unit distance
    /// Empty where no row has any; else their number, then 12 numbers each (shapes.clh). A row with shapes has in
    /// `opacity` the most any magnitude gives, so that 0 means clear, and factors of 1.
    std::vector<float> shapes;
    double slack = 0;  ///< largest distance from a value to the value its entry was made for

    std::size_t rows() const { return scale.size(); }
};

/// @param step_mm  distance between samples, for the opacity correction
/// @param of_regions  functions of region classes
TransferTables make_transfer_tables(const Classification& classification, VoxelType type, double step_mm,
                                    const std::vector<TransferFunction>& of_regions = {});

}  // namespace lacuna
