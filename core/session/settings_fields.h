#pragma once

#include "core/session/document.h"
#include "core/session/json_fields.h"

// The fields of what a session file holds, one line each (see json_fields.h). A field added to one of these structs is
// added here, or it is lost with every session that is saved; tests/unit/session checks that none is.
namespace lacuna {

inline ViewMode word_to(std::string_view text, ViewMode) { return parse_view_mode(text); }
inline Shading word_to(std::string_view text, Shading) { return parse_shading(text); }
inline Structure word_to(std::string_view text, Structure) { return parse_structure(text); }
inline Sampler word_to(std::string_view text, Sampler) { return parse_sampler(text); }

inline VoiFunction word_to(std::string_view text, VoiFunction) { return parse_voi_function(text); }
inline SlabMode word_to(std::string_view text, SlabMode) { return parse_slab_mode(text); }
inline MeasurementKind word_to(std::string_view text, MeasurementKind) { return parse_measurement_kind(text); }

template <class Archive>
void fields(Archive& archive, ValueRange& range) {
    archive("lo", range.lo);
    archive("hi", range.hi);
}

template <class Archive>
void fields(Archive& archive, SegmentationRange& range) {
    archive("name", range.name);
    archive("range", range.range);
    archive("tf", range.tf);
}

template <class Archive>
void fields(Archive& archive, RangeSetting& setting) {
    archive("range", setting.range);
    archive("enabled", setting.enabled);
    archive("color", setting.color);
}

template <class Archive>
void fields(Archive& archive, CuttingPlane& plane) {
    archive("normal", plane.normal);
    archive("offset", plane.offset);
    archive("cap", plane.cap);
}

template <class Archive>
void fields(Archive& archive, CutSetting& setting) {
    archive("plane", setting.plane);
    archive("enabled", setting.enabled);
}

template <class Archive>
void fields(Archive& archive, Quality& quality) {
    archive("step", quality.step);
    archive("structure", quality.structure);
    archive("sampler", quality.sampler);
    archive("error_budget", quality.error_budget);
    archive("time_budget_ms", quality.time_budget_ms);
    archive("plan", quality.plan);
}

template <class Archive>
void fields(Archive& archive, Slab& slab) {
    archive("thickness_mm", slab.thickness_mm);
    archive("mode", slab.mode);
}

template <class Archive>
void fields(Archive& archive, SliceSettings& slices) {
    archive("function", slices.function);
    archive("table", slices.table);
    archive("tilt", slices.tilt);
    archive("slab", slices.slab);
    archive("overlay_opacity", slices.overlay_opacity);
}

template <class Archive>
void fields(Archive& archive, Measurement& measurement) {
    archive("id", measurement.id);
    archive("kind", measurement.kind);
    archive("points_mm", measurement.points_mm);
    archive("right", measurement.right);
    archive("down", measurement.down);
}

template <class Archive>
void fields(Archive& archive, BoxRoi& box) {
    archive("lo", box.lo);
    archive("hi", box.hi);
    archive("enabled", box.enabled);
    archive("cap", box.cap);
}

template <class Archive>
void fields(Archive& archive, ModeSettings& settings) {
    archive("shading", settings.shading);
    archive("quality", settings.quality);
    archive("projection_window", settings.projection_window);
    archive("color_by_tf", settings.color_by_tf);
    archive("effects", settings.effects);
}

template <class Archive>
void fields(Archive& archive, ViewSettings& settings) {
    archive("mode", settings.mode);
    archive("iso", settings.iso);
    archive("lmip_threshold", settings.lmip_threshold);
    archive("shading", settings.shading);
    archive("tf", settings.tf);
    archive("ranges", settings.ranges);
    archive("cuts", settings.cuts);
    archive("roi", settings.roi);
    archive("window", settings.window);
    archive("projection_window", settings.projection_window);
    archive("slices", settings.slices);
    archive("measurements", settings.measurements);
    archive("color_by_tf", settings.color_by_tf);
    archive("surface_color", settings.surface_color);
    archive("quality", settings.quality);
    archive("effects", settings.effects);
    archive("other_modes", settings.other_modes);
}

template <class Archive>
void fields(Archive& archive, Camera& camera) {
    archive("azimuth_deg", camera.azimuth_deg);
    archive("elevation_deg", camera.elevation_deg);
    archive("roll_deg", camera.roll_deg);
    archive("zoom", camera.zoom);
    archive("center_mm", camera.center_mm);
    archive("fov_deg", camera.fov_deg);
}

}  // namespace lacuna
