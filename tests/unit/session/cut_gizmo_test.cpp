#include "core/session/cut_gizmo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lacuna {
namespace {

GridGeometry grid(glm::ivec3 size = {20, 30, 40}, glm::dvec3 spacing = {1, 1, 1}) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    geometry.origin = {-7, 11, 3};
    const double c = std::cos(0.3), s = std::sin(0.3);  // turned about z: nothing is level with the axes of space
    geometry.direction = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
    return geometry;
}

CuttingPlane through_centre(glm::dvec3 normal, const GridGeometry& geometry) {
    normal = glm::normalize(normal);
    return {normal, -glm::dot(normal, geometry.centre_mm()), true};
}

ViewRays seen(const GridGeometry& geometry, double azimuth, double elevation, bool perspective = false) {
    Camera camera;
    camera.azimuth_deg = azimuth;
    camera.elevation_deg = elevation;
    if (perspective) camera.fov_deg = 35;
    return resolve(camera, geometry, {400, 300});
}

double signed_distance(const CuttingPlane& plane, const glm::dvec3& mm) {
    return (glm::dot(plane.normal, mm) + plane.offset) / glm::length(plane.normal);
}

/// Area of a planar polygon, and whether it turns one way all around.
double area(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal, bool& convex) {
    double sum = 0;
    convex = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i], b = corners[(i + 1) % corners.size()], c = corners[(i + 2) % corners.size()];
        convex = convex && glm::dot(glm::cross(b - a, c - b), normal) > -1e-9;
        sum += 0.5 * glm::dot(glm::cross(a - corners[0], b - corners[0]), normal);
    }
    return sum;
}

TEST(Section, LiesOnThePlaneAndTheBoxAndIsConvex) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(-1, 1);
    int hexagons = 0;
    for (int i = 0; i < 500; ++i) {
        const GridGeometry geometry = grid({1 + i % 40, 1 + i % 7, 1 + i % 23}, {1, 1, 5});
        CuttingPlane plane = through_centre({share(random), share(random), share(random) + 1e-3}, geometry);
        plane = moved(plane, share(random) * 0.8 * half_extent_mm(plane.normal, geometry), geometry);
        plane.normal *= 3.0, plane.offset *= 3.0;  // need not have unit length
        const std::vector<glm::dvec3> corners = section_of(plane, geometry);
        ASSERT_GE(corners.size(), 3u);
        ASSERT_LE(corners.size(), 6u);
        hexagons += corners.size() == 6;
        for (const glm::dvec3& corner : corners) {
            EXPECT_NEAR(signed_distance(plane, corner), 0, 1e-6);
            const glm::dvec3 voxel = geometry.mm_to_voxel(corner);
            int on_faces = 0;
            for (int a = 0; a < 3; ++a) {
                EXPECT_GE(voxel[a], -0.5 - 1e-6);
                EXPECT_LE(voxel[a], geometry.size[a] - 0.5 + 1e-6);
                on_faces += std::abs(voxel[a] + 0.5) < 1e-6 || std::abs(voxel[a] - geometry.size[a] + 0.5) < 1e-6;
            }
            EXPECT_GE(on_faces, 2) << "a corner of the section lies on an edge of the box";
        }
        bool convex = false;
        EXPECT_GT(area(corners, glm::normalize(plane.normal), convex), 0);
        EXPECT_TRUE(convex);
    }
    EXPECT_GT(hexagons, 0);
}

TEST(Section, AnAxialPlaneCutsTheWholeRectangle) {
    const GridGeometry geometry = grid({20, 30, 40}, {0.5, 1, 2});
    bool convex = false;
    const CuttingPlane plane = through_centre({0, 0, 1}, geometry);
    EXPECT_NEAR(area(section_of(plane, geometry), plane.normal, convex), 10 * 30, 1e-9);
}

TEST(Section, APlaneBesideTheVolumeHasNone) {
    const GridGeometry geometry = grid();
    CuttingPlane plane = through_centre({1, 2, 3}, geometry);
    plane.offset += 1000;
    EXPECT_TRUE(section_of(plane, geometry).empty());
    plane.normal = glm::dvec3(0);
    EXPECT_TRUE(section_of(plane, geometry).empty());
}

TEST(PlaneEdit, MovingStopsAtTheVolume) {
    const GridGeometry geometry = grid();
    const CuttingPlane plane = through_centre({1, 1, 1}, geometry);
    EXPECT_NEAR(signed_distance(moved(plane, 2.5, geometry), geometry.centre_mm()), -2.5, 1e-9);
    const double half = half_extent_mm(plane.normal, geometry);
    EXPECT_NEAR(signed_distance(moved(plane, 1e6, geometry), geometry.centre_mm()), -half, 1e-9);
    EXPECT_NEAR(signed_distance(moved(plane, -1e6, geometry), geometry.centre_mm()), half, 1e-9);
}

