// lacuna batch: a series is never lost, whatever happens to it.

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/cli/program.h"

namespace lacuna::test {

namespace {

namespace fs = std::filesystem;
using Batch = ProgramTest;

/// A block of 24^3 voxels with a few pores whose number and place follow from the part's number.
void write_part(const fs::path& stem, unsigned number) {
    constexpr int k_side = 24;
    std::mt19937 random(number + 1);
    const auto draw = [&random](int lo, int hi) { return lo + int(random() % unsigned(hi - lo + 1)); };
    std::string voxels(k_side * k_side * k_side, '\0');
    const auto at = [&voxels](int x, int y, int z) -> char& {
        return voxels[std::size_t((z * k_side + y) * k_side + x)];
    };
    for (int z = 3; z < k_side - 3; ++z)
        for (int y = 3; y < k_side - 3; ++y)
            for (int x = 3; x < k_side - 3; ++x) at(x, y, z) = char(static_cast<unsigned char>(draw(196, 204)));
    for (unsigned pore = 0; pore < 1 + number % 3; ++pore) {
        const int r = draw(1, 2), cx = draw(8, 15), cy = draw(8, 15), cz = draw(8, 15);
        for (int z = -r; z <= r; ++z)
            for (int y = -r; y <= r; ++y)
                for (int x = -r; x <= r; ++x) at(cx + x, cy + y, cz + z) = char(draw(8, 12));
    }
    std::ofstream(stem.string() + ".raw", std::ios::binary) << voxels;
    std::ofstream(stem.string() + ".mhd")
        << "ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\nElementType = MET_UCHAR\nElementSpacing = 0.2 0.2 0.2\n"
           "ElementDataFile = "
        << stem.filename().string() << ".raw\n";
}

class Series : public Batch {
protected:
    void SetUp() override {
        fs::create_directory(path("parts"));
        std::ofstream(path("c.json")) << R"({"limits": {"porosity_percent": 1, "defect_diameter_mm": 1.2}})";
    }
    /// `count` parts; three of them are corrupt, each in its own way.
    void make_parts(unsigned count, bool with_corrupt = true) {
        for (unsigned i = 0; i < count; ++i) {
            char name[16];
            std::snprintf(name, sizeof name, "part%02u", i);
            const fs::path stem = folder_ / "parts" / name;
            write_part(stem, i);
            if (!with_corrupt) continue;
            if (i == 5) fs::resize_file(stem.string() + ".raw", 5000);
            if (i == 11) fs::remove(stem.string() + ".raw");
            if (i == 18) std::ofstream(stem.string() + ".mhd") << "no header at all";
        }
    }
    std::vector<std::string> words(const std::string& to, std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"batch",    path("parts"), "--criteria", path("c.json"),
                                     "--report", path(to),      "--worst",    "0"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(Series, KilledFiveTimesAndResumedEndsWithTheSameSummary) {
    make_parts(40);
    const Outcome undisturbed = lacuna(words("whole", {"--jobs", "2"}));
    ASSERT_EQ(undisturbed.status, 3) << undisturbed.err;
    std::mt19937 random(20240613);
    int killed = 0;
    for (int tries = 0; killed < 5 && tries < 20; ++tries) {
        Surroundings kill;
        kill.signal = SIGKILL;
        kill.signal_after_ms = 30 + int(random() % unsigned(std::max(60.0, 150 * undisturbed.seconds)));
        const Outcome outcome = lacuna(words("torn", {"--jobs", "2", "--resume"}), kill);
        killed += outcome.status == 1000 + SIGKILL;
    }
    EXPECT_EQ(killed, 5);
    const Outcome last = lacuna(words("torn", {"--jobs", "1", "--resume"}));
    EXPECT_EQ(last.status, 3) << last.err;
    const std::string csv = bytes_of(folder_ / "whole/summary.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 41);
    EXPECT_EQ(bytes_of(folder_ / "torn/summary.csv"), csv);
    EXPECT_EQ(bytes_of(folder_ / "torn/summary.html"), bytes_of(folder_ / "whole/summary.html"));
    // Every part but the broken ones has its report, and nothing half-made stands beside them.
    int reports = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "torn")) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
        if (!fs::exists(entry.path() / "report.json")) continue;
        ++reports;
        EXPECT_EQ(bytes_of(entry.path() / "report.json"),
                  bytes_of(folder_ / "whole" / entry.path().filename() / "report.json"));
    }
    EXPECT_EQ(reports, 37);
    for (const char* broken : {"part05", "part11", "part18"})
        EXPECT_NE(csv.find(std::string(broken) + "," + broken + ".mhd,broken,"), std::string::npos) << broken;
}

TEST_F(Series, ShardsMergedAreTheWhole) {
    make_parts(7, false);
    ASSERT_NE(lacuna(words("whole", {"--reference", path("parts/part03.mhd")})).status, 1);
    const std::string reference = path("parts/part03.mhd");
    for (const char* shard : {"2/3", "1/3"})
        EXPECT_LT(lacuna(words("shards", {"--shard", shard, "--reference", reference})).status, 4);
    expect_failure(lacuna({"batch", "--merge", path("shards")}), 1, "part02");
    EXPECT_LT(lacuna(words("shards", {"--shard", "3/3", "--reference", reference})).status, 4);
    const Outcome merged = lacuna({"batch", "--merge", path("shards")});
    EXPECT_EQ(merged.error_lines(), 0) << merged.err;
    EXPECT_EQ(bytes_of(folder_ / "shards/summary.csv"), bytes_of(folder_ / "whole/summary.csv"));
    EXPECT_EQ(bytes_of(folder_ / "shards/summary.html"), bytes_of(folder_ / "whole/summary.html"));
    // The reference deviates from itself by nothing.
    const std::string csv = bytes_of(folder_ / "whole/summary.csv");
    EXPECT_NE(csv.find("porosity_percent_deviation"), std::string::npos);
}

TEST_F(Series, NamesInAnotherEncodingAreMergedAndReplayedWithTheirSpacing) {
    write_part(folder_ / "parts" / "geh\xe4use", 1);
    write_part(folder_ / "parts" / "deckel", 2);
    std::ofstream(path("parts/kaputt\xff.mhd")) << "no header at all";
    const std::vector<std::string> spaced{"--spacing", "0.1,0.2,0.5"};
    EXPECT_EQ(lacuna(words("whole", spaced)).error_lines(), 0);
    for (const char* shard : {"1/2", "2/2"})
        EXPECT_EQ(lacuna(words("r", {"--shard", shard, "--spacing", "0.1,0.2,0.5"})).error_lines(), 0);
    const Outcome merged = lacuna({"batch", "--merge", path("r")});
    EXPECT_EQ(merged.error_lines(), 0) << merged.err;
    EXPECT_EQ(bytes_of(folder_ / "r/summary.csv"), bytes_of(folder_ / "whole/summary.csv"));
    const auto report = nlohmann::json::parse(bytes_of(folder_ / "r/geh_use/report.json"));
    EXPECT_NE(report["replay"].get<std::string>().find(" --spacing 0.1,0.2,0.5"), std::string::npos);
    EXPECT_NE(report["replay"].get<std::string>().find(" --worst 0"), std::string::npos);
}

TEST_F(Series, APartThatStandsOutIsMarked) {
    make_parts(9, false);
    // One part with three times the pores of any other.
    std::string voxels = bytes_of(folder_ / "parts/part04.raw");
    for (int z = 6; z < 18; ++z)
        for (int y = 6; y < 18; ++y)
            for (int x = 6; x < 18; ++x) voxels[std::size_t((z * 24 + y) * 24 + x)] = 10;
    std::ofstream(path("parts/part04.raw"), std::ios::binary) << voxels;
    lacuna(words("r"));
    std::istringstream lines(bytes_of(folder_ / "r/summary.csv"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("part04,")) {
            EXPECT_NE(line.find("porosity_percent"), std::string::npos) << line;
        }
    EXPECT_NE(bytes_of(folder_ / "r/summary.html").find("<svg"), std::string::npos);
}

TEST_F(Series, WhatIsOffIsSaidBeforeTheFirstPart) {
    make_parts(2, false);
    std::ofstream(path("bad.json")) << R"({"limits": {"cuont": 1}})";
    expect_failure(lacuna({"batch", path("parts"), "--criteria", path("bad.json"), "--report", path("r")}), 1, "cuont");
    expect_failure(lacuna({"batch", path("nowhere"), "--criteria", path("c.json"), "--report", path("r")}), 1,
                   "nowhere");
    fs::create_directory(path("empty"));
    expect_failure(lacuna({"batch", path("empty"), "--criteria", path("c.json"), "--report", path("r")}), 1, "no part");
    expect_failure(lacuna(words("r", {"--shard", "3/2"})), 2, "--shard");
    expect_failure(lacuna(words("r", {"--jobs", "0"})), 2, "--jobs");
    expect_failure(lacuna({"batch", path("parts")}), 2, "--criteria");
    expect_failure(lacuna({"batch", "--merge", path("empty")}), 1, "no series");
    expect_failure(lacuna(words("r", {"--reference", path("golden")})), 1, "golden");
    EXPECT_FALSE(fs::exists(path("r")));
    EXPECT_EQ(lacuna(words("r")).error_lines(), 0);
    expect_failure(lacuna(words("r")), 1, "--resume");
    std::ofstream(path("c.json")) << R"({"limits": {"porosity_percent": 2}})";
    expect_failure(lacuna(words("r", {"--resume"})), 1, "another series");
}

TEST_F(Series, AReferenceThatCannotBeReadIsSaidBeforeTheParts) {
    make_parts(3, false);
    // Its header is sound: only reading the voxels tells.
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("golden.nrrd")}).status, 0);
    fs::resize_file(path("golden.nrrd"), 3000);
    expect_failure(lacuna(words("r", {"--reference", path("golden.nrrd")})), 1, "reference component");
    EXPECT_FALSE(fs::exists(path("r/part00"))) << "hours of work, and no summary";
    // Mended, the same series goes on.
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("golden.nrrd")}).status, 0);
    const Outcome outcome = lacuna(words("r", {"--reference", path("golden.nrrd"), "--resume"}));
    EXPECT_EQ(outcome.error_lines(), 0) << outcome.err;
    EXPECT_NE(bytes_of(folder_ / "r/summary.csv").find("porosity_percent_deviation"), std::string::npos);
}

