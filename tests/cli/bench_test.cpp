// lacuna bench: its files, its scenes, and plans drawn again from their JSON.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/json_schema.h"

namespace lacuna::test {

namespace {

using nlohmann::json;
using Bench = ProgramTest;

const std::string k_source = LACUNA_SOURCE_DIR;

void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

TEST_F(Bench, TableJsonAndChart) {
    const Outcome outcome = lacuna({"bench", "sample:casting@24", "--quick", "--size", "40x40", "--rounds", "1",
                                    "--modes", "iso,ea", "--json", path("b.json"), "--chart", path("b.svg")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const json result = json::parse(bytes_of(path("b.json")));
    const JsonSchema schema(json::parse(bytes_of(k_source + "/docs/schemas/bench.schema.json")));
    for (const std::string& fault : schema.faults(result)) ADD_FAILURE() << fault;
    ASSERT_EQ(result["scenes"].size(), 2u);
    for (const json& scene : result["scenes"]) {
        EXPECT_GT(scene["points"].size(), 8u);
        int front = 0;
        for (const json& point : scene["points"]) {
            front += point["on_front"].get<bool>();
            EXPECT_NE(outcome.out.find(point["plan"]["structure"].get<std::string>()), std::string::npos);
        }
        EXPECT_GE(front, 1);
    }
    EXPECT_TRUE(bytes_of(path("b.svg")).starts_with("<svg"));
}

TEST_F(Bench, APlanDrawnAgainFromItsJsonGivesTheSameBytes) {
    const std::vector<std::string> scene{"render", "sample:head@24", "--size", "60x50", "--azimuth", "33"};
    const std::vector<std::vector<std::string>> ways{
        {"--mode", "iso", "--structure", "eacd", "--step", "0.8", "--refine", "bisect", "--refine-steps", "4"},
        {"--mode", "ea", "--structure", "octree", "--homogeneity", "30", "--ert", "0.03", "--sparse", "3,0.05"},
        {"--mode", "mip", "--structure", "macrocells", "--sampler", "nearest", "--step", "1.3"},
        {"--mode", "shear-warp"}};
    for (const auto& way : ways) {
        std::vector<std::string> words = scene;
        words.insert(words.end(), way.begin(), way.end());
        words.insert(words.end(), {"-o", path("a.png"), "--stats", path("s.json")});
        ASSERT_EQ(lacuna(words).status, 0) << way[1];
        write(path("plan.json"), json::parse(bytes_of(path("s.json")))["plan"].dump());
        words = scene;
        words.insert(words.end(), {"-o", path("b.png"), "--plan", path("plan.json"), "--stats", path("t.json")});
        const Outcome again = lacuna(words);
        ASSERT_EQ(again.status, 0) << again.err;
        EXPECT_EQ(bytes_of(path("a.png")), bytes_of(path("b.png"))) << way[1];
        EXPECT_EQ(json::parse(bytes_of(path("t.json")))["plan"], json::parse(bytes_of(path("s.json")))["plan"]);
    }
    const Outcome inline_plan = lacuna({"render", "sample:head@24", "--size", "20x20", "-o", path("c.png"), "--plan",
                                        R"({"mode":"mip","structure":"none","step":1})"});
    EXPECT_EQ(inline_plan.status, 0) << inline_plan.err;
}

TEST_F(Bench, ATurnKeepsItsBudgetAndItsPlanIsDrawnAgain) {
    const std::vector<std::string> scene{"render", "sample:head@24", "--size", "60x50", "--turntable", "3"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), scene.begin(), scene.end());
        return lacuna(more);
    };
    const Outcome planned =
        with({"--mode", "iso", "--error-budget", "4", "--verify", "-o", path("a.png"), "--stats", path("s.json")});
    ASSERT_EQ(planned.status, 0) << planned.err;
    const json stats = json::parse(bytes_of(path("s.json")));
    EXPECT_LE(stats["error"]["max"], 4 + 1) << "of the worst picture; the reference is in double precision";
    EXPECT_NE(stats["plan"]["why"][1].get<std::string>().find("Holds in all 3 views by rule"), std::string::npos)
        << stats["plan"]["why"][1];
    write(path("plan.json"), stats["plan"].dump());
    const Outcome again = with({"--plan", path("plan.json"), "-o", path("b.png")});
    ASSERT_EQ(again.status, 0) << again.err;
    for (const char* number : {"-000.png", "-001.png", "-002.png"})
        EXPECT_EQ(bytes_of(path(std::string("a") + number)), bytes_of(path(std::string("b") + number))) << number;
}

TEST_F(Bench, PlansThatDoNotFitAreRefused) {
    const std::vector<std::string> scene{"render", "sample:head@24", "-o", path("a.png")};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), scene.begin(), scene.end());
        return lacuna(more);
    };
    expect_failure(with({"--plan", R"({"step":1})", "--step", "2"}), 2, "--step does not go with --plan");
    expect_failure(with({"--plan", R"({"mode":"mip"})", "--mode", "iso"}), 2, "--mode iso");
    expect_failure(with({"--plan", R"({"stride":1})"}), 1, "stride");
    expect_failure(with({"--plan", R"({"step":-1})"}), 2, "step");
    expect_failure(with({"--plan", path("none.json")}), 1, "none.json");
    EXPECT_TRUE(files().empty());
}

