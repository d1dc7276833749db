#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "core/render/plan_json.h"
#include "core/session/settings_fields.h"
#include "core/session/settings_json.h"

namespace lacuna::test {

/// One value within some ViewSettings that can be changed: where it stands ("ranges[].range.tf") and how.
struct SettingsLeaf {
    std::string path;
    std::function<void(std::mt19937&)> change;
};

/// Draws what stands in settings. Values it makes are such as a window shows; those that are not, check() tells.
class RandomValues {
public:
    RandomValues(std::mt19937& random, ValueRange values) : random_(random), values_(values) {}
    double within(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool coin() { return below(2) == 0; }
    double value() { return within(values_.lo, values_.hi); }
    ValueRange range() {
        const double a = value(), b = value();
        return {std::min(a, b), std::max(a, b) + 1e-3 * values_.width()};
    }
    glm::dvec3 color() { return {within(0, 1), within(0, 1), within(0, 1)}; }
    glm::dvec3 direction() {
        glm::dvec3 v(0);
        while (!(glm::length(v) > 0.1)) v = {within(-1, 1), within(-1, 1), within(-1, 1)};
        return glm::normalize(v);
    }
    std::string text() {
        static const char* const names[] = {"Knochen", "Lunker – \"groß\"", "a/b\\c", "", "µ ≥ 3", "bone"};
        return names[below(int(std::size(names)))];
    }
    TransferFunction function() {
        TransferFunction tf;
        tf.name = text();
        tf.unit_distance_mm = within(0.2, 3);
        std::vector<double> at(std::size_t(2 + below(5)));
        for (double& v : at) v = value();
        std::sort(at.begin(), at.end());
        for (const double v : at) tf.points.push_back({v, color(), within(0, 1)});
        if (coin()) tf.gradient_opacity = {{0, within(0, 1)}, {within(1, 50), within(0, 1)}};
        if (coin())
            tf.shapes = {{{within(0, 5), within(6, 90)}, range(), range(), color(), within(0, 1), within(0, 1)}};
        tf.by_shapes = coin();
        return tf;
    }
    std::vector<Effect> effects() {
        std::vector<Effect> list;
        if (coin()) list.push_back({EffectKind::ssao, {within(0, 4), within(0, 9)}});
        if (coin()) list.push_back({EffectKind::dof, {within(0, 1), within(0, 3), within(0, 1)}});
        if (coin()) list.push_back({EffectKind::gamma, {within(0.5, 2)}});
        if (coin()) list.push_back({EffectKind::tonemap, {within(0.5, 2)}});
        if (coin()) list.push_back({EffectKind::brightness, {within(-0.5, 0.5)}});
        if (coin()) list.push_back({EffectKind::contrast, {within(0.5, 2)}});
        return list;
    }
    Measurement measurement(std::uint32_t id) {
        Measurement m;
        m.id = id;
        m.kind = MeasurementKind(below(4));
        const int axis = below(3);
        m.right = glm::dvec3(axis == 0, axis == 1, axis == 2);
        m.down = glm::dvec3(axis == 2, axis == 0, axis == 1);
        const glm::dvec3 corner(within(-9, 9), within(-9, 9), within(-9, 9));
        const int points = m.kind == MeasurementKind::angle ? 3 : 2;
        for (int i = 0; i < points; ++i)
            m.points_mm.push_back(corner + (1 + within(0, 9)) * double(i) * m.right +
                                  within(1, 9) * double(i) * m.down);
        return m;
    }
    std::mt19937& engine() { return random_; }

private:
    std::mt19937& random_;
    ValueRange values_;
};

inline int count_of(ViewMode) { return 7; }
inline int count_of(Shading) { return 3; }
inline int count_of(Structure) { return 9; }
inline int count_of(Sampler) { return 3; }
inline int count_of(VoiFunction) { return 3; }
inline int count_of(SlabMode) { return 3; }

/// Finds the leaves of settings by the functions fields() that the session file is written with: a field that is saved
/// is found here too, without being named a second time.
class LeafCollector {
public:
    LeafCollector(std::vector<SettingsLeaf>& leaves, std::string path, ValueRange values)
        : leaves_(leaves), path_(std::move(path)), values_(values) {}

    template <class T>
    void operator()(const char* key, T& value) {
        collect(path_.empty() ? key : path_ + "." + key, value);
    }