TEST_F(Series, AMergeTakesNoBrokenReference) {
    make_parts(3, false);
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("golden.nrrd")}).status, 0);
    const auto shard = [&](const char* which) {
        return lacuna(words("s", {"--reference", path("golden.nrrd"), "--shard", which}));
    };
    for (const char* which : {"1/2", "2/2"}) EXPECT_EQ(shard(which).error_lines(), 0);
    // Its report was lost, and made again from a file that is damaged by now: the parts are done, it is not.
    fs::remove_all(path("s/reference"));
    fs::resize_file(path("golden.nrrd"), 3000);
    expect_failure(shard("1/2"), 1, "reference component");
    expect_failure(lacuna({"batch", "--merge", path("s")}), 1, "reference component");
    EXPECT_FALSE(fs::exists(path("s/summary.csv")));
}

TEST_F(Series, ASecondRunOnTheSameFolderIsRefusedWhileTheFirstOneLives) {
    make_parts(2, false);
    EXPECT_EQ(lacuna(words("r")).error_lines(), 0);
    fs::remove_all(path("r/part01"));
    const int held = ::open(path("r/journal/shard-1.lock").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(held, 0) << "a run holds it";
    ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0) << "and lets it go";
    expect_failure(lacuna(words("r", {"--resume"})), 1, "another run");
    EXPECT_FALSE(fs::exists(path("r/part01")));
    ::close(held);
    const Outcome again = lacuna(words("r", {"--resume"}));
    EXPECT_EQ(again.error_lines(), 0) << again.err;
    EXPECT_TRUE(fs::exists(path("r/part01/report.json")));
}

