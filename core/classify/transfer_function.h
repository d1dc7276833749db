#pragma once

#include <algorithm>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

/// One node of a transfer function.
struct TransferPoint {
    double value = 0;       ///< in the volume's unit
    glm::dvec3 color{1.0};  ///< sRGB 0..1, not premultiplied
    double opacity = 0;     ///< 0..1 per unit_distance_mm
    friend bool operator==(const TransferPoint&, const TransferPoint&) = default;
};

/// One node of the gradient-opacity curve: a factor on the opacity.
struct GradientOpacityPoint {
    double magnitude = 0;  ///< gradient magnitude, units per mm
    double opacity = 1;    ///< factor 0..1
    friend bool operator==(const GradientOpacityPoint&, const GradientOpacityPoint&) = default;
};

struct ColorOpacity {
    glm::dvec3 color{0.0};
    double opacity = 0;
};

/// A trapezoid in the plane of values and gradient magnitudes (Kniss, Kindlmann & Hansen 2002 classify by such
/// widgets); with at_lo == at_hi a rectangle, with an at_hi of no width a triangle. Its sides count as inside.
struct TransferShape {
    ValueRange magnitude{0, 1};  ///< gradient magnitudes, units per mm; lo < hi
    ValueRange at_lo{0, 1};      ///< values from side to side where the magnitude is magnitude.lo
    ValueRange at_hi{0, 1};      ///< the same at magnitude.hi; the sides run straight between
    glm::dvec3 color{1.0};       ///< sRGB 0..1
    double opacity = 0.5;        ///< 0..1 per unit_distance_mm
    double softness = 0;         ///< 0..1: share of the half width over which opacity falls to 0 at either side

    bool is_rectangle() const { return at_lo == at_hi; }
    /// Values it covers at any magnitude.
    ValueRange values() const { return {std::min(at_lo.lo, at_hi.lo), std::max(at_lo.hi, at_hi.hi)}; }
    double opacity_at(double value, double magnitude) const;
    /// The largest opacity_at any magnitude (exact).
    double most_opacity_at(double value) const;
    friend bool operator==(const TransferShape&, const TransferShape&) = default;
};

/// A transfer function: linear between points, constant outside. Two points at one value make a jump: the value itself
/// takes the later point's. With shapes in use it is one of value and gradient magnitude: opacity is 1 less the product
/// of 1 less each shape's, colour their mean weighed by opacity; points then give the colours of projections alone, and
/// the gradient-opacity curve nothing.
struct TransferFunction {
    static constexpr std::size_t k_max_shapes = 16;

    std::string name;
    double unit_distance_mm = 1.0;
    std::vector<TransferPoint> points;                        ///< ascending by value; at least one
    std::vector<GradientOpacityPoint> gradient_opacity = {};  ///< ascending by magnitude; empty: factor 1 everywhere
    std::vector<TransferShape> shapes = {};                   ///< at most k_max_shapes
    bool by_shapes = true;                                    ///< false: the shapes are kept, and not used

    bool is_2d() const { return by_shapes && !shapes.empty(); }
    /// Whether what is seen of a value depends on the gradient there.
    bool uses_gradient() const { return is_2d() || !gradient_opacity.empty(); }
    /// Colour of the points; opacity per unit distance of the points, gradient factor left out, or of the shapes at the
    /// magnitude that shows the value best: 0 only where no gradient could show it. Transparent for NaN.
    ColorOpacity at(double value) const;
    /// Colour and opacity per unit distance of a value where the gradient has that magnitude (NaN counts as 0).
    ColorOpacity at(double value, double magnitude) const;
    /// Factor on the opacity for a gradient magnitude; 1 when there is no curve.
    double gradient_factor(double magnitude) const;
    /// Values from the first point's or shape's to the last's: beyond them nothing changes.
    ValueRange extent() const;
    friend bool operator==(const TransferFunction&, const TransferFunction&) = default;
};

/// Opacity of a step: 1-(1-a)^(step/unit).
double correct_opacity(double opacity, double step_mm, double unit_distance_mm);

/// Throws Error(bad_input) naming the first fault: no points, values not ascending or not finite, opacities or colours
/// outside 0..1, unit distance not positive, a shape that is none.
void check(const TransferFunction& tf);

/// The contract's transfer-function file; what it says of a technique is passed over (preset_file.h reads it). Unknown
/// keys are refused by name. @throws Error(bad_input) naming file and key, Error(io)
TransferFunction load_transfer_function(const std::filesystem::path& file);
TransferFunction transfer_function_from_json(const std::string& json, const std::string& where);
std::string to_json(const TransferFunction& tf);
void save_transfer_function(const TransferFunction& tf, const std::filesystem::path& file);

/// Names of the presets: bone, soft-tissue, skin, lung, angio, metal, voids, grey.
std::vector<std::string> preset_names();
/// A preset fitted to the data: HU points for volumes in HU (medical presets), else placed by Otsu's threshold and
/// percentiles; unit distance from the voxel spacing. @throws Error(bad_usage) naming the known presets
TransferFunction make_preset(const std::string& name, const Volume& volume, const VolumeStatistics& statistics);
/// The preset fitted best to the data when the user names none (HU: bone over faint soft tissue; else metal-like).
TransferFunction fit_transfer_function(const Volume& volume, const VolumeStatistics& statistics);

}  // namespace lacuna
