#include "core/render/effects.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <future>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/render/engine.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

constexpr float k_far = std::numeric_limits<float>::infinity();

/// A scene whose volume is only there for its size: a pixel of the 64x64 picture is one millimetre.
Scene stage(int pixels = 64) {
    const double side = pixels / std::sqrt(3.0);
    Scene scene = scene_of(sampled(centred({2, 2, 2}, glm::dvec3(side / 2)), [](const glm::dvec3&) { return 0.0; }),
                           ViewMode::iso, pixels);
    scene.iso = 1;
    return scene;
}

/// A frame of one colour, its depth from a function of the pixel.
template <class Depth>
Frame frame_of(const Scene& scene, Depth&& depth, glm::vec4 color = glm::vec4(0.5f, 0.5f, 0.5f, 1)) {
    Frame frame;
    frame.size = scene.size;
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            frame.depth_mm.push_back(float(depth(x, y)));
            frame.color.push_back(std::isinf(frame.depth_mm.back()) ? glm::vec4(0) : color);
        }
    return frame;
}

Frame apply(Scene scene, Frame frame, const std::string& effects) {
    scene.effects = parse_effects(effects);
    check(scene);
    apply_effects(scene, frame);
    return frame;
}

bool same_bytes(const Frame& a, const Frame& b) {
    return a.color.size() == b.color.size() &&
           std::memcmp(a.color.data(), b.color.data(), a.color.size() * sizeof(glm::vec4)) == 0 &&
           std::memcmp(a.depth_mm.data(), b.depth_mm.data(), a.depth_mm.size() * sizeof(float)) == 0;
}

float red(const Frame& frame, int x, int y) { return frame.color[pixel_index(frame, x, y)].r; }

std::string refusal(const std::string& list) {
    try {
        parse_effects(list);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
        return error.what();
    }
    ADD_FAILURE() << list << " was accepted";
    return "";
}

TEST(Effects, ACommaEndsAValueOrAnEffect) {
    const std::vector<Effect> effects = parse_effects("ssao=0.5,12,gamma=2.2,tonemap,dof=0.25,2,0.5,brightness=-0.1");
    const std::vector<Effect> expected{{EffectKind::ssao, {0.5, 12}},
                                       {EffectKind::gamma, {2.2}},
                                       {EffectKind::tonemap, {}},
                                       {EffectKind::dof, {0.25, 2, 0.5}},
                                       {EffectKind::brightness, {-0.1}}};
    EXPECT_EQ(effects, expected);
    EXPECT_EQ(parse_effects(to_text(effects)), effects);
    EXPECT_EQ(to_text(effects), "ssao=0.5,12,gamma=2.2,tonemap,dof=0.25,2,0.5,brightness=-0.1");
    EXPECT_EQ(effects[2].value(0), 1.2);
    EXPECT_EQ(parse_effects("ao=32")[0].value(2), 1);
}

TEST(Effects, WrongWordsAreRefusedWithWhatIsKnown) {
    EXPECT_NE(refusal("bloom=1").find("ssao, ao, dof, gamma, tonemap, brightness, contrast"), std::string::npos);
    EXPECT_NE(refusal("gamma").find("needs a value"), std::string::npos);
    EXPECT_NE(refusal("gamma=1,2").find("at most 1 value"), std::string::npos);
    EXPECT_NE(refusal("contrast=11").find("0 to 10"), std::string::npos);
    for (const char* wrong : {"", ",", "gamma=", "gamma=2,", "2", "tonemap,2", "gamma=2x", "gamma=nan", "gamma=inf",
                              "gamma=0", "GAMMA=2", "ssao=-1", "ao=0", "ao=1.5", "dof=-1", "dof=0.5,1,2", "ssao==1"})
        refusal(wrong);
    Scene scene = stage();
    scene.effects = parse_effects("ao");
    EXPECT_NO_THROW(check(scene));
    scene.mode = ViewMode::mip;
    EXPECT_THROW(check(scene), Error);
    scene.effects = {{EffectKind::gamma, {double(k_nan)}}};
    EXPECT_THROW(check(scene), Error);
}

TEST(Effects, NeutralValuesChangeNoByte) {
    const Scene scene = stage();
    const Frame frame = frame_of(
        scene, [](int x, int y) { return x < 40 ? 20 + 0.3 * y + (x % 7) : double(k_far); },
        glm::vec4(0.3f, 0.2f, 0.7f, 0.8f));
    for (const char* neutral : {"gamma=1", "contrast=1", "brightness=0", "tonemap=1", "ssao=0", "ao=16,0,0",
                                "dof=0.2,0", "gamma=1,contrast=1,brightness=0,dof=0.5,0,0"})
        EXPECT_TRUE(same_bytes(apply(scene, frame, neutral), frame)) << neutral;
}

