#include "core/session/cut_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lacuna {

namespace {

constexpr double k_arrow_px = 64;      // of the arrow, where it is seen from the side
constexpr double k_tilt_share = 0.72;  // of the way from the anchor to the section's border
constexpr double k_least_tilt_px = 30;
constexpr double k_end_on = 0.97;  // a normal this close to the line of sight cannot be followed along itself

glm::dvec3 box_corner(int corner, const GridGeometry& geometry) {
    return geometry.voxel_to_mm(glm::dvec3(corner & 1, (corner >> 1) & 1, corner >> 2) * glm::dvec3(geometry.size) -
                                0.5);
}

/// Two unit vectors in the plane, the first as level with a grid axis as can be.
std::array<glm::dvec3, 2> axes_in(const glm::dvec3& normal, const GridGeometry& geometry) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(glm::dot(normal, geometry.direction[axis])) <
            std::abs(glm::dot(normal, geometry.direction[least])) - 1e-9)
            least = axis;
    const glm::dvec3 along = geometry.direction[least];
    const glm::dvec3 u = glm::normalize(along - normal * glm::dot(along, normal));
    return {u, glm::cross(normal, u)};
}

/// Size of a pixel at a position, mm.
double pixel_at(const ViewRays& rays, const glm::dvec3& mm) {
    if (!rays.perspective) return rays.pixel_mm;
    return rays.pixel_mm * std::max(glm::dot(mm - rays.eye, rays.forward), 1e-6) / rays.distance_mm;
}

glm::dvec3 line_of_sight(const ViewRays& rays, const glm::dvec3& mm) {
    return rays.perspective ? glm::normalize(mm - rays.eye) : rays.forward;
}

/// How far along the line through p (direction d, unit) its point nearest to the ray through a pixel lies; where the
/// line is seen end on, how far the position is above where it was taken, upwards being away from the viewer.
double along_line(const ViewRays& rays, const glm::dvec3& p, const glm::dvec3& d, glm::dvec2 at, glm::dvec2 from) {
    const glm::dvec3 sight = line_of_sight(rays, p);
    const double facing = glm::dot(d, sight);
    if (std::abs(facing) > k_end_on) return (at.y - from.y) * pixel_at(rays, p) * (facing > 0 ? -1 : 1);
    const glm::dvec3 o = rays.origin(at.x - 0.5, at.y - 0.5), r = rays.direction(at.x - 0.5, at.y - 0.5);
    const double cosine = glm::dot(d, r), rest = 1 - cosine * cosine;
    if (!(rest > 1e-6)) return 0;
    const glm::dvec3 between = p - o;
    return (cosine * glm::dot(between, r) - glm::dot(between, d)) / rest;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - a - t * along);
}

double distance_in_picture(const ViewRays& rays, const glm::dvec3& mm, glm::dvec2 at) {
    const std::optional<glm::dvec2> where = in_picture(rays, mm);
    return where ? glm::length(*where - at) : std::numeric_limits<double>::infinity();
}

double distance_to_line(const ViewRays& rays, const glm::dvec3& a, const glm::dvec3& b, glm::dvec2 at) {
    const std::optional<glm::dvec2> from = in_picture(rays, a), to = in_picture(rays, b);
    return from && to ? distance_to_segment(at, *from, *to) : std::numeric_limits<double>::infinity();
}

glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double radians) {
    const double c = std::cos(radians), s = std::sin(radians);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));  // Rodrigues
}

CuttingPlane through(const glm::dvec3& normal, const glm::dvec3& point, bool cap) {
    return {normal, -glm::dot(normal, point), cap};
}

}  // namespace

double half_extent_mm(const glm::dvec3& direction, const GridGeometry& geometry) {
    double half = 0;
    for (int axis = 0; axis < 3; ++axis)
        half += 0.5 * std::abs(glm::dot(direction, geometry.direction[axis])) * geometry.size[axis] *
                geometry.spacing[axis];
    return half;
}

