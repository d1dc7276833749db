#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/error.h"
#include "core/render/effects.h"
#include "core/render/scene.h"

namespace lacuna {

namespace {

constexpr double k_no_default = std::numeric_limits<double>::quiet_NaN();
constexpr double k_largest_mm = 1e6;

struct ValueRule {
    const char* name = "";
    double least = 0, most = 0;
    double usual = k_no_default;
    bool whole = false;
};

struct EffectRule {
    EffectKind kind;
    std::string_view name;
    std::array<ValueRule, 4> values;
    std::size_t count;
};

constexpr std::array<EffectRule, 7> k_rules{{
    {EffectKind::ssao, "ssao", {{{"strength", 0, 4, 1}, {"radius in mm", 0, k_largest_mm, 0}}}, 2},
    {EffectKind::ao,
     "ao",
     {{{"number of samples", 1, 1024, 16, true},
       {"distance in mm", 0, k_largest_mm, 0},
       {"strength", 0, 1, 1},
       {"seed", 0, 4294967295.0, 1, true}}},
     4},
    {EffectKind::dof, "dof", {{{"focus", 0, k_largest_mm, 0.3}, {"strength", 0, 8, 1}, {"dimming", 0, 1, 0}}}, 3},
    {EffectKind::gamma, "gamma", {{{"gamma", 0.1, 10}}}, 1},
    {EffectKind::tonemap, "tonemap", {{{"white", 0.1, 100, 1.2}}}, 1},
    {EffectKind::brightness, "brightness", {{{"brightness", -1, 1}}}, 1},
    {EffectKind::contrast, "contrast", {{{"contrast", 0, 10}}}, 1},
}};

[[noreturn]] void refuse(const std::string& sentence) { throw Error(Errc::bad_usage, sentence); }

const EffectRule& rule_of(EffectKind kind) {
    for (const EffectRule& rule : k_rules)
        if (rule.kind == kind) return rule;
    refuse("There is no such effect.");
}

const EffectRule& rule_named(std::string_view name) {
    std::string known;
    for (const EffectRule& rule : k_rules) {
        if (rule.name == name) return rule;
        known += (known.empty() ? "" : ", ") + std::string(rule.name);
    }
    refuse(fmt::format("There is no effect '{}'; known are {}.", name, known));
}

double number_of(std::string_view text, std::string_view effect) {
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        refuse(fmt::format("'{}' is not a number; effect {} takes numbers separated by commas.", text, effect));
    return number;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string names_of(std::span<const ValueRule> rules) {
    std::string names;
    for (const ValueRule& rule : rules) names += (names.empty() ? "" : ", ") + std::string(rule.name);
    return names;
}

void check(const Effect& effect) {
    const EffectRule& rule = rule_of(effect.kind);
    const std::span<const ValueRule> known(rule.values.data(), rule.count);
    if (effect.values.size() > rule.count)
        refuse(fmt::format("Effect {} takes at most {} value{} ({}), not {}.", rule.name, rule.count,
                           rule.count == 1 ? "" : "s", names_of(known), effect.values.size()));
    for (std::size_t i = 0; i < rule.count; ++i) {
        const ValueRule& v = known[i];
        if (i >= effect.values.size()) {
            if (std::isnan(v.usual))
                refuse(fmt::format("Effect {0} needs a value: {0}={1:g}..{2:g}.", rule.name, v.least, v.most));
            continue;
        }
        const double value = effect.values[i];
        if (!(value >= v.least && value <= v.most) || (v.whole && value != std::floor(value)))
            refuse(fmt::format("Effect {}: the {} must be a{} number from {:.10g} to {:.10g}, not {:g}.", rule.name,
                               v.name, v.whole ? " whole" : "", v.least, v.most, value));
    }
}

}  // namespace

double Effect::value(std::size_t i) const { return i < values.size() ? values[i] : rule_of(kind).values.at(i).usual; }

std::string_view name_of(EffectKind kind) { return rule_of(kind).name; }

std::vector<Effect> parse_effects(std::string_view list) {
    std::vector<Effect> effects;
    bool takes_values = false;  // the effect before was written with '='
    for (std::size_t from = 0; from <= list.size();) {
        const std::size_t comma = std::min(list.find(',', from), list.size());
        std::string_view word = list.substr(from, comma - from);
        from = comma + 1;
        if (word.empty()) refuse("The list of effects has an empty place; write name[=v[,v..]],name..");
        if (is_letter(word.front())) {
            const std::size_t equals = word.find('=');
            effects.push_back({rule_named(word.substr(0, equals)).kind, {}});
            takes_values = equals != std::string_view::npos;
            if (!takes_values) continue;
            word.remove_prefix(equals + 1);
        } else if (!takes_values) {
            refuse(fmt::format("'{}' belongs to no effect; write name[=v[,v..]],name..", word));
        }
        effects.back().values.push_back(number_of(word, name_of(effects.back().kind)));
    }
    for (const Effect& effect : effects) check(effect);
    return effects;
}

std::string to_text(const std::vector<Effect>& effects) {
    std::string text;
    for (const Effect& effect : effects) {
        text += (text.empty() ? "" : ",") + std::string(name_of(effect.kind));
        for (std::size_t i = 0; i < effect.values.size(); ++i)
            text += fmt::format("{}{}", i == 0 ? '=' : ',', effect.values[i]);
    }
    return text;
}

bool serves(EffectKind kind, ViewMode mode) {
    return kind != EffectKind::ao || mode == ViewMode::iso || mode == ViewMode::shear_warp || mode == ViewMode::ea;
}

void check(const std::vector<Effect>& effects, ViewMode mode) {
    for (const Effect& effect : effects) {
        check(effect);
        if (!serves(effect.kind, mode))
            refuse(
                fmt::format("Effect ao needs a surface, which mode {} does not show; modes iso, shear-warp and ea do.",
                            name_of(mode)));
    }
}

}  // namespace lacuna
