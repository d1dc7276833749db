#include "core/accuracy/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/accuracy/limits.h"
#include "core/accuracy/shortlist.h"
#include "core/accuracy/sparse_outlook.h"
#include "core/base/order_statistics.h"
#include "core/base/stopwatch.h"

namespace lacuna {

namespace {

constexpr int k_probe = 4;          // a probe picture is so many times narrower and lower
constexpr int k_least_pixels = 64;  // of its sides, where the picture has them
constexpr int k_timings = 3;
constexpr int k_fact_rays = 1500;
constexpr int k_rounds = 7, k_first_rounds = 3;  // in which finalists are timed in turn; the close ones go on
constexpr double k_race_ms = 1500;               // after which no further round begins
constexpr double k_worth = 0.9;                  // sparse casting must promise to be so much faster
constexpr double k_base = 1.3;                   // structures within this factor of the best go on
constexpr std::size_t k_bases = 3;
constexpr int k_most_drawn = 12;   // candidates drawn whole before only those without loss are
constexpr int k_checked_more = 3;  // of other views to come, so many are measured

/// What a candidate came to.
struct Measured {
    ModePlan plan;
    double ms = 0, build_ms = 0, error = 0;
    double cost(int frames) const { return ms + build_ms / frames; }
};

/// A picture to draw, and brute force's of it.
struct View {
    Scene scene;
    TruePicture truth;
};

class Planner {
public:
    Planner(Engine& engine, const Scene& scene, const Budget& budget, const JobContext& job)
        : engine_(engine), scene_(scene), budget_(budget), job_(job) {
        brute_ = {scene.mode, brute_force(scene, budget.step)};
        brute_.plan.why.clear();
    }

    PlannedPlan run() {
        facts_ = measure_facts(scene_, {job_.stop});
        if (budget_.costs && scene_.volume.in_memory())
            view_facts_ = measure_view_facts(scene_, budget_.step, k_fact_rays, {job_.stop});
        draw_truths(job_.part(0, 0.1));
        std::vector<Measured> found = best_structures(job_.part(0.1, 0.4));
        const std::size_t bases = found.size();
        measure_trades(found, job_.part(0.4, 0.6));
        add_on_other_structures(found, bases);
        if (!by_rule()) add_sparse(found);
        return by_time() ? most_exact(std::move(found), job_.part(0.6, 1))
                         : fastest(std::move(found), job_.part(0.6, 1));
    }

private:
    bool by_time() const { return budget_.time_ms && !budget_.error; }
    /// A promise for views that nobody measures rests on rules alone.
    bool by_rule() const { return budget_.error && !budget_.other_views.empty(); }

    void refuse(const ModePlan& plan, const std::string& why) {
        const std::string words = difference_in_words(plan, brute_);
        refused_.push_back(
            fmt::format("Refused {}{}{}: {}", name_of(plan.plan.structure), words.empty() ? "" : ", ", words, why));
    }

    /// A promise of an error is not given for a method that fails on the scene, whatever this view shows of it; nor,
    /// for views to come, for one whose error only measuring tells.
    bool refused_beforehand(const ModePlan& plan) {
        if (!budget_.error) return false;
        std::string why = refused_by_limits(facts_, scene_, plan.plan, brute_.plan, *budget_.error);
        if (why.empty() && by_rule()) {
            const ErrorBound bound = known_bound(plan.plan, scene_, brute_.plan);
            const bool known = bound.known == ErrorKnown::exact ||
                               (bound.known == ErrorKnown::bounded && bound.levels <= *budget_.error);
            if (!known)
                why = fmt::format("how far off it is only a drawn view tells, and {} more are to come.",
                                  budget_.other_views.size());
        }
        if (!why.empty()) refuse(plan, why);
        return !why.empty();
    }

    void draw_truths(const JobContext& job) {
        const auto add = [&](const Camera& camera) {
            Scene scene = scene_;
            scene.camera = camera;
            Frame brute = engine_.render(scene, brute_.plan, {job.stop}).frame;
            views_.push_back({std::move(scene), TruePicture(std::move(brute), scene_.background)});
        };
        add(scene_.camera);
        const std::size_t others = budget_.other_views.size();
        const std::size_t more = std::min(others, std::size_t(k_checked_more));
        for (std::size_t i = 1; i <= more; ++i) {
            job.checkpoint(i, more + 1);
            add(budget_.other_views[i * (others + 1) / (more + 1) - 1]);
        }
        Scene small = scene_;
        small.size = glm::max(scene_.size / k_probe, glm::min(scene_.size, glm::ivec2(k_least_pixels)));
        share_ = double(small.size.x) * small.size.y / (double(scene_.size.x) * scene_.size.y);
        Frame brute = engine_.render(small, brute_.plan, {job.stop}).frame;
        probe_.push_back({std::move(small), TruePicture(std::move(brute), scene_.background)});
    }

