// Loads a generated 512x512x300 series of 16-bit CT slices and compares with reading its files' bytes and with ITK's
// GDCM series reader, all three in turn. usage: bench_dicom_load [SLICES [ROUNDS]]
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/base/order_statistics.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/io/dicom_reader.h"
#include "tests/support/dicom_zoo.h"

#ifdef LACUNA_BENCH_ITK
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImage.h>
#include <itkImageSeriesReader.h>
#endif

namespace {

using namespace lacuna;
namespace fs = std::filesystem;

void write_series(const fs::path& folder, int slices) {
    for (int i = 0; i < slices; ++i) {
        test::ZooSlice s;
        s.size = {512, 512};
        s.position = {0, 0, 0.7 * i};
        s.instance = i + 1;
        s.stored = [i](int x, int y) { return (x * 7 + y * 13 + i * 29 + (x * y >> 5)) & 0xFFF; };
        test::write_zoo_slice(folder / ("slice" + std::to_string(i) + ".dcm"), s);
    }
}

/// Reads one file's bytes to `target`, returns how many.
std::size_t read_bytes(const fs::path& file, char* target, std::size_t most) {
    const int descriptor = ::open(file.c_str(), O_RDONLY);
    std::size_t done = 0;
    for (ssize_t got = 1; descriptor >= 0 && got > 0; done += std::size_t(std::max<ssize_t>(got, 0)))
        got = ::read(descriptor, target + done, most - done);
    ::close(descriptor);
    return done;
}

/// All files' bytes into one fresh buffer, file after file.
double plain_read_ms(const std::vector<fs::path>& files, std::size_t bytes_each) {
    const Stopwatch watch;
    const std::unique_ptr<char, void (*)(void*)> all(static_cast<char*>(std::malloc(files.size() * bytes_each)),
                                                     std::free);
    for (std::size_t i = 0; i < files.size(); ++i) read_bytes(files[i], all.get() + i * bytes_each, bytes_each);
    return watch.ms();
}

/// The same by all threads.
double parallel_read_ms(const std::vector<fs::path>& files, std::size_t bytes_each) {
    const Stopwatch watch;
    const std::unique_ptr<char, void (*)(void*)> all(static_cast<char*>(std::malloc(files.size() * bytes_each)),
                                                     std::free);
    parallel_for(0, std::int64_t(files.size()), [&](std::int64_t i) {
        read_bytes(files[std::size_t(i)], all.get() + std::size_t(i) * bytes_each, bytes_each);
    });
    return watch.ms();
}

double itk_ms(const fs::path& folder) {
#ifdef LACUNA_BENCH_ITK
    const Stopwatch watch;
    using Image = itk::Image<short, 3>;
    auto names = itk::GDCMSeriesFileNames::New();
    names->SetDirectory(folder.string());
    auto reader = itk::ImageSeriesReader<Image>::New();
    reader->SetImageIO(itk::GDCMImageIO::New());
    reader->SetFileNames(names->GetInputFileNames());
    reader->Update();
    return watch.ms();
#else
    return 0;
#endif
}

long status_kib(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(key, 0) == 0) return std::atol(line.c_str() + key.size() + 1);
    return 0;
}

}  // namespace

int main(int argc, char** argv) try {
    const int slices = argc > 1 ? std::atoi(argv[1]) : 300, rounds = argc > 2 ? std::atoi(argv[2]) : 7;
    const test::TemporaryFolder folder;
    write_series(folder.path(), slices);
    std::vector<fs::path> files;
    std::size_t longest = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        files.push_back(entry.path());
        longest = std::max(longest, std::size_t(entry.file_size()));
    }
    find_dicom_series(folder.path());  // DCMTK's dictionary is loaded once a process

    std::vector<double> plain, parallel, scan, whole, itk;
    double beyond = 0, volume_bytes = 0;
    for (int round = 0; round < rounds; ++round) {
        plain.push_back(plain_read_ms(files, longest));
        parallel.push_back(parallel_read_ms(files, longest));
        std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts anew
        const long before = status_kib("VmRSS:");
        const Stopwatch watch;
        const auto found = find_dicom_series(folder.path());
        scan.push_back(watch.ms());
        const Volume volume = read_dicom_series(found.front());
        whole.push_back(watch.ms());
        volume_bytes = double(volume.bytes());
        beyond = std::max(beyond, 1024.0 * double(status_kib("VmHWM:") - before) - volume_bytes);
        itk.push_back(itk_ms(folder.path()));
    }
    const double ours = median(whole), reference = median(plain);
    std::printf("%d slices of 512x512, %.0f MiB, %d threads, median of %d rounds\n", slices, volume_bytes / (1 << 20),
                thread_count(), rounds);
    std::printf("  bytes of the files, one thread    %8.1f ms\n", reference);
    std::printf("  bytes of the files, all threads   %8.1f ms\n", median(parallel));
    std::printf("  scan of the headers               %8.1f ms\n", median(scan));
    std::printf("  scan and load                     %8.1f ms   %.2f times the bytes (limit 2)\n", ours,
                ours / reference);
    if (median(itk) > 0)
        std::printf("  ITK's GDCM series reader          %8.1f ms   %.2f times ours (at least 1)\n", median(itk),
                    median(itk) / ours);
    std::printf("  peak memory beyond the volume     %8.1f MiB  %.3f of the volume (limit 1.3)\n", beyond / (1 << 20),
                beyond / volume_bytes);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
