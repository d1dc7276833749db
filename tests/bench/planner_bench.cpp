// How good the planner's picks are: the time of the plan it picks against the best measured plan that keeps the same
// error budget, timed in turn, and whether the picked plan keeps it. Fails where the promise is broken: a geometric
// mean of the times' ratios over 1.3, a budget exceeded in more than 1 % of the scenes, or by more than twice.
//   bench_planner [SAMPLE-SIZE [PICTURE-SIDE [full]]]           the built-in samples
//   bench_planner random [SCENES [FIRST-SEED [full]]]           scenes nobody chose
//   bench_planner promise [SCENES [FIRST-SEED]]                 the errors alone, of many small ones
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/planner.h"
#include "core/accuracy/sweep.h"
#include "core/base/order_statistics.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/volume/samples.h"
#include "tests/support/random_scenes.h"

using namespace lacuna;

namespace {

constexpr int k_rounds = 9;
constexpr std::size_t k_rivals = 3;
constexpr double k_promised_ratio = 1.3, k_promised_over = 0.01, k_most_over = 2;

/// Times of all plans, in turn.
std::vector<double> times(Engine& engine, const Scene& scene, const std::vector<Plan>& plans) {
    std::vector<std::vector<double>> all(plans.size());
    for (int round = -1; round < k_rounds; ++round)
        for (std::size_t i = 0; i < plans.size(); ++i) {
            const std::size_t at = round % 2 ? plans.size() - 1 - i : i;
            const double ms = engine.render(scene, plans[at]).frame.ms;
            if (round >= 0) all[at].push_back(ms);
        }
    std::vector<double> medians;
    for (const std::vector<double>& of_plan : all) medians.push_back(median(of_plan));
    return medians;
}

class Judge {
public:
    Judge(Engine& engine, const std::optional<DeviceCosts>& costs) : engine_(engine), costs_(costs) {}

    void head() const {
        fmt::print("{:<16} {:<5} {:>6} {:>9} {:>7} {:>7} {:>6}  {}\n", "scene", "mode", "budget", "planning s", "error",
                   "ms", "ratio", "picked; best where another");
    }

    void compare_times(const std::string& name, const Scene& scene, SweepExtent extent) {
        SweepScene swept;
        swept.name = name;
        swept.scene = scene;
        swept.views = {scene.camera};
        SweepOptions options;
        options.extent = extent;
        options.closed_form = false;
        options.rounds = 3;
        const SceneResult measured = sweep(engine_, swept, options);
        for (const double budget : {0.5, 8.0}) {
            choose_plan(engine_, scene, asked(budget));  // compiles what is drawn
            engine_.drop_caches();
            const Stopwatch watch;
            const PlannedPlan planned = choose_plan(engine_, scene, asked(budget));
            const double planning_s = 1e-3 * watch.ms();
            hold(scene, planned, budget);
            std::vector<const SweepPoint*> rivals;
            for (const SweepPoint& point : measured.points)
                if (point.refused.empty() && point.plan.mode == scene.mode && point.error.max <= budget)
                    rivals.push_back(&point);
            std::sort(rivals.begin(), rivals.end(), [](const auto* a, const auto* b) { return a->ms < b->ms; });
            if (rivals.size() > k_rivals) rivals.resize(k_rivals);
            if (rivals.empty()) continue;
            std::vector<Plan> plans{planned.plan};
            for (const SweepPoint* rival : rivals) plans.push_back(rival->plan.plan);
            const std::vector<double> ms = times(engine_, scene, plans);
            const auto best = std::min_element(ms.begin() + 1, ms.end());
            const double slower = ms[0] / *best;
            sum_ += std::log(slower), worst_ = std::max(worst_, slower), ++compared_;
            planning_.push_back(planning_s);
            const SweepPoint& rival = *rivals[std::size_t(best - ms.begin()) - 1];
            fmt::print("{:<16} {:<5} {:>6g} {:>9.2f} {:>7.3g} {:>7.2f} {:>6.2f}  {}; {}\n", name, name_of(scene.mode),
                       budget, planning_s, planned.error, ms[0], slower, words(scene, planned.plan),
                       words(scene, rival.plan.plan));
        }
    }

