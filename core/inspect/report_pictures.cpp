#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/accuracy/image_error.h"
#include "core/inspect/report.h"
#include "core/inspect/report_text.h"
#include "core/render/engine.h"
#include "core/render/highlight.h"
#include "core/render/reference_renderer.h"

namespace lacuna {

namespace {

constexpr glm::ivec2 k_key_size{480, 400}, k_view_size{260, 260};
constexpr int k_slice_side = 260;
constexpr int k_most_marked = 200;  // defects marked in the picture of the whole part

glm::dvec3 color_of(Verdict verdict) {
    if (verdict == Verdict::fail) return {0.85, 0.15, 0.12};
    return verdict == Verdict::pass ? glm::dvec3(0.10, 0.60, 0.30) : glm::dvec3(0.95, 0.62, 0.10);
}

/// The defect's voxels, ready to be drawn over a frame.
Highlight highlight_of(const PartAnalysis& analysis, const Defect& defect, Verdict verdict) {
    Highlight mark;
    mark.first = defect.bbox_first;
    mark.size = defect.bbox_last - defect.bbox_first + 1;
    auto inside = std::make_shared<std::vector<std::uint8_t>>();
    inside->reserve(std::size_t(mark.size.x) * std::size_t(mark.size.y) * std::size_t(mark.size.z));
    for (int z = defect.bbox_first.z; z <= defect.bbox_last.z; ++z)
        for (int y = defect.bbox_first.y; y <= defect.bbox_last.y; ++y)
            for (int x = defect.bbox_first.x; x <= defect.bbox_last.x; ++x)
                inside->push_back(analysis.labels(x, y, z) == defect.id);
    mark.inside = std::move(inside);
    mark.color = color_of(verdict);
    mark.opacity = 0.85;
    return mark;
}

std::string plan_text(const Scene& scene, const Plan& plan) {
    return fmt::format(
        "{} at {:.6g}, structure {}, step {:g}, sampler {}, refinement {} ({} steps), azimuth {:g}, "
        "elevation {:g}, zoom {:.4g}",
        name_of(scene.mode), scene.iso, name_of(plan.structure), plan.step, name_of(plan.sampler), name_of(plan.refine),
        plan.refine_steps, scene.camera.azimuth_deg, scene.camera.elevation_deg, scene.camera.zoom);
}

/// Draws one report's pictures: the scene they share, and what differs.
class Painter {
public:
    Painter(const Volume& volume, Engine& engine, InspectionReport& report)
        : volume_(volume), engine_(engine), report_(report) {
        const PartFacts& part = report.analysis.part;
        scene_.volume = volume;
        scene_.mode = ViewMode::iso;
        scene_.iso = part.material_threshold;
        scene_.background = glm::dvec3(1);
        scene_.surface_color = {0.72, 0.75, 0.80};
        const double contrast = part.material_level - part.void_level;
        scene_.window = {part.void_level, part.material_level + 0.25 * contrast};
        if (!part.has_material || !(scene_.window.hi > scene_.window.lo)) scene_.window = report.scan.range;
        if (!(scene_.window.hi > scene_.window.lo)) scene_.window.hi = scene_.window.lo + 1;
        scene_.camera.azimuth_deg = 30;
        scene_.camera.elevation_deg = 25;
    }

    ReportPicture whole(std::span<const std::uint32_t> worst, const JobContext& job) {
        Scene scene = scene_;
        scene.size = k_key_size;
        scene.camera.center_mm = part_centre();
        scene.camera.zoom = zoom_for(glm::length(part_size()));
        const auto marked = worst.subspan(0, std::min<std::size_t>(worst.size(), k_most_marked));
        ReportPicture picture = draw(scene, marked, job);
        picture.caption = marked.empty() ? "The part."
                          : marked.size() == worst.size()
                              ? "The part; every defect is drawn over it, seen through the material."
                              : fmt::format("The part; its {} worst defects are drawn over it.", marked.size());
        return picture;
    }

