#include "core/inspect/criteria.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/names.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

constexpr NameTable<Rule, k_rules.size()> k_rule_names{{
    {Rule::porosity_percent, "porosity_percent"},
    {Rule::defect_volume_mm3, "defect_volume_mm3"},
    {Rule::defect_diameter_mm, "defect_diameter_mm"},
    {Rule::count, "count"},
    {Rule::min_gap_mm, "min_gap_mm"},
    {Rule::min_surface_distance_mm, "min_surface_distance_mm"},
}};

constexpr double k_most_counted = 9007199254740992;  // 2^53: a double holds every whole number up to here

/// Reads one criteria file; knows where it is, for messages.
class Reader {
public:
    Reader(std::string file, std::filesystem::path folder) : file_(std::move(file)), folder_(std::move(folder)) {}

    Criteria read(std::string_view text) {
        const Json root = parse(text);
        Criteria criteria;
        keys(root, "", {"material", "defects", "min_voxels", "method", "connectivity", "limits", "zones", "$schema"});
        if (root.contains("material")) read_material(root["material"], criteria.detection);
        if (root.contains("defects")) read_defects(root["defects"], criteria.detection);
        if (root.contains("min_voxels"))
            criteria.detection.min_voxels = whole(root["min_voxels"], "min_voxels", 1, std::int64_t(1) << 40);
        read_method(root, criteria.detection);
        if (root.contains("limits")) criteria.limits = read_limits(root["limits"], "limits");
        if (root.contains("zones")) read_zones(root["zones"], criteria);
        check_values(criteria.detection);
        criteria.json = root.dump();
        return criteria;
    }

private:
    [[noreturn]] void refuse(const std::string& key, const std::string& what) const {
        throw Error(Errc::bad_input, fmt::format("Criteria {}: {} {}.", file_, key.empty() ? "the file" : key, what));
    }

