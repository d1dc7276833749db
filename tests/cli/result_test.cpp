// What the commands put out: the contract's keys, and numbers that agree with each other.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/region_columns.h"

namespace lacuna::test {

namespace {

using nlohmann::json;
using Result = ProgramTest;

void expect_keys(const json& object, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) EXPECT_TRUE(object.contains(key)) << key;
}

TEST_F(Result, InfoJsonHasTheKeysAndTheRightNumbers) {
    const Outcome outcome = lacuna({"info", "sample:head@32", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const json info = json::parse(outcome.out);
    expect_keys(info, {"dims", "spacing", "origin", "direction", "scalar", "range", "unit", "bytes", "sha256",
                       "warnings", "dicom"});
    const std::int64_t voxels =
        info["dims"][0].get<std::int64_t>() * info["dims"][1].get<std::int64_t>() * info["dims"][2].get<std::int64_t>();
    EXPECT_EQ(info["bytes"], voxels * 2);
    EXPECT_EQ(info["scalar"], "i16");
    EXPECT_EQ(info["unit"], "HU");
    EXPECT_EQ(info["sha256"].get<std::string>().size(), 64u);
    EXPECT_LT(info["range"][0], info["range"][1]);
    EXPECT_EQ(info["direction"], json::parse("[[1,0,0],[0,1,0],[0,0,1]]"));
}

TEST_F(Result, ResultsDoNotDependOnTheLocale) {
    Surroundings german;
    german.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}};
    const std::vector<std::string> words{"regions", "sample:spheres@32", "--threshold", "otsu,max",
                                         "--csv",   path("r.csv")};
    const Outcome plain = lacuna(words);
    const std::string table = bytes_of(path("r.csv"));
    EXPECT_EQ(lacuna(words, german).out, plain.out);
    EXPECT_EQ(bytes_of(path("r.csv")), table);
    EXPECT_EQ(lacuna({"render", "sample:head@16", "-o", path("a.png"), "--step", "0.5"}, german).status, 0);
}

TEST_F(Result, StatisticsHaveTheContractsKeys) {
    const Outcome outcome = lacuna({"render", "sample:head@32", "-o", path("a.png"), "--size", "48x32", "--mode", "iso",
                                    "--stats", path("s.json"), "--verify", "--azimuth", "30"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("verified: max error "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "") << "no progress where standard error is no terminal";
    const json stats = json::parse(bytes_of(path("s.json")));
    expect_keys(stats, {"device", "input", "view", "plan", "build", "frames", "ms", "error"});
    expect_keys(stats["input"], {"dims", "spacing", "type"});
    expect_keys(stats["plan"], {"mode", "structure", "step", "sampler", "ert", "sparse", "why"});
    expect_keys(stats["ms"], {"min", "median", "max"});
    expect_keys(stats["error"], {"reference", "max", "mean", "psnr", "ssim", "pixels_over_budget"});
    ASSERT_EQ(stats["frames"].size(), 1u);
    expect_keys(stats["frames"][0], {"azimuth", "ms", "rays", "samples", "skipped", "structure_reads"});
    EXPECT_EQ(stats["plan"]["mode"], "iso");
    EXPECT_EQ(stats["view"]["azimuth"], 30);
    EXPECT_GT(stats["frames"][0]["samples"], 0);
    EXPECT_GT(stats["frames"][0]["ms"], 0);
    EXPECT_GE(stats["error"]["max"], 0);
    EXPECT_LE(stats["error"]["mean"], stats["error"]["max"]);
}

TEST_F(Result, AFilesTechniqueHoldsWhereNoFlagSaysOtherwise) {
    const auto plan_with = [&](const std::string& technique, const std::vector<std::string>& more) {
        std::ofstream(path("own.json")) << R"({"version":2,"name":"own","unit_distance_mm":1,)"
                                        << R"("points":[{"value":0,"color":[1,1,1],"opacity":0},)"
                                        << R"({"value":100,"color":[1,0.5,0],"opacity":1}])" << technique << "}";
        std::vector<std::string> words{"render", "sample:head@24", "-o",      path("a.png"), "--size", "32x32",
                                       "--tf",   path("own.json"), "--stats", path("s.json")};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = lacuna(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return json::parse(bytes_of(path("s.json")))["plan"];
    };
    const std::string technique = R"(,"technique":{"mode":"mip","shading":"none","step":0.25})";
    json plan = plan_with(technique, {});
    EXPECT_EQ(plan["mode"], "mip");
    EXPECT_EQ(plan["step"], 0.25);
    plan = plan_with(technique, {"--mode", "ea", "--step", "1"});
    EXPECT_EQ(plan["mode"], "ea");
    EXPECT_EQ(plan["step"], 1);
    plan = plan_with(technique, {"--mode", "iso"});
    EXPECT_EQ(plan["mode"], "iso");
    EXPECT_EQ(plan["step"], 0.25);
    const std::string unshaded = bytes_of(path("a.png"));
    plan_with(technique, {"--mode", "iso", "--shading", "phong"});
    EXPECT_NE(bytes_of(path("a.png")), unshaded);
    plan = plan_with("", {});
    EXPECT_EQ(plan["mode"], "ea") << "the contract's defaults where the file states nothing";
    EXPECT_EQ(plan["step"], 0.5);
    std::ofstream(path("bad.json")) << R"({"name":"x","points":[{"value":0,"color":[1,1,1],"opacity":0}],)"
                                    << R"("technique":{"mode":"hologram"}})";
    expect_failure(lacuna({"render", "sample:head@24", "-o", path("b.png"), "--tf", path("bad.json")}), 1, "hologram");
}

TEST_F(Result, StatisticsWithoutVerifyHaveNoError) {
    ASSERT_EQ(
        lacuna({"render", "sample:head@24", "-o", path("a.png"), "--size", "16x16", "--stats", path("s.json")}).status,
        0);
    EXPECT_TRUE(json::parse(bytes_of(path("s.json")))["error"].is_null());
}

TEST_F(Result, EveryMethodSaysWhatItIs) {
    struct Words {
        std::vector<std::string> words;
        const char *key, *value, *built;
    };
    for (const Words& w :
         {Words{{"--mode", "iso", "--refine", "cubic"}, "refine", "cubic", nullptr},
          Words{{"--mode", "iso", "--gradient", "sobel,stored"}, "gradient", "sobel,stored", "gradients"},
          Words{{"--integration", "preintegrated"}, "integration", "preintegrated", "segments"},
          Words{{"--sampler", "adaptive", "--structure", "none"}, "sampler", "adaptive", "steady blocks"}}) {
        std::vector<std::string> words{"render", "sample:casting@32", "-o",           path("a.png"), "--size",
                                       "40x40",  "--stats",           path("s.json"), "--verify"};
        words.insert(words.end(), w.words.begin(), w.words.end());
        const Outcome outcome = lacuna(words);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const json stats = json::parse(bytes_of(path("s.json")));
        EXPECT_EQ(stats["plan"][w.key], w.value);
        if (w.built) {
            EXPECT_GT(stats["build"][w.built]["bytes"], 0) << w.built;
        }
        EXPECT_LT(stats["error"]["mean"], 2) << w.value;
    }
}

TEST_F(Result, SmoothingIsSaidAndSeen) {
    const auto picture = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"render", "sample:casting@32", "-o",          path("a.png"), "--size",
                                       "40x40",  "--stats",           path("s.json")};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(lacuna(words).status, 0);
        return bytes_of(path("a.png"));
    };
    const std::string plain = picture({});
    EXPECT_NE(picture({"--smooth", "1.5"}), plain);
    EXPECT_NE(bytes_of(path("s.json")).find("Gaussian of 1.5 mm"), std::string::npos);
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("soft.nrrd"), "--smooth", "1.5"}).status, 0);
    ASSERT_EQ(lacuna({"convert", "sample:casting@32", path("hard.nrrd")}).status, 0);
    EXPECT_NE(bytes_of(path("soft.nrrd")), bytes_of(path("hard.nrrd")));
    EXPECT_EQ(lacuna({"info", path("soft.nrrd")}).status, 0);
}

