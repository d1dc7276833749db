#include "core/accuracy/device_costs.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/compute/device.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// A cache folder of its own while it lives.
class OwnCache {
public:
    OwnCache() {
        const char* before = std::getenv("LACUNA_CACHE");
        if (before) before_ = before;
        folder = std::filesystem::temp_directory_path() / "lacuna-costs-test";
        std::filesystem::remove_all(folder);
        setenv("LACUNA_CACHE", folder.c_str(), 1);
    }
    ~OwnCache() {
        std::filesystem::remove_all(folder);
        before_ ? setenv("LACUNA_CACHE", before_->c_str(), 1) : unsetenv("LACUNA_CACHE");
    }
    std::filesystem::path folder;

private:
    std::optional<std::string> before_;
};

DeviceCosts some() { return {"device", "driver", "program", 1, 100, 20, 8, 5, 50, 30, 10}; }

ViewFacts sparse_scene() {
    ViewFacts facts;
    facts.pixels = 250000;
    facts.rays = 200000;
    facts.whole = {40e6, 1e6, 5e5};
    facts.seen = {20e6, 4e5, 3e5};
    return facts;
}

Scene scene(ViewMode mode) { return small_scene(bumpy_ball<std::uint8_t>({9, 9, 9}, {1, 1, 1}, 200), mode); }

std::optional<double> predict(const ViewFacts& facts, const Plan& plan, ViewMode mode = ViewMode::ea) {
    return predicted_ms(some(), facts, scene(mode), plan, 0.5);
}

Plan brute() {
    Plan plan;
    plan.structure = Structure::none;
    plan.ert = 0;
    return plan;
}

TEST(DeviceCosts, APredictionAddsUpTheWork) {
    ViewFacts facts;
    facts.rays = 1000;
    facts.whole = {50000, 10000, 2000};
    Plan plan = brute();
    // 1 ms a frame + 1000 rays 100 ns + 50000 samples 20 ns + 10000 shown (5 + 50) ns
    EXPECT_NEAR(*predict(facts, plan), 1 + 0.1 + 1.0 + 0.55, 1e-9);
    plan.sampler = Sampler::nearest;
    EXPECT_NEAR(*predict(facts, plan), 1 + 0.1 + 0.4 + 0.55, 1e-9);
    plan.step = 1;
    EXPECT_NEAR(*predict(facts, plan), 1 + 0.1 + 0.2 + 0.275, 1e-9);
    EXPECT_NEAR(*predict(facts, brute(), ViewMode::mean), 1 + 0.1 + 1.0 + 0.05, 1e-9) << "nothing is shaded";
}

TEST(DeviceCosts, EmptySpaceMakesStructuresWorthIt) {
    const ViewFacts facts = sparse_scene();
    for (const Structure structure : {Structure::macrocells, Structure::octree, Structure::pc, Structure::acd}) {
        Plan plan = brute();
        plan.structure = structure;
        EXPECT_LT(*predict(facts, plan), 0.6 * *predict(facts, brute())) << name_of(structure);
    }
    ViewFacts fog = facts;
    fog.whole = {40e6, 40e6, 0};
    for (const Structure structure : {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::acd}) {
        Plan plan = brute();
        plan.structure = structure;
        EXPECT_GT(*predict(fog, plan), *predict(fog, brute())) << "nothing to skip: " << name_of(structure);
    }
}

TEST(DeviceCosts, TerminationShortensRays) {
    Plan plan = brute();
    plan.ert = 0.002;
    EXPECT_LT(*predict(sparse_scene(), plan), *predict(sparse_scene(), brute()));
}

TEST(DeviceCosts, NothingIsSaidOfWhatIsNotKnown) {
    Plan plan = brute();
    EXPECT_FALSE(predict(sparse_scene(), plan, ViewMode::mip));
    EXPECT_TRUE(predict(sparse_scene(), plan, ViewMode::mean));
    plan.structure = Structure::leap;
    EXPECT_FALSE(predict(sparse_scene(), plan));
    plan = brute();
    plan.sparse = 2;
    EXPECT_FALSE(predict(sparse_scene(), plan));
}

TEST(DeviceCosts, SparseCastingPaysByTheRaysItLeavesOut) {
    const DeviceCosts costs = some();
    EXPECT_NEAR(predicted_sparse_ms(costs, 100000, 0.25, 101), 1 + 25 + 1, 1e-9);
    EXPECT_GT(predicted_sparse_ms(costs, 100000, 1, 101), 101) << "all rays and the bookkeeping";
    EXPECT_GE(predicted_sparse_ms(costs, 100000, 0.25, 0.5), costs.frame_ms);
}

TEST(DeviceCosts, JsonComesBackAndWhatIsDamagedIsRefused) {
    EXPECT_EQ(device_costs_from_json(to_json(some()), "x"), some());
    for (const char* bad : {"", "[]", "{}", "{\"device\":1}", "null"})
        EXPECT_THROW(device_costs_from_json(bad, "x"), Error) << bad;
    DeviceCosts costs = some();
    costs.read_ns = -1;
    EXPECT_THROW(device_costs_from_json(to_json(costs), "x"), Error);
    costs.read_ns = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(device_costs_from_json(to_json(costs), "x"), Error);
}

TEST(DeviceCosts, TheReferenceRendererHasNone) {
    const OwnCache cache;
    Engine engine(nullptr);
    EXPECT_FALSE(costs_of(engine));
    EXPECT_FALSE(std::filesystem::exists(cache.folder));
}

TEST(DeviceCosts, AreMeasuredOncePerDeviceDriverAndProgram) {
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) GTEST_SKIP() << "no device";
    const OwnCache cache;
    Engine engine(device);
    const std::string name = device->info().name, driver = device->info().driver;
    EXPECT_FALSE(kept_costs(name, driver));
    const DeviceCosts measured = *costs_of(engine);
    EXPECT_GT(measured.frame_ms, 0);
    EXPECT_GT(measured.sample_ns + measured.nearest_ns, 0);
    EXPECT_GT(measured.gradient_ns, 0);
    EXPECT_EQ(kept_costs(name, driver), measured);
    EXPECT_EQ(*costs_of(engine), measured) << "not measured again";
    EXPECT_FALSE(kept_costs(name, driver + " newer"));
    EXPECT_FALSE(kept_costs("another", driver));
    DeviceCosts older = measured;
    older.program = "older kernels";
    write_file(costs_file(name), to_json(older));
    EXPECT_FALSE(kept_costs(name, driver));
    write_file(costs_file(name), "{");
    EXPECT_FALSE(kept_costs(name, driver)) << "damaged";
    setenv("LACUNA_CACHE", "", 1);  // nothing is to be kept
    EXPECT_TRUE(costs_file(name).empty());
}

}  // namespace
}  // namespace lacuna
