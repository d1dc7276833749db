#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/classify/preset_file.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

/// Where in which document a value stands, for messages.
struct Place {
    std::string file, key;

    Place in(std::string_view name) const {
        return {file, key.empty() ? std::string(name) : key + "." + std::string(name)};
    }
    Place in(std::size_t index) const { return {file, key + "[" + std::to_string(index) + "]"}; }
    [[noreturn]] void refuse(const std::string& fault) const {
        throw Error(Errc::bad_input,
                    file + ": " + (key.empty() ? std::string("the document") : "\"" + key + "\"") + " " + fault + ".",
                    file);
    }
};

void expect_object(const Json& json, const Place& place, std::initializer_list<std::string_view> known,
                   std::initializer_list<std::string_view> required) {
    if (!json.is_object()) place.refuse("must be a JSON object");
    for (const auto& item : json.items())
        if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
            std::string list;
            for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
            place.in(item.key()).refuse("is an unknown key; known here: " + list);
        }
    for (const std::string_view name : required)
        if (!json.contains(name)) place.in(name).refuse("is missing");
}

double number(const Json& json, const Place& place) {
    if (!json.is_number()) place.refuse("must be a number");
    return json.get<double>();
}

const Json& array(const Json& json, const Place& place) {
    if (!json.is_array()) place.refuse("must be a list");
    return json;
}

glm::dvec3 color_from(const Json& json, const Place& place) {
    if (array(json, place).size() != 3) place.refuse("must hold three numbers (red, green, blue)");
    glm::dvec3 color;
    for (std::size_t c = 0; c < 3; ++c) color[int(c)] = number(json[c], place.in(c));
    return color;
}

TransferPoint point_from(const Json& json, const Place& place) {
    expect_object(json, place, {"value", "color", "opacity"}, {"value", "color", "opacity"});
    TransferPoint point;
    point.value = number(json["value"], place.in("value"));
    point.opacity = number(json["opacity"], place.in("opacity"));
    point.color = color_from(json["color"], place.in("color"));
    return point;
}

ValueRange pair_from(const Json& json, const Place& place) {
    if (array(json, place).size() != 2) place.refuse("must hold two numbers");
    return {number(json[0], place.in(std::size_t(0))), number(json[1], place.in(std::size_t(1)))};
}

TransferShape shape_from(const Json& json, const Place& place) {
    expect_object(json, place, {"magnitude", "values_at_lo", "values_at_hi", "color", "opacity", "softness"},
                  {"magnitude", "values_at_lo", "color", "opacity"});
    TransferShape shape;
    shape.magnitude = pair_from(json["magnitude"], place.in("magnitude"));
    shape.at_lo = shape.at_hi = pair_from(json["values_at_lo"], place.in("values_at_lo"));
    if (json.contains("values_at_hi")) shape.at_hi = pair_from(json["values_at_hi"], place.in("values_at_hi"));
    shape.color = color_from(json["color"], place.in("color"));
    shape.opacity = number(json["opacity"], place.in("opacity"));
    if (json.contains("softness")) shape.softness = number(json["softness"], place.in("softness"));
    return shape;
}

Technique technique_from(const Json& json, const Place& place) {
    expect_object(json, place, {"mode", "shading", "step"}, {});
    Technique technique;
    const auto word = [&](const char* key) {
        if (!json.contains(key)) return std::string();
        if (!json[key].is_string()) place.in(key).refuse("must be a text");
        return json[key].get<std::string>();
    };
    technique.mode = word("mode");
    technique.shading = word("shading");
    if (json.contains("step")) {
        technique.step = number(json["step"], place.in("step"));
        if (!(technique.step > 0)) place.in("step").refuse("must be above 0");
    }
    return technique;
}

/// Comes before all else: a later version may hold keys that are not known here, and say so better than they do.
void check_version(const Json& document, const Place& root) {
    if (!document.is_object() || !document.contains("version")) return;
    const Json& version = document["version"];
    if (!version.is_number_integer() || version < 1) root.in("version").refuse("must be a whole number of 1 or more");
    if (version > k_transfer_file_version)
        throw Error(Errc::bad_input,
                    root.file + ": this transfer function is of version " + version.dump() +
                        " of the format, which is newer than this program; it reads versions up to " +
                        std::to_string(k_transfer_file_version) + ".",
                    root.file);
}

}  // namespace

