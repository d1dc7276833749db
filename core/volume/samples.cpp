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
constexpr int k_least_size = 8, k_largest_size = 2048;

}  // namespace

std::vector<std::string_view> sample_names() {
    std::vector<std::string_view> names;
    for (const SampleEntry& s : k_samples) names.push_back(s.name);
    return names;
}

AnalyticSample make_sample(std::string_view name, const SampleOptions& options, const JobContext& job) {
    const auto* entry =
        std::find_if(k_samples.begin(), k_samples.end(), [&](const SampleEntry& s) { return s.name == name; });
    if (entry == k_samples.end()) {
        std::string known;
        for (const SampleEntry& s : k_samples) known += (known.empty() ? "" : ", ") + std::string(s.name);
        throw Error(Errc::bad_usage,
                    "There is no built-in sample \"" + std::string(name) + "\"; the samples are " + known + ".");
    }
    SampleOptions chosen = options;
    if (chosen.size == 0) chosen.size = entry->default_size;
    if (chosen.size < k_least_size || chosen.size > k_largest_size)
        throw Error(Errc::bad_usage, "The sample's size " + std::to_string(chosen.size) + " is outside " +
                                         std::to_string(k_least_size) + ".." + std::to_string(k_largest_size) +
                                         " voxels; choose one inside.");
    if (!std::isfinite(chosen.noise) || !std::isfinite(chosen.blur_voxels))
        throw Error(Errc::bad_usage, "The sample's noise and blur must be finite numbers.");
    job.check();
    samples::Scene scene = entry->make(chosen);
    scene.name = std::string(name);
    scene.seed = chosen.seed;
    if (chosen.noise >= 0) scene.noise = chosen.noise;
    if (chosen.blur_voxels >= 0) scene.blur_voxels = chosen.blur_voxels;
    return samples::paint(std::move(scene), job);
}

}  // namespace lacuna
