#include "core/session/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "core/base/csv.h"
#include "core/base/names.h"

namespace lacuna {

namespace {

constexpr NameTable<MeasurementKind, 4> k_kinds{{{MeasurementKind::distance, "distance"},
                                                 {MeasurementKind::angle, "angle"},
                                                 {MeasurementKind::rectangle, "rectangle"},
                                                 {MeasurementKind::ellipse, "ellipse"}}};

/// A shape's box in its plane, mm from the plane's foot of the origin along right and down.
struct PlaneBox {
    glm::dvec2 lo, hi;
    explicit PlaneBox(const Measurement& m) {
        const auto at = [&](const glm::dvec3& p) { return glm::dvec2(glm::dot(p, m.right), glm::dot(p, m.down)); };
        lo = glm::min(at(m.points_mm[0]), at(m.points_mm[1]));
        hi = glm::max(at(m.points_mm[0]), at(m.points_mm[1]));
    }
};

/// The pixels of a shape's box: voxels where its sides run along the grid, else samples of its own lattice.
SliceFrame frame_of_shape(const GridGeometry& grid, const Measurement& m) {
    const PlaneBox box(m);
    SliceFrame frame;
    frame.right = m.right;
    frame.down = m.down;
    const glm::dvec3 middle = 0.5 * (m.points_mm[0] + m.points_mm[1]);
    const double depth = glm::dot(middle, m.normal());
    const auto place = [&](const glm::dvec2& corner) {
        frame.corner_mm = m.right * corner.x + m.down * corner.y + m.normal() * depth;
    };
    // Along the grid? Then a pixel is a voxel, and the lattice that of the voxel nearest to the middle.
    const auto step_along = [&](const glm::dvec3& direction) { return sheet_distance_mm(grid, direction); };
    frame.pixel_mm = {step_along(m.right), step_along(m.down)};
    const glm::dvec3 voxel = grid.voxel_to_mm(glm::round(grid.mm_to_voxel(middle)));
    frame.corner_mm = voxel - 0.5 * (frame.right * frame.pixel_mm.x + frame.down * frame.pixel_mm.y);
    frame.size = {1, 1};
    if (voxel_walk(grid, frame).on_grid) {
        const glm::dvec2 own(glm::dot(voxel, m.right), glm::dot(voxel, m.down));
        const glm::dvec2 first = glm::floor((box.lo - own) / frame.pixel_mm),
                         last = glm::ceil((box.hi - own) / frame.pixel_mm);
        frame.corner_mm += frame.right * (first.x * frame.pixel_mm.x) + frame.down * (first.y * frame.pixel_mm.y);
        frame.size = glm::ivec2(last - first) + 1;
        return frame;
    }
    frame.pixel_mm = glm::dvec2(grid.smallest_spacing_mm());
    place(box.lo);
    frame.size = glm::max(glm::ivec2(glm::ceil((box.hi - box.lo) / frame.pixel_mm)), glm::ivec2(1));
    return frame;
}

bool holds(const Measurement& m, const PlaneBox& box, const glm::dvec3& mm) {
    const glm::dvec2 at(glm::dot(mm, m.right), glm::dot(mm, m.down));
    if (m.kind == MeasurementKind::rectangle)
        return glm::all(glm::greaterThanEqual(at, box.lo)) && glm::all(glm::lessThan(at, box.hi));
    const glm::dvec2 radii = 0.5 * (box.hi - box.lo);
    if (!(radii.x > 0 && radii.y > 0)) return false;
    const glm::dvec2 share = (at - 0.5 * (box.lo + box.hi)) / radii;
    return glm::dot(share, share) <= 1;
}

std::string number(double value) {
    if (!std::isfinite(value)) return "";
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    std::replace(text, text + std::char_traits<char>::length(text), ',', '.');  // whatever the locale says
    return text;
}

}  // namespace

int point_count(MeasurementKind kind) { return kind == MeasurementKind::angle ? 3 : 2; }

std::string_view name_of(MeasurementKind kind) { return name_in(k_kinds, kind); }
MeasurementKind parse_measurement_kind(std::string_view text) { return parse_name(k_kinds, text, "measurement"); }

const char* fault_of(const Measurement& m) {
    if (int(m.points_mm.size()) != point_count(m.kind)) return "it has not as many points as its kind needs.";
    for (const glm::dvec3& p : m.points_mm)
        if (!(glm::dot(p, p) < 1e18)) return "a point is no position.";
    const auto unit = [](const glm::dvec3& v) { return std::abs(glm::length(v) - 1) <= 1e-6; };
    if (!unit(m.right) || !unit(m.down) || !(std::abs(glm::dot(m.right, m.down)) <= 1e-6))
        return "its axes are no unit vectors at right angles.";
    return "";
}

double length_mm(const Measurement& m) { return glm::distance(m.points_mm[0], m.points_mm[1]); }

double angle_deg(const Measurement& m) {
    const glm::dvec3 a = m.points_mm[0] - m.points_mm[1], b = m.points_mm[2] - m.points_mm[1];
    // atan2 keeps its digits near 0 and 180 degrees, where the arc cosine loses half of them.
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

glm::dvec2 extent_mm(const Measurement& m) {
    const PlaneBox box(m);
    return box.hi - box.lo;
}

double area_mm2(const Measurement& m) {
    const glm::dvec2 extent = extent_mm(m);
    return extent.x * extent.y * (m.kind == MeasurementKind::ellipse ? 0.25 * std::numbers::pi : 1.0);
}

RegionStatistics::RegionStatistics() { mean = stddev = min = max = std::numeric_limits<double>::quiet_NaN(); }

RegionStatistics region_statistics(const Volume& volume, const Measurement& m, const JobContext& job) {
    const SliceFrame frame = frame_of_shape(volume.geometry(), m);
    const std::vector<float> values = reslice(volume, frame, {}, job);
    const PlaneBox box(m);
    RegionStatistics found;
    // Welford: no digits are lost where the mean is large against the spread.
    double mean = 0, squares = 0;
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            const double value = values[std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x)];
            if (!std::isfinite(value) || !holds(m, box, frame.to_mm({x + 0.5, y + 0.5}))) continue;
            ++found.pixels;
            const double off = value - mean;
            mean += off / double(found.pixels);
            squares += off * (value - mean);
            found.min = found.pixels == 1 ? value : std::min(found.min, value);
            found.max = found.pixels == 1 ? value : std::max(found.max, value);
        }
    if (found.pixels == 0) return found;
    found.mean = mean;
    found.stddev = std::sqrt(squares / double(found.pixels));
    return found;
}

