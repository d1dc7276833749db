// The words of a call: what is accepted, what is refused with status 2, and how.

#include "tests/cli/program.h"

namespace lacuna::test {

namespace {

using Usage = ProgramTest;

TEST_F(Usage, VersionNamesTheProgram) {
    const Outcome outcome = lacuna({"--version"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("lacuna 0.")) << outcome.out;
}

TEST_F(Usage, EveryCommandHasHelpWithAnExample) {
    const std::vector<std::vector<std::string>> commands{
        {},          {"info"}, {"render"},     {"regions"},    {"convert"},
        {"devices"}, {"tf"},   {"tf", "list"}, {"tf", "show"}, {"tf", "fit"}};
    for (std::vector<std::string> words : commands) {
        words.push_back("--help");
        const Outcome outcome = lacuna(words);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.out.find("Example: lacuna"), std::string::npos) << words.front();
        EXPECT_EQ(outcome.err, "");
    }
}

TEST_F(Usage, NoCommandUnknownCommandAndUnknownFlagGiveTwo) {
    expect_failure(lacuna({}), 2, "no command");
    expect_failure(lacuna({"transmogrify"}), 2, "transmogrify");
    expect_failure(lacuna({"info", "sample:head@16", "--colour", "red"}), 2, "--colour");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--verbose"}), 2, "--verbose");
    expect_failure(lacuna({"info"}), 2, "INPUT");
    expect_failure(lacuna({"render", "sample:head@16"}), 2, "-o");
    expect_failure(lacuna({"render", "-o", path("a.png")}), 2, "INPUT");
    expect_failure(lacuna({"regions", "sample:head@16"}), 2, "--threshold");
    expect_failure(lacuna({"tf"}), 2, "tf");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--iso"}), 2, "--iso");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--iso", "1", "--iso", "2"}), 2, "--iso");
    EXPECT_TRUE(files().empty());
}

TEST_F(Usage, NoResultTakesThePlaceOfWhatIsRead) {
    const std::string scan = path("scan.nrrd"), series = path("series"), tf = path("tf.json");
    ASSERT_EQ(lacuna({"convert", "sample:spheres@16", scan}).status, 0);
    ASSERT_EQ(lacuna({"convert", "sample:spheres@16", series}).status, 0);
    ASSERT_EQ(lacuna({"tf", "fit", scan, "-o", tf}).status, 0);
    const std::string slice = series + "/slice00003.dcm", was = bytes_of(scan), image = bytes_of(slice);
    for (const char* flag : {"--csv", "--json", "--labels"})
        expect_failure(lacuna({"regions", scan, "--threshold", "otsu,max", flag, path("./scan.nrrd")}), 2, "scan.nrrd");
    expect_failure(lacuna({"regions", series, "--threshold", "otsu,max", "--csv", slice}), 2, "slice00003.dcm");
    expect_failure(lacuna({"tf", "fit", scan, "-o", scan}), 2, "scan.nrrd");
    const std::vector<std::string> render{"render", scan, "-o", path("a.png"), "--size", "8x8", "--tf", tf, "--stats"};
    for (const std::string& target : {scan, slice}) {
        std::vector<std::string> words = render;
        words.push_back(target);
        expect_failure(lacuna(words), 2, target);
    }
    EXPECT_TRUE(bytes_of(scan) == was && bytes_of(slice) == image);
    EXPECT_EQ(files(), (std::vector<std::string>{"scan.nrrd", "series", "tf.json"}));
}

struct BadWord {
    const char *flag, *value;
};

class BadWords : public ProgramTest, public ::testing::WithParamInterface<BadWord> {};

