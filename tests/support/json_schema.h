#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lacuna::test {

/// Holds JSON against a JSON Schema, as far as this project's schemas go: type, enum, required, properties,
/// additionalProperties false, items, anyOf, minItems, maxItems, minimum, maximum, exclusiveMinimum, $ref into $defs. A
/// keyword it does not know is a fault, so that no rule is passed over in silence.
class JsonSchema {
public:
    explicit JsonSchema(nlohmann::json schema) : root_(std::move(schema)) {}

    /// One line a fault; empty when the value keeps to the schema.
    std::vector<std::string> faults(const nlohmann::json& value) const {
        std::vector<std::string> found;
        check(root_, value, "$", found);
        return found;
    }

private:
    using json = nlohmann::json;
    using Faults = std::vector<std::string>;

    static bool is_of(const json& value, const std::string& type) {
        if (type == "object") return value.is_object();
        if (type == "array") return value.is_array();
        if (type == "string") return value.is_string();
        if (type == "boolean") return value.is_boolean();
        if (type == "null") return value.is_null();
        if (type == "number") return value.is_number();
        return type == "integer" && (value.is_number_integer() ||
                                     (value.is_number() && std::floor(value.get<double>()) == value.get<double>()));
    }

    void check_members(const json& schema, const json& value, const std::string& at, Faults& found) const {
        for (const json& key : schema.value("required", json::array()))
            if (!value.contains(key.get<std::string>())) found.push_back(at + " lacks " + key.get<std::string>());
        const json properties = schema.value("properties", json::object());
        for (const auto& [key, member] : value.items()) {
            if (properties.contains(key))
                check(properties[key], member, at + "." + key, found);
            else if (schema.contains("additionalProperties"))
                found.push_back(at + " may not have " + key);
        }
    }

    void check(const json& schema, const json& value, const std::string& at, Faults& found) const {
        for (const auto& [key, rule] : schema.items()) {
            const double number = value.is_number() ? value.get<double>() : 0;
            if (key == "$schema" || key == "title" || key == "description" || key == "$defs" || key == "required" ||
                key == "properties" || key == "additionalProperties") {
                if (key == "additionalProperties" && rule != false)
                    found.push_back("additionalProperties must be false");
            } else if (key == "$ref") {
                check(root_["$defs"].at(rule.get<std::string>().substr(8)), value, at, found);
            } else if (key == "type") {
                bool fits = false;
                for (const json& type : rule.is_array() ? rule : json::array({rule}))
                    fits = fits || is_of(value, type.get<std::string>());
                if (!fits) found.push_back(at + " is of the wrong type: " + value.dump());
            } else if (key == "enum") {
                if (std::find(rule.begin(), rule.end(), value) == rule.end())
                    found.push_back(at + " is " + value.dump());
            } else if (key == "anyOf") {
                bool fits = false;
                for (const json& one : rule) {
                    Faults inner;
                    check(one, value, at, inner);
                    fits = fits || inner.empty();
                }
                if (!fits) found.push_back(at + " fits none of its kinds: " + value.dump().substr(0, 100));
            } else if (key == "items") {
                if (value.is_array())
                    for (std::size_t i = 0; i < value.size(); ++i)
                        check(rule, value[i], at + "[" + std::to_string(i) + "]", found);
            } else if (key == "minItems") {
                if (value.is_array() && value.size() < rule) found.push_back(at + " has too few");
            } else if (key == "maxItems") {
                if (value.is_array() && value.size() > rule) found.push_back(at + " has too many");
            } else if (key == "minimum") {
                if (value.is_number() && !(number >= rule.get<double>())) found.push_back(at + " is too small");
            } else if (key == "maximum") {
                if (value.is_number() && !(number <= rule.get<double>())) found.push_back(at + " is too large");
            } else if (key == "exclusiveMinimum") {
                if (value.is_number() && !(number > rule.get<double>())) found.push_back(at + " is too small");
            } else {
                found.push_back("the schema has a keyword not known here: " + key);
            }
        }
        if (value.is_object()) check_members(schema, value, at, found);
    }

    json root_;
};

}  // namespace lacuna::test