TEST(PlaneEdit, SnappingFindsTheGridsAxes) {
    const GridGeometry geometry = grid();
    const glm::dvec3 almost = glm::normalize(geometry.direction[1] + 0.1 * geometry.direction[0]);
    EXPECT_LT(glm::length(snapped(almost, geometry) - geometry.direction[1]), 1e-12);
    EXPECT_LT(glm::length(snapped(-almost, geometry) + geometry.direction[1]), 1e-12);
}

TEST(PlaneGizmo, HandlesAreHitWhereTheyAreDrawn) {
    const GridGeometry geometry = grid();
    for (const bool perspective : {false, true}) {
        const ViewRays rays = seen(geometry, 35, 25, perspective);
        const PlaneGizmo gizmo = gizmo_of(through_centre({1, -0.4, 0.3}, geometry), geometry, rays);
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(glm::dot(gizmo.tilt[i] - gizmo.anchor, gizmo.normal), 0, 1e-9);
            EXPECT_EQ(grip_at(gizmo, rays, *in_picture(rays, gizmo.tilt[i]), 8), (Grip{Grip::Kind::tilt, i}));
        }
        EXPECT_EQ(grip_at(gizmo, rays, *in_picture(rays, gizmo.tip), 8).kind, Grip::Kind::move);
        EXPECT_EQ(grip_at(gizmo, rays, *in_picture(rays, gizmo.anchor), 8).kind, Grip::Kind::move);
        const glm::dvec3 edge = 0.5 * (gizmo.section[0] + gizmo.section[1]);
        EXPECT_EQ(grip_at(gizmo, rays, *in_picture(rays, edge), 8).kind, Grip::Kind::outline);
        EXPECT_FALSE(grip_at(gizmo, rays, {2, 2}, 8));
    }
}

TEST(PlaneDrag, TheArrowFollowsTheHandAlongTheNormal) {
    const GridGeometry geometry = grid();
    for (const bool perspective : {false, true}) {
        const ViewRays rays = seen(geometry, 35, 25, perspective);
        const CuttingPlane plane = through_centre({1, -0.4, 0.3}, geometry);
        const PlaneGizmo gizmo = gizmo_of(plane, geometry, rays);
        const PlaneDrag drag(plane, {Grip::Kind::move, 0}, geometry, rays, *in_picture(rays, gizmo.anchor));
        const CuttingPlane there = drag.to(*in_picture(rays, gizmo.anchor + 3.0 * gizmo.normal));
        EXPECT_NEAR(signed_distance(there, gizmo.anchor), -3, 1e-6);
        EXPECT_NEAR(glm::dot(there.normal, gizmo.normal), 1, 1e-12);
        const CuttingPlane back = drag.to(*in_picture(rays, gizmo.anchor));
        EXPECT_NEAR(signed_distance(back, gizmo.anchor), 0, 1e-9);
    }
}

TEST(PlaneDrag, SeenEndOnItMovesAwayWithTheHandGoingUp) {
    const GridGeometry geometry = grid();
    const ViewRays rays = seen(geometry, 0, 0);
    for (const double side : {1.0, -1.0}) {
        const CuttingPlane plane = through_centre(rays.forward * side, geometry);
        const PlaneDrag drag(plane, {Grip::Kind::move, 0}, geometry, rays, {200, 150});
        const PlaneGizmo after = gizmo_of(drag.to({200, 140}), geometry, rays);
        EXPECT_NEAR(glm::dot(after.anchor - geometry.centre_mm(), rays.forward), 10 * rays.pixel_mm, 1e-9);
    }
}

TEST(PlaneDrag, ATiltHandleStaysUnderTheHandAndTheAnchorOnThePlane) {
    const GridGeometry geometry = grid();
    for (const bool perspective : {false, true}) {
        const ViewRays rays = seen(geometry, 35, 25, perspective);
        const CuttingPlane plane = through_centre({1, -0.4, 0.3}, geometry);
        const PlaneGizmo gizmo = gizmo_of(plane, geometry, rays);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 from = *in_picture(rays, gizmo.tilt[i]);
            const PlaneDrag drag(plane, {Grip::Kind::tilt, i}, geometry, rays, from);
            EXPECT_NEAR(glm::dot(drag.to(from).normal, gizmo.normal), 1, 1e-9);
            // A point of the ball the handle is on, on the handle's half of it, lifted out of the plane.
            const double radius = glm::length(gizmo.tilt[i] - gizmo.anchor);
            const glm::dvec3 arm = (gizmo.tilt[i] - gizmo.anchor) / radius;
            const glm::dvec3 sight = perspective ? glm::normalize(gizmo.anchor - rays.eye) : rays.forward;
            const glm::dvec3 lifted = glm::normalize(arm + 0.15 * gizmo.normal);
            if (glm::dot(lifted, sight) * glm::dot(arm, sight) < 0.05) continue;  // near the rim, or beyond it
            const CuttingPlane there = drag.to(*in_picture(rays, gizmo.anchor + radius * lifted));
            EXPECT_NEAR(signed_distance(there, gizmo.anchor), 0, 1e-9);
            EXPECT_NEAR(glm::dot(there.normal, lifted), 0, 1e-5) << "the plane goes through the point dragged";
            EXPECT_NEAR(glm::dot(there.normal, gizmo.normal), 1 / std::sqrt(1 + 0.15 * 0.15), 1e-5);
        }
    }
}