    /// Whether the plan keeps the budget, by pictures drawn anew.
    void hold(const Scene& scene, const PlannedPlan& planned, double budget) {
        const Frame brute = engine_.render(scene, brute_force(scene, 0.5)).frame;
        const double error = compare(engine_.render(scene, planned.plan).frame, brute, scene.background).max;
        ++held_;
        over_ += !(error <= budget);
        far_over_ += !(error <= k_most_over * budget);
        lossy_ += error > 0;
    }

    Budget asked(double budget) const {
        Budget made{.error = budget};
        made.costs = costs_;
        return made;
    }

    /// @return the exit status
    int verdict() const {
        bool kept = over_ <= k_promised_over * held_ && far_over_ == 0;
        fmt::print("{} plans, {} of them with loss: budget exceeded in {}, by more than twice in {}\n", held_, lossy_,
                   over_, far_over_);
        if (compared_ > 0) {
            const double mean = std::exp(sum_ / compared_);
            kept = kept && mean <= k_promised_ratio;
            fmt::print("{} times compared, picked over best: geometric mean {:.2f}, worst {:.2f}\n", compared_, mean,
                       worst_);
            fmt::print("planning: median {:.2f} s, longest {:.2f} s\n", median(planning_),
                       *std::max_element(planning_.begin(), planning_.end()));
        }
        fmt::print("{}\n", kept ? "The promise is kept." : "THE PROMISE IS BROKEN.");
        return kept ? 0 : 1;
    }

private:
    static std::string words(const Scene& scene, const Plan& plan) {
        const ModePlan brute{scene.mode, brute_force(scene, 0.5)};
        const std::string difference = difference_in_words({scene.mode, plan}, brute);
        return fmt::format("{}{}{}", name_of(plan.structure), difference.empty() ? "" : ", ", difference);
    }

    Engine& engine_;
    const std::optional<DeviceCosts>& costs_;
    double sum_ = 0, worst_ = 0;
    int compared_ = 0, held_ = 0, over_ = 0, far_over_ = 0, lossy_ = 0;
    std::vector<double> planning_;
};

void judge_samples(Judge& judge, int size, int side, SweepExtent extent) {
    for (const char* name : {"casting", "head", "vessels", "spheres"}) {
        const Volume volume = make_sample(name, {.size = size}).volume;
        const VolumeStatistics statistics = compute_statistics(volume);
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            Scene scene = default_scene(volume, statistics);
            scene.mode = mode;
            scene.size = {side, side};
            scene.camera.azimuth_deg = 35;
            scene.camera.elevation_deg = 20;
            scene.camera.zoom = 1.5;
            judge.compare_times(name, scene, extent);
        }
    }
}

}  // namespace

int main(int count, char** words) {
    const auto number = [&](int at, int otherwise) { return count > at ? std::atoi(words[at]) : otherwise; };
    const std::string_view what = count > 1 ? words[1] : "";
    const bool random = what == "random", promise = what == "promise";
    const SweepExtent extent =
        count > 1 && std::string_view(words[count - 1]) == "full" ? SweepExtent::full : SweepExtent::quick;
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) return fmt::print("There is no OpenCL device to measure.\n"), 1;
    Engine engine(device);
    const auto costs = costs_of(engine);
    fmt::print("{}\n", engine.device_name());
    if (costs) fmt::print("{}\n", describe(*costs));
    Judge judge(engine, costs);
    if (!promise) judge.head();
    if (!random && !promise) {
        judge_samples(judge, number(1, 128), number(2, 384), extent);
        return judge.verdict();
    }
    const int scenes = number(2, promise ? 200 : 12), first = number(3, 1000);
    const double budgets[] = {0, 0.5, 2, 8, 32};
    for (int i = 0; i < scenes; ++i) {
        test::Random seed(unsigned(first + i));
        if (random) {
            judge.compare_times(fmt::format("seed {}", first + i), test::random_scene(seed, {384, 288}, 3), extent);
        } else {
            const Scene scene = test::random_scene(seed);
            const double budget = budgets[i % 5];
            judge.hold(scene, choose_plan(engine, scene, judge.asked(budget)), budget);
        }
    }
    return judge.verdict();
}
