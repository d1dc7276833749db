#include "core/session/document.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna {

const std::vector<WindowPreset>& hounsfield_windows() {
    static const std::vector<WindowPreset> presets = {{"Brain", 40, 80},        {"Abdomen", 40, 400},
                                                      {"Mediastinum", 50, 350}, {"Bone", 500, 2000},
                                                      {"Lung", -600, 1500},     {"Angio", 300, 600}};
    return presets;
}

ValueRange default_window(const Volume& volume, const VolumeStatistics& statistics) {
    if (volume.dicom && volume.dicom->window_center && volume.dicom->window_width && *volume.dicom->window_width > 0) {
        const double half = 0.5 * *volume.dicom->window_width;
        return {*volume.dicom->window_center - half, *volume.dicom->window_center + half};
    }
    if (volume.unit == "HU") return {-160, 240};
    const ValueRange middle{statistics.percentile(0.001), statistics.percentile(0.999)};
    if (middle.width() > 0) return middle;
    if (statistics.range.width() > 0) return statistics.range;
    return {statistics.range.lo - 0.5, statistics.range.lo + 0.5};
}

Document make_document(std::string input, Volume volume, const JobContext& job) {
    if (volume.empty()) throw Error(Errc::bad_input, "The volume holds no voxels.", input);
    Document document;
    document.input = std::move(input);
    document.volume = std::move(volume);
    document.statistics = std::make_shared<const VolumeStatistics>(compute_statistics(document.volume, job));
    job.check();
    const Scene scene = default_scene(document.volume, *document.statistics);
    ViewSettings& settings = document.settings;
    settings.mode = scene.mode;
    settings.iso = scene.iso;
    settings.lmip_threshold = scene.lmip_threshold;
    settings.shading = scene.shading;
    settings.tf = scene.classification.tf;
    settings.surface_color = scene.surface_color;
    settings.projection_window = scene.window;
    settings.window = default_window(document.volume, *document.statistics);
    document.camera = scene.camera;
    const GridGeometry& geometry = document.volume.geometry();
    document.cursor_mm = geometry.voxel_to_mm(glm::dvec3(geometry.size / 2));
    return document;
}

Scene scene_of(const Document& document) {
    const ViewSettings& settings = document.settings;
    Scene scene;
    scene.volume = document.volume;
    scene.mode = settings.mode;
    scene.iso = settings.iso;
    scene.lmip_threshold = settings.lmip_threshold;
    scene.shading = settings.shading;
    scene.surface_color = settings.surface_color;
    scene.window = settings.projection_window;
    scene.color_by_tf = settings.color_by_tf;
    scene.classification.tf = settings.tf;
    for (const RangeSetting& range : settings.ranges)
        if (range.enabled) scene.classification.ranges.push_back(range.range);
    for (const CutSetting& cut : settings.cuts)
        if (cut.enabled) scene.cuts.push_back(cut.plane);
    scene.camera = document.camera;
    if (scene.mode == ViewMode::shear_warp) scene.camera.fov_deg.reset();
    if (document.highlight) scene.highlights.push_back(*document.highlight);
    return scene;
}

Plan plan_of(const Document& document, const Scene& scene) {
    Plan plan = default_plan(scene);
    const Quality& quality = document.settings.quality;
    plan.step = quality.step;
    plan.sampler = quality.sampler;
    if (!quality.skip_empty && scene.mode != ViewMode::shear_warp) {
        plan.structure = Structure::none;
        plan.why.push_back("Empty space is not skipped, as asked.");
    }
    return plan;
}

Highlight highlight_of(const RegionTable& table, const RegionCharacteristics& region) {
    Highlight highlight;
    highlight.first = region.bbox_first;
    highlight.size = region.bbox_last - region.bbox_first + 1;
    highlight.inside = std::make_shared<const std::vector<std::uint8_t>>(region_mask(table.labels, region));
    return highlight;
}

glm::ivec3 nearest_voxel(const GridGeometry& geometry, const glm::dvec3& mm) {
    const glm::dvec3 voxel = glm::round(geometry.mm_to_voxel(mm));
    glm::ivec3 nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const double last = geometry.size[axis] - 1;
        nearest[axis] = voxel[axis] > 0 ? int(std::min(voxel[axis], last)) : 0;  // NaN becomes 0
    }
    return nearest;
}

}  // namespace lacuna