TEST(PlaneDrag, FarBeyondTheBallAndAnywhereElseThePlaneStaysSound) {
    const GridGeometry geometry = grid();
    const ViewRays rays = seen(geometry, -60, 80, true);
    const CuttingPlane plane = through_centre({0.2, 0.1, 1}, geometry);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> pixel(-2000, 2000);
    for (int i = 0; i < 1000; ++i)
        for (const Grip grip : {Grip{Grip::Kind::tilt, i % 4}, Grip{Grip::Kind::move, 0}}) {
            const PlaneDrag drag(plane, grip, geometry, rays, {200, 150});
            const CuttingPlane there = drag.to({pixel(random), pixel(random)}, i % 5 == 0);
            ASSERT_NEAR(glm::length(there.normal), 1, 1e-9);
            ASSERT_TRUE(std::isfinite(there.offset));
            ASSERT_LE(std::abs(signed_distance(there, geometry.centre_mm())),
                      half_extent_mm(there.normal, geometry) + 1e-6);
        }
}

TEST(BoxGizmo, SidesFollowTheHandAndStopAtTheirOpposites) {
    const GridGeometry geometry = grid({20, 30, 40}, {1, 1, 2});
    const ViewRays rays = seen(geometry, 35, 25);
    BoxRoi roi;
    roi.lo = {0.2, 0.3, 0.1}, roi.hi = {0.9, 0.8, 0.7};
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const glm::dvec3 handle = side_of(roi, side, geometry);
        const BoxDrag drag(roi, {Grip::Kind::side, side}, geometry, rays, *in_picture(rays, handle));
        const glm::dvec3 to = handle + 2.0 * geometry.direction[axis];
        const BoxRoi next = drag.to(*in_picture(rays, to));
        EXPECT_LT(glm::length(side_of(next, side, geometry) - to), 1e-6);
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            EXPECT_EQ(next.lo[other], roi.lo[other]);
            EXPECT_EQ(next.hi[other], roi.hi[other]);
        }
        for (const double share : {-5.0, 5.0}) {
            const BoxRoi ends = side_moved(roi, side, share, geometry);
            EXPECT_GE(ends.lo[axis], 0);
            EXPECT_LE(ends.hi[axis], 1);
            EXPECT_GE(ends.hi[axis] - ends.lo[axis], 1.0 / geometry.size[axis] - 1e-12);
        }
    }
}

TEST(BoxGizmo, TheMiddleMovesItWithoutAChangeOfSizeUntilTheBorder) {
    const GridGeometry geometry = grid();
    const ViewRays rays = seen(geometry, 0, 0);
    BoxRoi roi;
    roi.lo = {0.4, 0.4, 0.4}, roi.hi = {0.6, 0.6, 0.6};
    const glm::dvec2 from = *in_picture(rays, middle_of(roi, geometry));
    EXPECT_EQ(grip_at(roi, geometry, rays, from, 5).kind, Grip::Kind::side) << "the front side covers the middle";
    const BoxDrag drag(roi, {Grip::Kind::box, 0}, geometry, rays, from);
    const BoxRoi up = drag.to(from - glm::dvec2(0, 4));
    EXPECT_NEAR((up.lo.z - roi.lo.z) * 40, 4 * rays.pixel_mm, 1e-9);
    EXPECT_NEAR(up.hi.z - up.lo.z, 0.2, 1e-12);
    const BoxRoi far = drag.to(from - glm::dvec2(0, 4000));
    EXPECT_NEAR(far.hi.z, 1, 1e-12);
    EXPECT_NEAR(far.hi.z - far.lo.z, 0.2, 1e-12);
}

TEST(BoxGizmo, ItsPlanesKeepJustTheBox) {
    const GridGeometry geometry = grid({20, 30, 40}, {1, 1, 2});
    BoxRoi roi;
    EXPECT_TRUE(planes_of(roi, geometry).empty());
    roi.enabled = true;
    EXPECT_TRUE(planes_of(roi, geometry).empty()) << "the whole volume needs no plane";
    roi.lo = {0.25, 0, 0.5}, roi.hi = {0.75, 1, 1};
    const std::vector<CuttingPlane> planes = planes_of(roi, geometry);
    ASSERT_EQ(planes.size(), 3u);
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 20; ++x) {
                bool kept = true;
                for (const CuttingPlane& plane : planes)
                    kept = kept && signed_distance(plane, geometry.voxel_to_mm(glm::dvec3(x, y, z))) >= 0;
                EXPECT_EQ(kept, x >= 5 && x < 15 && z >= 20);
            }
}

}  // namespace
}  // namespace lacuna
