#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "core/classify/preset_file.h"

namespace lacuna {

namespace {

/// A node of a preset. `at` is in HU for medical presets; for the others it is a level of the data:
/// 0 top of the background's noise, 1 Otsu's threshold, 2 the material's mean, 3 the top of the material's noise,
/// 4 the largest value; between whole numbers linear.
struct Node {
    double at;
    glm::dvec3 color;
    double opacity;  ///< per smallest voxel spacing
};

struct Preset {
    std::string_view name;
    bool medical;
    std::span<const Node> nodes;
};

// Opacities are per voxel spacing: 0.5 looks solid after about five voxels, 0.02 is a film.
constexpr std::array k_bone{Node{150, {0.62, 0.30, 0.22}, 0.0}, Node{220, {0.80, 0.58, 0.42}, 0.06},
                            Node{350, {0.93, 0.83, 0.68}, 0.35}, Node{900, {0.97, 0.93, 0.85}, 0.70},
                            Node{1800, {1.0, 0.99, 0.96}, 0.90}};
constexpr std::array k_soft_tissue{Node{-160, {0.55, 0.38, 0.25}, 0.0}, Node{-90, {0.85, 0.68, 0.45}, 0.015},
                                   Node{0, {0.75, 0.40, 0.32}, 0.04},   Node{60, {0.83, 0.33, 0.28}, 0.14},
                                   Node{140, {0.88, 0.45, 0.38}, 0.22}, Node{300, {0.95, 0.88, 0.76}, 0.45},
                                   Node{1200, {1.0, 0.98, 0.93}, 0.70}};
constexpr std::array k_skin{Node{-600, {0.80, 0.58, 0.45}, 0.0}, Node{-350, {0.87, 0.66, 0.53}, 0.25},
                            Node{-150, {0.91, 0.72, 0.60}, 0.60}, Node{100, {0.92, 0.72, 0.61}, 0.80},
                            Node{800, {0.97, 0.92, 0.85}, 0.90}};
constexpr std::array k_lung{Node{-930, {0.25, 0.35, 0.60}, 0.0},  Node{-850, {0.35, 0.50, 0.75}, 0.012},
                            Node{-650, {0.60, 0.65, 0.85}, 0.03}, Node{-450, {0.85, 0.55, 0.50}, 0.12},
                            Node{-300, {0.80, 0.50, 0.45}, 0.02}, Node{-150, {0.80, 0.50, 0.45}, 0.0},
                            Node{250, {0.90, 0.85, 0.70}, 0.0},   Node{500, {0.95, 0.90, 0.78}, 0.08}};
constexpr std::array k_angio{Node{110, {0.45, 0.05, 0.05}, 0.0},  Node{160, {0.75, 0.12, 0.10}, 0.12},
                             Node{280, {0.90, 0.25, 0.18}, 0.50}, Node{450, {0.95, 0.60, 0.40}, 0.55},
                             Node{800, {0.95, 0.90, 0.78}, 0.50}, Node{1800, {1.0, 0.98, 0.95}, 0.70}};
constexpr std::array k_metal_hu{Node{1900, {0.45, 0.48, 0.52}, 0.0}, Node{2300, {0.62, 0.66, 0.72}, 0.45},
                                Node{3000, {0.80, 0.83, 0.87}, 0.90}};

constexpr std::array k_metal{Node{0.55, {0.38, 0.40, 0.44}, 0.0}, Node{1.0, {0.52, 0.55, 0.60}, 0.35},
                             Node{1.6, {0.68, 0.71, 0.76}, 0.85}, Node{2.0, {0.76, 0.79, 0.83}, 0.95},
                             Node{3.2, {0.84, 0.86, 0.88}, 0.95}, Node{4.0, {0.98, 0.82, 0.42}, 0.98}};
// In one dimension a void cannot be told from the air around the part: both are transparent. What shows a void is its
// flank, the values between air and material, drawn red through material that is a faint film; values above the
// material (dense inclusions) are drawn yellow.
constexpr std::array k_voids{Node{0.25, {0.75, 0.10, 0.08}, 0.0},  Node{0.6, {0.90, 0.18, 0.12}, 0.20},
                             Node{1.2, {0.95, 0.30, 0.18}, 0.20},  Node{1.6, {0.70, 0.62, 0.60}, 0.010},
                             Node{2.0, {0.70, 0.73, 0.78}, 0.004}, Node{3.0, {0.75, 0.78, 0.80}, 0.004},
                             Node{3.3, {1.00, 0.80, 0.25}, 0.25},  Node{4.0, {1.00, 0.88, 0.35}, 0.80}};
constexpr std::array k_grey{Node{0.0, {0.0, 0.0, 0.0}, 0.0}, Node{1.0, {0.38, 0.38, 0.38}, 0.05},
                            Node{2.0, {0.75, 0.75, 0.75}, 0.30}, Node{3.0, {0.88, 0.88, 0.88}, 0.45},
                            Node{4.0, {1.0, 1.0, 1.0}, 0.60}};

constexpr std::array k_presets{Preset{"bone", true, k_bone},    Preset{"soft-tissue", true, k_soft_tissue},
                               Preset{"skin", true, k_skin},    Preset{"lung", true, k_lung},
                               Preset{"angio", true, k_angio},  Preset{"metal", false, k_metal},
                               Preset{"voids", false, k_voids}, Preset{"grey", false, k_grey}};

struct ClassLevels {
    double mean = 0, stddev = 0;
};

/// Mean and standard deviation of the bins whose centre lies in [lo, hi].
ClassLevels levels_of(const VolumeStatistics& s, double lo, double hi, double fallback) {
    double n = 0, sum = 0, squares = 0;
    for (std::size_t b = 0; b < s.histogram.size(); ++b) {
        const double v = s.bin_centre(b), count = double(s.histogram[b]);
        if (v < lo || v > hi) continue;
        n += count;
        sum += count * v;
        squares += count * v * v;
    }
    if (!(n > 0)) return {fallback, 0};
    return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)))};
}

