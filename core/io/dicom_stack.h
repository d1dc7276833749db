#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/io/dicom_header.h"
#include "core/volume/volume.h"

namespace lacuna::dicom {

/// How a row of slice positions fits one even step.
struct StepFit {
    double step_mm = 0;       ///< least-squares step of the fitted grid; 0 for a single position
    std::vector<int> planes;  ///< grid plane of each position; empty when no even step fits
    double worst_mm = 0;      ///< largest distance of a position from its plane
    int duplicates = 0;       ///< positions that repeat another
    int missing = 0;          ///< planes without a position

    bool uniform() const { return !planes.empty(); }
    bool regular() const { return uniform() && duplicates == 0 && missing == 0; }
};

/// How near (mm) two slices are one: passes over the same positions may write them with other digits. Two hundredths of
/// a pixel, a hundredth of a mm at most; 1e-6 without a pixel spacing.
double same_position_mm(const std::optional<glm::dvec2>& spacing_mm);

/// Fits an even step to ascending positions (mm). Gaps that are whole multiples of the usual step are missing slices,
/// unless more than a third of the gaps are such: then the slices were taken unevenly, and no step fits. `instances`
/// (InstanceNumber, may be empty) can only confirm that slices are missing; they never order anything. Positions within
/// `same_mm` of each other repeat each other.
StepFit find_step(std::span<const double> along_mm, std::span<const std::optional<int>> instances = {},
                  double same_mm = 1e-6);

/// How found slices become a volume: a value, made without touching a pixel.
struct StackPlan {
    GridGeometry grid;                              ///< of the finished volume
    std::vector<std::size_t> order;                 ///< slices used, ascending along the normal
    std::vector<std::size_t> duplicates;            ///< slices set aside because another has their position
    std::vector<double> along_mm;                   ///< of each used slice, from the first
    std::vector<glm::dvec2> shift_px;               ///< of each used slice within its plane, from the first
    std::vector<int> planes;                        ///< grid plane of each used slice; empty: resampled along z
    std::vector<int> missing;                       ///< grid planes without a slice
    std::string missing_text;                       ///< names the gaps
    glm::ivec2 margin_px{0};                        ///< grid columns and rows before pixel (0, 0) of the first slice
    bool sheared = false;                           ///< slices are shifted against each other within their planes
    double spacing_min_mm = 0, spacing_max_mm = 0;  ///< between neighbouring slices as found
    double tilt_deg = 0;
    std::vector<Warning> warnings;

    bool resampled() const { return sheared || planes.empty(); }
};

/// Plans the stack of slices of one series. `names[i]` names slice i in messages.
/// @throws Error(bad_input) for slices whose place cannot be known (no positions in separate files), or that leave
/// gaps far larger than the stack itself
StackPlan plan_stack(std::span<const Frame> slices, glm::ivec2 size, std::span<const std::string> names);

}  // namespace lacuna::dicom