TEST(Effects, ToneFollowsItsFormulasOnColourNotPremultiplied) {
    const Scene scene = stage(4);
    for (const double a : {1.0, 0.25})
        for (const double c : {0.001, 0.2, 0.5, 0.98, 1.7}) {
            const Frame frame = frame_of(
                scene, [](int, int) { return 3; }, glm::vec4(float(c * a), float(0.5 * c * a), 0, float(a)));
            const auto first = [&](const char* effects) { return apply(scene, frame, effects).color[5]; };
            for (const double g : {0.1, 0.45, 2.2, 10.0}) {
                const glm::vec4 got = first(("gamma=" + std::to_string(g)).c_str());
                EXPECT_NEAR(got.r / a / std::pow(c, 1 / g), 1, 1e-5) << c << " " << g;
                EXPECT_NEAR(got.g / a / std::pow(0.5 * c, 1 / g), 1, 1e-5);
                EXPECT_EQ(got.b, 0);
                EXPECT_EQ(got.a, float(a));
            }
            EXPECT_NEAR(first("brightness=-0.25").r, (c - 0.25) * a, 1e-6);
            EXPECT_NEAR(first("brightness=-0.25").b, -0.25 * a, 1e-6);
            EXPECT_NEAR(first("contrast=3").r, ((c - 0.5) * 3 + 0.5) * a, 2e-6);
            EXPECT_NEAR(first("contrast=0").g, 0.5 * a, 1e-6);
            const double luma = 0.2126 * c + 0.7152 * 0.5 * c;
            EXPECT_NEAR(first("tonemap=2").r, c * a * (1 + luma / 4) / (1 + luma), 1e-6);
        }
    const Frame white = frame_of(
        scene, [](int, int) { return 3; }, glm::vec4(2, 2, 2, 1));
    EXPECT_NEAR(apply(scene, white, "tonemap=2").color[0].r, 1, 1e-6);
}

TEST(Effects, OrderMatters) {
    const Scene scene = stage(4);
    const Frame frame = frame_of(
        scene, [](int, int) { return 3; }, glm::vec4(0.25f, 0.25f, 0.25f, 1));
    EXPECT_NEAR(apply(scene, frame, "brightness=0.25,contrast=2").color[0].r, 0.5, 1e-6);
    EXPECT_NEAR(apply(scene, frame, "contrast=2,brightness=0.25").color[0].r, 0.25, 1e-6);
}

TEST(Effects, BackgroundStaysAndOpacityAndDepthAreKept) {
    const Scene scene = stage();
    Frame frame = frame_of(scene, [](int x, int y) { return x > 20 && y > 10 ? 30 + 0.5 * x : double(k_far); });
    frame.color[pixel_index(frame, 60, 60)] = glm::vec4(0);  // a depth, and yet nothing to be seen
    const Frame done = apply(scene, frame, "ssao=4,dof=0.9,4,0.5,gamma=2,tonemap,brightness=0.3,contrast=0.2");
    int changed = 0;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        EXPECT_EQ(done.color[i].a, frame.color[i].a);
        if (frame.color[i].a == 0) {
            EXPECT_EQ(done.color[i], glm::vec4(0));
        }
        changed += done.color[i] != frame.color[i];
    }
    EXPECT_GT(changed, 1000);
    EXPECT_EQ(std::memcmp(done.depth_mm.data(), frame.depth_mm.data(), frame.pixels() * sizeof(float)), 0);
}

