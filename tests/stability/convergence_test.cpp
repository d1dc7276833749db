#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/reference_renderer.h"
#include "tests/unit/render/render_volumes.h"

// Orders of accuracy of the device's pictures; tests/unit/render holds the reference renderer to the same.
namespace lacuna {
namespace {

using namespace test;

Engine& engine() {
    static Engine on_device(open_device());
    return on_device;
}

bool has_device() { return engine().device_name().find("no OpenCL") == std::string::npos; }

/// A soft ball: value falls smoothly from 100 within to 0 outside, so that nothing but the step limits EA.
Scene soft_ball(int pixels = 48) {
    const Volume volume = sampled(centred({40, 40, 40}), [](const glm::dvec3& mm) {
        return 100 * std::exp(-glm::dot(mm, mm) / (2 * 4.0 * 4.0));
    });
    Scene scene = scene_of(volume, ViewMode::ea, pixels);
    scene.classification.tf.points = {{0, {0.2, 0.3, 1}, 0}, {100, {1, 0.6, 0.1}, 0.3}};
    scene.camera.azimuth_deg = 27;
    scene.camera.elevation_deg = 14;
    return scene;
}

double mean_difference(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::dvec4 d = glm::abs(glm::dvec4(a.color[i]) - glm::dvec4(b.color[i]));
        sum += d.r + d.g + d.b + d.a;
    }
    return sum / double(4 * a.pixels());
}

using Renderer = std::function<Frame(const Scene&, const Plan&)>;

/// Slopes of log2(error) between steps halved from 2 voxels on, against the renderer's own limit of small steps.
std::vector<double> ea_slopes(const Renderer& render) {
    const Scene scene = soft_ball();
    const Frame limit = render(scene, brute_force(1.0 / 16));
    std::vector<double> errors, slopes;
    for (const double step : {2.0, 1.0, 0.5})
        errors.push_back(mean_difference(render(scene, brute_force(step)), limit));
    for (std::size_t i = 1; i < errors.size(); ++i) slopes.push_back(std::log2(errors[i - 1] / errors[i]));
    return slopes;
}

TEST(EaOrder, HalvingTheStepQuartersTheErrorOnTheDeviceAsInTheReference) {
    if (!has_device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    const Renderer reference = [](const Scene& s, const Plan& p) { return render_reference(s, p); };
    const Renderer device = [](const Scene& s, const Plan& p) { return engine().render(s, p).frame; };
    const auto expected = ea_slopes(reference), slopes = ea_slopes(device);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        EXPECT_GT(expected[i], 1.7) << "halving number " << i;
        EXPECT_GT(slopes[i], i == 0 ? 1.7 : 1.4) << "halving number " << i << "; the device's tables set a floor";
    }
    const Plan fine = brute_force(1.0 / 16);
    EXPECT_LT(mean_difference(device(soft_ball(), fine), reference(soft_ball(), fine)), 0.05 / 255)
        << "both go to the same limit, but for the device's tables";
}

/// Largest depth error of a ball's front, where it is not grazed; pixels without a hit count as infinite.
double iso_error(int voxels, const glm::dvec3& stretch, bool perspective, Structure structure) {
    constexpr double k_radius = 12.3;
    const glm::dvec3 spacing = 40.0 / voxels * stretch;
    Scene scene =
        scene_of(ball(centred(glm::ivec3(glm::round(40.0 / spacing)), spacing, 25), k_radius), ViewMode::iso, 41);
    scene.camera.azimuth_deg = 33;
    scene.camera.elevation_deg = 21;
    scene.camera.roll_deg = 10;
    if (perspective) scene.camera.fov_deg = 35;
    Plan plan = brute_force();
    plan.structure = structure;
    plan.refine = Refinement::bisect;
    plan.refine_steps = 20;
    const Frame frame = engine().render(scene, plan).frame;
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    double worst = 0;
    int met = 0;
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            const glm::dvec3 o = rays.origin(x, y), d = rays.direction(x, y);
            const double truth = ball_depth(o, d, k_radius);
            if (std::isinf(truth) || std::fabs(glm::dot(glm::normalize(o + truth * d), d)) < 0.5) continue;
            worst = std::max(worst, std::fabs(double(frame.depth_mm[pixel_index(frame, x, y)]) - truth));
            ++met;
        }
    return met > 100 ? worst : std::numeric_limits<double>::infinity();
}

TEST(IsoOrder, HalvingTheGridOnTheDeviceQuartersTheDepthError) {
    if (!has_device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    for (const Structure structure : {Structure::none, Structure::macrocells})
        for (const bool perspective : {false, true})
            for (const glm::dvec3 stretch : {glm::dvec3(1), glm::dvec3(1, 0.8, 2)}) {
                SCOPED_TRACE(testing::Message()
                             << name_of(structure) << " perspective " << perspective << " stretch z " << stretch.z);
                const double coarse = iso_error(20, stretch, perspective, structure);
                const double fine = iso_error(40, stretch, perspective, structure);
                EXPECT_LT(fine, 0.15);
                EXPECT_GT(coarse / fine, 2.8);
                EXPECT_LT(coarse / fine, 5.5);
            }
}

}  // namespace
}  // namespace lacuna
