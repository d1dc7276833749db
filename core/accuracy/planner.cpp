#include "core/accuracy/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/accuracy/limits.h"
#include "core/accuracy/shortlist.h"

namespace lacuna {

namespace {

constexpr int k_probe = 4;          // a probe picture is so many times narrower and lower
constexpr int k_least_pixels = 64;  // of its sides, where the picture has them
constexpr int k_timings = 3;
constexpr int k_fact_rays = 1500;
constexpr int k_rounds = 3;                  // in which finalists are timed in turn
constexpr double k_sparse_depth_pixels = 4;  // what the renderer takes for an edge between cast pixels
constexpr double k_worth = 0.9;              // sparse casting must promise to be so much faster
constexpr double k_probe_caution = 0.5;  // share of the error budget a probe may use: it sees a sixteenth of the rays

/// What a candidate came to.
struct Measured {
    ModePlan plan;
    double ms = 0, build_ms = 0, error = 0;
    double cost(int frames) const { return ms + build_ms / frames; }
};

class Planner {
public:
    Planner(Engine& engine, const Scene& scene, const Budget& budget, const JobContext& job)
        : engine_(engine), scene_(scene), budget_(budget), job_(job) {
        brute_ = {scene.mode, brute_force(scene, budget.step)};
        brute_.plan.why.clear();
        probe_ = scene;
        probe_.size = glm::max(scene.size / k_probe, glm::min(scene.size, glm::ivec2(k_least_pixels)));
        share_ = double(probe_.size.x) * probe_.size.y / (double(scene.size.x) * scene.size.y);
    }

    PlannedPlan run() {
        facts_ = measure_facts(scene_, {job_.stop});
        if (budget_.costs && scene_.volume.in_memory())
            view_facts_ = measure_view_facts(scene_, budget_.step, k_fact_rays, {job_.stop});
        truth_.emplace(engine_.render(probe_, brute_.plan, {job_.stop}).frame, scene_.background);
        const Measured structure = best_structure(job_.part(0, 0.4));
        std::vector<Measured> trades = measure_trades(structure, job_.part(0.4, 0.7));
        trades.push_back(structure);
        return verify(std::move(trades), job_.part(0.7, 1));
    }

private:
    void refuse(const ModePlan& plan, const std::string& why) {
        const std::string words = difference_in_words(plan, brute_);
        refused_.push_back(
            fmt::format("Refused {}{}{}: {}", name_of(plan.plan.structure), words.empty() ? "" : ", ", words, why));
    }

    /// A promise of an error is not given for a method that fails on the scene, whatever this view shows of it.
    bool refused_by_failure(const ModePlan& plan) {
        if (!budget_.error) return false;
        const std::string why = refused_by_limits(facts_, scene_, plan.plan, brute_.plan, *budget_.error);
        if (!why.empty()) refuse(plan, why);
        return !why.empty();
    }

    /// Draws a picture warm; the error is against the truth given.
    std::optional<Measured> measure(const Scene& scene, const ModePlan& plan, const TruePicture& truth) {
        Measured made{plan};
        try {
            const RenderResult first = engine_.render(scene, plan.plan, {job_.stop});
            for (const auto& [name, build] : first.build) made.build_ms += build.ms;
            made.error = truth.compare(first.frame).max;
            std::vector<double> times;
            for (int i = 0; i < k_timings; ++i) times.push_back(engine_.render(scene, plan.plan, {job_.stop}).frame.ms);
            std::sort(times.begin(), times.end());
            made.ms = times[times.size() / 2];
        } catch (const Error& error) {
            if (error.code() == Errc::cancelled) throw;
            refuse(plan, error.what());
            return std::nullopt;
        }
        return made;
    }

    std::optional<Measured> probe(const ModePlan& plan) {
        std::optional<Measured> made = measure(probe_, plan, *truth_);
        if (made) made->ms /= share_;
        return made;
    }

    std::optional<double> predicted(const Plan& plan) const {
        return view_facts_ ? predicted_ms(*budget_.costs, *view_facts_, scene_, plan, budget_.step) : std::nullopt;
    }