    ReportPicture view(const Defect& defect, const JobContext& job) {
        Scene scene = scene_;
        scene.size = k_view_size;
        scene.camera.center_mm = defect.centroid_mm;
        const double span = span_of(defect);
        scene.camera.zoom = zoom_for(span);
        const ViewRays rays = resolve(scene.camera, volume_.geometry(), scene.size);
        // What lies before the defect is cut away; the cut face shows the voxels' grey values.
        scene.cuts.push_back({rays.forward, -glm::dot(rays.forward, defect.centroid_mm), true});
        const std::uint32_t id[] = {defect.id};
        ReportPicture picture = draw(scene, id, job);
        picture.caption =
            fmt::format("Defect {}: the part cut open at its centre; the picture spans {:.3g} mm.", defect.id, span);
        return picture;
    }

    /// Voxels in the plane across the grid's third axis, the defect's outline over them.
    ReportPicture slice(const glm::dvec3& centre_mm, double side_mm, std::uint32_t id) const {
        const GridGeometry& g = volume_.geometry();
        const glm::dvec3 centre = g.mm_to_voxel(centre_mm);
        const int k = std::clamp(int(std::lround(centre.z)), 0, g.size.z - 1);
        ReportPicture picture;
        picture.size = glm::ivec2(k_slice_side);
        picture.rgb.resize(std::size_t(k_slice_side) * k_slice_side * 3, 255);
        const double pixel_mm = side_mm / k_slice_side;
        const auto voxel_at = [&](int px, int py) {
            return glm::dvec2(centre.x + (px + 0.5 - 0.5 * k_slice_side) * pixel_mm / g.spacing.x,
                              centre.y + (py + 0.5 - 0.5 * k_slice_side) * pixel_mm / g.spacing.y);
        };
        for (int py = 0; py < k_slice_side; ++py)
            for (int px = 0; px < k_slice_side; ++px)
                paint(picture, px, py, k, id, voxel_at(px, py), voxel_at(px + 2, py + 2));
        const double bar_mm = bar_length(side_mm);
        paint_bar(picture, int(std::lround(bar_mm / pixel_mm)));
        picture.caption = fmt::format("{}slice {} of {} along the third axis; the bar is {:g} mm.",
                                      id ? fmt::format("Defect {}: ", id) : "", k + 1, g.size.z, bar_mm);
        picture.plan =
            fmt::format("voxel values, nearest, window {:.6g} to {:.6g}", scene_.window.lo, scene_.window.hi);
        picture.error = "none: each pixel is the voxel it lies in, rounded to 8 bits";
        return picture;
    }

    double span_of(const Defect& defect) const {
        const GridGeometry& g = volume_.geometry();
        const double size = glm::length(defect.bbox_max_mm - defect.bbox_min_mm);
        return std::clamp(5 * size, std::min(24 * g.smallest_spacing_mm(), g.diameter_mm()), g.diameter_mm());
    }

private:
    glm::dvec3 part_centre() const {
        const PartFacts& part = report_.analysis.part;
        return 0.5 * (part.bbox_min_mm + part.bbox_max_mm);
    }
    glm::dvec3 part_size() const { return report_.analysis.part.bbox_max_mm - report_.analysis.part.bbox_min_mm; }
    /// At zoom 1 the picture spans the volume's diameter.
    double zoom_for(double span_mm) const { return volume_.geometry().diameter_mm() / std::max(1e-12, span_mm); }

    ReportPicture draw(const Scene& scene, std::span<const std::uint32_t> marked, const JobContext& job) {
        const Plan plan = default_plan(scene);
        Frame frame = engine_.render(scene, plan, job.part(0, 0.3)).frame;
        const Plan truth = reference_plan(scene, plan);
        const ImageError error = compare(frame, render_reference(scene, truth, job.part(0.3, 0.9)), scene.background);
        for (const std::uint32_t id : marked)
            draw_highlight(scene,
                           highlight_of(report_.analysis, report_.analysis.defects[id - 1],
                                        report_.judgement.defects[id - 1].verdict),
                           frame, {job.stop, nullptr});
        ReportPicture picture;
        picture.size = frame.size;
        picture.rgb = to_rgb8(frame, scene.background);
        picture.plan = plan_text(scene, plan);
        picture.error = fmt::format(
            "largest {:.3g}/255, mean {:.3g}/255, {} of {} pixels over 1/255, against the "
            "reference renderer (double precision, no structure), marks left out",
            error.max, error.mean, error.pixels_over_budget, frame.pixels());
        job.checkpoint(1, 1);
        return picture;
    }

