// A volume larger than the limit is drawn from disk, the limit is kept, and the picture is the same.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"

namespace lacuna::test {

namespace {

using nlohmann::json;
using Memory = ProgramTest;

/// Peak resident bytes of a run, as the system counted them.
std::int64_t peak_bytes(const std::vector<std::string>& words, int& status) {
    std::vector<char*> argv{const_cast<char*>(LACUNA_PROGRAM)};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int code = 0;
    rusage used{};
    ::wait4(child, &code, 0, &used);
    status = WIFEXITED(code) ? WEXITSTATUS(code) : -1;
    return std::int64_t(used.ru_maxrss) * 1024;
}

TEST_F(Memory, AVolumeBeyondTheLimitIsDrawnInBricksAndTheSame) {
    ASSERT_EQ(lacuna({"convert", "sample:casting@150x140x130", path("c.mhd")}).status, 0);
    for (const std::string mode : {"ea", "iso", "mip"}) {
        const std::vector<std::string> words{"render", path("c.mhd"), "--mode", mode, "--size", "128x96", "-o"};
        std::vector<std::string> whole = words, parts = words;
        whole.push_back(path("whole.png"));
        for (const std::string& word : {path("parts.png"), std::string("--memory-limit"), std::string("10"),
                                        std::string("--stats"), path("s.json")})
            parts.push_back(word);
        ASSERT_EQ(lacuna(whole).status, 0);
        const Outcome outcome = lacuna(parts);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(bytes_of(path("parts.png")), bytes_of(path("whole.png"))) << mode;
        const json stats = json::parse(bytes_of(path("s.json")));
        if (stats["device"] == "reference renderer (no OpenCL device)") GTEST_SKIP() << "no OpenCL device";
        EXPECT_GT(stats["plan"]["brick"], 0);
        EXPECT_NE(stats["plan"]["why"].dump().find("streamed from disk"), std::string::npos);
        EXPECT_GT(stats["bricks"]["total"], 1);
        EXPECT_LE(stats["bricks"]["bytes_peak"], 10 << 20);
    }
}

TEST_F(Memory, TheLimitIsKept) {
    // 272 MB of voxels; what the program and the OpenCL driver's compiler take on their own is the stated 256 MB.
    ASSERT_EQ(lacuna({"convert", "sample:spheres@700x700x555", path("large.raw")}).status, 0);
    ASSERT_EQ(std::filesystem::file_size(path("large.raw")), std::uintmax_t(700) * 700 * 555);
    int status = -1;
    const std::int64_t peak = peak_bytes(
        {"render", path("large.raw"), "-o", path("a.png"), "--memory-limit", "100", "--quiet", "--mode", "mip"},
        status);
    ASSERT_EQ(status, 0);
    EXPECT_LE(peak, std::int64_t(100 + 256) << 20);
    RecordProperty("peak_mb", std::to_string(peak >> 20));
}

TEST_F(Memory, WhatCannotBeReadInPartsSaysSo) {
    ASSERT_EQ(lacuna({"convert", "sample:head@96", path("packed.nrrd")}).status, 0);
    expect_failure(lacuna({"render", path("packed.nrrd"), "-o", path("a.png"), "--memory-limit", "1"}), 1,
                   "lacuna convert");
    ASSERT_EQ(lacuna({"convert", "sample:head@96", path("plain.mhd")}).status, 0);
    expect_failure(lacuna({"render", path("plain.mhd"), "-o", path("a.png"), "--memory-limit", "1"}), 1,
                   "raise --memory-limit");
    const std::vector<std::string> base{"render", path("plain.mhd"), "-o",   path("a.png"), "--memory-limit",
                                        "3",      "--size",          "32x32"};
    auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = base;
        words.insert(words.end(), more.begin(), more.end());
        return lacuna(words);
    };
    expect_failure(with({"--verify"}), 1, "--verify needs the whole volume in memory");
    expect_failure(with({"--mode", "shear-warp"}), 1, "Shear-warp needs the whole volume in memory");
    expect_failure(with({"--mode", "iso", "--effects", "ao"}), 1, "'ao' needs the whole volume in memory");
    expect_failure(lacuna({"convert", path("plain.mhd"), path("b.nii.gz"), "--memory-limit", "1"}), 1,
                   "raise --memory-limit");
    EXPECT_FALSE(std::filesystem::exists(path("b.nii.gz")));
}

TEST_F(Memory, BricksCanBeAskedFor) {
    ASSERT_EQ(lacuna({"render", "sample:vessels@48", "-o", path("a.png"), "--size", "64x64"}).status, 0);
    ASSERT_EQ(lacuna({"render", "sample:vessels@48", "-o", path("b.png"), "--size", "64x64", "--brick", "16"}).status,
              0);
    EXPECT_EQ(bytes_of(path("a.png")), bytes_of(path("b.png")));
    expect_failure(lacuna({"render", "sample:vessels@48", "-o", path("b.png"), "--brick", "4"}), 2, "--brick");
}

}  // namespace
}  // namespace lacuna::test
