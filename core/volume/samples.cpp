#include "core/volume/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/volume/sample_scene.h"

namespace lacuna {

namespace {

struct SampleEntry {
    std::string_view name;
    samples::Scene (*make)(const SampleOptions&);
    int default_size;
};

constexpr std::array k_samples{SampleEntry{"casting", samples::casting, 256}, SampleEntry{"head", samples::head, 256},
                               SampleEntry{"vessels", samples::vessels, 256},
                               SampleEntry{"spheres", samples::spheres, 128},
                               SampleEntry{"marschner-lobb", samples::marschner_lobb, 41}};
constexpr int k_least_size = 8, k_largest_size = 1 << 17;
constexpr std::int64_t k_most_voxels = std::int64_t(1) << 36;

glm::ivec3 dims_of(const SampleOptions& options, int default_size) {
    glm::ivec3 dims = options.dims;
    if (dims == glm::ivec3(0)) dims = glm::ivec3(options.size == 0 ? default_size : options.size);
    for (int a = 0; a < 3; ++a)
        if (dims[a] < k_least_size || dims[a] > k_largest_size)
            throw Error(Errc::bad_usage, "The sample's size " + std::to_string(dims[a]) + " is outside " +
                                             std::to_string(k_least_size) + ".." + std::to_string(k_largest_size) +
                                             " voxels; choose one inside.");
    if (std::int64_t(dims.x) * dims.y > k_most_voxels / dims.z)
        throw Error(Errc::bad_usage, "The sample would have more than 2^36 voxels; choose a smaller size.");
    return dims;
}

samples::Scene scene_of(std::string_view name, const SampleOptions& options) {
    const auto* entry =
        std::find_if(k_samples.begin(), k_samples.end(), [&](const SampleEntry& s) { return s.name == name; });
    if (entry == k_samples.end()) {
        std::string known;
        for (const SampleEntry& s : k_samples) known += (known.empty() ? "" : ", ") + std::string(s.name);
        throw Error(Errc::bad_usage,
                    "There is no built-in sample \"" + std::string(name) + "\"; the samples are " + known + ".");
    }
    SampleOptions chosen = options;
    chosen.dims = dims_of(options, entry->default_size);
    if (!std::isfinite(chosen.noise) || !std::isfinite(chosen.blur_voxels))
        throw Error(Errc::bad_usage, "The sample's noise and blur must be finite numbers.");
    samples::Scene scene = entry->make(chosen);
    scene.name = std::string(name);
    scene.seed = chosen.seed;
    if (chosen.noise >= 0) scene.noise = chosen.noise;
    if (chosen.blur_voxels >= 0) scene.blur_voxels = chosen.blur_voxels;
    return scene;
}

}  // namespace

std::vector<std::string_view> sample_names() {
    std::vector<std::string_view> names;
    for (const SampleEntry& s : k_samples) names.push_back(s.name);
    return names;
}

AnalyticSample make_sample(std::string_view name, const SampleOptions& options, const JobContext& job) {
    job.check();
    return samples::paint(scene_of(name, options), job);
}

Volume sample_in_parts(std::string_view name, const SampleOptions& options) {
    return samples::paint_in_parts(scene_of(name, options));
}

}  // namespace lacuna
