#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/order_statistics.h"
#include "core/inspect/batch.h"
#include "core/inspect/report_document.h"
#include "core/inspect/report_text.h"

namespace lacuna {

namespace {

constexpr double k_outlier = 3.5;  // Iglewicz & Hoaglin 1993, How to Detect and Handle Outliers
const Measured k_missing{NAN, NAN, NAN};

const Measured& value_of(const BatchRow& row, const std::string& name) {
    for (const auto& [key, value] : row.values)
        if (key == name) return value;
    return k_missing;
}

/// Iglewicz & Hoaglin 1993: 0.6745 (x - median) / MAD; where more than half the values are equal, and MAD is 0, the
/// mean absolute deviation times 1.253314 stands in for it. Both make it the usual z-score of normally distributed
/// values.
double robust_z(double value, double middle, double mad, double mean_deviation) {
    if (!std::isfinite(value) || !std::isfinite(middle)) return NAN;
    const double rounding = 1e-12 * std::abs(middle);
    if (mad > rounding) return 0.6745 * (value - middle) / mad;
    return mean_deviation > rounding ? (value - middle) / (1.253314 * mean_deviation) : 0;
}

std::vector<std::string> outliers_of(const std::vector<SeriesStatistics>& series, std::size_t row) {
    std::vector<std::string> names;
    for (const SeriesStatistics& s : series)
        if (s.outlier[row]) names.push_back(s.name);
    return names;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

std::string verdict_word(const BatchRow& row) { return row.verdict ? std::string(name_of(*row.verdict)) : "broken"; }

struct Counts {
    std::size_t pass = 0, fail = 0, cannot_tell = 0, broken = 0;
};

Counts count(const std::vector<BatchRow>& rows) {
    Counts n;
    for (const BatchRow& row : rows)
        ++(!row.verdict                    ? n.broken
           : *row.verdict == Verdict::pass ? n.pass
           : *row.verdict == Verdict::fail ? n.fail
                                           : n.cannot_tell);
    return n;
}

Chart values_chart(const std::vector<BatchRow>& rows, const std::vector<SeriesStatistics>& series,
                   const std::string& name, const std::string& title, const std::string& unit,
                   std::optional<double> limit) {
    Chart chart;
    chart.title = title;
    chart.x.title = "part";
    chart.y.title = title;
    chart.y.unit = unit;
    chart.y.lo = 0;
    Series usual{"within the series", {}, Marker::circle},
        odd{"outlier", {}, Marker::diamond, glm::dvec3(0.72, 0.11, 0.11)};
    const auto found =
        std::find_if(series.begin(), series.end(), [&](const SeriesStatistics& s) { return s.name == name; });
    double largest = limit.value_or(0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Measured& m = value_of(rows[i], name);
        if (!std::isfinite(m.value)) continue;
        const bool outlier = found != series.end() && found->outlier[i];
        DataPoint point{double(i + 1), m.value, outlier ? rows[i].name : "", m.lo, m.hi};
        largest = std::max(largest, m.hi);
        (outlier ? odd : usual).points.push_back(std::move(point));
    }
    chart.y.hi = largest > 0 ? 1.05 * largest : 1;
    if (limit) chart.marks.push_back({AxisName::y, *limit, "limit", {0.72, 0.11, 0.11}});
    if (found != series.end() && found->reference && std::isfinite(*found->reference))
        chart.marks.push_back({AxisName::y, *found->reference, "reference", {0.1, 0.3, 0.6}});
    chart.x.lo = 0;
    chart.x.hi = double(rows.size() + 1);
    for (Series* s : {&usual, &odd})
        if (!s->points.empty()) chart.series.push_back(std::move(*s));
    chart.legend = Legend::none;
    return chart;
}

/// Every characteristic's scores side by side: which part stands out, and by what.
Chart score_chart(const std::vector<SeriesStatistics>& series) {
    constexpr double k_shown = 10;
    Chart chart;
    chart.title = "Robust z-scores";
    chart.subtitle = "by characteristic; beyond the dashed lines: outliers (drawn at 10 where farther)";
    chart.y.title = "z-score";
    chart.y.lo = -k_shown - 1;
    chart.y.hi = k_shown + 1;
    chart.x.title = "characteristic";
    Series scores{"", {}, Marker::dot};
    for (std::size_t s = 0; s < series.size(); ++s)
        for (const double z : series[s].z)
            if (!std::isnan(z)) scores.points.push_back({double(s + 1), std::clamp(z, -k_shown, k_shown)});
    chart.x.lo = 0;
    chart.x.hi = double(series.size() + 1);
    chart.series.push_back(std::move(scores));
    for (const double at : {-k_outlier, k_outlier}) chart.marks.push_back({AxisName::y, at, ""});
    chart.legend = Legend::none;
    return chart;
}

Table parts_table(const std::vector<BatchRow>& rows, const std::vector<SeriesStatistics>& series, bool reference) {
    Table table{{{"Part", 80}, {"Verdict", 50}, {"Why", 140}, {"Outlier in", 120}}, {}, true};
    for (const SeriesStatistics& s : series) {
        table.columns.push_back({s.name, 70, true});
        if (reference) table.columns.push_back({"deviation", 60, true});
        table.columns.push_back({"z", 40, true});
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const BatchRow& row = rows[i];
        TableCell verdict{verdict_word(row), row.verdict ? double(*row.verdict) : 3};
        verdict.mark = row.verdict ? *row.verdict : Verdict::fail;
        std::vector<TableCell> cells{
            {row.name}, verdict, {joined(reasons_of(row), " ")}, {joined(outliers_of(series, i), ", ")}};
        if (row.verdict) cells[0].link = row.name + "/report.html";
        for (const SeriesStatistics& s : series) {
            const Measured& m = value_of(row, s.name);
            const bool there = !std::isnan(m.value);
            cells.push_back({there ? short_interval(m) : "", m.value});
            if (reference)
                cells.push_back(
                    {std::isnan(s.deviation[i]) ? "" : fmt::format("{:+.4g}", s.deviation[i]), s.deviation[i]});
            TableCell z{std::isnan(s.z[i]) ? "" : fmt::format("{:.2f}", s.z[i]), s.z[i]};
            if (s.outlier[i]) z.mark = Verdict::fail;
            cells.push_back(std::move(z));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table statistics_table(const std::vector<SeriesStatistics>& series) {
    Table table{{{"No.", 30, true},
                 {"Characteristic", 150},
                 {"Median", 80, true},
                 {"MAD", 80, true},
                 {"Reference", 80, true},
                 {"Outliers", 60, true}},
                {},
                false};
    for (std::size_t s = 0; s < series.size(); ++s) {
        const auto odd = std::count(series[s].outlier.begin(), series[s].outlier.end(), true);
        table.rows.push_back({{std::to_string(s + 1)},
                              {series[s].name},
                              {short_number(series[s].median)},
                              {short_number(series[s].mad)},
                              {series[s].reference ? short_number(*series[s].reference) : "-"},
                              {std::to_string(odd)}});
    }
    return table;
}

}  // namespace

std::vector<SeriesStatistics> compare_series(const std::vector<BatchRow>& rows,
                                             const std::optional<BatchRow>& reference) {
    std::vector<SeriesStatistics> all;
    const auto known = [&all](const std::string& name) {
        return std::any_of(all.begin(), all.end(), [&](const SeriesStatistics& s) { return s.name == name; });
    };
    for (const BatchRow& row : rows)
        for (const auto& [name, value] : row.values)
            if (!known(name)) {
                all.emplace_back();
                all.back().name = name;
            }
    for (SeriesStatistics& s : all) {
        std::vector<double> values, finite;
        for (const BatchRow& row : rows) values.push_back(value_of(row, s.name).value);
        std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
                     [](double v) { return std::isfinite(v); });
        s.median = median(finite);
        for (double& v : finite) v = std::abs(v - s.median);
        s.mad = median(finite);
        const double mean_deviation =
            finite.empty() ? 0 : std::accumulate(finite.begin(), finite.end(), 0.0) / double(finite.size());
        if (reference) s.reference = value_of(*reference, s.name).value;
        for (const double v : values) {
            const double off = s.reference ? v - *s.reference : NAN;
            s.deviation.push_back(std::isfinite(off) ? off : NAN);
            s.z.push_back(robust_z(v, s.median, s.mad, mean_deviation));
            s.outlier.push_back(std::abs(s.z.back()) > k_outlier);
        }
    }
    return all;
}

std::string summary_csv(const std::vector<BatchRow>& rows, const std::optional<BatchRow>& reference) {
    const std::vector<SeriesStatistics> series = compare_series(rows, reference);
    std::string csv = "part,input,verdict,reason,outlier_in,sha256,more_reasons";
    for (const SeriesStatistics& s : series) {
        csv += fmt::format(",{0},{0}_lo,{0}_hi", s.name);
        if (reference) csv += fmt::format(",{}_deviation", s.name);
        csv += fmt::format(",{}_z", s.name);
    }
    csv += "\r\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const BatchRow& row = rows[i];
        csv += csv_field(row.name) + ',' + csv_field(row.input) + ',' + verdict_word(row) + ',' +
               csv_field(row.reason) + ',' + csv_field(joined(outliers_of(series, i), ";")) + ',' + row.sha256 + ',' +
               csv_field(joined(row.more_reasons, " "));
        for (const SeriesStatistics& s : series) {
            const Measured& m = value_of(row, s.name);
            for (const double v : {m.value, m.lo, m.hi}) csv += ',' + exact_number(v);
            if (reference) csv += ',' + exact_number(s.deviation[i]);
            csv += ',' + exact_number(s.z[i]);
        }
        csv += "\r\n";
    }
    return csv;
}

std::string summary_html(const std::vector<BatchRow>& rows, const std::optional<BatchRow>& reference,
                         const Criteria& criteria, const std::string& software) {
    const std::vector<SeriesStatistics> series = compare_series(rows, reference);
    const Counts n = count(rows);
    ReportDocument document{fmt::format("Inspection of a series of {} parts", rows.size()), software, {}};
    auto& blocks = document.blocks;
    const Verdict verdict = n.fail + n.broken > 0 ? Verdict::fail
                            : n.cannot_tell > 0   ? Verdict::cannot_tell
                                                  : Verdict::pass;
    Banner banner{verdict, fmt::format("{} of {} parts pass", n.pass, rows.size()), {}};
    banner.reasons.push_back(
        fmt::format("{} fail, {} cannot be told, {} are broken.", n.fail, n.cannot_tell, n.broken));
    for (const BatchRow& row : rows)
        if (!row.verdict) banner.reasons.push_back(row.name + " is broken: " + row.reason);
    blocks.push_back(std::move(banner));
    if (!series.empty()) {
        blocks.push_back(Heading{"Over the series"});
        blocks.push_back(ChartRow{
            {values_chart(rows, series, "porosity_percent", "Porosity", "%", criteria.limits[Rule::porosity_percent]),
             values_chart(rows, series, "largest_defect_diameter_mm", "Largest defect's diameter", "mm",
                          criteria.limits[Rule::defect_diameter_mm]),
             values_chart(rows, series, "count", "Defects", "", criteria.limits[Rule::count]),
             values_chart(rows, series, "largest_defect_volume_mm3", "Largest defect's volume", "mm³",
                          criteria.limits[Rule::defect_volume_mm3]),
             values_chart(rows, series, "part_volume_mm3", "Part volume", "mm³", std::nullopt), score_chart(series)}});
        blocks.push_back(Heading{"Characteristics"});
        blocks.push_back(statistics_table(series));
    }
    blocks.push_back(Heading{"Parts"});
    blocks.push_back(parts_table(rows, series, reference.has_value()));
    if (reference)
        blocks.push_back(Paragraph{"Deviations are from the reference component " + reference->input + " (" +
                                   verdict_word(*reference) + ")."});
    blocks.push_back(
        Paragraph{"z is the robust score 0.6745 (x - median) / MAD over the series; beyond 3.5 on either side a value "
                  "is marked as "
                  "an outlier (Iglewicz and Hoaglin 1993). Parts are numbered as listed. Made by " +
                  software + ". Not a medical device."});
    return to_html(document);
}

}  // namespace lacuna