TEST(Effects, SsaoDarkensACreaseAndNoPlane) {
    for (const bool perspective : {false, true}) {
        Scene scene = stage();
        if (perspective) scene.camera.fov_deg = 60;
        const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
        const glm::dvec3 middle = rays.target;
        /// Depth of the surface through the middle with slopes a (left of it) and b (right), found along each ray.
        const auto roof = [&](double a, double b) {
            return [&rays, middle, a, b](int x, int y) {
                double depth = k_far;
                for (const bool left : {true, false}) {  // right . p * slope + forward . p = 0
                    const glm::dvec3 n = rays.right * (left ? a : b) + rays.forward;
                    const double t = glm::dot(n, middle - rays.origin(x, y)) / glm::dot(n, rays.direction(x, y));
                    const double side = glm::dot(rays.right, rays.origin(x, y) + rays.direction(x, y) * t - middle);
                    if (left == (side < 0)) depth = t;
                }
                return depth;
            };
        };
        for (const double slope : {0.0, 0.7, -1.5}) {
            const Frame plane = apply(scene, frame_of(scene, roof(slope, slope)), "ssao=4,8");
            for (int y = 12; y < 52; ++y)
                for (int x = 12; x < 52; ++x)
                    ASSERT_NEAR(red(plane, x, y), 0.5, 1e-3) << slope << " " << perspective << " " << x << "," << y;
        }
        const Frame crease = apply(scene, frame_of(scene, roof(-1, 1)), "ssao=1,8");
        const Frame ridge = apply(scene, frame_of(scene, roof(1, -1)), "ssao=1,8");
        EXPECT_LT(red(crease, 32, 32), 0.35);
        EXPECT_GT(red(crease, 32, 32), 0.05);
        EXPECT_GT(red(crease, 48, 32), 0.49);  // beyond the radius
        EXPECT_NEAR(red(ridge, 32, 32), 0.5, 1e-3);
    }
}

TEST(Effects, SsaoCastsNoHaloOnWhatLiesFarBehind) {
    const Scene scene = stage();
    for (const double back : {60.0, double(k_far)}) {
        const Frame frame = frame_of(scene, [&](int x, int) { return x < 32 ? 20.0 : back; });
        const Frame done = apply(scene, frame, "ssao=4,6");
        for (int x = 12; x < 52; ++x) EXPECT_NEAR(red(done, x, 30), red(frame, x, 30), 1e-4) << back << " at " << x;
    }
    const Frame step = apply(scene, frame_of(scene, [](int x, int) { return x < 32 ? 20.0 : 22.0; }), "ssao=1,6");
    EXPECT_LT(red(step, 33, 30), 0.45);  // a step lower than the radius does darken its foot
    EXPECT_NEAR(red(step, 30, 30), 0.5, 0.02);
}

TEST(Effects, DepthOfFieldLeavesTheFocusAndBlursMoreFurtherAway) {
    const Scene scene = stage(96);
    const auto striped = [&](double depth) {
        Frame frame = frame_of(scene, [=](int, int) { return depth; });
        for (std::size_t i = 0; i < frame.color.size(); ++i)
            frame.color[i] = glm::vec4(glm::vec3(i / 4 % 2 ? 1.0f : 0.0f), 1);
        return frame;
    };
    const auto amplitude = [](const Frame& frame) {
        float lo = 1, hi = 0;
        for (int x = 30; x < 66; ++x) {
            lo = std::min(lo, red(frame, x, 48));
            hi = std::max(hi, red(frame, x, 48));
        }
        return double(hi - lo);
    };
    // Focus 0.5 is the volume's centre, at depth 48 (half the diameter of 96 mm).
    EXPECT_TRUE(same_bytes(apply(scene, striped(48), "dof=0.5,2"), striped(48)));
    EXPECT_TRUE(same_bytes(apply(scene, striped(60), "dof=60,2"), striped(60)));
    for (const double sign : {-1.0, 1.0}) {
        double before = 1;
        for (const double away : {6.0, 12.0, 20.0, 30.0}) {
            const double now = amplitude(apply(scene, striped(48 + sign * away), "dof=0.5,2"));
            EXPECT_LT(now, before) << away * sign;
            before = now;
        }
        EXPECT_LT(before, 0.3);
    }
    const Frame dim = apply(scene, frame_of(scene, [](int, int) { return 72; }), "dof=0.5,0,0.5");
    EXPECT_NEAR(red(dim, 48, 48), 0.5 * (1 - 0.5 * 0.5), 1e-6);
}

TEST(Effects, DepthOfFieldKeepsSharpColourOutOfTheBlur) {
    const Scene scene = stage(96);
    Frame frame = frame_of(scene, [](int x, int) { return x < 48 ? 48.0 : 90.0; });
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
            frame.color[pixel_index(frame, x, y)] = x < 48 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 0, 1, 1);
    const Frame done = apply(scene, frame, "dof=0.5,4");
    for (int x = 0; x < 96; ++x) {
        EXPECT_NEAR(done.color[pixel_index(done, x, 40)].r, x < 48 ? 1 : 0, 1e-4) << x;
        EXPECT_NEAR(done.color[pixel_index(done, x, 40)].b, x < 48 ? 0 : 1, 1e-4) << x;
    }
}