    bool is_defect(const glm::dvec2& voxel, int k, std::uint32_t id) const {
        const glm::ivec2 at(std::lround(voxel.x), std::lround(voxel.y));
        const glm::ivec3 n = volume_.geometry().size;
        if (at.x < 0 || at.y < 0 || at.x >= n.x || at.y >= n.y) return false;
        return report_.analysis.labels(at.x, at.y, k) == id;
    }

    void paint(ReportPicture& picture, int px, int py, int k, std::uint32_t id, const glm::dvec2& voxel,
               const glm::dvec2& beyond) const {
        const glm::ivec3 n = volume_.geometry().size;
        const glm::ivec2 at(std::lround(voxel.x), std::lround(voxel.y));
        if (at.x < 0 || at.y < 0 || at.x >= n.x || at.y >= n.y) return;
        const ValueRange& w = scene_.window;
        const double shade = (volume_.value(at.x, at.y, k) - w.lo) / w.width();
        const auto grey = std::uint8_t(std::lround(255 * (std::isnan(shade) ? 0 : std::clamp(shade, 0.0, 1.0))));
        std::uint8_t* to = &picture.rgb[3 * (std::size_t(py) * k_slice_side + std::size_t(px))];
        to[0] = to[1] = to[2] = grey;
        if (id == 0) return;
        // On the outline: two pixels on, along a row or a column, what is defect ends or starts.
        const bool here = is_defect(voxel, k, id);
        if (here == is_defect({beyond.x, voxel.y}, k, id) && here == is_defect({voxel.x, beyond.y}, k, id)) return;
        const glm::dvec3 color = color_of(report_.judgement.defects[id - 1].verdict);
        for (int c = 0; c < 3; ++c) to[c] = std::uint8_t(std::lround(255 * color[c]));
    }

    /// The longest of 1, 2, 5 times a power of ten that is no longer than a third of the side.
    static double bar_length(double side_mm) {
        const double most = side_mm / 3, decade = std::pow(10.0, std::floor(std::log10(most)));
        for (const double step : {5.0, 2.0})
            if (step * decade <= most) return step * decade;
        return decade;
    }

    static void paint_bar(ReportPicture& picture, int length) {
        for (int y = k_slice_side - 14; y < k_slice_side - 9; ++y)
            for (int x = 10; x < std::min(k_slice_side, 10 + length); ++x) {
                const bool edge = y == k_slice_side - 14 || y == k_slice_side - 10;
                std::uint8_t* to = &picture.rgb[3 * (std::size_t(y) * k_slice_side + std::size_t(x))];
                to[0] = to[1] = to[2] = edge ? 0 : 255;
            }
    }

    const Volume& volume_;
    Engine& engine_;
    InspectionReport& report_;
    Scene scene_;
};

}  // namespace

std::vector<std::uint32_t> worst_first(const PartAnalysis& analysis, const Judgement& judgement) {
    std::vector<std::uint32_t> ids;
    for (const Defect& defect : analysis.defects) ids.push_back(defect.id);
    const auto rank = [&](std::uint32_t id) {
        const Verdict v = judgement.defects[id - 1].verdict;
        return v == Verdict::fail ? 0 : v == Verdict::cannot_tell ? 1 : 2;
    };
    // Ids run by descending volume already.
    std::stable_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
    return ids;
}

void draw_pictures(const Volume& volume, Engine& engine, int worst, InspectionReport& report, const JobContext& job) {
    Painter painter(volume, engine, report);
    const GridGeometry& g = volume.geometry();
    report.worst.clear();
    if (!report.analysis.part.has_material) {
        const glm::dvec3 extent = glm::dvec3(g.size) * g.spacing;
        report.key = painter.slice(g.centre_mm(), std::max(extent.x, extent.y), 0);
        return;
    }
    const std::vector<std::uint32_t> order = worst_first(report.analysis, report.judgement);
    const std::size_t pairs = std::min(order.size(), std::size_t(std::max(0, worst)));
    report.key = painter.whole(order, job.part(0, 1.0 / double(pairs + 1)));
    for (std::size_t i = 0; i < pairs; ++i) {
        const Defect& defect = report.analysis.defects[order[i] - 1];
        const JobContext step = job.part(double(i + 1) / double(pairs + 1), double(i + 2) / double(pairs + 1));
        report.worst.push_back({defect.id, painter.view(defect, step),
                                painter.slice(defect.centroid_mm, painter.span_of(defect), defect.id)});
    }
}

}  // namespace lacuna
