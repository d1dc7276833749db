// bench_inspect [SIZE [PORES]]: seconds and peak memory of analyse_part on a casting of its own making (a cylinder with
// that many balls of 1.5 to 8 voxels radius, blur 0.8 voxels, noise; default 512 and 5000), and connected components in
// turn with ITK's filter on the same data where ITK's headers are installed; between them the table of lacuna regions.
// Linux only: the peak comes from /proc.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/inspect/part_analysis.h"
#include "core/regions/run_components.h"

#ifdef LACUNA_BENCH_ITK_COMPONENTS
#include <itkConnectedComponentImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>
#endif

namespace {

using namespace lacuna;

constexpr double k_air = 3000, k_metal = 30000, k_noise = 700, k_blur = 0.8;

double status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key)) return 1024.0 * std::atof(line.c_str() + key.size() + 1);
    return 0;
}

std::uint64_t scrambled(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

struct Ball {
    glm::dvec3 centre;
    double radius;
};

/// One ball at most in each cell of a lattice, so that none touch.
std::vector<Ball> place_balls(int size, int pores) {
    const double outer = 0.45 * size, height = 0.8 * size;
    // As many cells as there are balls wanted, and half as many again.
    const double cell = std::cbrt(M_PI * outer * outer * height / (1.6 * pores));
    const int n = int(size / cell);
    std::vector<Ball> balls;
    std::uint64_t dice = 1;
    const auto random = [&dice] { return double(scrambled(dice++) >> 11) * 0x1p-53; };
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double radius = std::min(1.5 + 6.5 * std::pow(random(), 3), 0.4 * cell);
                const double room = std::max(0.0, cell / 2 - radius - 2);
                const glm::dvec3 jitter(2 * random() - 1, 2 * random() - 1, 2 * random() - 1);
                const glm::dvec3 centre = (glm::dvec3(x, y, z) + 0.5) * cell + room * jitter;
                const double off = std::hypot(centre.x - size / 2.0, centre.y - size / 2.0);
                if (off < outer - radius - 4 && std::abs(centre.z - size / 2.0) < height / 2 - radius - 4)
                    balls.push_back({centre, radius});
            }
    while (int(balls.size()) > pores) balls.erase(balls.begin() + std::ptrdiff_t(balls.size() * random()));
    return balls;
}

Volume paint(int size, const std::vector<Ball>& balls) {
    GridGeometry g;
    g.size = glm::ivec3(size);
    g.spacing = glm::dvec3(0.1);
    const auto share = [](double distance) { return 0.5 * std::erfc(distance / (std::sqrt(2.0) * k_blur)); };
    return make_volume<std::uint16_t>(g, [&](std::span<std::uint16_t> voxels) {
        parallel_for(0, size, [&](std::int64_t z) {
            std::vector<float> slice(std::size_t(size) * std::size_t(size));
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double radial = std::hypot(x - size / 2.0, y - size / 2.0) - 0.45 * size;
                    const double axial = std::abs(double(z) - size / 2.0) - 0.4 * size;
                    slice[std::size_t(y) * std::size_t(size) + std::size_t(x)] =
                        float(k_air + (k_metal - k_air) * share(std::max(radial, axial)));
                }
            for (const Ball& b : balls) {
                const double reach = b.radius + 4;
                if (std::abs(b.centre.z - double(z)) > reach) continue;
                for (int y = int(b.centre.y - reach); y <= int(b.centre.y + reach); ++y)
                    for (int x = int(b.centre.x - reach); x <= int(b.centre.x + reach); ++x) {
                        const double d = glm::length(glm::dvec3(x, y, double(z)) - b.centre) - b.radius;
                        float& v = slice[std::size_t(y) * std::size_t(size) + std::size_t(x)];
                        v += float((k_air - k_metal) * share(d));
                    }
            }
            for (std::size_t i = 0; i < slice.size(); ++i) {
                const std::uint64_t bits = scrambled(std::uint64_t(z) * slice.size() + i);
                const double u = (double(bits >> 40) + 1) * 0x1p-24, angle = double(bits & 0xffffff) * 0x1p-24;
                const double noise = k_noise * std::sqrt(-2 * std::log(u)) * std::cos(2 * M_PI * angle);
                voxels[std::size_t(z) * slice.size() + i] =
                    std::uint16_t(std::clamp(std::round(double(slice[i]) + noise), 0.0, 65535.0));
            }
        });
    });
}

