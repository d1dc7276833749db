#include "core/render/plan_json.h"

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

namespace lacuna {

namespace {

using nlohmann::ordered_json;

constexpr const char* k_gradient = "central,on-the-fly";  // the one there is

ordered_json number_or_null(bool given, const ordered_json& value) { return given ? value : ordered_json(nullptr); }

[[noreturn]] void refuse(const std::string& where, const std::string& fault) {
    throw Error(Errc::bad_input, where + ": " + fault);
}

using Readers = std::map<std::string, std::function<void(const ordered_json&)>>;

/// One reader a key; a reader may throw what nlohmann or the name tables throw.
Readers readers_for(ModePlan& made) {
    Plan& plan = made.plan;
    const auto number = [](auto& target) {
        return [&target](const ordered_json& value) { target = value.get<std::decay_t<decltype(target)>>(); };
    };
    const auto number_or = [](auto& target) {  // null keeps the default
        return [&target](const ordered_json& value) {
            if (!value.is_null()) target = value.get<std::decay_t<decltype(target)>>();
        };
    };
    return {{"mode", [&](const ordered_json& v) { made.mode = parse_view_mode(v.get<std::string>()); }},
            {"structure", [&](const ordered_json& v) { plan.structure = parse_structure(v.get<std::string>()); }},
            {"step", number(plan.step)},
            {"sampler", [&](const ordered_json& v) { plan.sampler = parse_sampler(v.get<std::string>()); }},
            {"gradient",
             [](const ordered_json& v) {
                 if (v.get<std::string>() != k_gradient)
                     throw Error(Errc::bad_usage, "There is no gradient but 'central,on-the-fly'.");
             }},
            {"refine", [&](const ordered_json& v) { plan.refine = parse_refinement(v.get<std::string>()); }},
            {"refine_steps", number(plan.refine_steps)},
            {"ert", number(plan.ert)},
            {"sparse", number_or(plan.sparse)},
            {"sparse_gradient", number_or(plan.sparse_gradient)},
            {"cells", number(plan.cells)},
            {"directions", number(plan.directions)},
            {"voxel_gradient",
             [&](const ordered_json& v) { plan.voxel_gradient = parse_voxel_gradient(v.get<std::string>()); }},
            {"homogeneity", number(plan.homogeneity)},
            {"homogeneity_angle", number(plan.homogeneity_angle_deg)},
            {"brick", number_or(plan.brick)},
            {"why", [&](const ordered_json& v) { plan.why = v.get<std::vector<std::string>>(); }}};
}

}  // namespace

std::string to_json(const ModePlan& made) {
    const Plan& plan = made.plan;
    const bool sparse = plan.sparse >= 2;
    const ordered_json json{{"mode", name_of(made.mode)},
                            {"structure", name_of(plan.structure)},
                            {"step", plan.step},
                            {"sampler", name_of(plan.sampler)},
                            {"gradient", k_gradient},
                            {"refine", name_of(plan.refine)},
                            {"refine_steps", plan.refine_steps},
                            {"ert", plan.ert},
                            {"sparse", number_or_null(sparse, plan.sparse)},
                            {"sparse_gradient", number_or_null(sparse, plan.sparse_gradient)},
                            {"cells", plan.cells},
                            {"directions", plan.directions},
                            {"voxel_gradient", name_of(plan.voxel_gradient)},
                            {"homogeneity", plan.homogeneity},
                            {"homogeneity_angle", plan.homogeneity_angle_deg},
                            {"brick", number_or_null(plan.brick > 0, plan.brick)},
                            {"why", plan.why}};
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ModePlan plan_from_json(const std::string& text, const std::string& where) {
    ordered_json json;
    try {
        json = ordered_json::parse(text);
    } catch (const nlohmann::json::exception&) {
        refuse(where, "this is no JSON.");
    }
    if (!json.is_object()) refuse(where, "a plan is a JSON object.");
    ModePlan made;
    const Readers readers = readers_for(made);
    for (const auto& [key, value] : json.items()) {
        const auto reader = readers.find(key);
        if (reader == readers.end()) refuse(where, "a plan has no key \"" + key + "\".");
        try {
            reader->second(value);
        } catch (const nlohmann::json::exception&) {
            refuse(where, "the plan's \"" + key + "\" is of the wrong kind.");
        } catch (const Error& error) {
            refuse(where, error.what());
        }
    }
    return made;
}

}  // namespace lacuna
