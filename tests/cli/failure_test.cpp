// What cannot be done: one line, status 1 (130 when interrupted), nothing half-written.

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/cli/program.h"

namespace lacuna::test {

namespace {

namespace fs = std::filesystem;
using Failure = ProgramTest;

void write_bytes(const std::string& file, std::size_t count) {
    std::ofstream(file, std::ios::binary) << std::string(count, '\7');
}

TEST_F(Failure, InputThatIsNotThere) {
    expect_failure(lacuna({"info", path("nothing.nrrd")}), 1, "nothing.nrrd");
    expect_failure(lacuna({"info", path("no-folder")}), 1, "no-folder");
    fs::create_directory(path("empty"));
    expect_failure(lacuna({"info", path("empty")}), 1, "empty");
}

TEST_F(Failure, RawFileOfAnotherSizeNamesBothByteCounts) {
    write_bytes(path("a.raw"), 1000);
    const Outcome outcome = lacuna({"info", path("a.raw"), "--raw", "10x10x11:u8"});
    expect_failure(outcome, 1, "1000");
    EXPECT_NE(outcome.err.find("1100"), std::string::npos) << outcome.err;
}

TEST_F(Failure, BrokenTransferFunctionFile) {
    std::ofstream(path("tf.json")) << "{\"points\": [";
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--tf", path("tf.json")}), 1, "tf.json");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--tf", path("none.json")}), 1,
                   "none.json");
    EXPECT_EQ(files(), std::vector<std::string>{"tf.json"});
}

TEST_F(Failure, TargetsThatCannotBeWrittenAreRefusedBeforeTheWork) {
    // A volume this large takes half a minute to make: the refusal must come before.
    const Outcome outcome = lacuna({"render", "sample:casting@1024", "-o", path("missing/a.png")});
    expect_failure(outcome, 1, "missing");
    EXPECT_LT(outcome.seconds, 10);
    fs::create_directory(path("folder.png"));
    expect_failure(lacuna({"render", "sample:casting@512", "-o", path("folder.png")}), 1, "folder.png");
    expect_failure(lacuna({"render", "sample:casting@512", "-o", path("a.png"), "--stats", path("missing/s.json")}), 1,
                   "missing");
    expect_failure(lacuna({"regions", "sample:casting@512", "--threshold", "0,1", "--csv", path("missing/r.csv")}), 1,
                   "missing");
    expect_failure(lacuna({"convert", "sample:head@16", path("missing/a.nrrd")}), 1, "missing");
    EXPECT_EQ(files(), std::vector<std::string>{"folder.png"});
}

TEST_F(Failure, UnknownVolumeEnding) {
    expect_failure(lacuna({"convert", "sample:head@16", path("a.xyz")}), 2, "a.xyz");
}

TEST_F(Failure, DiskFullLeavesNoHalfWrittenFile) {
    Surroundings full;
    full.file_size_limit = 2000;
    expect_failure(lacuna({"convert", "sample:marschner-lobb@40", path("a.nrrd")}, full), 1, "a.nrrd");
    expect_failure(lacuna({"convert", "sample:head@40", path("a.mhd")}, full), 1, "a.");
    full.file_size_limit = 100;
    expect_failure(lacuna({"tf", "fit", "sample:head@16", "-o", path("tf.json")}, full), 1, "tf.json");
    expect_failure(lacuna({"regions", "sample:spheres@32", "--threshold", "otsu,max", "--csv", path("r.csv")}, full), 1,
                   "r.csv");
    EXPECT_TRUE(files().empty()) << files().front();
}

TEST_F(Failure, AnonymisedImagesThatDoNotFitAreNoUnreadableOnes) {
    fs::create_directory(path("in"));
    ASSERT_EQ(lacuna({"convert", "sample:head@16", path("in/small")}).status, 0);
    ASSERT_EQ(lacuna({"convert", "sample:head@64", path("in/large")}).status, 0);
    Surroundings full;
    full.file_size_limit = 5000;  // room for the small ones
    expect_failure(lacuna({"convert", path("in"), path("out"), "--anonymise", "--quiet"}, full), 1, "disk is full");
    EXPECT_EQ(files(), std::vector<std::string>{"in"});
}

