// bench_regions [SIZE ...]: seconds and peak memory of find_regions and measure_surfaces on a casting with noise and on
// pure noise (the worst case: nearly every voxel is a region of its own). Linux only: the peak comes from /proc.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/regions/regions.h"
#include "core/volume/samples.h"

namespace {

using namespace lacuna;

double status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key)) return 1024.0 * std::atof(line.c_str() + key.size() + 1);
    return 0;
}

void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

Volume noise_volume(int size) {
    GridGeometry geometry;
    geometry.size = glm::ivec3(size);
    return make_volume<std::uint8_t>(geometry, [](std::span<std::uint8_t> voxels) {
        std::uint64_t state = 88172645463325252ull;
        for (std::uint8_t& voxel : voxels) {
            state ^= state << 13, state ^= state >> 7, state ^= state << 17;
            voxel = std::uint8_t(state >> 40);
        }
    });
}

void measure(const char* name, const Volume& volume, const RegionOptions& options) {
    const double voxels = double(volume.geometry().voxel_count());
    reset_peak();
    const double before = status_bytes("VmRSS:");
    const Stopwatch clock;
    const std::clock_t cpu_before = std::clock();
    double half_ms = 0, surfaces_ms = 0;  // when the labels stood and the measuring began
    const JobContext job{{}, [&](double f) { half_ms = f <= 0.5 ? clock.ms() : half_ms; }};
    std::size_t regions = 0, flagged = 0;
    std::string outcome;
    try {
        RegionTable table = find_regions(volume, options, job);
        regions = table.rows.size();
        const double found_ms = clock.ms();
        measure_surfaces(volume, table);
        surfaces_ms = clock.ms() - found_ms;
        for (const RegionCharacteristics& row : table.rows) flagged += !row.flags.empty();
    } catch (const Error& error) {
        outcome = error.what();
    }
    const double cpu_s = double(std::clock() - cpu_before) / CLOCKS_PER_SEC;
    std::printf("%-34s %4d %7.2f %7.2f %7.2f %7.2f %7.2f %9zu %9zu  %s\n", name, volume.geometry().size.x,
                clock.ms() / 1000, cpu_s, half_ms / 1000, surfaces_ms / 1000,
                (status_bytes("VmHWM:") - before) / voxels, regions, flagged, outcome.c_str());
    std::fflush(stdout);
}

RegionOptions growing(double width, std::int64_t min_voxels, Connectivity connectivity = Connectivity::c6) {
    RegionOptions options;
    options.range_width = width;
    options.min_voxels = min_voxels;
    options.connectivity = connectivity;
    return options;
}

RegionOptions thresholding(ValueRange range, Connectivity connectivity) {
    RegionOptions options;
    options.threshold = range;
    options.min_voxels = 8;
    options.connectivity = connectivity;
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> sizes;
    for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
    if (sizes.empty()) sizes.push_back(256);
    std::printf("%d threads\n%-34s %4s %7s %7s %7s %7s %7s %9s %9s\n", lacuna::thread_count(), "volume, options",
                "size", "s", "cpu s", "label s", "surf. s", "B/voxel", "regions", "flagged");
    for (const int size : sizes) {
        SampleOptions sample;
        sample.size = size;
        const AnalyticSample casting = make_sample("casting", sample);
        const double middle = (casting.background + casting.material) / 2;
        measure("casting, width 0.1, from 8", casting.volume, growing(0.1, 8));
        measure("casting, width 0.1, from 1", casting.volume, growing(0.1, 1));
        measure("casting, width 0.3, from 8", casting.volume, growing(0.3, 8));
        measure("casting, width 0.1, 26, from 8", casting.volume, growing(0.1, 8, Connectivity::c26));
        measure("casting, below half, 26", casting.volume, thresholding({-1e9, middle}, Connectivity::c26));
        measure("casting, above half, 6", casting.volume, thresholding({middle, 1e9}, Connectivity::c6));
        const Volume noise = noise_volume(size);
        measure("noise, width 0.1, from 8", noise, growing(0.1, 8));
        measure("noise, width 0.1, from 1", noise, growing(0.1, 1));
        measure("noise, width 0.4, from 8", noise, growing(0.4, 8));
        measure("noise, upper half, 26", noise, thresholding({128, 255}, Connectivity::c26));
        measure("noise, upper quarter, 6", noise, thresholding({192, 255}, Connectivity::c6));
    }
}