std::vector<glm::dvec3> section_of(const CuttingPlane& plane, const GridGeometry& geometry) {
    const double length = glm::length(plane.normal);
    if (!(length > 0) || geometry.size.x < 1) return {};
    const glm::dvec3 n = plane.normal / length;
    const double near = 1e-9 * geometry.diameter_mm();
    std::vector<glm::dvec3> corners;
    const auto add = [&](const glm::dvec3& at) {
        for (const glm::dvec3& other : corners)
            if (glm::length(other - at) <= 2 * near) return;
        corners.push_back(at);
    };
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            if (corner & (1 << axis)) continue;
            const glm::dvec3 a = box_corner(corner, geometry), b = box_corner(corner | (1 << axis), geometry);
            const double da = glm::dot(n, a) + plane.offset / length, db = glm::dot(n, b) + plane.offset / length;
            if (std::abs(da) <= near) add(a);
            if (std::abs(db) <= near) add(b);
            if ((da < -near && db > near) || (da > near && db < -near)) add(glm::mix(a, b, da / (da - db)));
        }
    if (corners.size() < 3) return {};
    glm::dvec3 middle(0);
    for (const glm::dvec3& corner : corners) middle += corner / double(corners.size());
    const auto [u, v] = axes_in(n, geometry);
    std::sort(corners.begin(), corners.end(), [&, &u = u, &v = v](const glm::dvec3& a, const glm::dvec3& b) {
        return std::atan2(glm::dot(a - middle, v), glm::dot(a - middle, u)) <
               std::atan2(glm::dot(b - middle, v), glm::dot(b - middle, u));
    });
    return corners;
}

CuttingPlane moved(const CuttingPlane& plane, double mm, const GridGeometry& geometry) {
    const double length = glm::length(plane.normal);
    const glm::dvec3 n = plane.normal / length;
    const double middle = glm::dot(n, geometry.centre_mm()), half = half_extent_mm(n, geometry);
    const double at = std::clamp(-plane.offset / length + mm - middle, -half, half);
    return {n, -(middle + at), plane.cap};
}

CuttingPlane turned(const CuttingPlane& plane, const glm::dvec3& axis, double degrees, const glm::dvec3& about) {
    const glm::dvec3 n = rotated(glm::normalize(plane.normal), glm::normalize(axis), glm::radians(degrees));
    return through(glm::normalize(n), about, plane.cap);
}

