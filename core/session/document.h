#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/inspect/part_analysis.h"
#include "core/io/volume_reader.h"
#include "core/regions/regions.h"
#include "core/render/plan_json.h"
#include "core/render/scene.h"
#include "core/session/measurement.h"
#include "core/session/slice_settings.h"
#include "core/volume/statistics.h"

namespace lacuna {

struct PatientIdentity;

/// A segmentation range as a person edits it: it may be switched off without being forgotten.
struct RangeSetting {
    SegmentationRange range;
    bool enabled = true;
    glm::dvec3 color{0.25, 0.61, 1.0};  ///< what it is told by, and what "one colour" draws it in; sRGB 0..1
    friend bool operator==(const RangeSetting&, const RangeSetting&) = default;
};

/// A cutting plane as a person edits it.
struct CutSetting {
    CuttingPlane plane;
    bool enabled = true;
    friend bool operator==(const CutSetting&, const CutSetting&) = default;
};

/// A box of the volume along the grid's own axes; what lies outside is cut away.
struct BoxRoi {
    glm::dvec3 lo{0}, hi{1};  ///< shares of the box of voxel cells along each axis, 0 <= lo < hi <= 1
    bool enabled = false;
    bool cap = true;  ///< data values on the box's sides; else inner surfaces show
    friend bool operator==(const BoxRoi&, const BoxRoi&) = default;
};

/// How carefully to draw.
struct Quality {
    double step = 0.5;                   ///< in units of the smallest voxel spacing
    std::optional<Structure> structure;  ///< none: the default plan's; one that cannot serve the scene is as none
    Sampler sampler = Sampler::linear;
    /// The planner picks the rest so that no pixel is off by more than this from brute force at `step`, in 1/255.
    std::optional<double> error_budget = {};
    /// The planner picks the most exact plan that draws a frame in so many milliseconds.
    std::optional<double> time_budget_ms = {};
    /// A plan chosen by hand, as JSON (plan_json.h); it goes before budgets while it can serve the scene. Empty: none.
    std::string plan = {};
    bool has_budget() const { return plan.empty() && (error_budget || time_budget_ms); }
    friend bool operator==(const Quality&, const Quality&) = default;
};

/// What each view mode keeps for itself while another one is shown.
struct ModeSettings {
    Shading shading = Shading::phong;
    Quality quality;
    ValueRange projection_window;
    bool color_by_tf = false;
    std::vector<Effect> effects;
    friend bool operator==(const ModeSettings&, const ModeSettings&) = default;
};

/// Everything undo brings back: how the volume is shown, but neither the camera nor the cross-hair nor results.
struct ViewSettings {
    ViewMode mode = ViewMode::ea;
    double iso = 0;
    double lmip_threshold = 0;
    Shading shading = Shading::phong;
    TransferFunction tf;
    std::vector<RangeSetting> ranges;  ///< at most Classification::k_max_ranges
    std::vector<CutSetting> cuts;      ///< at most k_max_planes
    BoxRoi roi;
    ValueRange window;             ///< grey levels of the slices
    ValueRange projection_window;  ///< grey levels of the projections and of cut faces
    SliceSettings slices;
    std::vector<Measurement> measurements;
    bool color_by_tf = false;  ///< projections in the transfer function's colours
    glm::dvec3 surface_color{0.92, 0.88, 0.80};
    Quality quality;
    std::vector<Effect>
        effects;  ///< on the 3D picture, in this order; those the mode has no use for are left out of it
    std::map<ViewMode, ModeSettings> other_modes;  ///< of the modes not shown: see switch_mode()
    friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
    static constexpr std::size_t k_max_planes = 6;
};

/// Shows another mode: its own shading, quality, projection window and effects come back, those of the mode shown until
/// now are kept for its return. A mode without any takes over those shown.
void switch_mode(ViewSettings& settings, ViewMode mode);

/// What a window shows: a volume, what is known of it, how it is seen, and what was found in it. A value; copies share
/// the voxels and the results.
struct Document {
    std::string input;    ///< as opened
    OpenOptions options;  ///< as opened: which series, how raw voxels lie
    Volume volume;
    std::shared_ptr<const PatientIdentity> patient;  ///< personal: for the views' corners alone; null: not known
    std::vector<std::shared_ptr<const VoiTable>> voi_tables;  ///< the file's own tables of grey levels
    std::shared_ptr<const VolumeStatistics> statistics;
    ViewSettings settings;
    Camera camera;
    Camera home;                                            ///< where the camera starts and comes back to
    glm::dvec3 cursor_mm{0};                                ///< the linked cross-hair
    std::shared_ptr<const RegionTable> regions;             ///< null until computed
    std::uint32_t selected_region = 0;                      ///< an id of `regions`; 0: none
    std::shared_ptr<const Highlight> highlight;             ///< the selected region's voxels; null: none
    std::shared_ptr<const PartAnalysis> inspection;         ///< null until inspected
    std::uint32_t selected_defect = 0;                      ///< an id of `inspection`; 0: none
    std::shared_ptr<const std::vector<Highlight>> defects;  ///< as drawn in 3D; null: none are shown
    std::shared_ptr<const ModePlan> planned;                ///< the planner's answer to the budget; null: none yet
};

/// Whether two settings make the same 3D picture: all are equal but what only slices show.
bool same_scene(const ViewSettings& a, const ViewSettings& b);

/// A named pair of grey levels for slices, as centre and width.
struct WindowPreset {
    const char* name;
    double center, width;
};

/// Hounsfield windows for CT.
const std::vector<WindowPreset>& hounsfield_windows();

/// A document with everything fitted to the data and the cross-hair in the middle. Cost: one pass over the voxels.
/// @throws Error(bad_input) for an empty volume; Error(cancelled)
Document make_document(std::string input, Volume volume, const JobContext& job = {});

/// The grey window a volume opens with: the file's own, soft tissue for HU, else percentiles 0.1 to 99.9.
ValueRange default_window(const Volume& volume, const VolumeStatistics& statistics);

/// Has the slices shown through one of the document's tables, as the file means it.
/// @pre table < document.voi_tables.size()
void show_table(ViewSettings& settings, const Document& document, std::size_t table);

/// A front view that shows what is denser than Otsu's threshold as large as it fits from every side; the plain camera
/// where that is the whole volume. Cost: at most 256^3 voxels are looked at.
Camera home_camera(const Volume& volume, const VolumeStatistics& statistics);

/// The planes that keep the box, a plane for each side that cuts something away; none while it is off.
std::vector<CuttingPlane> planes_of(const BoxRoi& roi, const GridGeometry& geometry);

/// What the enabled cuts and the box keep, as the renderers take it.
std::vector<CuttingPlane> planes_of(const ViewSettings& settings, const GridGeometry& geometry);

/// Why a structure cannot draw the scene, in one sentence; empty where it can.
std::string structure_refusal(Structure structure, const Scene& scene);

/// The document as a scene: disabled ranges and cuts left out, the selected region highlighted, perspective dropped
/// where the mode cannot do it. The image size and background are left to the caller.
Scene scene_of(const Document& document);

/// The plan for that scene: the one chosen by hand, else what the planner answered to a budget, where it can serve the
/// scene; else the least plan at the document's quality.
Plan plan_of(const Document& document, const Scene& scene);

/// The voxels of one region as a highlight. Cost: one pass over its bounding box.
Highlight highlight_of(const RegionTable& table, const RegionCharacteristics& region);

/// The voxels of each defect as a highlight in the colour given for it, by row; the k_most_highlights largest alone,
/// because every one of them is followed by rays in every frame. Cost: one pass over their boxes.
/// @throws Error(cancelled)
std::vector<Highlight> defect_highlights(const PartAnalysis& analysis, const std::vector<glm::dvec3>& colors,
                                         const JobContext& job = {});
inline constexpr std::size_t k_most_highlights = 2000;

/// The voxel nearest to a position, clamped into the grid.
glm::ivec3 nearest_voxel(const GridGeometry& geometry, const glm::dvec3& mm);

}  // namespace lacuna