    /// Draws the views, then warm; the largest error and the slowest view's time. A plan too far off is not timed.
    std::optional<Measured> measure(const std::deque<View>& views, const ModePlan& plan, int timings) {
        Measured made{plan};
        try {
            for (const View& view : views) {
                const RenderResult first = engine_.render(view.scene, plan.plan, {job_.stop});
                for (const auto& [name, build] : first.build) made.build_ms += build.ms;
                made.error = std::max(made.error, view.truth.largest(first.frame));
                double ms = first.frame.ms;
                if (within_error(made) && timings > 0) ms = median(times_of(view.scene, plan.plan, timings));
                made.ms = std::max(made.ms, ms);
            }
        } catch (const Error& error) {
            if (error.code() == Errc::cancelled) throw;
            refuse(plan, error.what());
            return std::nullopt;
        }
        return made;
    }

    std::vector<double> times_of(const Scene& scene, const Plan& plan, int timings) {
        std::vector<double> times;
        for (int i = 0; i < timings; ++i) times.push_back(engine_.render(scene, plan, {job_.stop}).frame.ms);
        return times;
    }

    std::optional<Measured> probe(const ModePlan& plan) {
        std::optional<Measured> made = measure(probe_, plan, k_timings);
        if (made) made->ms /= share_;
        return made;
    }

    std::optional<double> predicted(const Plan& plan) const {
        return view_facts_ ? predicted_ms(*budget_.costs, *view_facts_, scene_, plan, budget_.step) : std::nullopt;
    }

    double cost(const Measured& m) const { return m.cost(budget_.frames); }
    bool within_error(const Measured& m) const { return !budget_.error || m.error <= *budget_.error; }  // NaN is not

    /// The structures that cost least over the expected frames, without loss, the cheapest first.
    std::vector<Measured> best_structures(const JobContext& job) {
        std::vector<Outlook> outlooks;
        for (ModePlan& plan : lossless_plans(scene_, brute_)) {
            const std::optional<double> ms = predicted(plan.plan);
            outlooks.push_back({std::move(plan), ms});
        }
        const std::vector<std::string> reasons = leave_out(outlooks);
        std::vector<Measured> found;
        for (std::size_t i = 0; i < outlooks.size(); ++i) {
            job.checkpoint(i, outlooks.size());
            if (!reasons[i].empty())
                refuse(outlooks[i].plan, reasons[i]);
            else if (auto made = measure(probe_, outlooks[i].plan, 0))
                found.push_back(*made);
        }
        time_in_turn(found, probe_, k_timings, nullptr);
        for (Measured& one : found) one.ms /= share_;
        if (found.empty()) throw Error(Errc::device, "No plan could be drawn on this device; choose another one.");
        std::stable_sort(found.begin(), found.end(),
                         [&](const Measured& a, const Measured& b) { return cost(a) < cost(b); });
        const Measured best = found.front();
        std::size_t kept = 1;
        while (kept < found.size() && kept < k_bases && cost(found[kept]) <= k_base * cost(best)) ++kept;
        for (std::size_t i = kept; i < found.size(); ++i)
            refuse(found[i].plan,
                   fmt::format("about {:.3g} ms a frame and {:.3g} ms to build; {} takes {:.3g} ms and {:.3g} ms over "
                               "{} frames.",
                               found[i].ms, found[i].build_ms, name_of(best.plan.plan.structure), best.ms,
                               best.build_ms, budget_.frames));
        found.resize(kept);
        return found;
    }