TEST_F(Failure, AnonymisedDeflatedImageThatDoesNotFit) {
    const char* data = std::getenv("LACUNA_TEST_DATA");
    if (!data) GTEST_SKIP() << "skipped: LACUNA_TEST_DATA is not set";
    const std::string image = std::string(data) + "/dicom_zoo/one_ct_image_in_many_syntaxes/ctimage_deflated.dcm";
    ASSERT_EQ(lacuna({"convert", image, path("whole"), "--anonymise"}).status, 0);
    Surroundings full;
    full.file_size_limit = 100000;
    expect_failure(lacuna({"convert", image, path("out"), "--anonymise"}, full), 1, "disk is full");
    EXPECT_EQ(files(), std::vector<std::string>{"whole"});
}

TEST_F(Failure, MeshesThatDoNotFitAreTakenBackWithTheirFolder) {
    Surroundings full;
    full.file_size_limit = 20000;
    expect_failure(
        lacuna({"regions", "sample:spheres@32", "--threshold", "otsu,max", "--mesh", path("deep/meshes")}, full), 1,
        "region-");
    EXPECT_TRUE(files().empty()) << files().front();
}

TEST_F(Failure, AHomeThatTakesNoFilesCostsNoDevice) {
    const std::string usual = lacuna({"devices"}).out;
    Surroundings homeless;
    homeless.environment = {{"HOME", "/dev/null"}, {"XDG_CACHE_HOME", "/dev/null/cache"}};
    const std::string out = lacuna({"devices"}, homeless).out;
    EXPECT_EQ(out.substr(0, out.find('\n')), usual.substr(0, usual.find('\n')));
}

TEST_F(Failure, WarningsFollowAResultAndNeverAFault) {
    const std::string raw = path("a_8x8x8_uint8.raw");
    std::ofstream(raw) << std::string(512, 'x');
    EXPECT_NE(lacuna({"regions", raw, "--threshold", "0,255"}).err.find("lacuna: warning: "), std::string::npos);
    EXPECT_EQ(lacuna({"regions", raw, "--threshold", "0,255", "--quiet"}).err, "");
    Surroundings full;
    full.file_size_limit = 100;
    expect_failure(lacuna({"convert", raw, path("o.nrrd")}, full), 1, "o.nrrd");
}

TEST_F(Failure, FullStandardOutputIsNotSuccess) {
    Surroundings full;
    full.standard_output = "/dev/full";
    expect_failure(lacuna({"info", "sample:head@16"}, full), 1, "standard output");
}

TEST_F(Failure, MemoryLimitNamesNeedAndLimit) {
    const Outcome outcome =
        lacuna({"render", "sample:casting@64", "-o", path("a.png"), "--size", "1024x1024", "--memory-limit", "2"});
    expect_failure(outcome, 1, "limit is 2 MB");
    expect_failure(lacuna({"info", "sample:casting@256", "--memory-limit", "20"}), 1, "limit is 20 MB");
    EXPECT_TRUE(files().empty());
}

class Interrupt : public ProgramTest, public ::testing::WithParamInterface<int> {};

TEST_P(Interrupt, GivesOneHundredAndThirtySoonAndLeavesNothing) {
    Surroundings pressed;
    pressed.signal = GetParam();
    pressed.signal_after_ms = 300;
    const Outcome outcome =
        lacuna({"render", "sample:casting@1024", "-o", path("a.png"), "--size", "2048x2048"}, pressed);
    expect_failure(outcome, 130, "interrupted");
    EXPECT_LT(outcome.seconds, 5);
    EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, ::testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace

}  // namespace lacuna::test
