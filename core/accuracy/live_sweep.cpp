#include "core/accuracy/live_sweep.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr const char* k_pending = "Not measured yet.";

std::string identity(ModePlan plan) {
    plan.plan.why.clear();
    return to_json(plan);
}

double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    const double at = q * double(values.size() - 1);
    const auto i = std::size_t(at);
    return i + 1 < values.size() ? std::lerp(values[i], values[i + 1], at - double(i)) : values[i];
}

}  // namespace

LiveSweep::LiveSweep(const Scene& scene, double step, SweepExtent extent, const ModePlan& current) {
    const std::vector<Candidate> found = candidates(scene, step, extent);
    append(found.front().plan, "");
    append(current, "");
    for (const Candidate& candidate : found) append(candidate.plan, candidate.refused);
}

void LiveSweep::append(const ModePlan& plan, const std::string& refused) {
    if (find(plan)) return;
    SweepPoint& point = result_.points.emplace_back();
    point.plan = plan;
    point.plan.plan.why.clear();
    point.refused = refused.empty() ? k_pending : refused;
    times_.emplace_back();
    if (refused.empty())
        order_.push_back(result_.points.size() - 1);
    else
        impossible_.insert(result_.points.size() - 1);
}

std::optional<std::size_t> LiveSweep::next() const {
    if (order_.empty() || visits_ >= order_.size() * std::size_t(k_rounds)) return std::nullopt;
    const std::size_t round = visits_ / order_.size(), place = visits_ % order_.size();
    return order_[round % 2 ? order_.size() - 1 - place : place];
}

void LiveSweep::add(const Visit& visit) {
    const std::optional<std::size_t> at = next();
    if (!at) return;
    SweepPoint& point = result_.points[*at];
    if (!visit.refused.empty()) {
        point.refused = visit.refused;
        times_[*at].clear();
        impossible_.insert(*at);
        // Taken out of the round: what was visited of this round stays visited.
        const std::size_t round = visits_ / order_.size(), place = visits_ % order_.size();
        std::erase(order_, *at);
        visits_ = order_.empty() ? 0 : round * order_.size() + std::min(place, order_.size());
        mark_front(result_.points, FrontError::max);  // it may have stood there
        return;
    }
    if (times_[*at].empty()) {
        point.error = visit.error;
        point.build_ms = visit.build_ms;
        point.bytes = visit.bytes;
        point.refused.clear();
    }
    std::vector<double>& times = times_[*at];
    times.push_back(visit.ms);
    point.ms = quantile(times, 0.5);
    point.ms_low = quantile(times, 0.25);
    point.ms_high = quantile(times, 0.75);
    ++visits_;
    result_.rounds = int(visits_ / order_.size());
    mark_front(result_.points, FrontError::max);
}

void LiveSweep::include(const ModePlan& plan) {
    if (find(plan)) return;
    append(plan, "");
    // It is visited now; the rounds of the others begin where they were.
    const std::size_t added = order_.back(), before = order_.size() - 1;
    order_.pop_back();
    const std::size_t round = before == 0 ? 0 : visits_ / before, place = before == 0 ? 0 : visits_ % before;
    if (round == 0) {
        order_.insert(order_.begin() + std::ptrdiff_t(place), added);
        return;
    }
    // Later rounds: it is caught up with at the end of a first round that the others have had.
    order_.push_back(added);
    visits_ = before;
}

std::optional<std::size_t> LiveSweep::find(const ModePlan& plan) const {
    const std::string wanted = identity(plan);
    for (std::size_t i = 0; i < result_.points.size(); ++i)
        if (identity(result_.points[i].plan) == wanted) return i;
    return std::nullopt;
}

std::size_t LiveSweep::measured() const {
    return std::size_t(
        std::count_if(times_.begin(), times_.end(), [](const std::vector<double>& times) { return !times.empty(); }));
}

LiveSweep::Visit draw_visit(Engine& engine, const Scene& scene, const ModePlan& plan, const TruePicture* truth,
                            const JobContext& job) {
    LiveSweep::Visit visit;
    try {
        Scene shown = scene;
        shown.mode = plan.mode;
        const RenderResult first = engine.render(shown, plan.plan, {job.stop});
        for (const auto& [name, build] : first.build) {
            visit.build_ms += build.ms;
            visit.bytes += build.bytes;
        }
        if (truth) visit.error = truth->compare(first.frame);
        visit.ms = engine.render(shown, plan.plan, {job.stop}).frame.ms;
    } catch (const Error& error) {
        if (error.code() == Errc::cancelled) throw;
        visit.refused = error.what();
    }
    return visit;
}

}  // namespace lacuna