    /// The structure that costs least over the expected frames, without loss.
    Measured best_structure(const JobContext& job) {
        std::vector<Outlook> outlooks;
        for (const auto& [structure, name] : structure_names()) {
            ModePlan plan = brute_;
            plan.plan.structure = structure;
            try {
                check(plan.plan, scene_);
            } catch (const Error&) {
                continue;  // not of this mode
            }
            outlooks.push_back({plan, predicted(plan.plan)});
        }
        const std::vector<std::string> reasons = leave_out(outlooks);
        std::vector<Measured> found;
        for (std::size_t i = 0; i < outlooks.size(); ++i) {
            job.checkpoint(i, outlooks.size());
            if (!reasons[i].empty())
                refuse(outlooks[i].plan, reasons[i]);
            else if (auto made = probe(outlooks[i].plan))
                found.push_back(*made);
        }
        const auto cheaper = [&](const Measured& a, const Measured& b) {
            return a.cost(budget_.frames) < b.cost(budget_.frames);
        };
        if (found.empty()) throw Error(Errc::device, "No plan could be drawn on this device; choose another one.");
        const Measured best = *std::min_element(found.begin(), found.end(), cheaper);
        for (const Measured& other : found)
            if (to_json(other.plan) != to_json(best.plan))
                refuse(other.plan,
                       fmt::format(
                           "about {:.3g} ms a frame and {:.3g} ms to build; {} takes {:.3g} ms and {:.3g} ms over {} "
                           "frames.",
                           other.ms, other.build_ms, name_of(best.plan.plan.structure), best.ms, best.build_ms,
                           budget_.frames));
        return best;
    }

    std::vector<ModePlan> trades_of(const ModePlan& exact) const {
        std::vector<ModePlan> plans;
        const auto add = [&](auto&& change) {
            ModePlan plan = exact;
            change(plan.plan);
            plans.push_back(std::move(plan));
        };
        std::vector<double> ends{0};
        if (scene_.mode == ViewMode::ea) {
            // Opacity 1 - e hides at most e of what lies behind.
            const double e = budget_.error ? std::min(0.5, *budget_.error / 255) : 0.002;
            if (e > 0) ends.push_back(e);
            for (const double more : {0.01, 0.05})
                if (!budget_.error) ends.push_back(more);
        }
        for (const double ert : ends)
            for (const double factor : {1.0, 1.5, 2.0, 3.0})
                for (const auto& [sampler, name] : sampler_names()) {
                    if (ert == 0 && factor == 1 && sampler == exact.plan.sampler) continue;
                    add([&, s = sampler](Plan& p) { p.ert = ert, p.step = factor * exact.plan.step, p.sampler = s; });
                }
        // Segments keep peaks of the transfer function that longer steps would miss.
        for (const double factor : {2.0, 3.0})
            add([&](Plan& p) {
                p.ert = ends.back(), p.step = factor * exact.plan.step, p.integration = Integration::preintegrated;
            });
        std::erase_if(plans, [&](const ModePlan& plan) { return !serves(plan.plan); });
        return plans;
    }

