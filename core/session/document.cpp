#include "core/session/document.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna {

bool same_scene(const ViewSettings& a, const ViewSettings& b) {
    ViewSettings other = b;
    other.window = a.window;
    other.slices = a.slices;
    other.measurements = a.measurements;
    return a == other;
}

const std::vector<WindowPreset>& hounsfield_windows() {
    static const std::vector<WindowPreset> presets = {{"Brain", 40, 80},        {"Abdomen", 40, 400},
                                                      {"Bone", 500, 2000},      {"Lung", -600, 1500},
                                                      {"Mediastinum", 50, 350}, {"Angio", 300, 600}};
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

namespace {

/// How many of the voxels looked at, every `stride`-th along each axis, reach the threshold, by plane along each axis.
struct PlaneCounts {
    std::vector<std::int64_t> along[3];
    glm::ivec3 stride{1};
};

template <class T>
PlaneCounts count_dense(const VolumeView<T>& view, double threshold) {
    PlaneCounts counts;
    for (int axis = 0; axis < 3; ++axis) {
        counts.stride[axis] = std::max(1, (view.size[axis] + 255) / 256);
        counts.along[axis].assign(std::size_t((view.size[axis] - 1) / counts.stride[axis] + 1), 0);
    }
    for (int z = 0; z < view.size.z; z += counts.stride.z)
        for (int y = 0; y < view.size.y; y += counts.stride.y) {
            const T* row = view.row(y, z);
            std::int64_t in_row = 0;
            for (int x = 0; x < view.size.x; x += counts.stride.x)
                if (double(row[x]) >= threshold) {
                    ++in_row;
                    ++counts.along[0][std::size_t(x / counts.stride.x)];
                }
            counts.along[1][std::size_t(y / counts.stride.y)] += in_row;
            counts.along[2][std::size_t(z / counts.stride.z)] += in_row;
        }
    return counts;
}

}  // namespace

Camera home_camera(const Volume& volume, const VolumeStatistics& statistics) {
    const double threshold = otsu_threshold(statistics);
    const PlaneCounts counts =
        visit_type(volume.type(), [&](auto tag) { return count_dense(volume.view<decltype(tag)>(), threshold); });
    const GridGeometry& geometry = volume.geometry();
    glm::dvec3 first(0), last(0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto& planes = counts.along[axis];
        // A few bright voxels of noise do not make a plane part of the object.
        const std::int64_t most = *std::max_element(planes.begin(), planes.end());
        const auto dense = [&](std::int64_t count) { return count > most / 200; };
        const auto from = std::find_if(planes.begin(), planes.end(), dense);
        const auto to = std::find_if(planes.rbegin(), planes.rend(), dense);
        if (from == planes.end()) return {};
        first[axis] = double(from - planes.begin()) * counts.stride[axis] - 0.5;
        last[axis] = std::min(double(planes.rend() - to) * counts.stride[axis], double(geometry.size[axis])) - 0.5;
    }
    Camera camera;
    const double span_mm = glm::length((last - first) * geometry.spacing);
    if (!(span_mm > 0) || span_mm > 0.9 * geometry.diameter_mm()) return camera;
    camera.zoom = std::min(geometry.diameter_mm() / span_mm, 20.0);
    camera.center_mm = geometry.voxel_to_mm(0.5 * (first + last));
    return camera;
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
    // PS3.3 C.11.2.1.3: LINEAR where a DICOM file says nothing else; read_screen_facts() tells what it says.
    if (document.volume.dicom) settings.slices.function = VoiFunction::linear;
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip,
                                ViewMode::mean, ViewMode::shear_warp})
        if (mode != settings.mode)
            settings.other_modes[mode] = {settings.shading, settings.quality, settings.projection_window, false, {}};
    document.home = home_camera(document.volume, *document.statistics);
    document.camera = document.home;
    const GridGeometry& geometry = document.volume.geometry();
    document.cursor_mm = geometry.voxel_to_mm(glm::dvec3(geometry.size / 2));
    return document;
}

namespace {

/// Highlights are blended one after the other: the nearest has to come last. The chosen defect stands out.
void append_far_to_near(const std::vector<Highlight>& highlights, const Document& document,
                        std::vector<Highlight>& out) {
    const GridGeometry& geometry = document.volume.geometry();
    const ViewRays rays = resolve(document.camera, geometry, {2, 2});
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < highlights.size(); ++i) {
        const glm::dvec3 middle = glm::dvec3(highlights[i].first) + 0.5 * glm::dvec3(highlights[i].size - 1);
        order.emplace_back(-glm::dot(geometry.voxel_to_mm(middle), rays.forward), i);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [depth, i] : order) {
        out.push_back(highlights[i]);
        if (document.selected_defect != 0) out.back().opacity = i + 1 == document.selected_defect ? 0.95 : 0.35;
    }
}

}  // namespace

