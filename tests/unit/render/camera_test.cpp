// The camera of the contract: what no picture can be drawn with is refused in one sentence.

#include "core/render/camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"

namespace lacuna {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

void expect_refused(const Camera& camera, const char* why) {
    EXPECT_THROW(check(camera), Error) << why;
    EXPECT_THROW(resolve(camera, GridGeometry{}, {8, 8}), Error) << why;
}

TEST(CameraCheck, TakesTheUsualAndTheExtreme) {
    EXPECT_NO_THROW(check({}));
    Camera far;
    far.azimuth_deg = -7200;
    far.zoom = 1e-6;
    far.fov_deg = 179.9;
    far.center_mm = glm::dvec3(1e6, -1e6, 0);
    EXPECT_NO_THROW(check(far));
}

TEST(CameraCheck, RefusesWhatNoPictureCanBeDrawnWith) {
    for (const double bad : {0.0, -1.0, k_nan, k_infinity}) {
        Camera camera;
        camera.zoom = bad;
        expect_refused(camera, "zoom");
    }
    for (const double bad : {0.0, 0.009, 180.0, -30.0, k_nan}) {
        Camera camera;
        camera.fov_deg = bad;
        expect_refused(camera, "field of view");
    }
    for (double Camera::*angle : {&Camera::azimuth_deg, &Camera::elevation_deg, &Camera::roll_deg})
        for (const double bad : {k_nan, k_infinity}) {
            Camera camera;
            camera.*angle = bad;
            expect_refused(camera, "angle");
        }
    for (int axis = 0; axis < 3; ++axis) {
        Camera camera;
        camera.center_mm = glm::dvec3(0);
        (*camera.center_mm)[axis] = k_nan;
        expect_refused(camera, "centre");
    }
}

}  // namespace
}  // namespace lacuna