    /// Adds what the cheapest structure's plan may be traded for, as far as a small picture speaks for it.
    void measure_trades(std::vector<Measured>& found, const JobContext& job) {
        const Measured exact = found.front();
        const std::vector<ModePlan> plans = trades(scene_, exact.plan, budget_.error);
        const double rays = double(probe_[0].scene.size.x) * probe_[0].scene.size.y;
        measure(probe_, exact.plan, 0);  // another one of its kind may have taken its structure's place
        std::vector<TooFarOff> off;
        std::size_t done = 0;
        for (const ModePlan& plan : plans) {
            job.checkpoint(done++, plans.size());
            if (refused_beforehand(plan)) continue;
            if (const std::string reason = off_already(plan, off); !reason.empty()) {
                refuse(plan, reason);
                continue;
            }
            auto made = probe(plan);
            if (!made) continue;
            made->build_ms += exact.build_ms;  // its structure was there already
            if (!within_error(*made)) {
                off.push_back({plan, made->error});
                refuse(plan, fmt::format("{:.3g}/255 off on {:.0f} rays of this view; the budget is {:.3g}/255.",
                                         made->error, rays, *budget_.error));
            } else if (budget_.error && made->ms >= k_tie * exact.ms) {
                refuse(plan, fmt::format("about {:.3g} ms a frame, no faster than without loss ({:.3g} ms).", made->ms,
                                         exact.ms));
            } else {
                found.push_back(*made);
            }
        }
    }

    /// The fastest trade, on the other structures that are about as fast as the one it was measured on.
    void add_on_other_structures(std::vector<Measured>& found, std::size_t bases) const {
        if (found.size() == bases || bases < 2) return;
        const auto faster = [](const Measured& a, const Measured& b) { return a.ms < b.ms; };
        const Measured best = *std::min_element(found.begin() + std::ptrdiff_t(bases), found.end(), faster);
        for (std::size_t i = 1; i < bases; ++i) {
            Measured other = best;
            other.plan.plan.structure = found[i].plan.plan.structure;
            other.plan.plan.cells = found[i].plan.plan.cells;
            other.ms *= found[i].ms / found[0].ms;
            other.build_ms += found[i].build_ms - found[0].build_ms;
            try {
                check(other.plan.plan, scene_);
                found.push_back(std::move(other));
            } catch (const Error&) {  // segments and some structures do not go together
            }
        }
    }

    /// Sparse casting depends on the pixels' size, so no smaller picture tells of it; the whole brute-force picture
    /// tells how many rays it casts and how far off it is. Added to the fastest plan without loss and with any.
    void add_sparse(std::vector<Measured>& found) {
        const auto faster = [](const Measured& a, const Measured& b) { return a.ms < b.ms; };
        std::vector<Measured> bases{found.front()};
        const Measured fastest = *std::min_element(found.begin(), found.end(), faster);
        if (to_json(fastest.plan) != to_json(bases.front().plan)) bases.push_back(fastest);
        const Scene& scene = views_[0].scene;
        const double pixel_mm = resolve(scene.camera, scene.volume.geometry(), scene.size).pixel_mm;
        const double pixels = double(scene.size.x) * scene.size.y;
        const DeviceCosts costs = budget_.costs.value_or(DeviceCosts{});
        for (const int k : {2, 3, 4, 8}) {
            const SparseOutlook outlook(views_[0].truth.frame(), scene.background, k, pixel_mm);
            for (const Measured& base : bases) {
                Measured sparse = base;
                sparse.plan.plan.sparse = k;
                const double gradient =
                    budget_.error ? rounded_down(outlook.widest(*budget_.error - base.error)) : Plan{}.sparse_gradient;
                if (!(gradient > 0)) {
                    refuse(sparse.plan, fmt::format("what it interpolates is over {:.3g}/255 off for any gradient.",
                                                    *budget_.error - base.error));
                    continue;
                }
                sparse.plan.plan.sparse_gradient = gradient;
                if (refused_beforehand(sparse.plan)) continue;
                sparse.ms = predicted_sparse_ms(costs, pixels, outlook.share(gradient), base.ms);
                sparse.error = base.error + outlook.error(gradient);
                if (sparse.ms < k_worth * base.ms)
                    found.push_back(sparse);
                else
                    refuse(sparse.plan,
                           fmt::format("it would cast {:.0f} % of the rays and take about {:.3g} ms a frame, "
                                       "{:.3g} ms without.",
                                       100 * outlook.share(gradient), sparse.ms, base.ms));
            }
        }
    }

    /// A candidate drawn whole, if it keeps the error budget there; else the reason is noted.
    std::optional<Measured> drawn(const Measured& candidate, int timings) {
        auto whole = measure(views_, candidate.plan, timings);
        if (!whole) return std::nullopt;
        whole->build_ms = std::max(whole->build_ms, candidate.build_ms);  // the probe built it
        if (within_error(*whole)) return whole;
        refuse(candidate.plan, fmt::format("{:.3g}/255 off in the whole view; the budget is {:.3g}/255.", whole->error,
                                           *budget_.error));
        return std::nullopt;
    }

