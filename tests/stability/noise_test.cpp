// Noise of increasing strength: how region growing shatters, what brings it back, and whether porosity's interval still
// holds the truth.
#include <gtest/gtest.h>

#include <cstdio>

#include "core/inspect/part_analysis.h"
#include "core/regions/regions.h"
#include "core/volume/samples.h"
#include "core/volume/smooth.h"

namespace lacuna {
namespace {

constexpr double k_contrast = 27000;  // of the sample casting

AnalyticSample casting(double noise) {
    SampleOptions options;
    options.size = 80;
    options.noise = noise;
    options.blur_voxels = 0.7;
    return make_sample("casting", options);
}

struct Regions {
    std::size_t all = 0;  ///< of one voxel or more
    double covered = 0;   ///< share of the voxels in regions of 64 or more
};

Regions regions_of(const Volume& volume) {
    RegionOptions options;
    options.range_width = 0.1;
    Regions found;
    for (const RegionCharacteristics& row : find_regions(volume, options).rows) {
        ++found.all;
        if (row.voxels >= 64) found.covered += double(row.voxels) / double(volume.geometry().voxel_count());
    }
    return found;
}

TEST(Noise, ShattersRegionsUntilTheVolumeIsSmoothed) {
    const Volume clean_volume = casting(0).volume;
    const Regions clean = regions_of(clean_volume);
    Regions noisy;
    for (const double share : {0.02, 0.05, 0.1}) {
        const Regions found = regions_of(casting(share * k_contrast).volume);
        std::printf("noise %.0f %%: %zu regions, %.1f %% of the voxels in those of 64 or more\n", 100 * share,
                    found.all, 100 * found.covered);
        EXPECT_GE(found.all, noisy.all) << "noise " << share;
        noisy = found;
    }
    EXPECT_GT(noisy.all, 10 * clean.all) << "the published failure";
    EXPECT_LT(noisy.covered, clean.covered - 0.1) << "and rays have less to leap through";
    const Volume smooth = gaussian_smooth(casting(0.1 * k_contrast).volume, 1.5 * clean_volume.geometry().spacing.x);
    const Regions calmed = regions_of(smooth);
    std::printf("clean: %zu, %.1f %%; smoothed: %zu, %.1f %%\n", clean.all, 100 * clean.covered, calmed.all,
                100 * calmed.covered);
    EXPECT_LE(calmed.all, 3 * clean.all);
    EXPECT_GT(calmed.covered, clean.covered - 0.1);
}

/// Porosity of the sample's formula, in percent: its voids' exact volume against the part's, by 8 points a voxel.
double true_porosity(const AnalyticSample& sample) {
    const GridGeometry& grid = sample.volume.geometry();
    double voids = 0, material = 0;
    for (const SampleObject& object : sample.objects) voids += object.kind == "void" ? object.volume_mm3 : 0;
    for (int z = 0; z < 2 * grid.size.z; ++z)
        for (int y = 0; y < 2 * grid.size.y; ++y)
            for (int x = 0; x < 2 * grid.size.x; ++x)
                material += sample.value(grid.voxel_to_mm(0.5 * glm::dvec3(x, y, z) - 0.25)) >
                            0.5 * (sample.background + sample.material);
    return 100 * voids / (voids + material * grid.voxel_volume_mm3() / 8);
}

TEST(Noise, PorosityStaysWithinItsInterval) {
    const double truth = true_porosity(casting(0));
    double error = 0;
    for (const double share : {0.0, 0.02, 0.06, 0.1}) {
        const Measured porosity = analyse_part(casting(share * k_contrast).volume, {}).part.porosity_percent;
        std::printf("noise %.0f %%: porosity %.4f %% [%.4f, %.4f], true %.4f %%\n", 100 * share, porosity.value,
                    porosity.lo, porosity.hi, truth);
        EXPECT_LE(porosity.lo, truth) << "noise " << share;
        EXPECT_GE(porosity.hi, truth) << "noise " << share;
        error = std::max(error, std::fabs(porosity.value - truth));
    }
    EXPECT_GT(error, 0.01 * truth) << "one number alone is off; the interval says by how much";
}

}  // namespace
}  // namespace lacuna
