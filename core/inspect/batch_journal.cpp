#include "core/inspect/batch_journal.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto k_replace = Json::error_handler_t::replace;

// JSON has no NaN and no infinity: words stand for them, so that a row reads back as it was.
Json number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}
double number(const Json& json) {
    if (json.is_number()) return json.get<double>();
    const std::string word = json.get<std::string>();
    return word == "inf" ? INFINITY : word == "-inf" ? -INFINITY : NAN;
}

std::string series_text(const std::vector<BatchPart>& parts, const BatchOptions& options) {
    Json json{{"software", options.software},
              {"criteria", Json::parse(options.criteria.json)},
              {"raw", options.open.raw},
              {"series", options.open.series},
              {"keep_gaps", options.open.keep_gaps},
              {"spacing_mm", nullptr},
              {"reference", options.reference},
              {"worst", options.worst},
              {"shards", options.shards}};
    if (options.open.spacing_mm)
        json["spacing_mm"] = {options.open.spacing_mm->x, options.open.spacing_mm->y, options.open.spacing_mm->z};
    json["parts"] = Json::array();
    for (const BatchPart& part : parts) json["parts"].push_back({{"name", part.name}, {"input", part.input}});
    return json.dump(1, ' ', false, k_replace) + "\n";
}

}  // namespace

void BatchJournal::open(const std::vector<BatchPart>& parts, const BatchOptions& options) {
    const std::string text = series_text(parts, options);
    const fs::path series = folder_ / "series.json";
    std::error_code ec;
    if (fs::exists(series, ec)) {
        if (read_file(series) != text)
            throw Error(Errc::io, "The folder " + folder_.string() +
                                      " holds another series (other parts, criteria, options or version); name a new "
                                      "folder.");
        if (!options.resume && options.shards == 1)
            throw Error(Errc::io, "The folder " + folder_.string() +
                                      " holds this series already; go on with it (--resume), or name a new "
                                      "folder.");
    } else {
        if (fs::exists(folder_, ec) &&
            !(fs::is_directory(folder_, ec) && (fs::is_empty(folder_, ec) || fs::exists(folder_ / "journal", ec))))
            throw Error(Errc::io, "Cannot write " + folder_.string() + ": it is no empty folder; name a new one.");
        fs::create_directories(folder_ / "journal", ec);
        if (ec) throw_cannot_write(folder_, ec.value());
        write_file(series, text);
    }
    fs::create_directories(folder_ / "journal", ec);
    if (ec) throw_cannot_write(folder_, ec.value());
}

void BatchJournal::read_series(std::vector<BatchPart>& parts, BatchOptions& options) const {
    const fs::path series = folder_ / "series.json";
    std::error_code ec;
    if (!fs::exists(series, ec))
        throw Error(Errc::bad_input,
                    "The folder " + folder_.string() + " holds no series; name the --report folder of its shards.");
    try {
        const Json json = Json::parse(read_file(series));
        options.software = json.at("software").get<std::string>();
        options.criteria = parse_criteria(json.at("criteria").dump(), "series.json");
        options.reference = json.at("reference").get<std::string>();
        for (const Json& part : json.at("parts"))
            parts.push_back({part.at("name").get<std::string>(), part.at("input").get<std::string>()});
    } catch (const Json::exception&) {
        throw Error(Errc::bad_input, "The file " + series.string() + " is damaged; start the series anew.");
    }
}

std::optional<BatchRow> BatchJournal::read(const std::string& part) const {
    std::error_code ec;
    if (!fs::exists(entry(part), ec)) return std::nullopt;
    try {
        const Json json = Json::parse(read_file(entry(part)));
        BatchRow row;
        row.name = json.at("name").get<std::string>();
        row.input = json.at("input").get<std::string>();
        row.reason = json.at("reason").get<std::string>();
        row.more_reasons = json.value("more_reasons", std::vector<std::string>());  // entries before 2026-11 have none
        row.sha256 = json.at("sha256").get<std::string>();
        const std::string word = json.at("verdict").get<std::string>();
        for (const Verdict v : {Verdict::pass, Verdict::fail, Verdict::cannot_tell})
            if (name_of(v) == word) row.verdict = v;
        for (const auto& [name, m] : json.at("values").items())
            row.values.emplace_back(name, Measured{number(m.at(0)), number(m.at(1)), number(m.at(2))});
        // A part whose folder is gone is not done.
        if (row.verdict && !fs::exists(folder_ / part / "report.json", ec)) return std::nullopt;
        return row;
    } catch (const Json::exception&) {
        return std::nullopt;  // made anew
    }
}

void BatchJournal::write(const BatchRow& row) const {
    Json json{{"name", row.name},
              {"input", row.input},
              {"verdict", row.verdict ? std::string(name_of(*row.verdict)) : "broken"},
              {"reason", row.reason},
              {"sha256", row.sha256}};
    if (!row.more_reasons.empty()) json["more_reasons"] = row.more_reasons;
    json["values"] = Json::object();
    for (const auto& [name, m] : row.values) json["values"][name] = {number(m.value), number(m.lo), number(m.hi)};
    write_file(entry(row.name), json.dump(1, ' ', false, k_replace) + "\n");
}

void BatchJournal::forget(const std::string& part) const {
    std::error_code ec;
    fs::remove(entry(part), ec);
}

}  // namespace lacuna