    /// Of the candidates that keep the error budget the fastest: drawn whole in the order in which they are expected to
    /// be, as long as one may be faster than those that fit, which are then timed in turn.
    PlannedPlan fastest(std::vector<Measured> found, const JobContext& job) {
        std::stable_sort(found.begin(), found.end(),
                         [&](const Measured& a, const Measured& b) { return cost(a) < cost(b); });
        std::vector<Measured> fitting;
        double best = std::numeric_limits<double>::infinity();
        int tried = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            job.part(0, 0.5).checkpoint(i, found.size());
            const Measured& candidate = found[i];
            if (!worth_a_trial(cost(candidate), best, fitting.size())) {
                refuse(candidate.plan, fmt::format("about {:.3g} ms a frame expected; others that fit take {:.3g} ms.",
                                                   candidate.ms, best));
                continue;
            }
            const bool without_loss = losses(candidate.plan.plan, scene_, brute_.plan).empty();
            if (fitting.empty() && tried >= k_most_drawn && !without_loss) {
                refuse(candidate.plan, fmt::format("{} faster ones did not keep the budget; not drawn.", tried));
                continue;
            }
            ++tried;
            if (const auto whole = drawn(candidate, 1)) {
                fitting.push_back(*whole);
                best = std::min(best, cost(*whole));
            }
        }
        if (fitting.empty()) {  // brute force keeps every error budget
            const auto brute = measure(views_, brute_, k_timings);
            if (!brute) throw Error(Errc::device, "Brute force could not be drawn on this device; choose another one.");
            fitting.push_back(*brute);
        }
        const Measured taken = race(std::move(fitting), job.part(0.5, 1));
        return chosen(taken, !budget_.time_ms || taken.ms <= *budget_.time_ms);
    }

