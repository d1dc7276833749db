#include "core/accuracy/candidates.h"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

namespace lacuna {

namespace {

using nlohmann::ordered_json;

/// Collects candidates, each once.
class Collector {
public:
    explicit Collector(const Scene& scene) : scene_(scene) {}

    /// Adds a plan that can serve; @return why it cannot, "" when it can.
    std::string add(ModePlan plan) {
        plan.plan.why.clear();
        if (plan.mode != ViewMode::ea) plan.plan.ert = 0;  // the others end no ray early
        Scene shown = scene_;
        shown.mode = plan.mode;
        try {
            check(shown);
            check(plan.plan, shown);
        } catch (const Error& error) {
            return error.what();
        }
        if (seen_.insert(to_json(plan)).second) found.push_back({std::move(plan), ""});
        return "";
    }

    /// A plan changed in one way.
    template <class Value>
    void vary(const ModePlan& from, Value Plan::*member, const std::vector<Value>& values) {
        for (const Value& value : values) {
            ModePlan changed = from;
            changed.plan.*member = value;
            add(std::move(changed));
        }
    }

    std::vector<Candidate> found;

private:
    const Scene& scene_;
    std::set<std::string> seen_;
};

/// Structures that derive runs of like values from the classification, and so know thresholds.
bool knows_thresholds(Structure structure, ViewMode mode) {
    return mode == ViewMode::ea && structure != Structure::none && structure != Structure::macrocells &&
           structure != Structure::pyramid && structure != Structure::visible;
}

bool has_cells(Structure structure) {
    return structure == Structure::pc || structure == Structure::acd || structure == Structure::eacd;
}

void vary_fully(Collector& all, const ModePlan& base, double step) {
    const ViewMode mode = base.mode;
    const Structure structure = base.plan.structure;
    for (const auto& [sampler, name] : sampler_names()) {
        ModePlan other = base;
        other.plan.sampler = sampler;
        all.add(other);
        for (const double factor : {1.5, 2.0, 3.0, 4.0}) {
            other.plan.step = step * factor;
            all.add(other);
        }
    }
    if (mode == ViewMode::ea) all.vary(base, &Plan::ert, {0.0, 0.002, 0.01, 0.05});
    all.vary(base, &Plan::sparse, {2, 3, 4, 8});
    for (const int k : {4, 8}) {
        ModePlan aware = base;
        aware.plan.sparse = k;
        aware.plan.sparse_aware = true;
        all.add(aware);
    }
    for (const double factor : {1.0, 2.0, 3.0, 4.0}) {
        ModePlan segments = base;
        segments.plan.integration = Integration::preintegrated;
        segments.plan.step = factor * step;
        all.add(segments);
    }
    all.vary(base, &Plan::gradient_store, {GradientStore::stored});
    if (knows_thresholds(structure, mode)) {
        for (const double threshold : {0.002, 0.01, 0.05}) {
            ModePlan other = base;
            other.plan.homogeneity = threshold;
            other.plan.homogeneity_angle_deg = 10;
            other.plan.cells = has_cells(structure) ? 1 : other.plan.cells;
            all.add(other);
        }
    }
    if (has_cells(structure)) all.vary(base, &Plan::cells, {4, 16, 1});
    if (mode == ViewMode::iso && structure == Structure::acd)
        for (const auto& [refinement, name] : refinement_names())
            for (const int steps : {2, 5}) {
                ModePlan other = base;
                other.plan.refine = refinement;
                other.plan.refine_steps = steps;
                all.add(other);
                other.plan.step = 2 * step;
                all.add(other);
            }
    // What goes well together.
    ModePlan fast = base;
    fast.plan.step = 2 * step;
    fast.plan.sparse = 2;
    all.add(fast);
    fast.plan.sampler = Sampler::nearest;
    all.add(fast);
}

/// Shear-warp casts no rays: its samplers, regions of directions and normals are its own.
void vary_shear_warp(Collector& all, const ModePlan& base) {
    for (const auto& [sampler, name] : sampler_names()) {
        ModePlan other = base;
        other.plan.sampler = sampler;
        all.vary(other, &Plan::directions, {6, 24});
        if (sampler != Sampler::nearest) continue;
        for (const auto& [filter, filter_name] : voxel_gradient_names()) {
            other.plan.voxel_gradient = filter;
            all.add(other);
        }
    }
}

void vary_quickly(Collector& all, const ModePlan& base, double step) {
    if (base.mode == ViewMode::ea) all.vary(base, &Plan::ert, {0.0, 0.02});
    all.vary(base, &Plan::step, {1.5 * step, 2 * step, 4 * step});
    for (const auto& [sampler, name] : sampler_names()) all.vary(base, &Plan::sampler, {sampler});
    all.vary(base, &Plan::sparse, {2, 4});
    ModePlan segments = base;
    segments.plan.integration = Integration::preintegrated;
    segments.plan.step = 2 * step;
    all.add(segments);
}

}  // namespace

std::vector<Candidate> candidates(const Scene& scene, double step, SweepExtent extent) {
    Collector all(scene);
    Plan usual = default_plan(scene);
    usual.step = step;
    all.add({scene.mode, reference_plan(scene, usual)});
    all.add({scene.mode, usual});  // early, for runs whose time is short
    // First each structure once and an example of each trade, then the rest, the usual structure's before others': a
    // run whose time is short measures what tells most.
    std::vector<Candidate> refused;
    std::vector<ModePlan> bases;
    for (const auto& [structure, name] : structure_names()) {
        ModePlan base{scene.mode, usual};
        base.plan.structure = structure;
        if (structure == Structure::visible && scene.mode == ViewMode::iso) {
            Scene warped = scene;
            warped.mode = base.mode = ViewMode::shear_warp;
            base.plan = default_plan(warped);
            base.plan.step = step;
        }
        if (std::string why = all.add(base); !why.empty()) {
            refused.push_back({std::move(base), std::move(why)});
            continue;
        }
        if (base.mode == ViewMode::shear_warp) all.vary(base, &Plan::sampler, {Sampler::nearest});
        bases.insert(structure == usual.structure ? bases.begin() : bases.end(), std::move(base));
    }
    if (scene.mode != ViewMode::shear_warp) vary_quickly(all, {scene.mode, usual}, step);
    if (extent == SweepExtent::full)
        for (const ModePlan& base : bases)
            base.mode == ViewMode::shear_warp ? vary_shear_warp(all, base) : vary_fully(all, base, step);
    for (Candidate& candidate : refused) {
        candidate.plan.plan.why.clear();
        all.found.push_back(std::move(candidate));
    }
    return std::move(all.found);
}

std::string difference_in_words(const ModePlan& plan, const ModePlan& reference) {
    const ordered_json ours = ordered_json::parse(to_json(plan)), theirs = ordered_json::parse(to_json(reference));
    std::string words;
    for (const auto& [key, value] : ours.items()) {
        if (key == "why" || key == "structure" || value.is_null() || (theirs.contains(key) && theirs[key] == value))
            continue;
        const bool of_shear_warp = key == "mode" || key == "sampler" || key == "directions" || key == "voxel_gradient";
        if (plan.mode == ViewMode::shear_warp && !of_shear_warp) continue;  // it casts no rays
        if (key == "leap") {  // of the kernels only what differs from the lossless one's says something
            const ordered_json kernel = value.value("kernel", ordered_json());
            if (kernel.is_string() && kernel != "lossless")
                words += (words.empty() ? "" : ", ") + ("kernel " + kernel.get<std::string>());
            continue;
        }
        if (key == "sparse_gradient" || (key == "refine_steps" && plan.plan.refine == Refinement::none)) continue;
        std::string name = key;
        for (char& c : name)
            if (c == '_') c = ' ';
        words += (words.empty() ? "" : ", ") + name + " " +
                 (value.is_string()   ? value.get<std::string>()
                  : value.is_number() ? fmt::format("{:g}", value.get<double>())
                                      : value.dump());
    }
    return words;
}

}  // namespace lacuna