TEST_F(Bench, ShippedScenesKeepToTheSchemaAndAreUnderstood) {
    const JsonSchema schema(json::parse(bytes_of(k_source + "/docs/schemas/scenes.schema.json")));
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(k_source + "/resources/scenes")) {
        if (entry.path().string().ends_with(".tf.json")) continue;
        ++found;
        const json scenes = json::parse(bytes_of(entry.path().string()));
        for (const std::string& fault : schema.faults(scenes)) ADD_FAILURE() << entry.path() << ": " << fault;
        const Outcome outcome = lacuna({"bench", entry.path().string(), "--list", "--data", "some where"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        for (const json& scene : scenes["scenes"])
            EXPECT_NE(outcome.out.find(scene["name"].get<std::string>() + ": lacuna render "), std::string::npos);
        if (entry.path().stem() == "real") {
            EXPECT_NE(outcome.out.find("lacuna render 'some where/medical/"), std::string::npos);
        }
    }
    EXPECT_GE(found, 2);
    const json samples = json::parse(bytes_of(k_source + "/resources/scenes/samples.json"));
    for (const char* name : {"casting", "head", "vessels", "spheres", "marschner-lobb"})
        EXPECT_NE(samples.dump().find(std::string("sample:") + name), std::string::npos) << name;
}

TEST_F(Bench, SceneFilesOfOnesOwn) {
    write(path("s.json"), R"({"scenes":[
        {"name":"one","input":"sample:head@16","mode":"ea","size":"24x24","views":2,"cut":["1,0,0,0","0,1,0,0:open"]},
        {"name":"two","input":"sample:head@16","mode":"mip","size":"24x24"}]})");
    const Outcome outcome = lacuna({"bench", path("s.json"), "--quick", "--rounds", "1", "--json", path("b.json"),
                                    "--scene", "one", "--chart", path("b.png"), "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const json result = json::parse(bytes_of(path("b.json")));
    ASSERT_EQ(result["scenes"].size(), 1u);
    EXPECT_EQ(result["scenes"][0]["name"], "one");
    EXPECT_NE(result["scenes"][0]["command"].get<std::string>().find("--cut=0,1,0,0:open"), std::string::npos);
    EXPECT_TRUE(bytes_of(path("b.png")).starts_with("\x89PNG"));
}

TEST_F(Bench, WrongWordsAndFilesAreNamed) {
    const auto with = [&](const std::string& scenes) {
        write(path("s.json"), scenes);
        return lacuna({"bench", path("s.json"), "--quick"});
    };
    expect_failure(with("{"), 1, "s.json: this is no JSON");
    expect_failure(with(R"({"scenes":[]})"), 1, "at least one scene");
    expect_failure(with(R"({"scenes":[{"name":"a"}]})"), 1, "no \"input\"");
    expect_failure(with(R"({"scenes":[{"name":"a","input":"x","structure":"acd"}]})"), 1, "no key \"structure\"");
    expect_failure(with(R"({"scenes":[{"name":"a","input":"x","views":0}]})"), 1, "\"views\"");
    expect_failure(with(R"({"scenes":[{"name":"a","input":"sample:head@16","mode":"oil"}]})"), 2, "oil");
    expect_failure(with(R"({"scenes":[{"name":"a","input":"nowhere","mode":"ea"}]})"), 1, "nowhere");
    expect_failure(with(R"({"about":"x","scene":[]})"), 1, "scenes");
    expect_failure(lacuna({"bench", path("s.json"), "--scene", "zz"}), 1, "scenes");
    expect_failure(lacuna({"bench", "sample:head@16", "--chart", path("a.gif")}), 2, ".svg, .png or .pdf");
    expect_failure(lacuna({"bench", "sample:head@16", "--chart", path("none/a.svg")}), 1, "none");
    expect_failure(lacuna({"bench", "sample:head@16", "--modes", "iso,oil"}), 2, "oil");
    expect_failure(lacuna({"bench", "sample:head@16", "--views", "0"}), 2, "--views");
    expect_failure(lacuna({"bench", "sample:head@16", "--error", "rms"}), 2, "rms");
    EXPECT_EQ(files(), std::vector<std::string>{"s.json"});
}

TEST_F(Bench, WordsWithoutUseAreRefused) {
    write(path("s.json"), R"({"scenes":[{"name":"a","input":"sample:head@16","mode":"mip"}]})");
    const auto of_file = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"bench", path("s.json"), "--list"});
        return lacuna(more);
    };
    EXPECT_EQ(of_file({}).status, 0);
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--modes", "ea"}, {"--size", "8x8"}, {"--raw", "8x8x8:u8"}, {"--series", "1"}, {"--spacing", "1,1,2"}})
        expect_failure(of_file(more), 2, more[0]);
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--scene", "a"}), 2, "--scene");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--data", "."}), 2, "--data");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--modes", ""}), 2, "--modes");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--modes", "iso,mip,iso"}), 2, "each once");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--json", path("b.json")}), 2, "--list");
    expect_failure(lacuna({"bench", "sample:head@16", "--list", "--chart", path("b.svg")}), 2, "--list");
    write(path("s.json"), R"({"scenes":[{"name":"a","input":"sample:head@16","zoom":[]}]})");
    expect_failure(of_file({}), 1, "zoom");
}

