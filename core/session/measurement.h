#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/volume/reslice.h"
#include "core/volume/volume.h"

namespace lacuna {

enum class MeasurementKind { distance, angle, rectangle, ellipse };

/// Points a person needs to set: distance 2 (its ends), angle 3 (the vertex second), rectangle and ellipse 2 (opposite
/// corners of the shape's box).
int point_count(MeasurementKind kind);
/// "distance", "angle", "rectangle", "ellipse"; @throws Error(bad_usage) for an unknown word
std::string_view name_of(MeasurementKind kind);
MeasurementKind parse_measurement_kind(std::string_view text);

/// Something measured on a slice, wherever that lies in space. A plain value.
struct Measurement {
    std::uint32_t id = 0;  ///< distinguishes the measurements of a document; from 1
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<glm::dvec3> points_mm;  ///< point_count(kind) positions in one plane
    /// The plane it was drawn in: unit vectors across and down. A shape's sides run along them.
    glm::dvec3 right{1, 0, 0}, down{0, 1, 0};
    glm::dvec3 normal() const { return glm::cross(right, down); }
    bool is_region() const { return kind == MeasurementKind::rectangle || kind == MeasurementKind::ellipse; }
    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// What makes it no measurement (points, axes), in one sentence; empty when it is sound.
const char* fault_of(const Measurement& m);

/// Length of a distance, mm. @pre kind is distance
double length_mm(const Measurement& m);
/// The angle at the vertex, 0..180 degrees; 0 where a leg has no length. @pre kind is angle
double angle_deg(const Measurement& m);
/// Width and height of a shape's box, mm. @pre is_region()
glm::dvec2 extent_mm(const Measurement& m);
/// Area of the drawn shape, mm^2; its pixels' area differs by what the border cuts. @pre is_region()
double area_mm2(const Measurement& m);

/// The values in a shape. NaN where it holds no pixel with a value.
struct RegionStatistics {
    std::int64_t pixels = 0;  ///< with a value
    double mean, stddev;      ///< stddev of the population (divided by the number of pixels)
    double min, max;
    RegionStatistics();
};

/// Statistics of a shape's pixels: those with their centre inside it (a rectangle's left and upper border counted in,
/// the others out, so that rectangles side by side share none; an ellipse's border in). Along the grid the pixels are
/// the voxels of the nearest slice; else trilinear samples, `smallest spacing` apart, beginning half of that from the
/// shape's corner. A slab shown takes no part: they are the values of the plane. Cost: as reslice() of the shape's box.
/// @pre is_region(), the volume is in memory. @throws Error(cancelled)
RegionStatistics region_statistics(const Volume& volume, const Measurement& m, const JobContext& job = {});

/// Whether it lies in a picture's plane: every point within `tolerance_mm` of it, and a shape's plane parallel to it
/// (within 0.1 degrees).
bool lies_in(const Measurement& m, const SliceFrame& frame, double tolerance_mm);

/// A smallest id no measurement has.
std::uint32_t next_measurement_id(std::span<const Measurement> all);

/// One row a measurement: id, kind, length, angle, area, pixels, mean, stddev, min, max, unit, points. Carries nothing
/// of the patient. RFC 4180, numbers with a full stop.
std::string measurements_to_csv(const Volume& volume, std::span<const Measurement> all, const JobContext& job = {});

}  // namespace lacuna