TEST_F(Series, PartsOfAllSizesAndTheSameNameStandSideBySideAndAnInterruptLosesNone) {
    make_parts(2, false);
    fs::create_directories(path("more/part00"));
    ASSERT_EQ(lacuna({"convert", "sample:casting@40", path("more/part00.nrrd")}).status, 0);
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("more/part01.nrrd")}).status, 0);
    fs::resize_file(path("more/part01.nrrd"), 3000);
    std::ofstream(path("list.txt")) << "parts/part00.mhd\nmore/part01.nrrd\nmore/part00.nrrd\nparts/part00.mhd\n"
                                       "more/part00\nparts/part01.mhd\nnowhere.nrrd\n";
    const auto run = [&](const std::string& to, const Surroundings& how, bool resume) {
        std::vector<std::string> call{"batch",    path("list.txt"), "--criteria", path("c.json"),
                                      "--report", path(to),         "--worst",    "0"};
        if (resume) call.emplace_back("--resume");
        return lacuna(call, how);
    };
    const Outcome whole = run("whole", {}, false);
    EXPECT_EQ(whole.status, 3) << whole.err;
    Surroundings interrupt;
    interrupt.signal = SIGINT;
    interrupt.signal_after_ms = std::max(50, int(400 * whole.seconds));
    const Outcome stopped = run("r", interrupt, false);
    EXPECT_TRUE(stopped.status == 130 || stopped.status == 3) << stopped.status << stopped.err;
    EXPECT_EQ(run("r", {}, true).status, 3);
    const std::string csv = bytes_of(folder_ / "whole/summary.csv");
    EXPECT_EQ(bytes_of(folder_ / "r/summary.csv"), csv);
    EXPECT_EQ(bytes_of(folder_ / "r/summary.html"), bytes_of(folder_ / "whole/summary.html"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 8);
    for (const char* row :
         {"part00,part00.mhd,", "part01,part01.nrrd,broken,", "part00-2,part00.nrrd,", "part00-3,part00.mhd,",
          "part00-4,part00,broken,", "part01-2,part01.mhd,", "nowhere,nowhere.nrrd,broken,"})
        EXPECT_NE(csv.find(row), std::string::npos) << row << "\n" << csv;
}

TEST_F(Series, MemoryTooSmallForAPartIsItsRow) {
    make_parts(2, false);
    const Outcome outcome = lacuna(words("r", {"--memory-limit", "10"}));
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(bytes_of(folder_ / "r/summary.csv").find("the limit is 10 MB"), std::string::npos);
}

TEST_F(Series, AListNamesPartsAndAFullDiskStopsTheSeriesWhole) {
    make_parts(3, false);
    std::ofstream(path("list.txt"))
        << "# two parts and a sample\nparts/part00.mhd\n\nparts/part02.mhd\r\nsample:casting@32\n";
    const std::vector<std::string> listed{"batch",   path("list.txt"), "--criteria", path("c.json"), "--report",
                                          path("r"), "--worst",        "0",          "--resume"};
    Surroundings full = without_opencl(folder_);
    full.file_size_limit = 9000;
    expect_no_room(lacuna(listed, full));
    const Outcome outcome = lacuna(listed);
    EXPECT_EQ(outcome.error_lines(), 0) << outcome.err;
    const std::string csv = bytes_of(folder_ / "r/summary.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
    EXPECT_TRUE(fs::exists(path("r/part02/report.html")));
}

}  // namespace

}  // namespace lacuna::test
