// Parts with known pores: what is found, how well it is sized, and whether the truth lies in the intervals printed.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/inspect/part_analysis.h"
#include "core/volume/samples.h"

namespace lacuna {
namespace {

/// What became of the pores of one class of size, in voxels across (ball of equal volume).
struct SizeClass {
    double from, to;
    int pores = 0, found = 0, measured = 0, volume_in = 0, diameter_in = 0;
    double error = 0, squared_error = 0, width = 0;
};

struct Outcome {
    std::vector<SizeClass> classes{{0, 3}, {3, 4}, {4, 6}, {6, 9}, {9, 15}, {15, 1000}};
    int finds = 0, false_finds = 0;

    void add(const AnalyticSample& sample, const PartAnalysis& analysis) {
        const GridGeometry& g = sample.volume.geometry();
        std::vector<bool> real(analysis.defects.size() + 1, false);
        for (const SampleObject& pore : sample.objects) {
            if (pore.kind != "void") continue;
            const double across = std::cbrt(6 * pore.volume_mm3 / M_PI) / g.spacing.x;
            SizeClass* row = nullptr;
            for (SizeClass& c : classes)
                if (across >= c.from && across < c.to) row = &c;
            ++row->pores;
            const std::uint32_t id = find_at(analysis, pore);
            if (id == 0) continue;
            real[id] = true;
            ++row->found;
            const Defect& d = analysis.defects[id - 1];
            if (!d.measurable) continue;
            ++row->measured;
            row->volume_in += d.volume_mm3.lo <= pore.volume_mm3 && pore.volume_mm3 <= d.volume_mm3.hi;
            const double longest = 2 * std::max({pore.radii_mm.x, pore.radii_mm.y, pore.radii_mm.z});
            row->diameter_in += d.diameter_mm.lo <= longest && longest <= d.diameter_mm.hi;
            const double error = d.volume_mm3.value / pore.volume_mm3 - 1;
            row->error += error, row->squared_error += error * error;
            row->width += (d.volume_mm3.hi - d.volume_mm3.lo) / pore.volume_mm3;
        }
        finds += int(analysis.defects.size());
        for (const Defect& d : analysis.defects) false_finds += !real[d.id];
    }

    /// The find whose centre lies within a pore.
    static std::uint32_t find_at(const PartAnalysis& analysis, const SampleObject& pore) {
        for (const Defect& d : analysis.defects)
            if (glm::length((d.centroid_mm - pore.centre_mm) / pore.radii_mm) < 1) return d.id;
        return 0;
    }

    void print(const char* title) const {
        std::printf("%s\n%12s %6s %6s %9s %10s %9s %9s %10s %12s\n", title, "voxels across", "pores", "found",
                    "measured", "mean err %", "rms err %", "width %", "volume in", "diameter in");
        for (const SizeClass& c : classes)
            if (c.pores > 0)
                std::printf("%5.0f ..%6.0f %6d %6d %9d %10.2f %9.2f %9.1f %10d %12d\n", c.from, c.to, c.pores, c.found,
                            c.measured, 100 * c.error / std::max(1, c.measured),
                            100 * std::sqrt(c.squared_error / std::max(1, c.measured)),
                            100 * c.width / std::max(1, c.measured), c.volume_in, c.diameter_in);
        std::printf("finds %d, false %d\n", finds, false_finds);
    }
};

class CastingDetection : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(CastingDetection, FindsThePoresAndItsIntervalsHoldTheirTrueVolumes) {
    const auto [noise, blur] = GetParam();
    Outcome outcome;
    for (const unsigned seed : {1u, 2u}) {
        SampleOptions options;
        options.size = 128;
        options.noise = noise;
        options.blur_voxels = blur;
        options.seed = seed;
        const AnalyticSample sample = make_sample("casting", options);
        const PartAnalysis analysis = analyse_part(sample.volume, {});
        outcome.add(sample, analysis);
        std::printf(
            "threshold %.0f air %.0f material %.0f noise %.0f edge %.3f voxels plateau %.0f..%.0f porosity %.4f [%.4f, "
            "%.4f] part %.1f mm3\n",
            analysis.part.material_threshold, analysis.part.void_level, analysis.part.material_level,
            analysis.part.noise, analysis.part.edge_width_mm / sample.volume.geometry().spacing.x,
            analysis.stability.plateau.lo, analysis.stability.plateau.hi, analysis.part.porosity_percent.value,
            analysis.part.porosity_percent.lo, analysis.part.porosity_percent.hi, analysis.part.part_volume_mm3.value);
        for (const auto& w : analysis.part.warnings) std::printf("warning: %s\n", w.c_str());
    }
    char title[100];
    std::snprintf(title, sizeof title, "noise %.0f of contrast 27000, blur %.1f voxels", noise, blur);
    outcome.print(title);
    int measured = 0, volume_in = 0, diameter_in = 0;
    for (const SizeClass& c : outcome.classes) {
        if (c.from >= 3) {
            EXPECT_EQ(c.found, c.pores) << "voxels across from " << c.from;
        }
        measured += c.measured, volume_in += c.volume_in, diameter_in += c.diameter_in;
    }
    EXPECT_GE(volume_in, 0.95 * measured);
    EXPECT_GE(diameter_in, 0.95 * measured);
    EXPECT_LE(outcome.false_finds, 0.01 * outcome.finds);
}

INSTANTIATE_TEST_SUITE_P(NoiseAndBlur, CastingDetection,
                         testing::Combine(testing::Values(500.0, 1500.0, 3000.0), testing::Values(0.7, 1.2)));

}  // namespace
}  // namespace lacuna
