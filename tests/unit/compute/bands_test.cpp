#include "core/compute/bands.h"

#include <thread>

#include "compute_fixture.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/compute/buffers.h"
#include "core/compute/program.h"

namespace lacuna {

namespace {

/// Each row costs `work` rounds and is marked with its number plus one.
constexpr const char* k_mark_rows =
    "__kernel void mark_rows(__global float* rows, int first, int work) {\n"
    "    const int row = first + get_global_id(0);\n"
    "    float x = row + 1.0f;\n"
    "    for (int i = 0; i < work; ++i) x = fma(x, 0.999f, 0.001f * (row + 1.0f));\n"
    "    rows[row] += work > 0 ? row + 1.0f + 0.0f * x : row + 1.0f;\n"
    "}\n";

class BandsTest : public ComputeTest {
protected:
    std::vector<float> mark(int rows, int granule, int work, const JobContext& job = {}) {
        ProgramLibrary library(device_);
        cl::Kernel kernel = library.kernel_of_text("mark_rows", k_mark_rows, "mark_rows", "");
        std::vector<float> marks(std::size_t(rows), 0.0f);
        const cl::Buffer buffer(device_->context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, rows * sizeof(float),
                                marks.data());
        kernel.setArg(0, buffer);
        kernel.setArg(2, work);
        run_in_bands(
            *device_, rows, granule,
            [&](int first, int count, cl::Event& done) {
                bands_.emplace_back(first, count);
                kernel.setArg(1, first);
                device_->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count), cl::NDRange(1),
                                                      nullptr, &done);
            },
            job);
        read_values(*device_, buffer, std::span<float>(marks));
        return marks;
    }
    std::vector<std::pair<int, int>> bands_;
};

}  // namespace

TEST_F(BandsTest, EveryRowRunsOnce) {
    for (const auto& [rows, granule] : {std::pair{1, 1}, {1, 16}, {17, 16}, {64, 16}, {333, 7}, {5, 0}}) {
        bands_.clear();
        const std::vector<float> marks = mark(rows, granule, 0);
        for (int row = 0; row < rows; ++row) ASSERT_EQ(marks[row], row + 1) << rows << " rows by " << granule;
        int next = 0;
        for (const auto& [first, count] : bands_) {
            EXPECT_EQ(first, next);
            next += count;
            if (next < rows) {
                EXPECT_EQ(count % std::max(granule, 1), 0);
            }
        }
        EXPECT_EQ(next, rows);
    }
}

TEST_F(BandsTest, NoRowsAreNoLaunch) {
    run_in_bands(*device_, 0, 16, [](int, int, cl::Event&) { FAIL(); });
    run_in_bands(*device_, -3, 16, [](int, int, cl::Event&) { FAIL(); });
}

TEST_F(BandsTest, BandsGrowWhereRowsAreQuick) {
    mark(4096, 1, 0);
    EXPECT_LT(bands_.size(), 1000u);
}

TEST_F(BandsTest, ProgressRisesToOne) {
    double last = 0;
    JobContext job;
    job.progress = [&](double f) {
        EXPECT_GE(f, last);
        last = f;
    };
    mark(100, 16, 0, job);
    EXPECT_EQ(last, 1);
}

TEST_F(BandsTest, AStopEndsTheWorkEarly) {
    std::stop_source source;
    const JobContext job{source.get_token()};
    std::jthread stopper;
    mark(16, 16, 1);  // compiled before the clock runs
    double stopped_after_ms = -1;
    Stopwatch watch;
    stopper = std::jthread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        watch.restart();
        source.request_stop();
    });
    try {
        mark(200000, 16, 200000, job);  // minutes of work
        FAIL() << "ran to its end";
    } catch (const Error& failure) {
        EXPECT_EQ(failure.code(), Errc::cancelled);
        stopped_after_ms = watch.ms();
    }
    EXPECT_LT(stopped_after_ms, 500) << "30 ms where the machine is not busy with other work";
    source = {};
    EXPECT_EQ(mark(16, 16, 0)[15], 16) << "the queue is usable afterwards";
}

TEST_F(BandsTest, StoppedBeforeItStarts) {
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(mark(16, 16, 0, JobContext{source.get_token()}), Error);
    EXPECT_TRUE(bands_.empty());
}

TEST_F(BandsTest, WhatALaunchThrowsIsTranslated) {
    const auto code = [&](auto thrown) {
        try {
            run_in_bands(*device_, 4, 1, [&](int, int, cl::Event&) { throw thrown; });
        } catch (const Error& failure) {
            return failure.code();
        }
        return Errc::io;
    };
    EXPECT_EQ(code(cl::Error(CL_INVALID_KERNEL_ARGS, "clEnqueueNDRangeKernel")), Errc::device);
    EXPECT_EQ(code(cl::Error(CL_MEM_OBJECT_ALLOCATION_FAILURE, "clEnqueueNDRangeKernel")), Errc::out_of_memory);
    EXPECT_EQ(code(Error(Errc::bad_input, "off")), Errc::bad_input);
}

}  // namespace lacuna