/// The frame's red over what it was, at the middle of the picture.
double accessibility(Scene scene, const std::string& effects) {
    Engine engine(nullptr);
    const Plan plan = brute_force();
    const Frame plain = engine.render(scene, plan).frame;
    scene.effects = parse_effects(effects);
    const Frame done = engine.render(scene, plan).frame;
    const int c = scene.size.x / 2;
    return double(red(done, c, c)) / double(red(plain, c, c));
}

/// A block filling all below the plane through the middle (seen from the front, -y), with an optional pit.
template <class Value>
Scene block(Value&& value, glm::dvec3 spacing = glm::dvec3(1), double turn_deg = 0) {
    const glm::ivec3 size(glm::dvec3(48) / spacing);
    Scene scene = scene_of(sampled(centred(size, spacing, turn_deg), value), ViewMode::iso, 17);
    scene.iso = 0;
    scene.camera.zoom = 8;
    return scene;
}

TEST(Effects, AmbientOcclusionOfAPlaneIsNone) {
    const auto plane = [](const glm::dvec3& mm) { return mm.y + 0.2 * mm.x; };
    EXPECT_NEAR(accessibility(block(plane), "ao=64,30"), 1, 0.02);
    EXPECT_NEAR(accessibility(block(plane, {1, 1, 4}), "ao=64,30"), 1, 0.02);
    EXPECT_NEAR(accessibility(block(plane, glm::dvec3(1), 20), "ao=64,30"), 1, 0.02);
    Scene cut = block([](const glm::dvec3&) { return 1.0; });  // solid: what the cut took away casts no shadow
    cut.cuts = {{{0.3, 1, 0}, 0, false}};
    cut.iso = 0.5;
    cut.cuts[0].cap = true;
    EXPECT_NEAR(accessibility(cut, "ao=64,30"), 1, 1e-6);
    cut.cuts.clear();  // the volume's own side
    EXPECT_NEAR(accessibility(cut, "ao=64,30"), 1, 1e-6);
}

TEST(Effects, AmbientOcclusionInAPitApproachesItsClosedForm) {
    // From any point of a half-spherical bowl the sky is the other half of the sphere: half of all, by the cosine law.
    constexpr double k_radius = 16;
    const auto bowl = [](const glm::dvec3& mm) {
        return std::min(mm.y + 8, glm::length(mm + glm::dvec3(0, 8, 0)) - k_radius);
    };
    EXPECT_NEAR(accessibility(block(bowl), "ao=256,40"), 0.5, 0.05);
    EXPECT_NEAR(accessibility(block(bowl), "ao=16,40"), 0.5, 0.08);
    EXPECT_NEAR(accessibility(block(bowl), "ao=256,40,0.5"), 0.75, 0.03);
    EXPECT_NEAR(accessibility(block(bowl), "ao=64,4"), 1, 0.02);  // nothing within the distance
}

TEST(Effects, AmbientOcclusionByOpacityDarkensAPitToo) {
    const auto bowl = [](const glm::dvec3& mm) {
        return std::min(mm.y + 8, glm::length(mm + glm::dvec3(0, 8, 0)) - 16);
    };
    Scene scene = block(bowl);
    scene.mode = ViewMode::ea;
    TransferFunction tf;
    tf.points = {{0.0, glm::dvec3(1), 0.0}, {0.5, glm::dvec3(1), 0.95}};
    scene.classification.tf = tf;
    EXPECT_NEAR(accessibility(scene, "ao=256,40"), 0.5, 0.1);
    Scene plane = block([](const glm::dvec3& mm) { return mm.y; });
    plane.mode = ViewMode::ea;
    plane.classification.tf = tf;
    EXPECT_GT(accessibility(plane, "ao=256,40"), 0.85);
}

TEST(Effects, SameBytesTwiceAndForAnyNumberOfThreads) {
    const Volume two = sampled(centred({24, 21, 17}, {1, 1, 2}, 15), [](const glm::dvec3& mm) {
        return 6 - std::min(glm::length(mm - glm::dvec3(5, 0, 0)), glm::length(mm + glm::dvec3(5, 0, 0)));
    });
    Scene scene = scene_of(two, ViewMode::iso, 61);
    scene.camera.fov_deg = 40;
    scene.effects = parse_effects("ssao,ao=8,6,1,7,dof=0.4,3,0.2,tonemap,gamma=1.3,brightness=0.05,contrast=1.2");
    Engine engine(nullptr);
    const Frame first = engine.render(scene, brute_force()).frame;
    EXPECT_TRUE(same_bytes(engine.render(scene, brute_force()).frame, first));
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        EXPECT_TRUE(same_bytes(engine.render(scene, brute_force()).frame, first)) << threads;
    }
    set_thread_count(0);
    scene.effects[1].values[3] = 8;
    EXPECT_FALSE(same_bytes(engine.render(scene, brute_force()).frame, first)) << "the seed counts";
}