/// The five levels that non-medical presets are placed by, strictly ascending even for a constant volume.
std::array<double, 5> data_levels(const VolumeStatistics& s) {
    const double threshold = otsu_threshold(s);
    const ClassLevels background = levels_of(s, -INFINITY, threshold, s.range.lo);
    const ClassLevels material = levels_of(s, threshold, INFINITY, s.range.hi);
    const double scale = std::max({s.range.width(), 1e-2 * std::abs(s.range.lo), 1e-2 * std::abs(s.range.hi), 1e-6});
    const double least = 1e-3 * scale;
    std::array<double, 5> levels{};
    levels[1] = threshold;
    // Four standard deviations keep the noise of air out; a background of several tissues must not eat the flank.
    levels[0] = std::min(background.mean + 4 * background.stddev,
                         background.mean + 0.5 * std::max(0.0, threshold - background.mean));
    levels[0] = std::min(levels[0], threshold - least);
    levels[2] = std::max(material.mean, threshold + least);
    levels[3] = std::max(std::min(material.mean + 4 * material.stddev, s.range.hi), levels[2] + least);
    levels[4] = std::max(s.range.hi, levels[3] + least);
    return levels;
}

double on_scale(std::span<const double> levels, double at) {
    const double last = double(levels.size() - 1);
    if (at >= last) return levels.back();
    const auto i = std::size_t(std::clamp(std::floor(at), 0.0, last - 1));
    return levels[i] + (at - double(i)) * (levels[i + 1] - levels[i]);
}

/// Where a HU value of a medical preset lies in data that are not in HU: air at the background's mean level, the onset
/// of bone at Otsu's threshold, dense bone at the material's mean.
double hu_on_levels(const std::array<double, 5>& levels, double hu) {
    constexpr std::array k_hu{-950.0, 130.0, 1200.0, 2000.0, 3100.0};
    std::size_t i = 0;
    while (i + 2 < k_hu.size() && hu > k_hu[i + 1]) ++i;
    return levels[i] + (hu - k_hu[i]) / (k_hu[i + 1] - k_hu[i]) * (levels[i + 1] - levels[i]);
}

}  // namespace

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset& p : k_presets) names.emplace_back(p.name);
    return names;
}

Technique technique_of_preset(const std::string& name) {
    // Films of little opacity are dimmed to nothing by shading that follows noise; surfaces live by it.
    const bool films = name == "lung" || name == "grey";
    return {"ea", films ? "none" : "phong", 0.5};
}

TransferFunction make_preset(const std::string& name, const Volume& volume, const VolumeStatistics& statistics) {
    const auto* preset =
        std::find_if(k_presets.begin(), k_presets.end(), [&](const Preset& p) { return p.name == name; });
    if (preset == k_presets.end()) {
        std::string known;
        for (const Preset& p : k_presets) known += (known.empty() ? "" : ", ") + std::string(p.name);
        throw Error(Errc::bad_usage,
                    "There is no transfer-function preset \"" + name + "\"; the presets are " + known + ".");
    }
    const bool hu = volume.unit == "HU";
    std::span<const Node> nodes = preset->nodes;
    bool in_hu = hu && preset->medical;
    if (hu && preset->name == "metal" && statistics.range.hi > 2300) {  // implants; else there is none to see
        nodes = k_metal_hu;
        in_hu = true;
    }
    const std::array<double, 5> levels = data_levels(statistics);
    TransferFunction tf;
    tf.name = name;
    if (!volume.empty()) tf.unit_distance_mm = volume.geometry().smallest_spacing_mm();
    for (const Node& node : nodes) {
        const double value = in_hu             ? node.at
                             : preset->medical ? hu_on_levels(levels, node.at)
                                               : on_scale(levels, node.at);
        tf.points.push_back({value, node.color, node.opacity});
    }
    check(tf);
    return tf;
}

TransferFunction fit_transfer_function(const Volume& volume, const VolumeStatistics& statistics) {
    if (volume.unit != "HU") return make_preset("metal", volume, statistics);
    // Without bone in sight the soft tissue is what there is to show; without tissue the histogram decides.
    if (statistics.range.hi < -200) return make_preset("grey", volume, statistics);
    if (statistics.range.hi < 250) return make_preset("soft-tissue", volume, statistics);
    TransferFunction tf = make_preset("bone", volume, statistics);
    const std::array film{TransferPoint{-250, {0.85, 0.62, 0.50}, 0.0}, TransferPoint{-100, {0.87, 0.66, 0.54}, 0.012},
                          TransferPoint{60, {0.86, 0.56, 0.47}, 0.012}};
    tf.name = "bone over soft tissue";
    tf.points.insert(tf.points.begin(), film.begin(), film.end());
    for (TransferPoint& p : tf.points)
        if (p.value == 150) p.opacity = 0.012;
    return tf;
}

}  // namespace lacuna