void switch_mode(ViewSettings& settings, ViewMode mode) {
    if (mode == settings.mode) return;
    settings.other_modes[settings.mode] = {settings.shading, settings.quality, settings.projection_window,
                                           settings.color_by_tf, settings.effects};
    settings.mode = mode;
    const auto own = settings.other_modes.find(mode);
    if (own == settings.other_modes.end()) return;
    settings.shading = own->second.shading;
    settings.quality = own->second.quality;
    settings.projection_window = own->second.projection_window;
    settings.color_by_tf = own->second.color_by_tf;
    settings.effects = std::move(own->second.effects);
    settings.other_modes.erase(own);
}

void show_table(ViewSettings& settings, const Document& document, std::size_t table) {
    const VoiTable& chosen = *document.voi_tables[table];
    settings.slices.function = VoiFunction::table;
    settings.slices.table = int(table);
    settings.window = {chosen.first, chosen.last()};
}

std::vector<CuttingPlane> planes_of(const BoxRoi& roi, const GridGeometry& geometry) {
    std::vector<CuttingPlane> planes;
    if (!roi.enabled) return planes;
    const glm::dvec3 cells(geometry.size);
    const auto side = [&](int axis, double share, double inwards) {
        const glm::dvec3 normal = inwards * geometry.direction[axis];
        const glm::dvec3 corner = geometry.voxel_to_mm(share * cells - 0.5);
        planes.push_back({normal, -glm::dot(normal, corner), roi.cap});
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (roi.lo[axis] > 0) side(axis, roi.lo[axis], 1);
        if (roi.hi[axis] < 1) side(axis, roi.hi[axis], -1);
    }
    return planes;
}

std::vector<CuttingPlane> planes_of(const ViewSettings& settings, const GridGeometry& geometry) {
    std::vector<CuttingPlane> planes;
    for (const CutSetting& cut : settings.cuts)
        if (cut.enabled) planes.push_back(cut.plane);
    for (const CuttingPlane& side : planes_of(settings.roi, geometry)) planes.push_back(side);
    return planes;
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
    scene.cuts = planes_of(settings, document.volume.geometry());
    for (const Effect& effect : settings.effects)
        if (serves(effect.kind, settings.mode)) scene.effects.push_back(effect);
    scene.camera = document.camera;
    if (scene.mode == ViewMode::shear_warp) scene.camera.fov_deg.reset();
    if (document.defects) append_far_to_near(*document.defects, document, scene.highlights);
    if (document.highlight) scene.highlights.push_back(*document.highlight);
    return scene;
}

namespace {

/// The plan where it is of the scene's mode and can serve it.
std::optional<Plan> serving(const ModePlan& plan, const Scene& scene) {
    if (plan.mode != scene.mode) return std::nullopt;
    try {
        check(plan.plan, scene);
    } catch (const Error&) {
        return std::nullopt;
    }
    return plan.plan;
}

std::optional<Plan> asked_for(const Document& document, const Scene& scene) {
    const Quality& quality = document.settings.quality;
    if (quality.has_budget()) return document.planned ? serving(*document.planned, scene) : std::nullopt;
    if (quality.plan.empty()) return std::nullopt;
    try {
        return serving(plan_from_json(quality.plan, "the chosen plan"), scene);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

std::string structure_refusal(Structure structure, const Scene& scene) {
    Plan plan = default_plan(scene);
    plan.structure = structure;
    try {
        check(plan, scene);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

Plan plan_of(const Document& document, const Scene& scene) {
    if (std::optional<Plan> asked = asked_for(document, scene)) return *std::move(asked);
    Plan plan = default_plan(scene);
    const Quality& quality = document.settings.quality;
    plan.step = quality.step;
    plan.sampler = quality.sampler;
    if (!quality.structure || *quality.structure == plan.structure) return plan;
    if (const std::string refusal = structure_refusal(*quality.structure, scene); !refusal.empty()) {
        plan.why.push_back(refusal);
        return plan;
    }
    plan.structure = *quality.structure;
    plan.why.push_back("The structure '" + std::string(name_of(plan.structure)) + "', as asked.");
    return plan;
}

Highlight highlight_of(const RegionTable& table, const RegionCharacteristics& region) {
    Highlight highlight;
    highlight.first = region.bbox_first;
    highlight.size = region.bbox_last - region.bbox_first + 1;
    highlight.inside = std::make_shared<const std::vector<std::uint8_t>>(region_mask(table.labels, region));
    return highlight;
}

std::vector<Highlight> defect_highlights(const PartAnalysis& analysis, const std::vector<glm::dvec3>& colors,
                                         const JobContext& job) {
    // Ids go by descending volume: the first rows are the largest.
    const std::size_t count = std::min({analysis.defects.size(), colors.size(), k_most_highlights});
    std::vector<Highlight> highlights(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Defect& defect = analysis.defects[i];
        RegionCharacteristics box;
        box.id = defect.id;
        box.bbox_first = defect.bbox_first;
        box.bbox_last = defect.bbox_last;
        highlights[i].first = defect.bbox_first;
        highlights[i].size = defect.bbox_last - defect.bbox_first + 1;
        highlights[i].inside = std::make_shared<const std::vector<std::uint8_t>>(region_mask(analysis.labels, box));
        highlights[i].color = colors[i];
        job.checkpoint(i, count);
    }
    return highlights;
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
