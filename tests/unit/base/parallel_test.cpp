#include "core/base/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <numeric>
#include <set>
#include <vector>

namespace lacuna {
namespace {

class Parallel : public testing::TestWithParam<int> {
protected:
    void SetUp() override { set_thread_count(GetParam()); }
    void TearDown() override { set_thread_count(0); }
};

TEST_P(Parallel, EmptyAndReversedRangesDoNothing) {
    const auto fail = [](std::int64_t) { FAIL() << "called"; };
    parallel_for(3, 3, fail);
    parallel_for(5, -5, fail);
    parallel_bands(4, 2, 3, [](std::int64_t, std::int64_t) { FAIL() << "called"; });
}

TEST_P(Parallel, EachIndexOnce) {
    std::vector<std::atomic<int>> calls(1001);
    parallel_for(-500, 501, [&](std::int64_t i) { ++calls[std::size_t(i + 500)]; });
    for (const auto& c : calls) ASSERT_EQ(c.load(), 1);
}

TEST_P(Parallel, BandsPartitionTheRange) {
    for (const int bands : {-1, 0, 1, 3, 7, 100}) {
        std::vector<std::atomic<int>> calls(17);
        parallel_bands(0, 17, bands, [&](std::int64_t first, std::int64_t last) {
            ASSERT_LT(first, last);
            for (std::int64_t i = first; i < last; ++i) ++calls[std::size_t(i)];
        });
        for (const auto& c : calls) ASSERT_EQ(c.load(), 1) << bands << " bands";
    }
}

TEST_P(Parallel, FirstExceptionStopsAndLeaves) {
    std::atomic<int> calls{0};
    try {
        parallel_for(0, 1'000'000, [&](std::int64_t i) {
            ++calls;
            if (i == 10) throw Error(Errc::io, "The disk is gone.");
        });
        FAIL() << "no exception";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::io);
        EXPECT_STREQ(e.what(), "The disk is gone.");
    }
    EXPECT_LT(calls.load(), 1'000'000);
}

TEST_P(Parallel, StopBecomesCancelled) {
    std::stop_source stop;
    JobContext job{stop.get_token(), nullptr};
    std::atomic<int> calls{0};
    try {
        parallel_for(
            0, 1'000'000,
            [&](std::int64_t) {
                if (++calls == 5) stop.request_stop();
            },
            job);
        FAIL() << "no exception";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::cancelled);
    }
    EXPECT_LT(calls.load(), 5 + GetParam() + 1);
}

TEST_P(Parallel, AlreadyStoppedCallsNothing) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(parallel_for(0, 5, [](std::int64_t) { FAIL() << "called"; }, {stop.get_token(), nullptr}), Error);
}

TEST_P(Parallel, ProgressNeverDecreasesAndEndsAtOne) {
    std::vector<double> seen;
    JobContext job{{}, [&](double f) { seen.push_back(f); }};
    parallel_for(
        0, 257, [](std::int64_t) {}, job);
    ASSERT_EQ(seen.size(), 257u);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_GT(seen.front(), 0);
    EXPECT_DOUBLE_EQ(seen.back(), 1);
}

TEST_P(Parallel, ThrowingProgressIsRethrown) {
    JobContext job{{}, [](double) { throw Error(Errc::device, "The sink is broken."); }};
    EXPECT_THROW(parallel_for(
                     0, 9, [](std::int64_t) {}, job),
                 Error);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 7));

TEST(JobContextTest, EmptyContextNeverStops) {
    const JobContext job;
    EXPECT_FALSE(job.stopped());
    EXPECT_NO_THROW(job.check());
    EXPECT_NO_THROW(job.checkpoint(0, 0));
    EXPECT_FALSE(job.part(0.2, 0.4).progress);
}

TEST(JobContextTest, PartsMapTheirShareAndNest) {
    double last = -1;
    const JobContext job{{}, [&](double f) { last = f; }};
    job.part(0.5, 1.0).part(0.0, 0.5).checkpoint(1, 2);
    EXPECT_DOUBLE_EQ(last, 0.625);
    job.part(0.5, 1.0).checkpoint(4, 4);
    EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(JobContextTest, PartsShareTheStop) {
    std::stop_source stop;
    const JobContext job{stop.get_token(), nullptr};
    const JobContext step = job.part(0, 1);
    stop.request_stop();
    EXPECT_THROW(step.check(), Error);
    EXPECT_THROW(step.checkpoint(1, 2), Error);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which take terabytes of address space themselves
/// In a process that can have no more threads: whether a loop that asks for 63 still does everything.
[[noreturn]] void loop_without_threads() {
    set_thread_count(64);
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * rlim_t(::sysconf(_SC_PAGESIZE)) + (1 << 20);  // no room for another stack
    const rlimit limit{most, most};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(2);
    std::atomic<int> calls = 0;
    parallel_for(0, 100, [&](std::int64_t) { ++calls; });
    std::_Exit(calls == 100 ? 0 : 1);
}

TEST(ParallelDeathTest, WithoutThreadsToGetTheCallersOwnDoesAll) {
    EXPECT_EXIT(loop_without_threads(), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace lacuna
