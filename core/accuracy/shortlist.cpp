#include "core/accuracy/shortlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr std::int64_t k_fine_cells_voxels = std::int64_t(1) << 25;  // beyond, cells of 4^3 leave the caches
constexpr double k_default_ert = 0.002;

bool serves(const Plan& plan, const Scene& scene) {
    try {
        check(plan, scene);
        return true;
    } catch (const Error&) {
        return false;
    }
}

bool over_cells(Structure structure) {
    return structure == Structure::pc || structure == Structure::acd || structure == Structure::eacd;
}

}  // namespace

double rounded_down(double value) {
    if (!(value > 0)) return 0;
    const double scale = std::pow(10, 2 - std::floor(std::log10(value)));
    return std::floor(value * scale * (1 - 1e-9)) / scale;
}

std::vector<ModePlan> lossless_plans(const Scene& scene, const ModePlan& brute) {
    std::vector<ModePlan> plans;
    const bool fine = !scene.volume.empty() && scene.volume.geometry().voxel_count() <= k_fine_cells_voxels;
    for (const auto& [structure, name] : structure_names())
        for (const int cells : {4, 8}) {
            ModePlan plan = brute;
            plan.plan.structure = structure;
            if (over_cells(structure))
                plan.plan.cells = cells;
            else if (cells != 8)
                continue;
            if (over_cells(structure) && cells == 4 && !fine) continue;
            if (serves(plan.plan, scene)) plans.push_back(std::move(plan));
        }
    return plans;
}

std::vector<ModePlan> trades(const Scene& scene, const ModePlan& exact, const std::optional<double>& error) {
    std::vector<ModePlan> plans;
    const auto add = [&](const ModePlan& plan) {
        if (serves(plan.plan, scene)) plans.push_back(plan);
    };
    std::vector<double> ends{0};
    if (scene.mode == ViewMode::ea && error) {
        // By rule no more is hidden than the budget; with another loss beside it a quarter of that.
        const double whole = rounded_down(std::min(0.5, *error / hidden_levels(1, scene.shading)));
        if (whole > 0) ends = {whole, rounded_down(whole / 4), 0};
    } else if (scene.mode == ViewMode::ea) {
        ends = {0, k_default_ert, 0.01, 0.05};
    }
    for (const double factor : {1.0, 1.5, 2.0, 3.0})
        for (const auto& [sampler, name] : sampler_names())
            for (const double ert : ends) {
                const bool lossless = factor == 1 && sampler != Sampler::nearest;
                if (lossless && ert == 0 && sampler == exact.plan.sampler) continue;  // that is `exact`
                if (error && ends.size() == 3 && ert != (lossless ? ends[0] : ends[1])) continue;
                ModePlan plan = exact;
                plan.plan.ert = ert, plan.plan.step = factor * exact.plan.step, plan.plan.sampler = sampler;
                add(plan);
            }
    // Segments keep peaks of the transfer function that longer steps would miss.
    for (const double factor : {2.0, 3.0}) {
        ModePlan plan = exact;
        plan.plan.ert = error && ends.size() == 3 ? ends[1] : ends.back();
        plan.plan.step = factor * exact.plan.step;
        plan.plan.integration = Integration::preintegrated;
        add(plan);
    }
    if (scene.mode == ViewMode::iso)
        for (const auto& [refine, steps] : {std::pair(exact.plan.refine, 2), {Refinement::none, 0}}) {
            ModePlan plan = exact;
            plan.plan.refine = refine, plan.plan.refine_steps = steps;
            add(plan);
        }
    return plans;
}

std::vector<std::string> leave_out(const std::vector<Outlook>& outlooks) {
    const Outlook* best = nullptr;
    for (const Outlook& one : outlooks)
        if (one.ms && !std::isnan(*one.ms) && (!best || *one.ms < *best->ms)) best = &one;
    std::vector<std::string> reasons(outlooks.size());
    for (std::size_t i = 0; i < outlooks.size(); ++i)
        if (best && outlooks[i].ms && !(*outlooks[i].ms <= k_hopeless * *best->ms))
            reasons[i] =
                fmt::format("about {:.3g} ms a frame by this device's costs, {} about {:.3g} ms; not measured.",
                            *outlooks[i].ms, name_of(best->plan.plan.structure), *best->ms);
    return reasons;
}

std::string off_already(const ModePlan& plan, const std::vector<TooFarOff>& measured) {
    const Plan& p = plan.plan;
    for (const TooFarOff& other : measured) {
        const Plan& q = other.plan.plan;
        ModePlan alike = other.plan;
        alike.plan.step = p.step;
        alike.plan.ert = p.ert;
        alike.plan.why = p.why;
        if (q.step <= p.step && q.ert <= p.ert && to_json(alike) == to_json(plan))
            return fmt::format("step {:g} with ert {:g} is {:.3g}/255 off already; not measured.", q.step, q.ert,
                               other.error);
    }
    return "";
}

bool worth_a_trial(double expected_ms, double best_ms, std::size_t fitting) {
    return fitting < k_finalists && expected_ms <= k_close * best_ms;
}

std::vector<bool> still_in(const std::vector<double>& ms) {
    const double fastest = ms.empty() ? 0 : *std::min_element(ms.begin(), ms.end());
    std::vector<bool> in;
    for (const double one : ms) in.push_back(one <= k_tie * fastest);
    return in;
}

}  // namespace lacuna