PresetFile preset_from_json(const std::string& json, const std::string& where) {
    const Place root{where, ""};
    Json document;
    try {
        document = Json::parse(json);
    } catch (const Json::exception& fault) {
        root.refuse(std::string("is not valid JSON (") + fault.what() + ")");
    }
    check_version(document, root);
    expect_object(
        document, root,
        {"version", "name", "unit_distance_mm", "points", "gradient_opacity", "shapes", "by_shapes", "technique"},
        {"points"});
    PresetFile preset;
    TransferFunction& tf = preset.tf;
    if (document.contains("name")) {
        if (!document["name"].is_string()) root.in("name").refuse("must be a text");
        tf.name = document["name"].get<std::string>();
    }
    if (document.contains("unit_distance_mm"))
        tf.unit_distance_mm = number(document["unit_distance_mm"], root.in("unit_distance_mm"));
    const Place points = root.in("points");
    for (const Json& item : array(document["points"], points))
        tf.points.push_back(point_from(item, points.in(tf.points.size())));
    if (document.contains("gradient_opacity")) {
        const Place curve = root.in("gradient_opacity");
        for (const Json& item : array(document["gradient_opacity"], curve)) {
            const Place place = curve.in(tf.gradient_opacity.size());
            expect_object(item, place, {"magnitude", "opacity"}, {"magnitude", "opacity"});
            tf.gradient_opacity.push_back(
                {number(item["magnitude"], place.in("magnitude")), number(item["opacity"], place.in("opacity"))});
        }
    }
    if (document.contains("shapes")) {
        const Place shapes = root.in("shapes");
        for (const Json& item : array(document["shapes"], shapes))
            tf.shapes.push_back(shape_from(item, shapes.in(tf.shapes.size())));
    }
    if (document.contains("by_shapes")) {
        if (!document["by_shapes"].is_boolean()) root.in("by_shapes").refuse("must be true or false");
        tf.by_shapes = document["by_shapes"].get<bool>();
    }
    if (document.contains("technique")) preset.technique = technique_from(document["technique"], root.in("technique"));
    try {
        check(tf);
    } catch (const Error& fault) {
        throw Error(fault.code(), where + ": " + fault.what(), where);
    }
    return preset;
}

TransferFunction transfer_function_from_json(const std::string& json, const std::string& where) {
    return preset_from_json(json, where).tf;
}

PresetFile load_preset(const std::filesystem::path& file) {
    return preset_from_json(read_file(file, std::uintmax_t(16) << 20), file.string());
}

TransferFunction load_transfer_function(const std::filesystem::path& file) { return load_preset(file).tf; }

std::string to_json(const TransferFunction& tf) { return to_json(PresetFile{tf, {}}); }

std::string to_json(const PresetFile& preset) {
    const TransferFunction& tf = preset.tf;
    Json document;
    if (preset.technique || !tf.shapes.empty()) document["version"] = k_transfer_file_version;
    document["name"] = tf.name;
    document["unit_distance_mm"] = tf.unit_distance_mm;
    document["points"] = Json::array();
    for (const TransferPoint& p : tf.points)
        document["points"].push_back(
            {{"value", p.value}, {"color", {p.color.r, p.color.g, p.color.b}}, {"opacity", p.opacity}});
    if (!tf.gradient_opacity.empty()) {
        document["gradient_opacity"] = Json::array();
        for (const GradientOpacityPoint& p : tf.gradient_opacity)
            document["gradient_opacity"].push_back({{"magnitude", p.magnitude}, {"opacity", p.opacity}});
    }
    if (!tf.shapes.empty()) {
        document["shapes"] = Json::array();
        const auto pair = [](ValueRange range) { return Json::array({range.lo, range.hi}); };
        for (const TransferShape& s : tf.shapes)
            document["shapes"].push_back({{"magnitude", pair(s.magnitude)},
                                          {"values_at_lo", pair(s.at_lo)},
                                          {"values_at_hi", pair(s.at_hi)},
                                          {"color", {s.color.r, s.color.g, s.color.b}},
                                          {"opacity", s.opacity},
                                          {"softness", s.softness}});
    }
    if (!tf.by_shapes) document["by_shapes"] = false;
    if (preset.technique) {
        Json technique = Json::object();
        if (!preset.technique->mode.empty()) technique["mode"] = preset.technique->mode;
        if (!preset.technique->shading.empty()) technique["shading"] = preset.technique->shading;
        if (preset.technique->step > 0) technique["step"] = preset.technique->step;
        document["technique"] = technique;
    }
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save_transfer_function(const TransferFunction& tf, const std::filesystem::path& file) {
    save_preset({tf, {}}, file);
}

void save_preset(const PresetFile& preset, const std::filesystem::path& file) {
    check(preset.tf);
    write_file(file, to_json(preset));
}

}  // namespace lacuna