TEST(Effects, AmbientOcclusionComesByWayOfBetterAndBetterPictures) {
    const auto bowl = [](const glm::dvec3& mm) {
        return std::min(mm.y + 8, glm::length(mm + glm::dvec3(0, 8, 0)) - 16);
    };
    Scene scene = block(bowl);
    Engine engine(nullptr);
    for (const int samples : {1, 2, 20}) {
        scene.effects = parse_effects("brightness=0.1,ao=" + std::to_string(samples) + ",40,contrast=1.3");
        const Frame last = engine.render(scene, brute_force()).frame;
        std::vector<Frame> on_the_way;  // theirs to keep
        const auto keep = [&](Frame frame) { on_the_way.push_back(std::move(frame)); };
        EXPECT_TRUE(same_bytes(engine.render(scene, brute_force(), {}, false, keep).frame, last)) << samples;
        std::vector<double> errors;
        for (const Frame& frame : on_the_way) {
            double sum = 0;
            for (std::size_t i = 0; i < frame.pixels(); ++i)
                sum += double(std::fabs(frame.color[i].r - last.color[i].r));
            errors.push_back(sum / double(frame.pixels()));
        }
        if (samples < 20) {
            EXPECT_TRUE(errors.empty()) << samples;
            continue;
        }
        ASSERT_EQ(errors.size(), 4u) << "of 2, 4, 8 and 16 samples";
        for (std::size_t i = 0; i < errors.size(); ++i) {
            EXPECT_GT(errors[i], 0) << i;
            EXPECT_LT(errors[i], 0.12) << i << ": all effects are there";
        }
        EXPECT_LT(errors.back(), 0.5 * errors.front());
    }
}

TEST(Effects, WhatIsHeldIsToldWhileAFrameIsDrawn) {
    Scene scene = block([](const glm::dvec3& mm) { return mm.y; });
    scene.effects = parse_effects("ao=4,40");
    Engine engine(nullptr);
    std::vector<std::future<std::size_t>> answers;
    int told = 0;
    // Who shows a picture on the way asks this, and would otherwise wait for the last one.
    const auto ask = [&](const Frame&) {
        answers.push_back(std::async(std::launch::async, [&engine] { return engine.bytes_held(); }));
        told += answers.back().wait_for(std::chrono::seconds(10)) == std::future_status::ready;
    };
    engine.render(scene, brute_force(), {}, false, ask);
    EXPECT_EQ(told, 1) << "the picture of 2 samples";
}

TEST(Effects, OddDepthsAndTinyPicturesAreSafe) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(2, 7), glm::ivec2(37, 3), glm::ivec2(64, 64)}) {
        for (const bool perspective : {false, true}) {
            Scene scene = stage();
            scene.size = size;
            if (perspective) scene.camera.fov_deg = 90;
            const float odd[] = {k_nan, k_far, -k_far, 0, -5, 1e30f, 20, 21, 1e-30f};
            int i = 0;
            const Frame frame = frame_of(scene, [&](int, int) { return odd[i++ % 9]; });
            const Frame done = apply(scene, frame, "ssao=4,ao=4,dof=0.5,8,1,gamma=2,tonemap,contrast=2");
            for (const glm::vec4& c : done.color)
                EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && std::isfinite(c.a));
        }
    }
}

TEST(Effects, AStopEndsThemWithin30Ms) {
    Scene scene = scene_of(ball(centred({64, 64, 64}), 28), ViewMode::iso, 512);
    Frame frame = frame_of(scene, [](int, int) { return 30; });
    for (const char* effects : {"ao=1024,200", "ssao,dof,gamma=2"}) {
        scene.effects = parse_effects(effects);
        std::stop_source stop;
        stop.request_stop();
        EXPECT_THROW(apply_effects(scene, frame, {stop.get_token(), nullptr}), Error);
    }
    scene.effects = parse_effects("ao=1024,200");
    std::stop_source stop;
    std::chrono::steady_clock::time_point asked;
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
        asked = std::chrono::steady_clock::now();
        stop.request_stop();
    });
    EXPECT_THROW(apply_effects(scene, frame, {stop.get_token(), nullptr}), Error);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - asked;
    stopper.join();
    EXPECT_LT(took.count(), 100) << "30 ms on a machine of its own";
}

}  // namespace
}  // namespace lacuna
