// What a series is made of.

#include "core/inspect/batch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/chart/svg_text.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

class Parts : public testing::Test {
protected:
    Parts() : folder_(fs::temp_directory_path() / ("lacuna-parts-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "series");
    }
    ~Parts() override { fs::remove_all(folder_); }

    void touch(const std::string& name) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << "x";
    }
    std::vector<std::string> names(const std::string& input, const std::string& reports = {}) const {
        std::vector<std::string> all;
        for (const BatchPart& part :
             find_parts({(folder_ / input).string()}, reports.empty() ? fs::path() : folder_ / reports))
            all.push_back(part.name);
        return all;
    }
    fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(Parts, ReportsWithinTheSeriesAreNoneBeforeAndAfterTheyAreMade) {
    fs::create_directories(folder_ / "series/a");
    fs::create_directories(folder_ / "series/b");
    const Names expected{"a", "b"};
    EXPECT_EQ(names("series", "series/reports/1"), expected);
    touch("series/reports/1/series.json");
    touch("series/reports/2/series.json");
    EXPECT_EQ(names("series", "series/reports/1"), expected);
    EXPECT_EQ(names("series", "series/reports/3"), expected);
    // What holds anything else is a part, wherever its reports go.
    touch("series/b/slice.dcm");
    touch("series/b/reports/series.json");
    EXPECT_EQ(names("series", "series/b/reports"), (Names{"a", "b", "reports"}));
}

TEST_F(Parts, EveryVolumeFileIsOneButOfTheHeadersOfOneStemTheFirst) {
    for (const char* name : {"p.nrrd", "p.nii.gz", "p.mha", "q.dat", "q.mhd", "q.raw", "r.vgi", "r.vol", "p.txt"})
        touch(std::string("series/") + name);
    std::vector<BatchPart> parts = find_parts({(folder_ / "series").string()});
    Names files, unique;
    for (const BatchPart& part : parts) {
        files.push_back(fs::path(part.input).filename().string());
        unique.push_back(part.name);
    }
    EXPECT_EQ(files, (Names{"p.mha", "p.nii.gz", "p.nrrd", "q.mhd", "r.vgi"}));
    EXPECT_EQ(unique, (Names{"p", "p-2", "p-3", "q", "r"}));
}

TEST_F(Parts, AListMayBeginWithAByteOrderMark) {
    std::ofstream(folder_ / "list.txt") << "\xef\xbb\xbfsample:casting@32\r\n# none\r\nb.mhd\r\n";
    const std::vector<BatchPart> parts = find_parts({(folder_ / "list.txt").string()});
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].input, "sample:casting@32");
}

TEST_F(Parts, AFileThatIsNoTextIsNoList) {
    const std::string file = (folder_ / "scan.dcm").string();
    std::ofstream(file, std::ios::binary) << std::string(128, '\0') << "DICM and\nmore\n";
    try {
        find_parts({file});
        FAIL() << "its bytes were taken for the names of parts";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_input);
        EXPECT_NE(std::string(error.what()).find("no list"), std::string::npos) << error.what();
    }
}

TEST_F(Parts, NamesAreUtf8AndLeaveRoomForWhatIsWrittenBesideThem) {
    std::string umlauts;
    for (int i = 0; i < 120; ++i) umlauts += "\xc3\xa4";
    for (const std::string& name : {std::string("geh\xe4use"), umlauts + "1", umlauts + "2"})
        fs::create_directories(folder_ / "series" / name);
    const Names found = names("series");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0], "geh_use");
    EXPECT_NE(found[1], found[2]);
    for (const std::string& name : found) {
        EXPECT_EQ(valid_utf8(name), name);
        EXPECT_LT(name.size(), 200u);
    }
}

TEST(OpenFlags, SayHowAnInputWasOpened) {
    EXPECT_EQ(open_flags({}), "");
    OpenOptions options;
    options.raw = "4x4x4:u8";
    options.spacing_mm = glm::dvec3(0.1, 0.1, 0.5);
    options.keep_gaps = true;
    EXPECT_EQ(open_flags(options), " --raw 4x4x4:u8 --spacing 0.1,0.1,0.5 --keep-gaps");
}

}  // namespace

}  // namespace lacuna
