#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/classify/transfer_function.h"
#include "core/render/effects.h"

namespace lacuna {

/// Values of a session file as JSON and back, each field named once: a struct has one function
///     template <class Archive> void fields(Archive& archive, Struct& value)
/// (found by argument-dependent lookup) that calls archive("key", value.member) for every member; FieldWriter and
/// FieldReader run it either way. Numbers that are not finite become the texts "nan", "inf" and "-inf", which JSON has
/// no numbers for. A map keyed by an enumeration is an object. Enumerations give their words by `std::string_view
/// name_of(E)` and `E word_to(std::string_view, E)`.
using Json = nlohmann::ordered_json;

/// @throws Error(bad_input) naming `where` for a text that is no JSON
inline Json parse_json(const std::string& text, const std::string& where) {
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw Error(Errc::bad_input, where + " is no JSON; it may have been cut short.");
    return json;
}

class FieldWriter {
public:
    template <class T>
    void operator()(const char* key, const T& value) {
        json_[key] = write(value);
    }
    Json take() { return std::move(json_); }

    template <class T>
    static Json write(const T& value) {
        if constexpr (requires { value.has_value(); })
            return value ? write(*value) : Json(nullptr);
        else if constexpr (std::is_same_v<T, TransferFunction>)
            return Json::parse(to_json(value));  // the contract's transfer-function file
        else if constexpr (std::is_same_v<T, std::vector<Effect>>)
            return Json(to_text(value));  // as on the command line
        else if constexpr (std::is_floating_point_v<T>)
            return std::isfinite(value) ? Json(value) : Json(std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
        else if constexpr (std::is_enum_v<T>)
            return Json(std::string(name_of(value)));
        else if constexpr (std::is_arithmetic_v<T> || std::is_convertible_v<T, std::string>)
            return Json(value);
        else if constexpr (requires {
                               value.length();
                               value[0];
                           })
            return write_vector(value);
        else if constexpr (requires { typename T::mapped_type; })
            return write_map(value);
        else if constexpr (requires { value.begin(); })
            return write_list(value);
        else {
            FieldWriter inner;
            fields(inner, const_cast<T&>(value));  // fields() only reads through a FieldWriter
            return inner.take();
        }
    }

private:
    template <class V>
    static Json write_vector(const V& value) {
        Json list = Json::array();
        for (int i = 0; i < int(value.length()); ++i) list.push_back(write(value[i]));
        return list;
    }
    template <class L>
    static Json write_list(const L& value) {
        Json list = Json::array();
        for (const auto& item : value) list.push_back(write(item));
        return list;
    }
    template <class M>
    static Json write_map(const M& value) {
        Json object = Json::object();
        for (const auto& [key, item] : value) object[std::string(name_of(key))] = write(item);
        return object;
    }
    Json json_ = Json::object();
};

/// Reads what FieldWriter wrote. A key left out keeps the value there was, so that files of older versions stay good;
/// a key nobody asked for and a wrong type are refused by name.
class FieldReader {
public:
    FieldReader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) refuse(where_, "an object");
    }

    template <class T>
    void operator()(const char* key, T& value) {
        known_.insert(key);
        const auto at = json_.find(key);
        if (at != json_.end()) read(*at, value, where_ + "." + key);
    }
    /// @throws Error(bad_input) naming a key that no field has
    void finish() const {
        for (const auto& [key, value] : json_.items())
            if (!known_.contains(key)) throw Error(Errc::bad_input, where_ + " has an unknown entry '" + key + "'.");
    }

