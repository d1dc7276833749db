#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/classify/classification.h"
#include "core/render/camera.h"
#include "core/render/effects.h"
#include "core/volume/volume.h"

namespace lacuna {

enum class ViewMode : int { iso, ea, mip, lmip, minip, mean, shear_warp };
enum class Shading { none, lambert, phong };

/// Keeps the half-space normal . p + offset >= 0 (mm). The normal need not have unit length.
struct CuttingPlane {
    glm::dvec3 normal{1, 0, 0};
    double offset = 0;
    bool cap = true;  ///< draw data values on the cut face; else inner surfaces show
    friend bool operator==(const CuttingPlane&, const CuttingPlane&) = default;
};

/// Voxels drawn over the picture in one colour, seen through whatever hides them (a selected region).
struct Highlight {
    glm::ivec3 first{0}, size{0};                             ///< the box of voxels `inside` covers
    std::shared_ptr<const std::vector<std::uint8_t>> inside;  ///< size.x*size.y*size.z, x fastest, non-zero: drawn
    glm::dvec3 color{1.0, 0.45, 0.1};
    double opacity = 0.75;
};

/// What a view makes of the voxels by the homogeneous regions they lie in (core/render/region_view.h makes it).
struct RegionClasses {
    static constexpr std::uint8_t k_hidden = 255;
    static constexpr std::size_t k_max_functions = 8;
    /// A byte a voxel, x fastest: 0 as the classification says, k_hidden not seen, 1 + i drawn by functions[i].
    /// Null: all 0.
    std::shared_ptr<const std::vector<std::uint8_t>> of_voxel;
    std::vector<TransferFunction> functions;  ///< EA only
    explicit operator bool() const { return of_voxel != nullptr; }
};

/// What is to be seen: plain values, no word of how. The lattice every renderer samples: a ray's sample k (from 0) lies
/// (k + 1/2) steps behind the ray's entry into the box of voxel cells ([-1/2, n-1/2] in voxel coordinates; a ray that
/// starts inside the box enters at its origin), n = max(0, ceil(length / step - 1/2)) samples in all;
/// reconstruction between voxel centres is trilinear (or nearest), beyond the outermost centres clamped to them. Cuts
/// never shift the lattice; they narrow the range of k. A sample whose neighbourhood holds a voxel that is not finite
/// (weight 0 included) is NaN and contributes nothing.
///
/// iso: the first point where iso_measure(value) turns from outside to inside is drawn opaque in surface_color. A ray
///   entering through the volume's own side inside the object hits there, with that side's normal (a ray that starts
///   inside the box and inside the object hits at its origin, with c = 1). A ray entering the
///   kept part through a cut inside the object shows the grey data value there (`cap`), or runs on to the first
///   turn from inside to outside (`open`), drawn as a surface. After a NaN sample the ray counts as outside, and a hit
///   at the very next sample is not refined. With the refinement `cubic` (plan.h) the turn is the first of the exact
///   trilinear signal on the kept ray, whatever the samples; after a cell with a voxel that is not finite the ray
///   counts as outside, and one that is inside at its end hits there.
/// ea: emission-absorption by the classification, front to back, opacity corrected for the step. A ray entering
///   through a capped cut where the opacity (gradient factor left out) is above 0 ends there in the grey data value.
///   Depth: the sample at which opacity first exceeds 1/2. With the integration `preintegrated` the kept ray is cut at
///   its samples; along each piece the value changes linearly from end to end and the transfer function is integrated
///   exactly, its own attenuation included; shading is that at the piece's middle, depth the middle of the piece behind
///   which opacity exceeds 1/2; a piece with an end that is NaN contributes nothing.
/// mip / minip / mean: largest / smallest / mean sample, drawn grey through the window, or in the transfer function's
///   colour where color_by_tf; rays without a sample (or with none inside the ranges) are background. mean divides by
///   the number of samples counted: those neither NaN nor outside the ranges. Depth: the first sample that wins;
///   infinity for mean. lmip: the first local maximum at or above lmip_threshold along the counted samples (a sample
///   not smaller than the threshold whose counted successor is smaller, or that is the last); the largest sample where
///   none reaches the threshold.
/// regions: a sample is of the class of the voxel nearest to its clamped position (halves round up). One of a hidden
///   voxel, whatever else lies around it, is NaN as above: it contributes nothing, is not counted, ends nothing, and to
///   an iso ray is outside. One of a class with a function of its own takes colour and opacity from that, where the
///   segmentation ranges let its value through. Reconstruction, gradients and refinement read all voxels, hidden or
///   not.
/// shear_warp: the iso surface by shear-warp of its visible voxels (Csebfalvi et al. 1999), see shear_warp.h;
///   orthographic only.
/// Headlight shading, two-sided: with c = |n.v|, lambert gives colour * (0.2 + 0.8 c), phong
///   colour * (0.2 + 0.7 c) + 0.3 c^20; n is the gradient's direction in mm: the gradients at
///   the eight voxels around, interpolated trilinearly whatever the sampler. At a voxel: central differences over one
///   voxel each way, or (plan's `sobel`) these smoothed by (1 2 1)/4 along both other axes (Sobel's operator; Zucker &
///   Hummel 1981 weigh corners otherwise); voxels beyond the border repeat it. A gradient that is zero or NaN counts as
///   c = 0 and as magnitude 0. EA applies it to each sample's colour. Nothing is clamped before the picture is shown.
struct Scene {
    Volume volume;
    ViewMode mode = ViewMode::ea;
    Classification classification;
    double iso = 0;
    std::vector<CuttingPlane> cuts;  ///< at most k_max_cuts
    Camera camera;
    glm::ivec2 size{512, 512};
    Shading shading = Shading::phong;
    glm::dvec3 surface_color{0.92, 0.88, 0.80};
    ValueRange window{0, 255};  ///< grey levels of caps and of the MIP family: lo black, hi white
    bool color_by_tf = false;   ///< MIP family: the transfer function's colour instead of grey
    double lmip_threshold = 0;
    RegionClasses regions;  ///< what is shown of homogeneous regions, and how
    std::vector<Highlight> highlights;
    glm::dvec3 background{0.0};
    std::vector<Effect> effects;  ///< applied to the finished frame in this order, before highlights

    static constexpr std::size_t k_max_cuts = 12;
};

/// Names as on the command line ("iso", "shear-warp", ...). parse_* throw Error(bad_usage) listing the known names.
std::string_view name_of(ViewMode mode);
std::string_view name_of(Shading shading);
ViewMode parse_view_mode(std::string_view text);
Shading parse_shading(std::string_view text);

/// A scene with everything fitted to the data: iso by Otsu, fitted transfer function, window = value range,
/// lmip threshold = iso.
Scene default_scene(const Volume& volume, const VolumeStatistics& statistics);

/// @throws Error(bad_usage) for the first parameter out of range (too many cuts or ranges, a zero normal, a bad camera)
void check(const Scene& scene);

}  // namespace lacuna
