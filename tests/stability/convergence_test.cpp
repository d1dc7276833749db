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

constexpr double k_slope_tolerance = 0.15;

/// Slope of a straight line through log2(error) of settings each twice as fine as the one before.
double slope_of(const std::vector<double>& errors) {
    const double n = double(errors.size()), middle = (n - 1) / 2;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        sum -= (double(i) - middle) * std::log2(errors[i]);
        squares += (double(i) - middle) * (double(i) - middle);
    }
    return sum / squares;
}

std::vector<Renderer> both_renderers() {
    return {[](const Scene& s, const Plan& p) { return render_reference(s, p); },
            [](const Scene& s, const Plan& p) { return engine().render(s, p).frame; }};
}

// Etiene, Kirby & Silva 2014: the error against step, grid and pixel must fall as theory has it.
TEST(Slopes, EmissionAbsorptionIsOfSecondOrderInTheStep) {
    if (!has_device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    // A shell, which changes faster than the ball itself: errors far above what single precision and tables leave.
    Scene scene = soft_ball();
    scene.classification.tf.points = {{10, {0.2, 0.3, 1}, 0}, {50, {1, 0.6, 0.1}, 0.6}, {90, {1, 1, 1}, 0}};
    for (const Renderer& render : both_renderers()) {
        const Frame limit = render(scene, brute_force(1.0 / 32));
        std::vector<double> errors;
        for (const double step : {1.0, 0.5, 0.25})
            errors.push_back(mean_difference(render(scene, brute_force(step)), limit));
        EXPECT_NEAR(slope_of(errors), 2, k_slope_tolerance) << errors[0] << " " << errors[1] << " " << errors[2];
    }
}

/// Mean depth error of a ball's front where it is not grazed, mm.
double mean_iso_error(const Renderer& render, int voxels, const Plan& plan) {
    constexpr double k_radius = 12.3;
    Scene scene =
        scene_of(ball(centred(glm::ivec3(voxels), glm::dvec3(40.0 / voxels), 25), k_radius), ViewMode::iso, 41);
    scene.camera.azimuth_deg = 33;
    scene.camera.elevation_deg = 21;
    const Frame frame = render(scene, plan);
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    double sum = 0;
    int met = 0;
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            const glm::dvec3 o = rays.origin(x, y), d = rays.direction(x, y);
            const double truth = ball_depth(o, d, k_radius);
            if (std::isinf(truth) || std::fabs(glm::dot(glm::normalize(o + truth * d), d)) < 0.5) continue;
            sum += std::fabs(double(frame.depth_mm[pixel_index(frame, x, y)]) - truth);
            ++met;
        }
    return met > 100 ? sum / met : std::numeric_limits<double>::infinity();
}

TEST(Slopes, ASurfacesDepthIsOfSecondOrderInTheGridAndFirstInTheStepUnrefined) {
    if (!has_device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    for (const Renderer& render : both_renderers()) {
        Plan plan = brute_force();
        plan.refine = Refinement::bisect;
        plan.refine_steps = 20;
        std::vector<double> grid, step;
        for (const int voxels : {20, 40, 80}) grid.push_back(mean_iso_error(render, voxels, plan));
        EXPECT_NEAR(slope_of(grid), 2, k_slope_tolerance) << grid[0] << " " << grid[1] << " " << grid[2];
        for (const double s : {2.0, 1.0, 0.5}) {
            Plan unrefined = brute_force(s);
            unrefined.refine = Refinement::none;
            step.push_back(mean_iso_error(render, 80, unrefined));
        }
        EXPECT_NEAR(slope_of(step), 1, k_slope_tolerance) << step[0] << " " << step[1] << " " << step[2];
    }
}

/// The picture at fractional pixels, interpolated between pixel centres.
glm::dvec4 between_pixels(const Frame& f, glm::dvec2 at) {
    const glm::ivec2 p = glm::clamp(glm::ivec2(glm::floor(at)), glm::ivec2(0), f.size - 2);
    const glm::dvec2 w = at - glm::dvec2(p);
    const auto c = [&](int x, int y) { return glm::dvec4(f.color[pixel_index(f, p.x + x, p.y + y)]); };
    return glm::mix(glm::mix(c(0, 0), c(1, 0), w.x), glm::mix(c(0, 1), c(1, 1), w.x), w.y);
}

TEST(Slopes, APictureIsOfSecondOrderInThePixel) {
    if (!has_device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    for (const Renderer& render : both_renderers()) {
        const Plan plan = brute_force(0.25);
        constexpr int k_fine = 192;
        const Frame fine = render(soft_ball(k_fine), plan);
        std::vector<double> errors;
        for (const int pixels : {24, 48, 96}) {
            const Frame coarse = render(soft_ball(pixels), plan);
            const double ratio = double(k_fine) / pixels;
            double sum = 0;
            for (int y = 12; y < k_fine - 12; ++y)
                for (int x = 12; x < k_fine - 12; ++x) {
                    const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / ratio - 0.5;
                    const glm::dvec4 d =
                        glm::abs(between_pixels(coarse, at) - glm::dvec4(fine.color[pixel_index(fine, x, y)]));
                    sum += d.r + d.g + d.b + d.a;
                }
            errors.push_back(sum);
        }
        EXPECT_NEAR(slope_of(errors), 2, k_slope_tolerance) << errors[0] << " " << errors[1] << " " << errors[2];
    }
}

}  // namespace
}  // namespace lacuna
