#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::test {

/// What a run of the program came to.
struct Outcome {
    int status = -1;  ///< exit status; 1000 + N when signal N killed it
    std::string out, err;
    double seconds = 0;

    /// Number of lines on standard error.
    int error_lines() const;
};

/// How the program is started.
struct Surroundings {
    std::vector<std::pair<std::string, std::string>> environment;  ///< set on top of this process's
    long file_size_limit = 0;  ///< bytes any written file may have; what is over it fails as a full disk does
    int signal = 0;            ///< sent after signal_after_ms
    int signal_after_ms = 0;
    std::string standard_output = {};  ///< a file to send standard output to, instead of catching it
};

/// Starts `lacuna` with these words and waits for its end.
Outcome lacuna(const std::vector<std::string>& words, const Surroundings& surroundings = {});

/// A file's bytes; empty where there is none.
std::string bytes_of(const std::filesystem::path& file);

/// No OpenCL: its compiler ends the whole process where a file of its cache finds no room, before ours can say so.
/// @param folder  any without descriptions of OpenCL platforms
Surroundings without_opencl(const std::filesystem::path& folder);

/// A folder of its own for each test, gone afterwards.
class ProgramTest : public ::testing::Test {
protected:
    ProgramTest();
    ~ProgramTest() override;
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// Names of everything in the folder, sorted.
    std::vector<std::string> files() const;
    std::filesystem::path folder_;
};

/// True if a program of the system ran and found nothing to complain about; its words go to `said`.
bool runs(const std::string& command, std::string& said);

/// Asserts the exit status and that standard error is one line that starts with "lacuna: " and holds `part`.
void expect_failure(const Outcome& outcome, int status, const std::string& part);

/// Exit status 1, and "lacuna: Cannot write ..." as the last line.
void expect_no_room(const Outcome& outcome);

}  // namespace lacuna::test
