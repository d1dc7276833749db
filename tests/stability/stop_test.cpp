#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "core/accel/macrocells.h"
#include "core/base/atomic_file.h"
#include "core/compute/device.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "core/render/engine.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"
#include "tests/support/scenes.h"

// Every long job, stopped early, in the middle and late: it must end soon, as cancelled, and leave nothing behind.
namespace lacuna {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, removed at the end.
class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "lacuna-stop-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~Folder() {
        std::error_code ec;
        fs::remove_all(path_, ec);
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

const Volume& large_volume() {
    static const Volume volume = test::bumpy_ball<std::uint16_t>({192, 192, 192}, {1, 1, 1}, 60000);
    return volume;
}

/// The same volume in every format, written once.
std::string file_of(const std::string& name) {
    static const Folder folder;
    const fs::path file = folder / name;
    if (!fs::exists(file)) write_volume(large_volume(), file);
    return file.string();
}

struct LongJob {
    std::string name;
    std::function<void(const JobContext&)> run;
};

void PrintTo(const LongJob& job, std::ostream* out) { *out << job.name; }

Engine& engine() {
    static Engine only(open_device());
    return only;
}

LongJob opening(const std::string& name, const std::string& file) {
    return {name, [file](const JobContext& job) { open_volume(file_of(file), {}, job); }};
}

LongJob writing(const std::string& name, const std::string& file) {
    return {name, [file](const JobContext& job) {
                const Folder folder;
                fs::create_directory(folder / "out");
                try {
                    write_volume(large_volume(), folder / "out" / file, job);
                } catch (...) {
                    EXPECT_TRUE(fs::is_empty(folder / "out")) << "something was left behind";
                    throw;
                }
            }};
}

LongJob rendering(ViewMode mode) {
    std::string name = "render_" + std::string(name_of(mode));
    std::replace(name.begin(), name.end(), '-', '_');
    return {name, [mode](const JobContext& job) {
                Scene scene = test::small_scene(large_volume(), mode, {1024, 1024});
                Plan plan = default_plan(scene);
                plan.step = 0.1;
                engine().drop_caches();  // building is part of the job
                engine().render(scene, plan, job);
            }};
}

std::vector<LongJob> long_jobs() {
    std::vector<LongJob> jobs = {
        opening("open_nrrd", "v.nrrd"),
        opening("open_nii_gz", "v.nii.gz"),
        opening("open_mhd", "v.mhd"),
        opening("open_raw", "v.raw"),
        opening("open_dicom", "dicom"),
        writing("write_nrrd", "o.nrrd"),
        writing("write_nii_gz", "o.nii.gz"),
        writing("write_nii", "o.nii"),
        writing("write_mhd", "o.mhd"),
        writing("write_raw", "o.raw"),
        writing("write_dicom", "dicom"),
        {"sample",
         [](const JobContext& job) {
             make_sample("head", {160, -1, -1, 1}, job);
         }},
        {"statistics", [](const JobContext& job) { compute_statistics(large_volume(), job); }},
        {"sha256", [](const JobContext& job) { voxel_sha256(large_volume(), job); }},
        {"macrocells", [](const JobContext& job) { build_macrocells(large_volume(), 3, job); }},
    };
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip,
                                ViewMode::mean, ViewMode::shear_warp})
        jobs.push_back(rendering(mode));
    return jobs;
}

class Stop : public testing::TestWithParam<LongJob> {};

TEST_P(Stop, EndsTheJobSoonWhereverItStands) {
    using Clock = std::chrono::steady_clock;
    GetParam().run({});  // files written, kernels compiled
    for (const double at : {0.0, 0.4, 0.8}) {
        std::stop_source source;
        std::atomic<bool> asked = false;
        Clock::time_point when{};
        const JobContext job{source.get_token(), [&](double done) {
                                 if (done < at || asked.exchange(true)) return;
                                 when = Clock::now();
                                 source.request_stop();
                             }};
        try {
            GetParam().run(job);
            FAIL() << "ran to the end though asked to stop at " << at << (asked ? "" : " (no such progress was told)");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::cancelled) << error.what();
        }
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - when).count();
        EXPECT_LT(ms, 250) << "30 ms are meant; the rest is a busy machine's";
    }
}

INSTANTIATE_TEST_SUITE_P(Jobs, Stop, testing::ValuesIn(long_jobs()), [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace lacuna