TEST_P(BadWords, RenderRefusesNamingFlagAndValue) {
    const auto [flag, value] = GetParam();
    const Outcome outcome = lacuna({"render", "sample:head@16", "-o", path("a.png"), flag, value});
    expect_failure(outcome, 2, flag);
    EXPECT_NE(outcome.err.find(value), std::string::npos) << outcome.err;
    EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Render, BadWords,
    ::testing::Values(
        BadWord{"--iso", "12x"}, BadWord{"--iso", "nan"}, BadWord{"--iso", "1e999"}, BadWord{"--iso", "1,5"},
        BadWord{"--iso", "0x10"}, BadWord{"--azimuth", "inf"}, BadWord{"--zoom", "0"}, BadWord{"--zoom", "-1"},
        BadWord{"--perspective", "180"}, BadWord{"--perspective", "-5"}, BadWord{"--perspective", "1e-6"},
        BadWord{"--size", "512"}, BadWord{"--size", "0x5"}, BadWord{"--size", "20000x20"},
        BadWord{"--size", "64x64x64"}, BadWord{"--center", "1,2"}, BadWord{"--center", "1,2,three"},
        BadWord{"--range", "300,-200"}, BadWord{"--range", "1;2"}, BadWord{"--range", "1,2,3"},
        BadWord{"--cut", "1,0,0"}, BadWord{"--cut", "1,0,0,2:shut"}, BadWord{"--step", "0"}, BadWord{"--step", "-0.5"},
        BadWord{"--sampler", "cubic"}, BadWord{"--gradient", "scharr"}, BadWord{"--gradient", "sobel,central"},
        BadWord{"--gradient", "stored,"}, BadWord{"--integration", "guess"}, BadWord{"--smooth", "0"},
        BadWord{"--smooth", "-1"}, BadWord{"--smooth", "nan"}, BadWord{"--sparse", "0"}, BadWord{"--sparse", "-2"},
        BadWord{"--sparse", "1"}, BadWord{"--sparse", "2.5"}, BadWord{"--sparse", "4,-1"}, BadWord{"--cells", "0"},
        BadWord{"--homogeneity", "-0.1"}, BadWord{"--homogeneity", "0,181"}, BadWord{"--step", "nan"},
        BadWord{"--refine-steps", "-1"}, BadWord{"--refine", "magic"}, BadWord{"--refine-steps", "2.5"},
        BadWord{"--structure", "hedge"}, BadWord{"--directions", "7"}, BadWord{"--voxel-gradient", "prewitt"},
        BadWord{"--ert", "1"}, BadWord{"--ert", "-0.1"}, BadWord{"--turntable", "0"}, BadWord{"--mode", "xray"},
        BadWord{"--shading", "gouraud"}, BadWord{"--window", "5"}, BadWord{"--tf", "preset:rainbow"},
        BadWord{"--memory-limit", "lots"}, BadWord{"--leaping", "jump"}, BadWord{"--leap-values", "hedges"},
        BadWord{"--leap-values", "groups,2,0.5"}, BadWord{"--leap-quantise", "5,1"}, BadWord{"--leap-min-voxels", "0"},
        BadWord{"--regions", "some"}, BadWord{"--range-width", "1.5"}, BadWord{"--region-tf", "1"},
        BadWord{"--region-tf", "5:preset:rainbow"}));

class BadRegionWords : public ProgramTest, public ::testing::WithParamInterface<BadWord> {};

TEST_P(BadRegionWords, RegionsRefusesNamingFlagAndValue) {
    const auto [flag, value] = GetParam();
    std::vector<std::string> words{"regions", "sample:head@16", flag, value};
    if (std::string(flag) != "--threshold" && std::string(flag) != "--range-width")
        words.insert(words.end(), {"--threshold", "0,100"});
    const Outcome outcome = lacuna(words);
    expect_failure(outcome, 2, flag);
    EXPECT_NE(outcome.err.find(value), std::string::npos) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(Regions, BadRegionWords,
                         ::testing::Values(BadWord{"--threshold", "5,1"}, BadWord{"--threshold", "low,1"},
                                           BadWord{"--threshold", "nan,1"}, BadWord{"--range-width", "1.5"},
                                           BadWord{"--range-width", "-0.1"}, BadWord{"--connectivity", "8"},
                                           BadWord{"--min-voxels", "0"}, BadWord{"--mesh-format", "fbx"}));

TEST_F(Usage, FlagsThatDoNotGoTogether) {
    const std::string out = path("a.png");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--mode", "shear-warp", "--perspective", "30"}), 2,
                   "--perspective");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--mode", "shear-warp", "--verify"}), 2, "--verify");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--mode", "ea", "--structure", "visible"}), 2,
                   "visible");
    const auto refuse = [&](std::vector<std::string> words, const char* part) {
        words.insert(words.begin(), {"render", "sample:head@16", "-o", out});
        expect_failure(lacuna(words), 2, part);
    };
    refuse({"--mode", "iso", "--refine", "cubic", "--sampler", "nearest"}, "linear");
    refuse({"--mode", "mip", "--integration", "preintegrated"}, "ea");
    refuse({"--mode", "shear-warp", "--sampler", "adaptive"}, "nearest or linear");
    refuse({"--integration", "preintegrated", "--sampler", "adaptive"}, "linear");
    refuse({"--integration", "preintegrated", "--homogeneity", "0.1"}, "riemann");
    refuse({"--structure", "acd", "--homogeneity", "1.5"}, "opacities");
    refuse({"--structure", "leap", "--integration", "preintegrated"}, "macrocells");
    refuse({"--structure", "leap", "--homogeneity", "0.1", "--brick", "16"}, "bricks");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--mode", "shear-warp", "--regions", "hide"}), 2,
                   "--regions");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--range-width", "0.1"}), 2, "--regions");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--structure", "leap", "--homogeneity", "2"}), 2,
                   "share");
    expect_failure(lacuna({"render", "sample:marschner-lobb@16", "-o", out, "--structure", "leap"}), 2, "macrocells");
    expect_failure(lacuna({"render", "sample:head@16", "-o", out, "--structure", "leap", "--leaping", "published"}), 2,
                   "lossless");
    expect_failure(lacuna({"regions", "sample:head@16", "--threshold", "0,1", "--range-width", "0.1"}), 2,
                   "--threshold");
    expect_failure(lacuna({"regions", "sample:head@16", "--threshold", "0,1", "--mesh-format", "ply"}), 2, "--mesh");
    expect_failure(lacuna({"regions", "sample:head@16", "--threshold", "0,1", "--no-surfaces"}), 2, "--no-surfaces");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.jpg")}), 2, "a.jpg");
    EXPECT_TRUE(files().empty());
}