    /// Times plans in turn, forth and back, so that a machine whose speed wanders favours none: a plan's time is the
    /// median over the rounds, of the slowest view. @param go_on  asked after each round who goes on; null: all do
    void time_in_turn(std::vector<Measured>& plans, const std::deque<View>& views, int rounds,
                      const std::function<std::vector<bool>(int round)>& go_on) {
        std::vector<std::vector<std::vector<double>>> times(plans.size(),
                                                            std::vector<std::vector<double>>(views.size()));
        std::vector<bool> in(plans.size(), true);
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < plans.size(); ++i) {
                const std::size_t at = round % 2 ? plans.size() - 1 - i : i;
                for (std::size_t view = 0; in[at] && view < views.size(); ++view)
                    times[at][view].push_back(
                        engine_.render(views[view].scene, plans[at].plan.plan, {job_.stop}).frame.ms);
            }
            for (std::size_t i = 0; i < plans.size(); ++i) {
                plans[i].ms = 0;
                for (const std::vector<double>& of_view : times[i])
                    plans[i].ms = std::max(plans[i].ms, median(of_view));
            }
            if (go_on) in = go_on(round);
        }
    }

    /// The fastest of those that fit; those left behind after some rounds drop out.
    Measured race(std::vector<Measured> plans, const JobContext& job) {
        if (plans.size() == 1) return plans.front();
        const Stopwatch watch;
        std::vector<bool> in(plans.size(), true);
        time_in_turn(plans, views_, k_rounds, [&](int round) {
            job.checkpoint(std::size_t(round) + 1, k_rounds);
            if (round + 1 < k_first_rounds) return in;
            std::vector<double> costs;
            for (const Measured& plan : plans) costs.push_back(cost(plan));
            in = still_in(costs);
            const bool over = watch.ms() > k_race_ms || std::count(in.begin(), in.end(), true) == 1;
            return over ? std::vector<bool>(plans.size()) : in;
        });
        std::size_t best = plans.size();
        for (std::size_t i = 0; i < plans.size(); ++i)
            if (in[i] && (best == plans.size() || cost(plans[i]) < cost(plans[best]))) best = i;
        for (std::size_t i = 0; i < plans.size(); ++i)
            if (i != best)
                refuse(plans[i].plan, fmt::format("{:.3g} ms a frame; the plan taken needs {:.3g} ms, timed in turn.",
                                                  plans[i].ms, plans[best].ms));
        return plans[best];
    }

    /// Of the candidates that draw a frame in time the most exact: drawn whole in the order of what small pictures say
    /// of their error, as long as one may be more exact than what fits.
    PlannedPlan most_exact(std::vector<Measured> found, const JobContext& job) {
        const double limit = *budget_.time_ms;
        std::stable_sort(found.begin(), found.end(), [&](const Measured& a, const Measured& b) {
            return a.error != b.error ? a.error < b.error : cost(a) < cost(b);
        });
        std::optional<Measured> best, fastest;
        for (std::size_t i = 0; i < found.size(); ++i) {
            job.checkpoint(i, found.size());
            const Measured& candidate = found[i];
            if (best && !(candidate.error < best->error)) {
                refuse(candidate.plan, fmt::format("about {:.3g}/255 off expected; the plan taken is {:.3g}/255 off.",
                                                   candidate.error, best->error));
                continue;
            }
            if (candidate.ms > k_close * limit) {
                refuse(candidate.plan,
                       fmt::format("about {:.3g} ms a frame; the budget is {:.3g} ms.", candidate.ms, limit));
                continue;
            }
            const auto whole = drawn(candidate, k_timings);
            if (!whole) continue;
            if (!fastest || whole->ms < fastest->ms) fastest = whole;
            if (!(whole->ms <= limit)) {
                refuse(candidate.plan,
                       fmt::format("{:.3g} ms for the whole view; the budget is {:.3g} ms.", whole->ms, limit));
                continue;
            }
            const bool better = !best || whole->error < best->error;
            if (best)
                refuse(better ? best->plan : whole->plan,
                       fmt::format("{:.3g}/255 off; the plan taken is {:.3g}/255 off.",
                                   better ? best->error : whole->error, better ? whole->error : best->error));
            if (better) best = whole;
        }
        if (best) return chosen(*best, true);
        const Measured& quickest = *std::min_element(found.begin(), found.end(),
                                                     [](const Measured& a, const Measured& b) { return a.ms < b.ms; });
        const auto last = measure(views_, quickest.plan, k_timings);
        if (last && (!fastest || last->ms < fastest->ms)) fastest = last;
        if (!fastest) throw Error(Errc::device, "No plan could be drawn on this device; choose another one.");
        return chosen(*fastest, fastest->ms <= limit);
    }

    std::string asked() const {
        std::string words;
        if (budget_.error) words += fmt::format("error budget {:.3g}/255", *budget_.error);
        if (budget_.time_ms)
            words += fmt::format("{}time budget {:.3g} ms", words.empty() ? "" : ", ", *budget_.time_ms);
        return words;
    }

    /// What holds for the views that follow.
    std::string about_other_views(const Plan& plan) const {
        const std::size_t all = budget_.other_views.size() + 1;
        if (!by_rule())
            return fmt::format("Measured in {} of {} views, the worst of them counts; the others may differ.",
                               views_.size(), all);
        const ErrorBound bound = known_bound(plan, scene_, brute_.plan);
        return fmt::format(
            "Holds in all {} views by rule ({}), and was measured in {} of them.", all,
            bound.known == ErrorKnown::exact
                ? std::string("the same samples as brute force are taken in any")
                : fmt::format("rays end where at most {:.3g} of 255 levels are hidden, in any", bound.levels),
            views_.size());
    }

    PlannedPlan chosen(const Measured& measured, bool meets) {
        PlannedPlan made{measured.plan.plan, measured.error, measured.ms, meets};
        const std::string words = difference_in_words(measured.plan, brute_);
        made.plan.why = {fmt::format(
            "{}{}{}: {:.3g}/255 from brute force over the whole view and {:.3g} ms a frame, both "
            "measured ({}).",
            name_of(made.plan.structure), words.empty() ? "" : ", ", words, measured.error, measured.ms, asked())};
        if (!budget_.other_views.empty()) made.plan.why.push_back(about_other_views(made.plan));
        if (!meets) made.plan.why.push_back("No plan tried fits the time budget; this is the fastest.");
        // For an error budget such a plan was refused.
        const std::string fails = budget_.error ? "" : refused_by_limits(facts_, scene_, made.plan, brute_.plan, 0);
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
    std::deque<View> views_;               ///< the scene's, then some of the other ones
    std::deque<View> probe_;               ///< the scene's, small
    double share_ = 1;                     ///< of the view's rays in the probe picture
    SceneFacts facts_;
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
