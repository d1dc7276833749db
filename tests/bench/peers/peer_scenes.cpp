#include "tests/bench/peers/peer_scenes.h"

#include <algorithm>

#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna::peers {

namespace {

constexpr double k_head_offset = 1024;  // HU to unsigned

/// Signed HU as unsigned values, so that every scene has the same voxel type.
Volume as_unsigned(const Volume& volume, double offset) {
    if (volume.type() == VoxelType::u16) return volume;
    const auto from = volume.view<std::int16_t>().voxels();
    return make_volume<std::uint16_t>(volume.geometry(), [&](auto to) {
        std::transform(from.begin(), from.end(), to.begin(),
                       [&](std::int16_t v) { return std::uint16_t(std::max(0.0, v + offset)); });
    });
}

TransferFunction opaque_metal() {
    return {"opaque metal",
            1,
            {{12000, {0.60, 0.60, 0.65}, 0.0}, {20000, {0.75, 0.75, 0.80}, 0.9}, {36000, {0.90, 0.90, 0.95}, 0.95}},
            {}};
}

TransferFunction skin_and_skull() {
    TransferFunction tf{"skin and skull",
                        1,
                        {{-600, {0.80, 0.50, 0.40}, 0.0},
                         {-300, {0.90, 0.60, 0.50}, 0.02},
                         {0, {0.90, 0.60, 0.50}, 0.03},
                         {120, {0.90, 0.60, 0.50}, 0.01},
                         {400, {1.00, 0.95, 0.80}, 0.15},
                         {1200, {1.0, 1.0, 0.9}, 0.5},
                         {3000, {1.0, 1.0, 1.0}, 0.6}},
                        {}};
    for (TransferPoint& p : tf.points) p.value += k_head_offset;
    return tf;
}

TransferFunction contrast_agent() {
    return {"contrast agent",
            1,
            {{600, {0.80, 0.10, 0.10}, 0.0},
             {900, {0.90, 0.20, 0.15}, 0.35},
             {1200, {1.0, 0.5, 0.4}, 0.7},
             {1600, {1, 1, 1}, 0.8}},
            {}};
}

TransferFunction fog() {
    return {"fog",
            1,
            {{0, {0.3, 0.5, 0.9}, 0.0005},
             {10000, {0.3, 0.5, 0.9}, 0.0015},
             {16000, {0.95, 0.6, 0.2}, 0.02},
             {22000, {0.8, 0.8, 0.8}, 0.004},
             {36000, {1, 1, 1}, 0.006}},
            {}};
}

struct Subject {
    const char* sample;
    TransferFunction tf;
    double iso;
};

std::vector<Subject> subjects() {
    return {{"casting", opaque_metal(), 16000},
            {"head", skin_and_skull(), 500 + k_head_offset},
            {"vessels", contrast_agent(), 700}};
}

Scene scene_of(const Subject& subject, int size) {
    const Volume volume = as_unsigned(make_sample(subject.sample, {.size = size}).volume, k_head_offset);
    Scene scene = default_scene(volume, compute_statistics(volume));
    scene.classification.tf = subject.tf;
    // Opacities are per voxel, as when a user looks at a data set for the first time.
    scene.classification.tf.unit_distance_mm = volume.geometry().smallest_spacing_mm();
    scene.iso = subject.iso;
    scene.camera.zoom = 1.35;
    scene.camera.fov_deg = 30;
    scene.camera.azimuth_deg = 7;
    scene.camera.elevation_deg = 20;
    return scene;
}

}  // namespace

std::vector<PeerScene> make_ea_scenes(int size) {
    std::vector<PeerScene> scenes;
    for (const Subject& subject : subjects()) {
        PeerScene next{subject.sample, scene_of(subject, size)};
        next.scene.mode = ViewMode::ea;
        scenes.push_back(std::move(next));
    }
    PeerScene misty = scenes.front();
    misty.name = "fog";
    const double unit_mm = misty.scene.classification.tf.unit_distance_mm;
    misty.scene.classification.tf = fog();
    misty.scene.classification.tf.unit_distance_mm = unit_mm;
    scenes.push_back(std::move(misty));
    return scenes;
}

std::vector<PeerScene> make_plain_scenes(int size, ViewMode mode) {
    std::vector<PeerScene> scenes;
    for (const Subject& subject : subjects()) {
        scenes.push_back({subject.sample, scene_of(subject, size)});
        scenes.back().scene.mode = mode;
    }
    return scenes;
}

}  // namespace lacuna::peers