    Json parse(std::string_view text) const {
        std::string last_key;
        std::vector<std::set<std::string>> open;  // keys met in each object that is not closed yet
        const auto watch = [&](int, Json::parse_event_t event, Json& value) {
            if (event == Json::parse_event_t::object_start) open.emplace_back();
            if (event == Json::parse_event_t::object_end) open.pop_back();
            if (event == Json::parse_event_t::key) {
                last_key = value.get<std::string>();
                if (!open.back().insert(last_key).second) refuse(last_key, "is given twice; keep one");
            }
            return true;
        };
        try {
            Json root = Json::parse(text, watch);
            if (!root.is_object()) refuse("", "is not a JSON object; see docs/schemas/criteria.schema.json");
            return root;
        } catch (const Json::out_of_range&) {
            refuse(last_key, "is a number too large to be one; limits are finite");
        } catch (const Json::parse_error& error) {
            const std::size_t upto = std::min(error.byte, text.size());
            const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(upto), '\n');
            refuse(last_key,
                   fmt::format("or what follows it is no JSON (line {}); numbers are finite, names quoted", line));
        }
    }

    static std::string at(const std::string& parent, const std::string& key) {
        return parent.empty() ? key : parent + "." + key;
    }

    void keys(const Json& object, const std::string& where, const std::set<std::string>& known) const {
        if (!object.is_object()) refuse(where, "must be an object { ... }");
        for (const auto& [key, value] : object.items()) {
            if (known.contains(key)) continue;
            for (const std::string& name : known)
                if (name.starts_with(key + "_") &&
                    (name.ends_with("mm") || name.ends_with("mm3") || name.ends_with("percent")))
                    refuse(at(where, key), "lacks its unit: write " + name);
            std::string list;
            for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
            refuse(at(where, key), "is no known key; known here are " + list);
        }
    }

    double number(const Json& value, const std::string& key) const {
        if (!value.is_number()) refuse(key, "must be a number, without quotes; its unit is part of the key");
        const double n = value.get<double>();
        if (!std::isfinite(n)) refuse(key, "must be a finite number");
        return n;
    }

    std::int64_t whole(const Json& value, const std::string& key, std::int64_t least, std::int64_t most) const {
        const double n = number(value, key);
        if (!(n >= double(least) && n <= double(most) && n == std::floor(n)))
            refuse(key, fmt::format("must be a whole number from {} to {}", least, most));
        return std::int64_t(n);
    }

    /// @return true for "auto"
    bool is_auto(const Json& value, const std::string& key) const {
        if (!value.is_string()) return false;
        if (value.get<std::string>() != "auto") refuse(key, "is a text that is not \"auto\"");
        return true;
    }

    void read_material(const Json& value, DetectionOptions& options) const {
        if (is_auto(value, "material")) return;
        if (!value.is_array() || value.size() != 2) refuse("material", "must be [lo, hi] or \"auto\"");
        const ValueRange range{number(value[0], "material"), number(value[1], "material")};
        if (!(range.lo < range.hi)) refuse("material", "has lo >= hi; the smaller value comes first");
        options.material = range;
    }

    std::optional<double> read_side(const Json& value, const std::string& key, const std::string& word) const {
        if (is_auto(value, key)) return std::nullopt;
        keys(value, key, {word});
        if (!value.contains(word)) refuse(key, "must be {\"" + word + "\": value} or \"auto\"");
        return number(value[word], key + "." + word);
    }

    void read_defects(const Json& value, DetectionOptions& options) const {
        keys(value, "defects", {"void", "inclusion"});
        if (value.empty()) refuse("defects", "names no kind of defect; give void, inclusion or both");
        options.voids = value.contains("void");
        options.inclusions = value.contains("inclusion");
        if (options.voids) options.void_below = read_side(value["void"], "defects.void", "below");
        if (options.inclusions) options.inclusion_above = read_side(value["inclusion"], "defects.inclusion", "above");
    }

    void read_method(const Json& root, DetectionOptions& options) const {
        // A value given is meant as it stands, unless the surface is asked to be followed. One of inclusions says
        // nothing of voids that are looked for too.
        if (options.void_below || options.material || (options.inclusion_above && !options.voids))
            options.method = ThresholdMethod::fixed;
        if (root.contains("method")) {
            const Json& value = root["method"];
            try {
                options.method = parse_threshold_method(value.is_string() ? value.get<std::string>() : "");
            } catch (const Error&) {
                refuse("method", "must be \"local\", \"otsu\" or \"fixed\"");
            }
            const bool given = options.material || options.void_below || (options.inclusion_above && !options.voids);
            if (options.method == ThresholdMethod::fixed && !given)
                refuse("method", "is \"fixed\", but neither material nor defects.void.below gives a value");
        }
        if (!root.contains("connectivity")) return;
        const std::int64_t n = whole(root["connectivity"], "connectivity", 6, 26);
        if (n != 6 && n != 18 && n != 26) refuse("connectivity", "must be 6, 18 or 26");
        options.connectivity = Connectivity(n);
    }

    void check_values(const DetectionOptions& options) const {
        if (options.void_below && options.material && !(*options.void_below <= options.material->hi))
            refuse("defects.void.below", "lies above the material's values: all of the part would be void");
        if (options.inclusion_above && options.material && !(*options.inclusion_above >= options.material->lo))
            refuse("defects.inclusion.above", "lies below the material's values: all of the part would be inclusion");
        if (options.void_below && options.inclusion_above && !(*options.void_below < *options.inclusion_above))
            refuse("defects.void.below", "is not below defects.inclusion.above (lo > hi): a value would be both");
    }

    Limits read_limits(const Json& value, const std::string& where) const {
        std::set<std::string> known;
        for (const Rule rule : k_rules) known.emplace(name_of(rule));
        keys(value, where, known);
        Limits limits;
        for (const Rule rule : k_rules) {
            const std::string key(name_of(rule));
            if (!value.contains(key)) continue;
            const double limit = number(value[key], at(where, key));
            if (!(limit >= 0)) refuse(at(where, key), "is negative; a limit is 0 or more");
            if (rule == Rule::porosity_percent && limit > 100) refuse(at(where, key), "is above 100 percent");
            if (rule == Rule::count && limit != std::floor(limit)) refuse(at(where, key), "must be a whole number");
            if (rule == Rule::count && limit > k_most_counted) refuse(at(where, key), "is more than can be counted");
            limits[rule] = limit;
        }
        return limits;
    }

    glm::dvec3 point(const Json& value, std::size_t first, const std::string& key) const {
        return {number(value[first], key), number(value[first + 1], key), number(value[first + 2], key)};
    }

    void read_box(const Json& value, const std::string& key, Zone& zone) const {
        const bool two = value.is_array() && value.size() == 2 && value[0].is_array() && value[0].size() == 3 &&
                         value[1].is_array() && value[1].size() == 3;
        const bool six = value.is_array() && value.size() == 6;
        if (!two && !six) refuse(key, "must be [[x, y, z], [x, y, z]]: the smallest corner, then the largest, in mm");
        zone.box_min_mm = two ? point(value[0], 0, key) : point(value, 0, key);
        zone.box_max_mm = two ? point(value[1], 0, key) : point(value, 3, key);
        for (int axis = 0; axis < 3; ++axis)
            if (!(zone.box_min_mm[axis] < zone.box_max_mm[axis]))
                refuse(key, fmt::format("has lo >= hi along {}; the smallest corner comes first", "xyz"[axis]));
    }

    void read_zones(const Json& value, Criteria& criteria) const {
        if (!value.is_array()) refuse("zones", "must be a list [ ... ]");
        std::set<std::string> names;
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string where = fmt::format("zones[{}]", i);
            const Json& item = value[i];
            keys(item, where, {"name", "box_mm", "labels", "label", "limits"});
            Zone zone;
            if (!item.contains("name") || !item["name"].is_string() || item["name"].get<std::string>().empty())
                refuse(where + ".name", "is missing; a zone needs a name");
            zone.name = item["name"].get<std::string>();
            if (!names.insert(zone.name).second) refuse(where + ".name", "is used twice: " + zone.name);
            if (item.contains("box_mm") == item.contains("labels")) refuse(where, "must have either box_mm or labels");
            if (item.contains("box_mm")) read_box(item["box_mm"], where + ".box_mm", zone);
            if (item.contains("labels")) {
                if (!item["labels"].is_string()) refuse(where + ".labels", "must be the name of a label volume file");
                zone.is_box = false;
                zone.labels = folder_ / item["labels"].get<std::string>();
            }
            if (item.contains("label")) {
                if (zone.is_box) refuse(where + ".label", "goes with labels, not with box_mm");
                zone.label = std::uint32_t(whole(item["label"], where + ".label", 1, UINT32_MAX));
            }
            if (!item.contains("limits")) refuse(where + ".limits", "is missing; a zone without limits says nothing");
            zone.limits = read_limits(item["limits"], where + ".limits");
            criteria.zones.push_back(std::move(zone));
        }
    }

    std::string file_;
    std::filesystem::path folder_;
};

}  // namespace

std::string_view name_of(Rule rule) { return name_in(k_rule_names, rule); }

std::string_view unit_of(Rule rule) {
    switch (rule) {
        case Rule::porosity_percent:
            return "%";
        case Rule::defect_volume_mm3:
            return "mm3";
        case Rule::count:
            return "";
        default:
            return "mm";
    }
}

bool limits_from_above(Rule rule) { return rule != Rule::min_gap_mm && rule != Rule::min_surface_distance_mm; }

bool Limits::empty() const {
    return std::none_of(values.begin(), values.end(), [](const auto& value) { return value.has_value(); });
}

Criteria parse_criteria(std::string_view json, const std::string& file_name, const std::filesystem::path& folder) {
    return Reader(file_name, folder).read(json);
}

Criteria read_criteria(const std::filesystem::path& file) {
    constexpr std::uintmax_t k_largest = 16 << 20;
    return parse_criteria(read_file(file, k_largest), file.filename().string(), file.parent_path());
}

}  // namespace lacuna