    bool serves(const Plan& plan) const {
        try {
            check(plan, scene_);
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    bool within_error(const Measured& m, double caution) const {
        return !budget_.error || m.error <= caution * *budget_.error;  // NaN is not within
    }

    std::vector<Measured> measure_trades(const Measured& exact, const JobContext& job) {
        std::vector<Measured> kept;
        std::vector<TooFarOff> off;
        std::size_t done = 0;
        const std::vector<ModePlan> plans = trades_of(exact.plan);
        const double rays = double(probe_.size.x) * probe_.size.y;
        for (const ModePlan& plan : plans) {
            job.checkpoint(done++, plans.size());
            if (refused_by_failure(plan)) continue;
            if (const std::string reason = off_already(plan, off); !reason.empty()) {
                refuse(plan, reason);
                continue;
            }
            const auto made = probe(plan);
            if (!made) continue;
            if (!within_error(*made, 1)) off.push_back({plan, made->error});
            if (!within_error(*made, k_probe_caution))
                refuse(plan, fmt::format("{:.3g}/255 off on {:.0f} rays of this view; the budget is {:.3g}/255.",
                                         made->error, rays, *budget_.error));
            else if (budget_.error && made->ms >= exact.ms)
                refuse(plan, fmt::format("about {:.3g} ms a frame, no faster than without loss ({:.3g} ms).", made->ms,
                                         exact.ms));
            else
                kept.push_back(*made);
        }
        return kept;
    }

    /// Sparse casting depends on the pixels' size, so no smaller picture tells of it. How many rays it casts is known
    /// from the whole brute-force picture, its error only once it is drawn.
    void add_sparse(const Frame& picture, std::vector<Measured>& found) {
        const auto faster = [](const Measured& a, const Measured& b) { return a.ms < b.ms; };
        const Measured base = *std::min_element(found.begin(), found.end(), faster);
        const double pixels = double(picture.pixels());
        const double pixel_mm = resolve(scene_.camera, scene_.volume.geometry(), scene_.size).pixel_mm;
        const DeviceCosts costs = budget_.costs.value_or(DeviceCosts{});
        std::vector<double> gradients{Plan{}.sparse_gradient};
        if (budget_.error) gradients = {std::max(0.002, 0.5 * *budget_.error / 255), 2 * *budget_.error / 255};
        for (const int k : {2, 3, 4})
            for (const double gradient : gradients) {
                Measured sparse = base;
                sparse.plan.plan.sparse = k;
                sparse.plan.plan.sparse_gradient = gradient;
                if (!(gradient > 0) || !serves(sparse.plan.plan) || refused_by_failure(sparse.plan)) continue;
                const double share = sparse_share(picture, k, gradient, k_sparse_depth_pixels * k * pixel_mm);
                sparse.ms = predicted_sparse_ms(costs, pixels, share, base.ms);
                sparse.error = std::numeric_limits<double>::infinity();  // behind all whose error is known
                if (sparse.ms < k_worth * base.ms)
                    found.push_back(sparse);
                else
                    refuse(sparse.plan,
                           fmt::format("it would cast {:.0f} % of the rays and take about {:.3g} ms a frame, "
                                       "{:.3g} ms without.",
                                       100 * share, sparse.ms, base.ms));
            }
    }

    /// Draws candidates whole, the most promising first, until one fits; then those about as fast, too, and takes the
    /// fastest of them.
    PlannedPlan verify(std::vector<Measured> found, const JobContext& job) {
        const Frame brute_frame = engine_.render(scene_, brute_.plan, {job_.stop}).frame;
        add_sparse(brute_frame, found);
        const TruePicture truth(brute_frame, scene_.background);
        const bool by_time = budget_.time_ms && !budget_.error;
        std::sort(found.begin(), found.end(), [&](const Measured& a, const Measured& b) {
            if (by_time && a.error != b.error) return a.error < b.error;
            return a.cost(budget_.frames) < b.cost(budget_.frames);
        });
        std::vector<double> expected;
        for (const Measured& one : found) expected.push_back(one.cost(budget_.frames));
        std::vector<Measured> fitting;
        std::optional<Measured> fastest;
        for (std::size_t i = 0, last = found.size(); i < last; ++i) {
            job.checkpoint(i, found.size());
            const auto whole = fits(found[i], truth, by_time);
            if (whole && (!fastest || whole->ms < fastest->ms)) fastest = whole;
            if (!whole || (budget_.time_ms && !(whole->ms <= *budget_.time_ms))) continue;
            if (by_time) return chosen(*whole, true);
            if (fitting.empty()) last = i + finalists(expected, i);
            fitting.push_back(*whole);
        }
        if (!fitting.empty()) return chosen(fastest_of(std::move(fitting), job), true);
        if (fastest) return chosen(*fastest, !budget_.time_ms);
        // Brute force keeps every error budget.
        auto brute = measure(scene_, brute_, truth);
        if (!brute) throw Error(Errc::device, "Brute force could not be drawn on this device; choose another one.");
        return chosen(*brute, !budget_.time_ms || brute->ms <= *budget_.time_ms);
    }

    /// A candidate drawn whole, if it keeps the error budget there; why not, or why it misses the time, is noted.
    std::optional<Measured> fits(const Measured& candidate, const TruePicture& truth, bool by_time) {
        if (by_time && candidate.plan.plan.sparse == 0 && candidate.ms > 1.5 * *budget_.time_ms) {
            refuse(candidate.plan,
                   fmt::format("about {:.3g} ms a frame; the budget is {:.3g} ms.", candidate.ms, *budget_.time_ms));
            return std::nullopt;
        }
        auto whole = measure(scene_, candidate.plan, truth);
        if (!whole) return std::nullopt;
        whole->build_ms = std::max(whole->build_ms, candidate.build_ms);  // the probe built it
        if (!within_error(*whole, 1)) {
            refuse(candidate.plan, fmt::format("{:.3g}/255 off in the whole view; the budget is {:.3g}/255.",
                                               whole->error, *budget_.error));
            return std::nullopt;
        }
        if (budget_.time_ms && !(whole->ms <= *budget_.time_ms))
            refuse(candidate.plan,
                   fmt::format("{:.3g} ms for the whole view; the budget is {:.3g} ms.", whole->ms, *budget_.time_ms));
        return whole;
    }

    /// Times plans in turn, so that a machine whose speed wanders favours none.
    Measured fastest_of(std::vector<Measured> plans, const JobContext& job) {
        if (plans.size() == 1) return plans.front();
        std::vector<std::vector<double>> times(plans.size());
        for (int round = 0; round < k_rounds; ++round)
            for (std::size_t i = 0; i < plans.size(); ++i) {
                const std::size_t at = round % 2 ? plans.size() - 1 - i : i;
                times[at].push_back(engine_.render(scene_, plans[at].plan.plan, {job.stop}).frame.ms);
            }
        std::size_t best = 0;
        for (std::size_t i = 0; i < plans.size(); ++i) {
            std::sort(times[i].begin(), times[i].end());
            plans[i].ms = times[i][times[i].size() / 2];
            if (plans[i].cost(budget_.frames) < plans[best].cost(budget_.frames)) best = i;
        }
        for (std::size_t i = 0; i < plans.size(); ++i)
            if (i != best)
                refuse(plans[i].plan, fmt::format("{:.3g} ms a frame; the plan taken needs {:.3g} ms, timed in turn.",
                                                  plans[i].ms, plans[best].ms));
        return plans[best];
    }

    PlannedPlan chosen(const Measured& measured, bool meets) {
        PlannedPlan made{measured.plan.plan, measured.error, measured.ms, meets};
        const std::string words = difference_in_words(measured.plan, brute_);
        std::string asked;
        if (budget_.error) asked += fmt::format("error budget {:.3g}/255", *budget_.error);
        if (budget_.time_ms)
            asked += fmt::format("{}time budget {:.3g} ms", asked.empty() ? "" : ", ", *budget_.time_ms);
        made.plan.why = {fmt::format(
            "{}{}{}: {:.3g}/255 from brute force over the whole view and {:.3g} ms a frame, both "
            "measured ({}).",
            name_of(made.plan.structure), words.empty() ? "" : ", ", words, measured.error, measured.ms, asked)};
        if (!meets) made.plan.why.push_back("No plan tried fits the time budget; this is the fastest.");
        const std::string fails = refused_by_limits(facts_, scene_, made.plan, brute_.plan, 0);
        if (!fails.empty()) made.plan.why.push_back("In other views than this " + fails);
        made.plan.why.insert(made.plan.why.end(), refused_.begin(), refused_.end());
        return made;
    }

    Engine& engine_;
    const Scene& scene_;
    const Budget& budget_;
    const JobContext& job_;
    ModePlan brute_;
    std::optional<ViewFacts> view_facts_;  ///< where the device's costs are known
    Scene probe_;
    double share_ = 1;  ///< of the view's rays in the probe picture
    SceneFacts facts_;
    std::optional<TruePicture> truth_;
    std::vector<std::string> refused_;
};

}  // namespace

PlannedPlan choose_plan(Engine& engine, const Scene& scene, const Budget& budget, const JobContext& job) {
    if (!budget.error && !budget.time_ms) throw Error(Errc::bad_usage, "Planning needs an error or a time budget.");
    if (budget.error && !(*budget.error >= 0)) throw Error(Errc::bad_usage, "The error budget must be at least 0.");
    if (budget.time_ms && !(*budget.time_ms > 0)) throw Error(Errc::bad_usage, "The time budget must be above 0.");
    if (budget.frames < 1) throw Error(Errc::bad_usage, "At least one frame must be expected.");
    check(scene);
    if (scene.mode == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "Shear-warp has one plan; a budget goes with the modes that cast rays.");
    return Planner(engine, scene, budget, job).run();
}

}  // namespace lacuna