bool lies_in(const Measurement& m, const SliceFrame& frame, double tolerance_mm) {
    constexpr double k_parallel = 1 - 1.5e-6;  // cosine of 0.1 degrees
    if (m.is_region() && !(std::abs(glm::dot(m.normal(), frame.normal())) >= k_parallel)) return false;
    return std::all_of(m.points_mm.begin(), m.points_mm.end(),
                       [&](const glm::dvec3& p) { return std::abs(frame.depth_mm(p)) <= tolerance_mm; });
}

std::uint32_t next_measurement_id(std::span<const Measurement> all) {
    std::uint32_t largest = 0;
    for (const Measurement& m : all) largest = std::max(largest, m.id);
    return largest + 1;
}

std::string measurements_to_csv(const Volume& volume, std::span<const Measurement> all, const JobContext& job) {
    std::string out =
        "id,kind,length_mm,angle_deg,width_mm,height_mm,area_mm2,pixels,mean,stddev,min,max,unit,points_mm\r\n";
    for (const Measurement& m : all) {
        std::string points;
        for (const glm::dvec3& p : m.points_mm)
            points += (points.empty() ? "" : "; ") + number(p.x) + " " + number(p.y) + " " + number(p.z);
        std::array<std::string, 10> cell;  // what a kind has not stays empty
        if (m.kind == MeasurementKind::distance) cell[0] = number(length_mm(m));
        if (m.kind == MeasurementKind::angle) cell[1] = number(angle_deg(m));
        if (m.is_region()) {
            const RegionStatistics s = region_statistics(volume, m, job);
            const glm::dvec2 extent = extent_mm(m);
            cell = {"",
                    "",
                    number(extent.x),
                    number(extent.y),
                    number(area_mm2(m)),
                    std::to_string(s.pixels),
                    number(s.mean),
                    number(s.stddev),
                    number(s.min),
                    number(s.max)};
        }
        out += std::to_string(m.id) + "," + std::string(name_of(m.kind));
        for (const std::string& text : cell) out += "," + text;
        out += "," + csv_field(volume.unit) + "," + csv_field(points) + "\r\n";
    }
    return out;
}

}  // namespace lacuna
