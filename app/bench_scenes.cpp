#include "app/bench_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/parse.h"
#include "core/base/atomic_file.h"
#include "core/base/shell_word.h"
#include "core/render/turn.h"

namespace lacuna::cli {

namespace {

using nlohmann::json;

/// What a scene may say of `lacuna render`: what is seen, none of how it is drawn but the reference's step.
constexpr const char* k_scene_flags[] = {
    "raw",     "series", "spacing", "mode",      "iso",  "tf",   "range",  "cut",         "window", "lmip-threshold",
    "shading", "size",   "azimuth", "elevation", "roll", "zoom", "center", "perspective", "step"};
constexpr int k_most_views = 360;

[[noreturn]] void refuse_file(const std::string& where, const std::string& fault) {
    throw Error(Errc::bad_input, where + ": " + fault);
}

bool is_scene_flag(const std::string& key) {
    return std::find(std::begin(k_scene_flags), std::end(k_scene_flags), key) != std::end(k_scene_flags);
}

/// "FILE" made relative to the folder; presets stay.
std::string placed_tf(const std::string& tf, const std::filesystem::path& folder) {
    return tf.starts_with("preset:") ? tf : (folder / tf).string();
}

std::string text_of(const std::string& where, const std::string& key, const json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return value.dump();
    refuse_file(where, fmt::format("\"{}\" must be a text or a number.", key));
}

SceneWords scene_from(const json& scene, const std::string& file, const std::filesystem::path& folder,
                      const std::filesystem::path& data, std::size_t number) {
    SceneWords made;
    if (!scene.is_object()) refuse_file(file, fmt::format("scene {} is no JSON object.", number));
    if (!scene.contains("name") || !scene["name"].is_string())
        refuse_file(file, fmt::format("scene {} has no \"name\".", number));
    made.name = scene["name"].get<std::string>();
    const std::string where = fmt::format("{}, scene \"{}\"", file, made.name);
    if (!scene.contains("input") || !scene["input"].is_string()) refuse_file(where, "it has no \"input\".");
    const std::string input = scene["input"].get<std::string>();
    made.words.push_back(input.starts_with("sample:") ? input : (data / input).string());
    for (const auto& [key, value] : scene.items()) {
        if (key == "name" || key == "input") continue;
        if (key == "views") {
            if (!value.is_number_integer() || value < 1 || value > k_most_views)
                refuse_file(where, fmt::format("\"views\" must be a whole number from 1 to {}.", k_most_views));
            made.views = value.get<int>();
            continue;
        }
        if (!is_scene_flag(key))
            refuse_file(where, fmt::format("a scene has no key \"{}\"; it has name, input, views, {}.", key,
                                           fmt::join(k_scene_flags, ", ")));
        if (value.is_array() && value.empty()) refuse_file(where, fmt::format("\"{}\" is an empty list.", key));
        for (const json& one : value.is_array() ? value : json::array({value})) {
            std::string text = text_of(where, key, one);
            if (key == "tf") text = placed_tf(text, folder);
            if (const std::size_t colon = text.find(':'); key == "range" && colon != std::string::npos)
                text = text.substr(0, colon + 1) + placed_tf(text.substr(colon + 1), folder);
            made.words.push_back("--" + key + "=" + text);
        }
    }
    return made;
}

}  // namespace

std::vector<SceneWords> load_scenes(const std::filesystem::path& file, const std::filesystem::path& data) {
    constexpr std::uintmax_t k_most_bytes = 1 << 20;
    const std::string text = read_file(file, k_most_bytes), name = file.string();
    const json root = json::parse(text, nullptr, false);
    if (root.is_discarded()) refuse_file(name, "this is no JSON.");
    if (!root.is_object() || !root.contains("scenes") || !root["scenes"].is_array() || root["scenes"].empty())
        refuse_file(name, "a scene file is a JSON object with a list \"scenes\" of at least one scene.");
    for (const auto& [key, value] : root.items())
        if (key != "scenes" && key != "$schema" && key != "about")
            refuse_file(name, fmt::format("a scene file has no key \"{}\"; it has $schema, about and scenes.", key));
    std::vector<SceneWords> made;
    const std::filesystem::path folder = file.parent_path();
    for (const json& scene : root["scenes"])
        made.push_back(scene_from(scene, name, folder, data.empty() ? folder : data, made.size() + 1));
    return made;
}

BenchScene::BenchScene(const SceneWords& scene) : scene_(scene) {
    CLI::App words;
    options_.add_to(words);
    std::vector<std::string> reversed(scene.words.rbegin(), scene.words.rend());
    options_.output = "scene.png";
    try {
        words.parse(std::move(reversed));
        options_.parse();
    } catch (const CLI::ParseError& error) {
        throw Error(Errc::bad_usage, fmt::format("Scene \"{}\": {}.", scene.name, error.what()));
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("Scene \"{}\": {}", scene.name, error.what()));
    }
}

std::string BenchScene::command() const {
    std::string words = "lacuna render";
    for (const std::string& word : scene_.words) words += " " + shell_word(word);
    return words;
}

SweepScene BenchScene::open(const Console& console, int views) {
    static std::string opened;  // the words that say which volume
    static Volume volume;
    static VolumeStatistics statistics;
    const std::string which = options_.input.input + '\n' + options_.input.open.raw + '\n' +
                              options_.input.open.series + '\n' + options_.input.spacing_text;
    if (which != opened) {
        opened.clear();
        volume = {};
        volume = options_.input.load(console);
        statistics = compute_statistics(volume, console.job("Measuring"));
        opened = which;
    }
    SweepScene made;
    made.name = scene_.name;
    made.scene = options_.scene(volume, statistics);
    made.step = options_.plan(made.scene).step;
    made.views = full_turn(made.scene.camera, scene_.views > 0 ? scene_.views : views);
    made.command = command();
    if (options_.input.input.starts_with("sample:"))
        made.sample = [input = options_.input.input](const JobContext& job) { return *open_sample(input, job); };
    return made;
}

}  // namespace lacuna::cli
