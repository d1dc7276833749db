// How long one slice takes: along the grid, tilted, and as slabs, on a 512^3 volume; by the clock, and the processor's
// time, which other work on the machine does not lengthen. bench_slices [SIZE] [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/session/measurement.h"
#include "core/volume/reslice.h"
#include "core/volume/samples.h"

using namespace lacuna;

namespace {

struct Case {
    const char* name;
    SliceFrame frame;
    Slab slab;
    std::vector<double> ms{}, cpu_ms{};
};

/// A square picture of `pixels` across, one voxel a pixel, through the middle.
SliceFrame middle_frame(const GridGeometry& grid, const glm::dvec3& right, const glm::dvec3& down, int pixels) {
    SliceFrame frame;
    frame.right = right;
    frame.down = down;
    frame.pixel_mm = glm::dvec2(grid.smallest_spacing_mm());
    frame.size = glm::ivec2(pixels);
    const glm::dvec3 middle = grid.voxel_to_mm(glm::dvec3(grid.size / 2));
    const double half = (pixels / 2 + 0.5) * frame.pixel_mm.x;
    frame.corner_mm = middle - right * half - down * half;
    return frame;
}

}  // namespace

int main(int argc, char** argv) {
    SampleOptions options;
    options.size = argc > 1 ? std::atoi(argv[1]) : 512;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 15;
    const Volume volume = make_sample("head", options).volume;
    const GridGeometry& grid = volume.geometry();
    const glm::dmat3 turn(glm::mat3_cast(glm::angleAxis(0.5, glm::normalize(glm::dvec3(0.3, 1, 0.5)))));
    const glm::dvec3 x = grid.direction[0], y = grid.direction[1], z = grid.direction[2];
    const int n = options.size;
    const SliceFrame axial = middle_frame(grid, x, y, n), sagittal = middle_frame(grid, y, -z, n);
    const SliceFrame tilted = middle_frame(grid, turn * x, turn * y, n);
    const double ten = 10 * grid.smallest_spacing_mm();
    std::vector<Case> cases = {{"axial", axial, {}},
                               {"sagittal", sagittal, {}},
                               {"tilted", tilted, {}},
                               {"axial, mean of 10 slices", axial, {ten, SlabMode::mean}},
                               {"sagittal, MIP of 10 slices", sagittal, {ten, SlabMode::mip}},
                               {"tilted, MIP of 10 sheets", tilted, {ten, SlabMode::mip}}};
    for (int round = 0; round < rounds; ++round)
        for (Case& each : cases) {  // interleaved: what else the machine does meets all alike
            const Stopwatch watch;
            const std::clock_t cpu = std::clock();
            const std::vector<float> values = reslice(volume, each.frame, each.slab);
            each.ms.push_back(watch.ms());
            each.cpu_ms.push_back(1000.0 * double(std::clock() - cpu) / CLOCKS_PER_SEC);
            if (values.size() != std::size_t(n) * std::size_t(n)) return 1;
        }
    for (Case& each : cases) {
        std::sort(each.ms.begin(), each.ms.end());
        std::sort(each.cpu_ms.begin(), each.cpu_ms.end());
        fmt::print("{:28} {:7.2f} ms, processor {:7.2f} ms\n", each.name, each.ms[each.ms.size() / 2],
                   each.cpu_ms[each.cpu_ms.size() / 2]);
    }
    return 0;
}