void measure_inspection(const Volume& volume, const std::vector<Ball>& balls) {
    const double voxels = double(volume.geometry().voxel_count());
    std::ofstream("/proc/self/clear_refs") << "5";
    const double before = status_bytes("VmRSS:");
    const Stopwatch clock;
    const std::clock_t cpu = std::clock();
    const PartAnalysis a = analyse_part(volume, {});
    const double s = clock.ms() / 1000, cpu_s = double(std::clock() - cpu) / CLOCKS_PER_SEC;
    const double bytes = (status_bytes("VmHWM:") - before) / voxels;
    double truth = 0;
    for (const Ball& b : balls) truth += 4.0 / 3 * M_PI * std::pow(b.radius * volume.geometry().spacing.x, 3);
    std::size_t inside = 0, matched = 0;
    std::vector<const Ball*> of(a.defects.size() + 1, nullptr);
    for (const Ball& b : balls) {
        const glm::ivec3 p(glm::round(b.centre));
        if (const std::uint32_t id = a.labels(p.x, p.y, p.z)) of[id] = &b;
    }
    for (const Defect& d : a.defects) {
        if (!of[d.id] || !d.measurable) continue;
        const double v = 4.0 / 3 * M_PI * std::pow(of[d.id]->radius * volume.geometry().spacing.x, 3);
        ++matched;
        inside += d.volume_mm3.lo <= v && v <= d.volume_mm3.hi;
    }
    std::printf(
        "inspection, %d^3, %zu pores: %.2f s (%.2f s of processor time), %.2f bytes a voxel beyond the volume\n",
        volume.geometry().size.x, balls.size(), s, cpu_s, bytes);
    std::printf("  %zu defects, true volume in its interval for %zu of %zu, porosity %.4f [%.4f, %.4f], true %.4f %%\n",
                a.defects.size(), inside, matched, a.part.porosity_percent.value, a.part.porosity_percent.lo,
                a.part.porosity_percent.hi, 100 * truth / a.part.part_volume_mm3.value);
    std::fflush(stdout);
}

/// The table of `lacuna regions --threshold min,T` on the same volume, surfaces and distances included.
void measure_region_table(const Volume& volume) {
    const double voxels = double(volume.geometry().voxel_count());
    std::ofstream("/proc/self/clear_refs") << "5";
    const double before = status_bytes("VmRSS:");
    const Stopwatch clock;
    const std::clock_t cpu = std::clock();
    RegionOptions options;
    options.threshold = ValueRange{0, (k_air + k_metal) / 2};
    options.connectivity = Connectivity::c26;
    options.min_voxels = 8;
    RegionTable table = find_regions(volume, options);
    const double found_s = clock.ms() / 1000;
    measure_surfaces(volume, table);
    const double s = clock.ms() / 1000, bytes = (status_bytes("VmHWM:") - before) / voxels;
    std::printf(
        "region table: %.2f s (%.2f s of processor time), %.2f of them surfaces and distances, %zu rows, %.2f "
        "bytes a voxel\n",
        s, double(std::clock() - cpu) / CLOCKS_PER_SEC, s - found_s, table.rows.size(), bytes);
    std::fflush(stdout);
}

#ifdef LACUNA_BENCH_ITK_COMPONENTS
using ByteImage = itk::Image<std::uint8_t, 3>;
using LabelImage = itk::Image<std::uint32_t, 3>;

/// The same work on both sides: labels of what a mask of bytes holds, face neighbours.
void measure_components(const Volume& volume) {
    const glm::ivec3 n = volume.geometry().size;
    const auto* values = volume.view<std::uint16_t>().data;
    const Volume mask = make_volume<std::uint8_t>(volume.geometry(), [&](std::span<std::uint8_t> out) {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[i] < (k_air + k_metal) / 2;
    });
    auto image = ByteImage::New();
    ByteImage::RegionType region;
    for (unsigned a = 0; a < 3; ++a) region.SetSize(a, ByteImage::SizeValueType(n[int(a)]));
    image->SetRegions(region);
    image->GetPixelContainer()->SetImportPointer(reinterpret_cast<std::uint8_t*>(mask.buffer().data()), mask.bytes(),
                                                 false);
    std::vector<double> ours, theirs;
    std::size_t count = 0, itk_count = 0;
    for (int round = 0; round < 3; ++round) {
        {
            const Stopwatch clock;
            const runs::RunList list = runs::find_runs(n, runs::mark_in_range(mask, {1, 1}));
            const runs::Components components = runs::join(list, Connectivity::c6);
            std::vector<std::uint32_t> labels(std::size_t(volume.geometry().voxel_count()));
            parallel_for(0, n.z, [&](std::int64_t z) {
                runs::for_runs(list, int(z), [&](int y, int at_z, const runs::Run& run, std::size_t k) {
                    std::uint32_t* row = labels.data() + volume.geometry().linear_index(0, y, at_z);
                    std::fill(row + run.first, row + run.last + 1, components.of_run[k] + 1);
                });
            });
            ours.push_back(clock.ms());
            count = components.count();
        }
        auto filter = itk::ConnectedComponentImageFilter<ByteImage, LabelImage>::New();
        filter->SetInput(image);
        filter->SetNumberOfWorkUnits(unsigned(thread_count()));
        const Stopwatch clock;
        filter->Update();
        theirs.push_back(clock.ms());
        itk_count = filter->GetObjectCount();
    }
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    std::printf("components: ours %.0f ms (%zu), ITK %.0f ms (%zu): %.2f times ours\n", ours[1], count, theirs[1],
                itk_count, theirs[1] / ours[1]);
}
#endif

}  // namespace

int main(int argc, char** argv) {
    const int size = argc > 1 ? std::atoi(argv[1]) : 512, pores = argc > 2 ? std::atoi(argv[2]) : 5000;
    if (size < 64 || pores < 1) {
        std::fprintf(stderr, "bench_inspect [SIZE from 64 [PORES]]\n");
        return 2;
    }
    const std::vector<Ball> balls = place_balls(size, pores);
    const Volume volume = paint(size, balls);
    std::printf("%d threads\n", thread_count());
    measure_inspection(volume, balls);
    measure_region_table(volume);
#ifdef LACUNA_BENCH_ITK_COMPONENTS
    measure_components(volume);
#endif
}
