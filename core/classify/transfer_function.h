#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

/// One node of a transfer function.
struct TransferPoint {
    double value = 0;            ///< in the volume's unit
    glm::dvec3 color{1.0};       ///< sRGB 0..1, not premultiplied
    double opacity = 0;          ///< 0..1 per unit_distance_mm
    friend bool operator==(const TransferPoint&, const TransferPoint&) = default;
};

/// One node of the gradient-opacity curve: a factor on the opacity.
struct GradientOpacityPoint {
    double magnitude = 0;        ///< gradient magnitude, units per mm
    double opacity = 1;          ///< factor 0..1
    friend bool operator==(const GradientOpacityPoint&, const GradientOpacityPoint&) = default;
};

struct ColorOpacity {
    glm::dvec3 color{0.0};
    double opacity = 0;
};

/// A 1D transfer function: linear between points, constant outside. Two points at one value make a jump: the value
/// itself takes the later point's.
struct TransferFunction {
    std::string name;
    double unit_distance_mm = 1.0;
    std::vector<TransferPoint> points;                    ///< ascending by value; at least one
    std::vector<GradientOpacityPoint> gradient_opacity;   ///< ascending by magnitude; empty: factor 1 everywhere

    /// Colour and opacity per unit distance at a value; transparent for NaN.
    ColorOpacity at(double value) const;
    /// Factor on the opacity for a gradient magnitude; 1 when there is no curve.
    double gradient_factor(double magnitude) const;
    /// True if any value in the closed range has opacity > 0 (exact, from the points).
    bool any_visible(ValueRange range) const;
    friend bool operator==(const TransferFunction&, const TransferFunction&) = default;
};

/// Opacity of a step: 1-(1-a)^(step/unit).
double correct_opacity(double opacity, double step_mm, double unit_distance_mm);

/// Throws Error(bad_input) naming the first fault: no points, values not ascending or not finite, opacities or colours
/// outside 0..1, unit distance not positive.
void check(const TransferFunction& tf);

/// The contract's transfer-function file. Unknown keys are refused by name.
/// @throws Error(bad_input) naming file and key, Error(io)
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
