#include "core/compute/device.h"

#include <fstream>
#include <thread>

#include "compute_fixture.h"
#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/stopwatch.h"
#include "core/compute/self_test.h"

namespace lacuna {

namespace {

using DeviceTest = ComputeTest;

Errc code_of(const std::string& choice, std::string* sentence = nullptr) {
    try {
        open_device(choice);
    } catch (const Error& failure) {
        if (sentence) *sentence = failure.what();
        return failure.code();
    }
    return Errc::io;  // none of those looked for
}

/// Ends the process with 0 when nothing opens and the log says so once; for use in a child process.
[[noreturn]] void open_where_no_driver_is(const std::string& vendors) {
    ::setenv("OCL_ICD_VENDORS", vendors.c_str(), 1);
    int said = 0;
    set_log_sink([&](LogLevel level, std::string_view) { said += level >= LogLevel::warning; });
    int status = 0;
    if (!list_devices(true).empty()) status = 1;
    if (open_device() || open_device()) status = 2;
    if (said != 1) status = 3;
    if (code_of("0") != Errc::bad_usage) status = 4;
    std::_Exit(status);
}

}  // namespace

TEST(NoDevice, EmptyVendorFolderGivesNoneAndSaysSoOnce) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const ScratchFolder folder;
    EXPECT_EXIT(open_where_no_driver_is(folder.path().string() + "/"), testing::ExitedWithCode(0), "");
}

TEST(NoDevice, DriverThatDoesNotLoadGivesNone) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const ScratchFolder folder;
    std::ofstream(folder.path() / "broken.icd") << "libno-such-driver.so\n";
    EXPECT_EXIT(open_where_no_driver_is(folder.path().string() + "/"), testing::ExitedWithCode(0), "");
}

TEST_F(DeviceTest, OpensTheDefaultAndKnowsIt) {
    const DeviceInfo& info = device_->info();
    EXPECT_TRUE(info.usable);
    EXPECT_EQ(info.fault, "");
    EXPECT_NE(info.name, "");
    EXPECT_NE(info.platform, "");
    EXPECT_GT(info.compute_units, 0);
    EXPECT_GT(info.max_allocation_bytes, 0u);
    EXPECT_LE(info.max_allocation_bytes, info.memory_bytes);
    if (info.is_cpu) {
        EXPECT_TRUE(device_->unified_memory());
    }
}

TEST_F(DeviceTest, OpensQuicklyOnceWarm) {
    const Stopwatch watch;
    open_device();
    EXPECT_LT(watch.ms(), 1000);
}

TEST_F(DeviceTest, ListsWithAndWithoutMeasuring) {
    const auto plain = list_devices(false), measured = list_devices(true);
    ASSERT_EQ(plain.size(), measured.size());
    ASSERT_FALSE(measured.empty());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        EXPECT_EQ(measured[i].index, int(i));
        EXPECT_EQ(plain[i].name, measured[i].name);
        EXPECT_EQ(measured[i].usable, measured[i].fault.empty());
        if (measured[i].usable) {
            EXPECT_GT(measured[i].rank_ms, 0);
        }
    }
}

TEST_F(DeviceTest, OpensByIndexAndByPartOfTheName) {
    const DeviceInfo info = device_->info();
    EXPECT_EQ(open_device(std::to_string(info.index))->info().name, info.name);
    std::string upper = info.name;
    for (char& c : upper) c = char(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(open_device(upper.substr(0, upper.size() - 1))->info().name, info.name);
}

TEST_F(DeviceTest, UnknownChoicesAreBadUsageAndListWhatThereIs) {
    std::string sentence;
    for (const char* choice : {"99", "no such device", "-1", "99999999999999999999999", "0x0", " "}) {
        if (std::string(choice) == " " && device_->info().name.find(' ') != std::string::npos) continue;
        EXPECT_EQ(code_of(choice, &sentence), Errc::bad_usage) << choice;
        EXPECT_NE(sentence.find(device_->info().name), std::string::npos) << sentence;
    }
}

TEST_F(DeviceTest, CancelledBeforeItStarts) {
    std::stop_source source;
    source.request_stop();
    const JobContext job{source.get_token()};
    EXPECT_THROW(list_devices(true, job), Error);
    ProgramLibrary library(device_);
    EXPECT_THROW(self_test_fault(*device_, library, job), Error);
    EXPECT_THROW(measure_rank_ms(*device_, library, job), Error);
}

TEST_F(DeviceTest, OpensFromSeveralThreadsAtOnce) {
    std::vector<std::jthread> threads;
    std::atomic<int> opened = 0;
    for (int i = 0; i < 4; ++i) threads.emplace_back([&] { opened += open_device() != nullptr; });
    threads.clear();
    EXPECT_EQ(opened, 4);
}

/// A self-test that cannot fail proves nothing: each row spoils the kernels in one way a bad driver might.
TEST_F(DeviceTest, SelfTestSeesWrongAnswers) {
    const std::string good = expand_kernel_source("compute/self_test.cl");
    ProgramLibrary library(device_);
    EXPECT_EQ(self_test_fault(*device_, library), "");
    const std::pair<const char*, const char*> spoils[] = {
        {"(upper - lower) * f.x", "(upper - lower) * 0.0f"},   // nearest along x
        {"row = dims.x", "row = dims.y"},                      // exchanged axes
        {"along_y.y - along_y.x) * f.z", "along_y.y) * f.z"},  // wrong weights
        {"values[i] = ", "if (i != 200) values[i] = "},        // the last ones not written
        {"values[i] = ", "values[i] = NAN + "},                // not a number
        {"= scratch[0]", "= scratch[1]"},                      // another lane's part
        {"scratch[lane] += scratch", "scratch[lane] = scratch"},
        {"__kernel void sum_groups", "__kernel void sum_group"},  // missing kernel
        {"float sample_ramp(", "float sample_ramp)("},            // does not compile
    };
    for (const auto& [from, to] : spoils) {
        std::string spoilt = good;
        const std::size_t at = spoilt.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        spoilt.replace(at, std::string(from).size(), to);
        EXPECT_NE(self_test_fault(*device_, library, {}, spoilt), "") << to;
    }
}

}  // namespace lacuna
