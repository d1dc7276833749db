#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/classify/transfer_function.h"

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

TransferPoint point_from(const Json& json, const Place& place) {
    expect_object(json, place, {"value", "color", "opacity"}, {"value", "color", "opacity"});
    TransferPoint point;
    point.value = number(json["value"], place.in("value"));
    point.opacity = number(json["opacity"], place.in("opacity"));
    const Json& color = array(json["color"], place.in("color"));
    if (color.size() != 3) place.in("color").refuse("must hold three numbers (red, green, blue)");
    for (std::size_t c = 0; c < 3; ++c) point.color[int(c)] = number(color[c], place.in("color").in(c));
    return point;
}

}  // namespace

TransferFunction transfer_function_from_json(const std::string& json, const std::string& where) {
    const Place root{where, ""};
    Json document;
    try {
        document = Json::parse(json);
    } catch (const Json::exception& fault) {
        root.refuse(std::string("is not valid JSON (") + fault.what() + ")");
    }
    expect_object(document, root, {"name", "unit_distance_mm", "points", "gradient_opacity"}, {"points"});
    TransferFunction tf;
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
    try {
        check(tf);
    } catch (const Error& fault) {
        throw Error(fault.code(), where + ": " + fault.what(), where);
    }
    return tf;
}

TransferFunction load_transfer_function(const std::filesystem::path& file) {
    return transfer_function_from_json(read_file(file, std::uintmax_t(16) << 20), file.string());
}

std::string to_json(const TransferFunction& tf) {
    Json document;
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
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save_transfer_function(const TransferFunction& tf, const std::filesystem::path& file) {
    check(tf);
    write_file(file, to_json(tf));
}

}  // namespace lacuna