TEST_F(Bench, HowAnInputIsOpenedReachesItsScenes) {
    const Outcome listed = lacuna({"bench", "folder", "--list", "--keep-gaps", "--modes", "mip"});
    EXPECT_NE(listed.out.find("--keep-gaps"), std::string::npos) << listed.out;
    expect_failure(lacuna({"bench", "sample:spheres@128", "--quick", "--modes", "mip", "--memory-limit", "1"}), 1,
                   "--memory-limit");
}

TEST_F(Bench, NothingMeasuredIsNoResult) {
    const Outcome outcome = lacuna({"bench", "sample:head@16", "--quick", "--modes", "mip", "--size", "16x16",
                                    "--time-limit", "1e-9", "--quiet", "--json", path("b.json")});
    expect_failure(outcome, 1, "--time-limit");
    EXPECT_TRUE(files().empty());
}

TEST_F(Bench, QuietWithoutAFileTheTableIsTheResult) {
    const Outcome outcome =
        lacuna({"bench", "sample:head@16", "--quick", "--modes", "mip", "--size", "16x16", "--rounds", "1", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("macrocells"), std::string::npos);
}

TEST_F(Bench, ABudgetThatCannotBeKeptIsSaidWithQuietToo) {
    const std::vector<std::string> words{"render", "sample:head@16", "-o",   path("a.png"), "--size",
                                         "24x24",  "--time-budget",  "1e-6", "--quiet"};
    const Outcome outcome = lacuna(words);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("lacuna: the time budget cannot be kept")) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1);
}

TEST_F(Bench, InterruptedItLeavesNothing) {
    Surroundings interrupted;
    interrupted.signal = 2;
    interrupted.signal_after_ms = 1500;
    const Outcome outcome =
        lacuna({"bench", "sample:casting@96", "--json", path("b.json"), "--chart", path("b.svg")}, interrupted);
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_TRUE(files().empty());
}

TEST_F(Bench, VerifyingAgainstOtherTruths) {
    const std::vector<std::string> scene{
        "render", "sample:spheres@24", "-o", path("a.png"), "--size", "40x40", "--mode", "iso"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), scene.begin(), scene.end());
        return lacuna(more);
    };
    const Outcome map =
        with({"--verify-map", path("m.png"), "--step", "2", "--verify-against", "fine", "--stats", path("s.json")});
    ASSERT_EQ(map.status, 0) << map.err;
    EXPECT_TRUE(bytes_of(path("m.png")).starts_with("\x89PNG"));
    EXPECT_NE(map.out.find("silhouette pixels missed"), std::string::npos) << map.out;
    const json error = json::parse(bytes_of(path("s.json")))["error"];
    EXPECT_NE(error["reference"].get<std::string>().find("step 0.125"), std::string::npos);
    EXPECT_TRUE(error["surface"].contains("max_voxels"));
    const Outcome closed = with({"--verify-against", "closed-form", "--iso", "110"});
    EXPECT_EQ(closed.status, 0) << closed.err;
    expect_failure(with({"--verify-against", "better"}), 2, "--verify-against");
    expect_failure(with({"--verify-against", "closed-form", "--smooth", "3"}), 2, "--smooth");
    expect_failure(with({"--verify-against", "closed-form", "--regions", "hide"}), 1, "regions");
    expect_failure(lacuna({"render", "x.mhd", "-o", path("b.png"), "--verify-against", "closed-form"}), 2,
                   "sample:NAME");
}

TEST_F(Bench, PixelsOverTheBudgetAreCountedAgainstTheBudget) {
    const std::vector<std::string> scene{"render", "sample:head@24", "-o", path("a.png"), "--size", "60x50"};
    const auto over = [&](std::vector<std::string> more) {
        more.insert(more.begin(), scene.begin(), scene.end());
        more.insert(more.end(), {"--mode", "mip", "--verify", "--stats", path("s.json")});
        const Outcome outcome = lacuna(more);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        const json error = json::parse(bytes_of(path("s.json")))["error"];
        const std::string budget = more[6] == "--error-budget" ? more[7] : "1";
        EXPECT_NE(outcome.out.find(" pixels over " + budget + "/255"), std::string::npos) << outcome.out;
        EXPECT_EQ(error["pixels_over_budget"] > 0, error["max"] > std::stod(budget)) << error;
        return error;
    };
    EXPECT_GT(over({"--sampler", "nearest"})["pixels_over_budget"], 0);
    const json nearest = over({"--sampler", "nearest"});
    EXPECT_GT(nearest["projection"]["max_overshoot"], 0) << "a voxel is brighter than what lies beside it";
    over({"--error-budget", "160"});
    over({"--error-budget", "250"});
}

}  // namespace
}  // namespace lacuna::test