TEST_F(Result, EveryModeMakesAPictureOfItsOwn) {
    std::vector<std::string> pictures;
    for (const char* mode : {"iso", "ea", "mip", "lmip", "minip", "mean", "shear-warp"}) {
        const std::string target = path(std::string(mode) + ".png");
        const Outcome outcome = lacuna({"render", "sample:casting@32", "-o", target, "--size", "64x64", "--mode", mode,
                                        "--azimuth", "30", "--elevation", "20"});
        ASSERT_EQ(outcome.status, 0) << mode << ": " << outcome.err;
        const std::string bytes = bytes_of(target);
        EXPECT_TRUE(bytes.starts_with("\x89PNG")) << mode;
        for (const std::string& other : pictures) EXPECT_NE(bytes, other) << mode;
        pictures.push_back(bytes);
    }
}

TEST_F(Result, TurntableWritesNumberedFramesAllRound) {
    const Outcome outcome = lacuna({"render", "sample:head@24", "-o", path("turn.png"), "--size", "24x24",
                                    "--turntable", "4", "--stats", path("s.json"), "--azimuth", "10"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(files(),
              (std::vector<std::string>{"s.json", "turn-000.png", "turn-001.png", "turn-002.png", "turn-003.png"}));
    const json frames = json::parse(bytes_of(path("s.json")))["frames"];
    ASSERT_EQ(frames.size(), 4u);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(frames[std::size_t(i)]["azimuth"], 10 + 90 * i);
    EXPECT_NE(bytes_of(path("turn-000.png")), bytes_of(path("turn-001.png")));
}

TEST_F(Result, QuietPrintsNothing) {
    const Outcome outcome = lacuna({"render", "sample:head@16", "-o", path("a.png"), "--size", "16x16", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

/// What a binary STL encloses, by the divergence theorem; its length must fit its own count.
double enclosed_by_stl(const std::string& bytes) {
    std::uint32_t count = 0;
    EXPECT_GT(bytes.size(), 84u);
    std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(bytes.size(), 84u + 50u * count);
    double six = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        float t[12];
        std::memcpy(t, bytes.data() + 84 + 50 * std::size_t(i), sizeof t);
        const glm::dvec3 a(t[3], t[4], t[5]), b(t[6], t[7], t[8]), c(t[9], t[10], t[11]);
        six += glm::dot(a, glm::cross(b, c));
    }
    return six / 6;
}

TEST_F(Result, MeshesEncloseTheirRegionsVolume) {
    for (const bool exact : {false, true}) {
        std::vector<std::string> words{"regions", "sample:casting@96", "--threshold", "min,otsu",   "--inner",
                                       "--json",  path("r.json"),      "--mesh",      path("mesh"), "--min-voxels",
                                       "150"};
        if (exact) words.push_back("--exact-surfaces");
        ASSERT_EQ(lacuna(words).status, 0);
        const json table = json::parse(bytes_of(path("r.json")));
        ASSERT_GT(table["regions"].size(), 1u);
        for (const json& row : table["regions"]) {
            char name[40];
            std::snprintf(name, sizeof name, "mesh/region-%05d.stl", row["id"].get<int>());
            const double voxels = row["volume_mm3"].get<double>();
            EXPECT_NEAR(enclosed_by_stl(bytes_of(path(name))) / voxels, 1, exact ? 0.06 : 0.01)
                << "values move the surface within the voxels at it";
        }
    }
}

TEST_F(Result, SurfacesAreLeftOutWhereNotWanted) {
    ASSERT_EQ(
        lacuna({"regions", "sample:spheres@32", "--threshold", "otsu,max", "--no-surfaces", "--json", path("r.json")})
            .status,
        0);
    const json row = json::parse(bytes_of(path("r.json")))["regions"][0];
    for (const char* key : {"surface_mesh_mm2", "diameter_mm", "integral_volume_mm3", "surface_distance_mm", "gap_mm"})
        EXPECT_TRUE(row.at(key).is_null()) << key;
    EXPECT_GT(row["surface_crofton_mm2"].get<double>(), 0);
}

TEST_F(Result, RegionsTableFilesAgree) {
    const Outcome outcome =
        lacuna({"regions", "sample:spheres@48", "--threshold", "otsu,max", "--json", path("r.json"), "--csv",
                path("r.csv"), "--labels", path("l.nrrd"), "--mesh", path("mesh"), "--min-voxels", "20"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json table = json::parse(bytes_of(path("r.json")));
    const json& rows = table.is_array() ? table : table["regions"];
    ASSERT_GT(rows.size(), 1u);
    expect_keys(rows[0], k_contract_keys);
    expect_keys(rows[0], k_surface_keys);
    double fractions = 0;
    for (const json& row : rows) {
        fractions += row["fraction"].get<double>();
        EXPECT_GE(row["voxels"], 20);
        EXPECT_GE(row["shape_factor"].get<double>(), 36 * M_PI * (1 - 1e-9));
        EXPECT_GE(row["diameter_mm"].get<double>(), row["equivalent_diameter_mm"].get<double>());
        EXPECT_GT(row["gap_mm"].get<double>(), 0);
        EXPECT_NEAR(row["integral_volume_mm3"].get<double>() / row["volume_mm3"].get<double>(), 1, 0.2);
    }
    EXPECT_NEAR(fractions, 1, 1e-6);
    std::stringstream csv(bytes_of(path("r.csv")));
    std::size_t lines = 0;
    for (std::string line; std::getline(csv, line);) ++lines;
    EXPECT_EQ(lines, rows.size() + 1);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("mesh")), {}), std::ptrdiff_t(rows.size()));
    const json labels = json::parse(lacuna({"info", path("l.nrrd"), "--json"}).out);
    EXPECT_EQ(labels["range"][1], rows.size());
}

TEST_F(Result, InnerLeavesOutWhatTouchesTheBorder) {
    const std::vector<std::string> words{"regions", "sample:casting@64", "--threshold", "min,otsu",
                                         "--json",  path("r.json")};
    ASSERT_EQ(lacuna(words).status, 0);
    const auto touching = [&] {
        const json table = json::parse(bytes_of(path("r.json")));
        int count = 0;
        for (const json& row : table.is_array() ? table : table["regions"]) count += row["touches_border"].get<bool>();
        return count;
    };
    EXPECT_GT(touching(), 0);
    std::vector<std::string> inner = words;
    inner.push_back("--inner");
    ASSERT_EQ(lacuna(inner).status, 0);
    EXPECT_EQ(touching(), 0);
}

TEST_F(Result, InnerOfASingleSliceKeepsWhatLiesWithinIt) {
    // A plate with a hole in it, and a notch in its rim; air all round.
    const auto speck = [](int a, int b) {
        const bool plate = a > 2 && a < 21 && b > 2 && b < 21;
        return plate && !(std::abs(a - 12) < 3 && std::abs(b - 11) < 2) && !(a < 6 && std::abs(b - 12) < 2);
    };
    std::string voxels;
    for (int b = 0; b < 24; ++b)
        for (int a = 0; a < 24; ++a) voxels += speck(a, b) ? '\x64' : '\0';
    for (const char* size : {"24x24x1", "24x1x24", "1x24x24"}) {
        std::ofstream(path("slice.raw"), std::ios::binary) << voxels;
        const Outcome outcome = lacuna({"regions", path("slice.raw"), "--raw", std::string(size) + ":u8:0.5,0.5,0.5",
                                        "--threshold", "0,50", "--inner", "--json", path("r.json")});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const json table = json::parse(bytes_of(path("r.json")));
        ASSERT_EQ(table["regions"].size(), 1u) << size;
        EXPECT_EQ(table["regions"][0]["voxels"], 5 * 3) << size;
        EXPECT_GT(table["regions"][0]["surface_distance_mm"].get<double>(), 0) << size;
    }
}

TEST_F(Result, ConvertKeepsVoxelsAndGeometry) {
    const json before = json::parse(lacuna({"info", "sample:head@24", "--json"}).out);
    for (const char* name : {"a.nrrd", "a.mhd", "a.nii.gz", "a.raw"}) {
        ASSERT_EQ(lacuna({"convert", "sample:head@24", path(name)}).status, 0) << name;
        const Outcome outcome = lacuna({"info", path(name), "--json"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const json after = json::parse(outcome.out);
        EXPECT_EQ(after["sha256"], before["sha256"]) << name;
        EXPECT_EQ(after["dims"], before["dims"]) << name;
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(after["spacing"][i].get<double>(), before["spacing"][i].get<double>(), 1e-5) << name;
    }
}

TEST_F(Result, DevicesSayWhatWasChosenAndWhy) {
    const Outcome outcome = lacuna({"devices", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json list = json::parse(outcome.out);
    expect_keys(list, {"devices", "chosen", "why"});
    EXPECT_FALSE(list["why"].get<std::string>().empty());
    EXPECT_EQ(lacuna({"render", "--device", "list"}).status, 0);
}

TEST_F(Result, TransferFunctionsShownCanBeUsed) {
    const Outcome names = lacuna({"tf", "list"});
    ASSERT_EQ(names.status, 0);
    std::stringstream lines(names.out);
    int count = 0;
    for (std::string name; std::getline(lines, name); ++count) {
        const Outcome shown = lacuna({"tf", "show", name});
        EXPECT_EQ(shown.status, 0) << name << shown.err;
        EXPECT_GE(json::parse(shown.out)["points"].size(), 1u) << name;
    }
    EXPECT_EQ(count, 8);
    ASSERT_EQ(lacuna({"tf", "fit", "sample:head@24", "-o", path("tf.json")}).status, 0);
    EXPECT_EQ(
        lacuna({"render", "sample:head@24", "-o", path("a.png"), "--size", "16x16", "--tf", path("tf.json")}).status,
        0);
    EXPECT_EQ(lacuna({"render", "sample:head@24", "-o", path("b.png"), "--size", "16x16", "--mode", "mip", "--tf",
                      "preset:bone", "--range", "-200,1500:preset:skin"})
                  .status,
              0);
}

}  // namespace

}  // namespace lacuna::test
