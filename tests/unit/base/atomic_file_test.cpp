#include "core/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "core/base/atomic_folder.h"
#include "core/base/error.h"

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / ("lacuna-" + std::string(info->name()) + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::size_t files() const { return std::size_t(std::distance(fs::directory_iterator(folder_), {})); }

    fs::path folder_;
};

template <class Call>
Error error_of(Call&& call) {
    try {
        call();
    } catch (const Error& e) {
        return e;
    }
    ADD_FAILURE() << "no Error";
    return {Errc::device, ""};
}

TEST_F(AtomicFileTest, NothingLeftWithoutCommit) {
    {
        AtomicFile file(folder_ / "a.nii.gz");
        EXPECT_TRUE(file.path().string().ends_with("a.nii.gz"));
        std::ofstream(file.path()) << "half";
        EXPECT_EQ(files(), 1u);
    }
    EXPECT_EQ(files(), 0u);
}

/// Where the first process of a container writes to, as every one-program container's is; empty: none can be made here.
std::string path_in_a_container(const fs::path& target) {
    int ends[2];
    if (::pipe(ends) != 0) return {};
    if (const pid_t outer = ::fork(); outer == 0) {
        if (::unshare(CLONE_NEWPID) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0) ::_exit(1);
        if (const pid_t first = ::fork(); first == 0) {
            const std::string path = ::getpid() == 1 ? AtomicFile(target).path().string() : "";
            ::_exit(::write(ends[1], path.data(), path.size()) == ssize_t(path.size()) ? 0 : 1);
        } else {
            ::waitpid(first, nullptr, 0);
        }
        ::_exit(0);
    } else {
        ::close(ends[1]);
        ::waitpid(outer, nullptr, 0);
    }
    char path[4096];
    const ssize_t size = ::read(ends[0], path, sizeof path);
    ::close(ends[0]);
    return {path, std::size_t(std::max<ssize_t>(size, 0))};
}

TEST_F(AtomicFileTest, ProcessesOfOneNumberInTwoContainersDoNotWriteIntoOneFile) {
    const std::string one = path_in_a_container(folder_ / "series.json"),
                      other = path_in_a_container(folder_ / "series.json");
    if (one.empty() || other.empty()) GTEST_SKIP() << "no process may have numbers of its own here";
    EXPECT_NE(one, other);
}

TEST_F(AtomicFileTest, KeepsTheOldFileUntilCommit) {
    write_file(folder_ / "a.txt", "old");
    {
        AtomicFile file(folder_ / "a.txt");
        std::ofstream(file.path()) << "new";
    }
    EXPECT_EQ(read_file(folder_ / "a.txt"), "old");
    write_file(folder_ / "a.txt", "newer");
    EXPECT_EQ(read_file(folder_ / "a.txt"), "newer");
    EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, CommitOfNothingWrittenFails) {
    const Error e = error_of([&] {
        AtomicFile file(folder_ / "a.txt");
        file.commit();
    });
    EXPECT_EQ(e.code(), Errc::io);
    EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFileTest, TwoJobsDoNotFillTheSameFolder) {
    AtomicFolder first(folder_ / "out");
    std::ofstream(first.path() / "a.txt") << "kept";
    EXPECT_EQ(error_of([this] { AtomicFolder second(folder_ / "out"); }).code(), Errc::io);
    first.commit();
    EXPECT_EQ(read_file(folder_ / "out" / "a.txt"), "kept");
    fs::remove_all(folder_ / "out");
    AtomicFolder after(folder_ / "out");  // the first is through
    after.commit();
    EXPECT_TRUE(fs::is_directory(folder_ / "out"));
}

TEST_F(AtomicFileTest, AFolderOfItsKindIsReplacedUnlessItHoldsMore) {
    const std::vector<std::string> own{"mark.json", "table.csv"};
    const auto make = [&](const char* text) {
        AtomicFolder folder(folder_ / "out", own);
        std::ofstream(folder.path() / "mark.json") << text;
        folder.commit();
    };
    make("first");
    write_file(folder_ / "out" / "table.csv", "x");
    make("second");
    EXPECT_EQ(read_file(folder_ / "out" / "mark.json"), "second");
    EXPECT_FALSE(fs::exists(folder_ / "out" / "table.csv"));
    write_file(folder_ / "out" / "scan.nrrd", "somebody's own");
    const Error refused = error_of([&] { make("third"); });
    EXPECT_EQ(refused.code(), Errc::io);
    EXPECT_NE(std::string(refused.what()).find("scan.nrrd"), std::string::npos) << refused.what();
    fs::remove(folder_ / "out" / "scan.nrrd");
    const Error late = error_of([&] {
        AtomicFolder folder(folder_ / "out", own);
        std::ofstream(folder.path() / "mark.json") << "fourth";
        write_file(folder_ / "out" / "scan.nrrd", "put there meanwhile");
        folder.commit();
    });
    EXPECT_EQ(late.code(), Errc::io);
    EXPECT_EQ(read_file(folder_ / "out" / "mark.json"), "second");
    EXPECT_EQ(read_file(folder_ / "out" / "scan.nrrd"), "put there meanwhile");
    EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, MissingFolderIsNamed) {
    const Error e = error_of([&] { write_file(folder_ / "no" / "a.txt", "x"); });
    EXPECT_EQ(e.code(), Errc::io);
    EXPECT_NE(std::string(e.what()).find("does not exist"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("a.txt"), std::string::npos) << e.what();
}

TEST_F(AtomicFileTest, TargetThatIsAFolderIsRefused) {
    fs::create_directories(folder_ / "a.txt" / "inside");
    const Error e = error_of([&] { write_file(folder_ / "a.txt", "x"); });
    EXPECT_EQ(e.code(), Errc::io);
    EXPECT_EQ(files(), 1u);
}

// A limit on file size stands for a full disk: both make write() fail halfway.
TEST_F(AtomicFileTest, FullDiskLeavesTheOldFileAndNothingElse) {
    write_file(folder_ / "a.bin", "old");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 4096;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    Error e(Errc::device, "");
    try {
        write_file(folder_ / "a.bin", std::string(100'000, 'x'));
    } catch (const Error& fault) {
        e = fault;
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(e.code(), Errc::io);
    EXPECT_NE(std::string(e.what()).find("too large"), std::string::npos) << e.what();
    EXPECT_EQ(read_file(folder_ / "a.bin"), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, EmptyAndBinaryRoundTrip) {
    write_file(folder_ / "empty", "");
    EXPECT_EQ(read_file(folder_ / "empty"), "");
    const std::string bytes("\0\r\n\xff\x1a", 5);
    write_file(folder_ / "bytes", bytes);
    EXPECT_EQ(read_file(folder_ / "bytes"), bytes);
}

TEST_F(AtomicFileTest, ReadFaultsNameTheFile) {
    const Error missing = error_of([&] { read_file(folder_ / "none.json"); });
    EXPECT_EQ(missing.code(), Errc::io);
    EXPECT_NE(std::string(missing.what()).find("none.json"), std::string::npos);
    write_file(folder_ / "long", "12345");
    EXPECT_EQ(read_file(folder_ / "long", 5), "12345");
    const Error long_one = error_of([&] { read_file(folder_ / "long", 4); });
    EXPECT_EQ(long_one.code(), Errc::bad_input);
    EXPECT_NE(std::string(long_one.what()).find("5 bytes"), std::string::npos) << long_one.what();
    EXPECT_EQ(error_of([&] { read_file(folder_); }).code(), Errc::io);
}

}  // namespace
}  // namespace lacuna