glm::dvec3 snapped(const glm::dvec3& normal, const GridGeometry& geometry) {
    glm::dvec3 best(1, 0, 0);
    double most = -2;
    for (int i = 0; i < 27; ++i) {
        if (i == 13) continue;  // no direction
        const glm::dvec3 d = glm::normalize(geometry.direction * glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        if (const double closeness = glm::dot(d, normal); closeness > most) {
            most = closeness;
            best = d;
        }
    }
    return best;
}

std::optional<glm::dvec2> in_picture(const ViewRays& rays, const glm::dvec3& mm) {
    if (rays.perspective && !(glm::dot(mm - rays.eye, rays.forward) > 1e-3 * rays.distance_mm)) return std::nullopt;
    return rays.project(mm) + 0.5;
}

PlaneGizmo gizmo_of(const CuttingPlane& plane, const GridGeometry& geometry, const ViewRays& rays) {
    PlaneGizmo gizmo;
    const double length = glm::length(plane.normal);
    gizmo.normal = plane.normal / length;
    gizmo.section = section_of(plane, geometry);
    if (gizmo.section.empty()) {
        const glm::dvec3 centre = geometry.centre_mm();
        gizmo.anchor = centre - gizmo.normal * (glm::dot(gizmo.normal, centre) + plane.offset / length);
    } else {
        // By area, so that the anchor does not jump where the section gains a corner.
        double area = 0;
        for (std::size_t i = 1; i + 1 < gizmo.section.size(); ++i) {
            const glm::dvec3 a = gizmo.section[0], b = gizmo.section[i], c = gizmo.section[i + 1];
            const double part = glm::length(glm::cross(b - a, c - a));
            gizmo.anchor += part * (a + b + c) / 3.0;
            area += part;
        }
        gizmo.anchor = area > 0 ? gizmo.anchor / area : gizmo.section[0];
    }
    const double pixel = pixel_at(rays, gizmo.anchor);
    gizmo.tip = gizmo.anchor - gizmo.normal * (k_arrow_px * pixel);
    const auto [u, v] = axes_in(gizmo.normal, geometry);
    const glm::dvec3 arms[4] = {u, v, -u, -v};
    for (int i = 0; i < 4; ++i) {
        double reach = 0;  // from the anchor to the section's border
        for (std::size_t k = 0; k < gizmo.section.size(); ++k) {
            const glm::dvec3 a = gizmo.section[k], b = gizmo.section[(k + 1) % gizmo.section.size()];
            const glm::dvec3 out = glm::cross(b - a, gizmo.normal);
            const double slope = glm::dot(arms[i], out), gap = glm::dot(a - gizmo.anchor, out);
            if (slope * gap > 0 && std::abs(slope) > 1e-12 && (reach == 0 || gap / slope < reach)) reach = gap / slope;
        }
        gizmo.tilt[i] = gizmo.anchor + arms[i] * std::max(k_tilt_share * reach, k_least_tilt_px * pixel);
    }
    return gizmo;
}

Grip grip_at(const PlaneGizmo& gizmo, const ViewRays& rays, glm::dvec2 at, double reach_px) {
    Grip grip;
    double nearest = reach_px;
    const auto offer = [&](double distance, Grip candidate) {
        if (!(distance <= nearest)) return;
        nearest = distance;
        grip = candidate;
    };
    for (int i = 0; i < 4; ++i) offer(distance_in_picture(rays, gizmo.tilt[i], at), {Grip::Kind::tilt, i});
    offer(distance_in_picture(rays, gizmo.anchor, at), {Grip::Kind::move, 0});
    offer(distance_in_picture(rays, gizmo.tip, at), {Grip::Kind::move, 0});
    if (grip) return grip;
    nearest = 0.5 * reach_px;
    offer(distance_to_line(rays, gizmo.anchor, gizmo.tip, at), {Grip::Kind::move, 0});
    for (std::size_t k = 0; k < gizmo.section.size(); ++k)
        offer(distance_to_line(rays, gizmo.section[k], gizmo.section[(k + 1) % gizmo.section.size()], at),
              {Grip::Kind::outline, 0});
    return grip;
}

PlaneDrag::PlaneDrag(const CuttingPlane& plane, const Grip& grip, const GridGeometry& geometry, const ViewRays& rays,
                     glm::dvec2 at)
    : plane_(plane), grip_(grip), geometry_(geometry), rays_(rays), gizmo_(gizmo_of(plane, geometry, rays)), from_(at) {
    if (grip.kind != Grip::Kind::tilt) return;
    const glm::dvec3 arm = gizmo_.tilt[grip.index] - gizmo_.anchor;
    radius_mm_ = glm::length(arm);
    behind_ = glm::dot(arm, line_of_sight(rays_, gizmo_.anchor)) > 0;
}

glm::dvec3 PlaneDrag::arm_at(glm::dvec2 at) const {
    const glm::dvec3 o = rays_.origin(at.x - 0.5, at.y - 0.5), d = rays_.direction(at.x - 0.5, at.y - 0.5);
    const glm::dvec3 nearest = o + d * glm::dot(gizmo_.anchor - o, d) - gizmo_.anchor;
    const double off = glm::length(nearest);
    if (off >= radius_mm_) return nearest / off;
    return glm::normalize(nearest + d * (std::sqrt(radius_mm_ * radius_mm_ - off * off) * (behind_ ? 1 : -1)));
}

double PlaneDrag::shift_at(glm::dvec2 at) const { return along_line(rays_, gizmo_.anchor, gizmo_.normal, at, from_); }

CuttingPlane PlaneDrag::to(glm::dvec2 at, bool snap) const {
    if (grip_.kind != Grip::Kind::tilt) return moved(plane_, shift_at(at) - shift_at(from_), geometry_);
    const glm::dvec3 a = arm_at(from_), b = arm_at(at), axis = glm::cross(a, b);
    const double sine = glm::length(axis);
    glm::dvec3 normal = gizmo_.normal;
    if (sine > 1e-12) normal = rotated(normal, axis / sine, std::atan2(sine, glm::dot(a, b)));
    if (snap) normal = snapped(normal, geometry_);
    return through(glm::normalize(normal), gizmo_.anchor, plane_.cap);
}

glm::dvec3 corner_of(const BoxRoi& roi, int corner, const GridGeometry& geometry) {
    glm::dvec3 share;
    for (int axis = 0; axis < 3; ++axis) share[axis] = corner & (1 << axis) ? roi.hi[axis] : roi.lo[axis];
    return geometry.voxel_to_mm(share * glm::dvec3(geometry.size) - 0.5);
}

glm::dvec3 middle_of(const BoxRoi& roi, const GridGeometry& geometry) {
    return geometry.voxel_to_mm(0.5 * (roi.lo + roi.hi) * glm::dvec3(geometry.size) - 0.5);
}

glm::dvec3 side_of(const BoxRoi& roi, int side, const GridGeometry& geometry) {
    glm::dvec3 share = 0.5 * (roi.lo + roi.hi);
    share[side / 2] = side % 2 ? roi.hi[side / 2] : roi.lo[side / 2];
    return geometry.voxel_to_mm(share * glm::dvec3(geometry.size) - 0.5);
}

Grip grip_at(const BoxRoi& roi, const GridGeometry& geometry, const ViewRays& rays, glm::dvec2 at, double reach_px) {
    Grip grip;
    double nearest = reach_px, closest_depth = std::numeric_limits<double>::infinity();
    const auto offer = [&](const glm::dvec3& mm, Grip candidate) {
        const double distance = distance_in_picture(rays, mm, at);
        const double depth = glm::dot(mm - rays.eye, rays.forward);
        // Handles that cover one another: the one in front is meant.
        if (!(distance <= reach_px) || (grip && !(depth < closest_depth) && !(distance < 0.5 * nearest))) return;
        nearest = distance;
        closest_depth = depth;
        grip = candidate;
    };
    offer(middle_of(roi, geometry), {Grip::Kind::box, 0});
    for (int side = 0; side < 6; ++side) offer(side_of(roi, side, geometry), {Grip::Kind::side, side});
    return grip;
}

BoxRoi side_moved(const BoxRoi& roi, int side, double share, const GridGeometry& geometry) {
    BoxRoi next = roi;
    const int axis = side / 2;
    const double least = 1.0 / std::max(1, geometry.size[axis]);
    if (side % 2)
        next.hi[axis] = std::clamp(roi.hi[axis] + share, std::min(1.0, roi.lo[axis] + least), 1.0);
    else
        next.lo[axis] = std::clamp(roi.lo[axis] + share, 0.0, std::max(0.0, roi.hi[axis] - least));
    return next;
}

BoxDrag::BoxDrag(const BoxRoi& roi, const Grip& grip, const GridGeometry& geometry, const ViewRays& rays, glm::dvec2 at)
    : roi_(roi), grip_(grip), geometry_(geometry), rays_(rays), from_(at) {}

BoxRoi BoxDrag::to(glm::dvec2 at) const {
    const glm::dvec3 extent = glm::dvec3(geometry_.size) * geometry_.spacing;
    if (grip_.kind == Grip::Kind::side) {
        const glm::dvec3 handle = side_of(roi_, grip_.index, geometry_);
        const glm::dvec3 along = geometry_.direction[grip_.index / 2];
        const double mm = along_line(rays_, handle, along, at, from_) - along_line(rays_, handle, along, from_, from_);
        return side_moved(roi_, grip_.index, mm / extent[grip_.index / 2], geometry_);
    }
    const double pixel = pixel_at(rays_, middle_of(roi_, geometry_));
    const glm::dvec3 mm = (rays_.right * (at.x - from_.x) - rays_.up * (at.y - from_.y)) * pixel;
    BoxRoi next = roi_;
    for (int axis = 0; axis < 3; ++axis) {
        const double share =
            std::clamp(glm::dot(geometry_.direction[axis], mm) / extent[axis], -roi_.lo[axis], 1 - roi_.hi[axis]);
        next.lo[axis] = std::clamp(roi_.lo[axis] + share, 0.0, 1.0);
        next.hi[axis] = std::clamp(roi_.hi[axis] + share, 0.0, 1.0);
    }
    return next;
}

}  // namespace lacuna