    template <class T>
    static void read(const Json& json, T& value, const std::string& where) {
        if constexpr (requires { value.has_value(); })
            read_optional(json, value, where);
        else if constexpr (std::is_same_v<T, TransferFunction>)
            value = transfer_function_from_json(json.dump(), where);
        else if constexpr (std::is_same_v<T, std::vector<Effect>>)
            read_effects(json, value, where);
        else if constexpr (std::is_same_v<T, bool>) {
            if (!json.is_boolean()) refuse(where, "true or false");
            value = json.get<bool>();
        } else if constexpr (std::is_floating_point_v<T>)
            value = T(read_number(json, where));
        else if constexpr (std::is_enum_v<T>) {
            if (!json.is_string()) refuse(where, "a word");
            try {
                value = word_to(json.get<std::string>(), value);
            } catch (const Error& error) {
                throw Error(Errc::bad_input, where + ": " + error.what());
            }
        } else if constexpr (std::is_integral_v<T>) {
            if (!json.is_number_integer() || json.get<double>() < double(std::numeric_limits<T>::lowest()) ||
                json.get<double>() > double(std::numeric_limits<T>::max()))
                refuse(where, "a whole number");
            value = json.get<T>();
        } else if constexpr (std::is_same_v<T, std::string>) {
            if (!json.is_string()) refuse(where, "a text");
            value = json.get<std::string>();
        } else if constexpr (requires {
                                 value.length();
                                 value[0];
                             })
            read_vector(json, value, where);
        else if constexpr (requires { typename T::mapped_type; })
            read_map(json, value, where);
        else if constexpr (requires { value.resize(0); })
            read_list(json, value, where);
        else if constexpr (requires { value.begin(); })
            read_array(json, value, where);
        else {
            FieldReader inner(json, where);
            fields(inner, value);
            inner.finish();
        }
    }

private:
    [[noreturn]] static void refuse(const std::string& where, const std::string& wanted) {
        throw Error(Errc::bad_input, where + " has to be " + wanted + ".");
    }
    static double read_number(const Json& json, const std::string& where) {
        if (json.is_number()) return json.get<double>();
        const std::string text = json.is_string() ? json.get<std::string>() : "";
        if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
        if (text == "inf") return std::numeric_limits<double>::infinity();
        if (text == "-inf") return -std::numeric_limits<double>::infinity();
        refuse(where, "a number");
    }
    static void read_effects(const Json& json, std::vector<Effect>& value, const std::string& where) {
        if (!json.is_string()) refuse(where, "a text");
        const std::string text = json.get<std::string>();
        try {
            value = text.empty() ? std::vector<Effect>() : parse_effects(text);
        } catch (const Error& error) {
            throw Error(Errc::bad_input, where + ": " + error.what());
        }
    }
    template <class T>
    static void read_optional(const Json& json, std::optional<T>& value, const std::string& where) {
        if (json.is_null()) return value.reset();
        T inner{};
        read(json, inner, where);
        value = std::move(inner);
    }
    template <class V>
    static void read_vector(const Json& json, V& value, const std::string& where) {
        if (!json.is_array() || json.size() != std::size_t(value.length()))
            refuse(where, "a list of " + std::to_string(value.length()) + " numbers");
        for (int i = 0; i < int(value.length()); ++i) read(json[std::size_t(i)], value[i], where);
    }
    template <class L>
    static void read_list(const Json& json, L& value, const std::string& where) {
        if (!json.is_array()) refuse(where, "a list");
        value.clear();
        for (std::size_t i = 0; i < json.size(); ++i) {
            typename L::value_type item{};
            read(json[i], item, where + "[" + std::to_string(i) + "]");
            value.push_back(std::move(item));
        }
    }
    /// Of an enumeration's words.
    template <class M>
    static void read_map(const Json& json, M& value, const std::string& where) {
        if (!json.is_object()) refuse(where, "an object");
        value.clear();
        for (const auto& [word, item] : json.items()) {
            typename M::key_type key{};
            read(Json(word), key, where);
            read(item, value[key], where + "." + word);
        }
    }
    template <class A>
    static void read_array(const Json& json, A& value, const std::string& where) {
        if (!json.is_array() || json.size() != value.size()) refuse(where, "a list of " + std::to_string(value.size()));
        for (std::size_t i = 0; i < json.size(); ++i) read(json[i], value[i], where);
    }

    const Json& json_;
    std::string where_;
    std::set<std::string, std::less<>> known_;
};

}  // namespace lacuna