    template <class T>
    void collect(const std::string& path, T& value) {
        if constexpr (requires { value.has_value(); })
            collect_optional(path, value);
        else if constexpr (std::is_same_v<T, TransferFunction>)
            leaf(path, [&value](RandomValues& draw) { value = draw.function(); });
        else if constexpr (std::is_same_v<T, std::vector<Effect>>)
            leaf(path, [&value](RandomValues& draw) { value = draw.effects(); });
        else if constexpr (std::is_same_v<T, ValueRange>)
            leaf(path, [&value](RandomValues& draw) { value = draw.range(); });
        else if constexpr (std::is_same_v<T, glm::dquat>)
            leaf(path, [&value](RandomValues& draw) { value = glm::angleAxis(draw.within(-1, 1), draw.direction()); });
        else if constexpr (std::is_same_v<T, Measurement>)
            leaf(path, [&value](RandomValues& draw) { value = draw.measurement(value.id); });
        else if constexpr (std::is_same_v<T, bool>)
            leaf(path, [&value](RandomValues&) { value = !value; });
        else if constexpr (std::is_enum_v<T>)
            leaf(path, [&value](RandomValues& draw) { value = T(draw.below(count_of(value))); });
        else if constexpr (std::is_integral_v<T>)
            leaf(path, [&value](RandomValues& draw) { value = T(draw.below(4)); });
        else if constexpr (std::is_floating_point_v<T>)
            leaf(path, [&value, path](RandomValues& draw) { value = number(path, draw); });
        else if constexpr (std::is_same_v<T, std::string>)
            leaf(path, [&value, path](RandomValues& draw) {
                if (path.ends_with("plan"))
                    value = draw.coin() ? std::string() : to_json(ModePlan{ViewMode(draw.below(6)), {}});
                else
                    value = draw.text();
            });
        else if constexpr (requires {
                               value.length();
                               value[0];
                           })
            leaf(path, [&value, path](RandomValues& draw) {
                if (path.find("color") != std::string::npos)
                    value = draw.color();
                else if (path.ends_with("normal"))
                    value = draw.direction();
                else
                    for (int i = 0; i < int(value.length()); ++i) value[i] = draw.within(0, 1);
            });
        else if constexpr (requires { typename T::mapped_type; }) {
            for (auto& [key, item] : value) collect(path + "{}", item);
        } else if constexpr (requires { value.resize(0); }) {
            collect_list(path, value);
        } else {
            LeafCollector inner(leaves_, path, values_);
            fields(inner, value);
        }
    }

private:
    static double number(const std::string& path, RandomValues& draw) {
        if (path.ends_with("opacity")) return draw.within(0, 1);
        if (path.ends_with("step")) return draw.within(0.1, 2);
        if (path.ends_with("budget")) return draw.within(1, 20);
        if (path.ends_with("budget_ms")) return draw.within(5, 200);
        if (path.ends_with("thickness_mm")) return draw.within(0, 12);
        if (path.ends_with("offset")) return draw.within(-15, 15);
        return draw.value();
    }
    template <class O>
    void collect_optional(const std::string& path, O& value) {
        using Inner = typename O::value_type;
        leaf(path, [&value, path, values = values_](RandomValues& draw) {
            if (value && draw.coin()) return value.reset();
            if (!value) value.emplace();
            std::vector<SettingsLeaf> inner;
            LeafCollector(inner, "", values).template collect<Inner>(path, *value);
            inner.front().change(draw.engine());
        });
    }
    template <class L>
    void collect_list(const std::string& path, L& value) {
        leaf(path, [&value, path](RandomValues& draw) {
            using Item = typename L::value_type;
            constexpr std::size_t k_most = 4;
            if (!value.empty() && (value.size() >= k_most || draw.below(3) == 0))
                return void(value.erase(value.begin() + draw.below(int(value.size()))));
            if constexpr (std::is_same_v<Item, Measurement>)
                value.push_back(draw.measurement(next_measurement_id(value)));
            else
                value.push_back(Item{});
            if constexpr (std::is_same_v<Item, RangeSetting>) value.back().range.range = draw.range();
            if constexpr (std::is_same_v<Item, CutSetting>) value.back().plane.normal = draw.direction();
        });
        for (auto& item : value) collect(path + "[]", item);
    }
    template <class Change>
    void leaf(const std::string& path, Change change) {
        leaves_.push_back({path, [change, values = values_](std::mt19937& random) {
                               RandomValues draw(random, values);
                               change(draw);
                           }});
    }

    std::vector<SettingsLeaf>& leaves_;
    std::string path_;
    ValueRange values_;
};

/// All values of the settings that can be changed; they refer to `settings`, which has to stay where it is.
/// @param values  the volume's, from which grey levels and the like are drawn
inline std::vector<SettingsLeaf> leaves_of(ViewSettings& settings, ValueRange values) {
    std::vector<SettingsLeaf> leaves;
    LeafCollector(leaves, "", values).collect("", settings);
    return leaves;
}

/// A valid change of one value; of those not in `seen` where there are any and a coin says so. Adds its path to `seen`.
/// @return the path; empty where nothing valid came of many attempts
inline std::string change_something(ViewSettings& settings, ValueRange values, std::mt19937& random,
                                    std::set<std::string>& seen) {
    for (int attempt = 0; attempt < 200; ++attempt) {
        ViewSettings next = settings;
        std::vector<SettingsLeaf> leaves = leaves_of(next, values);
        std::vector<SettingsLeaf*> fresh;
        for (SettingsLeaf& leaf : leaves)
            if (!seen.contains(leaf.path)) fresh.push_back(&leaf);
        SettingsLeaf& leaf =
            fresh.empty() || random() % 4 == 0 ? leaves[random() % leaves.size()] : *fresh[random() % fresh.size()];
        leaf.change(random);
        try {
            check(next, "random settings");
        } catch (const Error&) {
            continue;
        }
        if (next == settings) continue;
        seen.insert(leaf.path);
        settings = std::move(next);
        return leaf.path;
    }
    return {};
}

}  // namespace lacuna::test