TEST_F(Usage, OneFileTakesOneResult) {
    const auto render = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"render", "sample:head@16", "-o", path("a.png")});
        return lacuna(words);
    };
    expect_failure(render({"--stats", path("a.png")}), 2, "a.png");
    expect_failure(render({"--verify-map", path("./a.png")}), 2, "a.png");
    expect_failure(render({"--verify-map", path("m.png"), "--stats", path("m.png")}), 2, "m.png");
    expect_failure(render({"--turntable", "3", "--stats", path("a-001.png")}), 2, "a-001.png");
    expect_failure(render({"--verify-map", path("m.jpg")}), 2, "m.jpg");
    expect_failure(lacuna({"bench", "sample:head@16", "--json", path("b.svg"), "--chart", path("b.svg")}), 2, "b.svg");
    expect_failure(lacuna({"regions", "sample:head@16", "--threshold", "0,1", "--json", path("r"), "--csv", path("r")}),
                   2, "/r");
    EXPECT_TRUE(files().empty());
}

TEST_F(Usage, SwitchesTakeNoValue) {
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--verify", "-5"}), 2, "-5");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--quick", "-0.5"}), 2, "-0.5");
    EXPECT_TRUE(files().empty());
}

TEST_F(Usage, LeapingIsToldToLeapAlone) {
    const auto render = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"render", "sample:head@16", "-o", path("a.png"), "--shading", "none"});
        return lacuna(words);
    };
    expect_failure(render({"--leaping", "published"}), 2, "--leaping goes with --structure leap");
    expect_failure(render({"--structure", "octree", "--leap-min-voxels", "9"}), 2, "--leap-min-voxels");
    expect_failure(render({"--error-budget", "1", "--leaping", "published"}), 2, "budget");
    expect_failure(render({"--plan", R"({"structure":"leap"})", "--leap-values", "kd-tree"}), 2, "--plan");
    EXPECT_TRUE(files().empty());
    EXPECT_EQ(render({"--structure", "leap", "--leaping", "published"}).status, 0);
}

TEST_F(Usage, WordsWithoutEffectAreNamed) {
    const auto render = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"render", "sample:head@16", "-o", path("a.png"), "--size", "16x16"});
        return lacuna(words);
    };
    const Outcome idle = render({"--mode", "mip", "--iso", "5", "--refine", "newton", "--cells", "4", "--ert", "0.1"});
    EXPECT_EQ(idle.status, 0);
    EXPECT_EQ(idle.err,
              "lacuna: without effect in mode mip by structure macrocells: --iso, --refine, --ert, --cells\n");
    EXPECT_EQ(render({"--mode", "mip", "--ert", "0", "--structure", "none", "--sampler", "linear"}).err, "");
    EXPECT_EQ(render({"--mode", "iso", "--iso", "5", "--refine", "newton", "--cells", "4"}).err, "");
    EXPECT_EQ(render({"--mode", "ea", "--homogeneity", "0.1", "--structure", "octree", "--ert", "0.1"}).err, "");
    EXPECT_NE(render({"--homogeneity", "0.1", "--structure", "macrocells"}).err.find("--homogeneity"),
              std::string::npos);
}

TEST_F(Usage, NegativeValuesAreValuesNotFlags) {
    const Outcome outcome =
        lacuna({"render", "sample:head@24", "-o",       path("a.png"), "--size",    "24x24", "--mode",
                "iso",    "--iso",          "-300",     "--range",     "-900,3000", "--cut", "-1,0,0,5",
                "--cut",  "-.5,0,0,9:open", "--window", "-100,400",    "--azimuth", "-30",   "--elevation",
                "-20.5",  "--roll",         "-1e1",     "--center",    "-1,-2,-3"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
    EXPECT_EQ(lacuna({"regions", "sample:head@24", "--threshold", "-200,100"}).status, 0);
}

TEST_F(Usage, UnknownSampleAndUnknownSeriesGiveTwo) {
    expect_failure(lacuna({"info", "sample:teapot"}), 2, "teapot");
    expect_failure(lacuna({"tf", "show", "rainbow"}), 2, "rainbow");
    expect_failure(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--device", "no such device"}), 2,
                   "no such device");
}

}  // namespace

}  // namespace lacuna::test
