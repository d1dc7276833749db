#include "core/base/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "core/base/error.h"

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class Locks : public testing::Test {
protected:
    Locks() : file_(fs::temp_directory_path() / ("lacuna-lock-" + std::to_string(::getpid()))) {}
    ~Locks() override { fs::remove(file_); }
    bool is_free() const {
        try {
            const FileLock lock(file_, "busy");
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()), "busy");
            EXPECT_EQ(error.code(), Errc::io);
            return false;
        }
    }
    fs::path file_;
};

TEST_F(Locks, KeepOthersOutWhileTheyLive) {
    std::optional<FileLock> lock;
    lock.emplace(file_, "busy");
    EXPECT_FALSE(is_free());
    lock.reset();
    EXPECT_TRUE(is_free());
    EXPECT_TRUE(is_free()) << "the file that stays locks nothing";
}

TEST_F(Locks, EndWithTheProcessThatHeldThem) {
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const FileLock lock(file_, "busy");
        if (::write(told[1], "x", 1) == 1) ::pause();
        ::_exit(1);
    }
    char word;
    ASSERT_EQ(::read(told[0], &word, 1), 1);
    EXPECT_FALSE(is_free());
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(is_free());
}

TEST_F(Locks, SayWhereTheirFileCannotBeMade) { EXPECT_THROW(FileLock("/nowhere/at/all/lock", "busy"), Error); }

}  // namespace
}  // namespace lacuna
