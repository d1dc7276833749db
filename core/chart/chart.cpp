#include "core/chart/chart.h"

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/chart/axis_scale.h"
#include "core/chart/chart_parts.h"

namespace lacuna {

namespace chart {

namespace {

void check_bars(const Bars& bars) {
    if (bars.edges.size() != bars.heights.size() + 1)
        throw Error(Errc::bad_usage, "Bars need one edge more than they have heights.");
    for (std::size_t i = 0; i + 1 < bars.edges.size(); ++i)
        if (!(bars.edges[i] < bars.edges[i + 1])) throw Error(Errc::bad_usage, "The edges of bars must ascend.");
}

Extent extent_of(const Chart& chart, AxisName name) {
    const bool x = name == AxisName::x;
    const Axis& axis = x ? chart.x : chart.y;
    Extent extent;
    const auto add = [&](double value) { extent.add(value, axis.scale); };
    for (const Series& series : chart.series)
        for (const DataPoint& p : series.points) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
            add(x ? p.x : p.y);
            if (!x && p.low > 0) add(p.low);
            if (!x) add(p.high);
        }
    for (const Bars& bars : chart.bars)
        for (const double value : x ? bars.edges : bars.heights) add(value);
    for (const Mark& mark : chart.marks)
        if (mark.axis == name) add(mark.at);
    return extent;
}

std::string title_of(const Axis& axis) { return axis.unit.empty() ? axis.title : axis.title + " (" + axis.unit + ")"; }

double widest(const Canvas& canvas, const std::vector<Tick>& ticks) {
    double width = 0;
    for (const Tick& tick : ticks) width = std::max(width, canvas.measure(tick.label, k_tick_style).x);
    return width;
}

/// Ticks whose labels would overlap their neighbours' lose them, those at the ends last.
void thin_out(const Canvas& canvas, const AxisScale& scale, std::vector<Tick>& ticks, bool upright) {
    double free_from = -1e9;
    for (Tick& tick : ticks) {
        if (tick.label.empty()) continue;
        const glm::dvec2 size = canvas.measure(tick.label, k_tick_style);
        const double at = upright ? -scale.at(tick.value) : scale.at(tick.value);
        const double half = 0.5 * (upright ? 0.8 * size.y : size.x + 5);
        if (at - half < free_from)
            tick.label.clear();
        else
            free_from = at + half;
    }
}

void draw_grid(Canvas& canvas, const Box& plot, const AxisScale& scale, const std::vector<Tick>& ticks, bool upright) {
    for (const Tick& tick : ticks) {
        const double at = scale.at(tick.value);
        const Stroke stroke{glm::dvec3(tick.label.empty() ? 0.94 : 0.86), 0.6};
        if (upright)
            canvas.line({plot.x, at}, {plot.right(), at}, stroke);
        else
            canvas.line({at, plot.y}, {at, plot.bottom()}, stroke);
    }
    if (!scale.has_lane()) return;
    const double edge = scale.lane_end();
    const Box lane =
        upright ? Box{plot.x, edge, plot.width, plot.bottom() - edge} : Box{plot.x, plot.y, edge - plot.x, plot.height};
    canvas.rectangle(lane, {glm::dvec3(0.955), 1});
    const double zero = scale.at(0);
    if (upright)
        canvas.line({plot.x, zero}, {plot.right(), zero}, {glm::dvec3(0.86), 0.6});
    else
        canvas.line({zero, plot.y}, {zero, plot.bottom()}, {glm::dvec3(0.86), 0.6});
}

void draw_tick_labels(Canvas& canvas, const Box& plot, const AxisScale& x, const std::vector<Tick>& x_ticks,
                      const AxisScale& y, const std::vector<Tick>& y_ticks, bool names) {
    const Stroke stroke{k_axis_color, 0.8};
    for (const Tick& tick : x_ticks) {
        const double at = x.at(tick.value), length = tick.label.empty() ? 2 : 3.5;
        if (!names) canvas.line({at, plot.bottom()}, {at, plot.bottom() + length}, stroke);
        canvas.text(tick.label, {at, plot.bottom() + 4.5}, k_tick_style, Align::middle, Align::start);
    }
    for (const Tick& tick : y_ticks) {
        const double at = y.at(tick.value), length = tick.label.empty() ? 2 : 3.5;
        canvas.line({plot.x - length, at}, {plot.x, at}, stroke);
        canvas.text(tick.label, {plot.x - 5.5, at}, k_tick_style, Align::end);
    }
    canvas.line({plot.x, plot.bottom()}, {plot.right(), plot.bottom()}, {k_axis_color, 1});
    canvas.line({plot.x, plot.y}, {plot.x, plot.bottom()}, {k_axis_color, 1});
    // The break between a zero lane and the scale proper.
    const auto cut = [&](const glm::dvec2& at, const glm::dvec2& along) {
        const glm::dvec2 slant(2.5, -2.5);
        canvas.line(at - along, at + along, {glm::dvec3(1), 2});
        for (const double side : {-1.0, 1.0})
            canvas.line(at + side * along - slant, at + side * along + slant, {k_axis_color, 0.8});
    };
    if (y.has_lane()) cut({plot.x, y.lane_end()}, {0, 1.2});
    if (x.has_lane()) cut({x.lane_end(), plot.bottom()}, {1.2, 0});
}

/// Title and subtitle, left-aligned. @return their height with the gap below
double draw_heading(Canvas& canvas, const Box& box, const std::string& title, const std::string& subtitle,
                    const TextStyle& style) {
    double height = 0;
    if (!title.empty()) height += canvas.paragraph(title, {box.x, box.y}, box.width, style) + 1;
    if (!subtitle.empty()) height += canvas.paragraph(subtitle, {box.x, box.y + height}, box.width, k_subtitle_style);
    return height > 0 ? height + 6 : 0;
}

double draw_note(Canvas& canvas, const Box& box, const std::string& note) {
    if (note.empty()) return 0;
    const double height = canvas.measure(note, k_note_style, box.width).y;
    canvas.paragraph(note, {box.x, box.bottom() - height}, box.width, k_note_style);
    return height + 5;
}

/// Where the plot lies once the labels around it have their room.
Box place_plot(const Canvas& canvas, const Chart& chart, const Box& box) {
    // The y labels depend on the height alone, so a trial scale of the right height measures them.
    const double x_height = canvas.measure("0", k_tick_style).y + 5 + (title_of(chart.x).empty() ? 0 : 14);
    const AxisScale trial(chart.y, extent_of(chart, AxisName::y), box.bottom() - x_height, box.y + 5,
                          !chart.bars.empty());
    const double label = widest(canvas, trial.ticks(int(box.height / 38)));
    const double left = label + 7 + (title_of(chart.y).empty() ? 0 : 15);
    Box plot{box.x + left, box.y + 5, box.width - left - 7, box.height - 5 - x_height};
    if (!(plot.width >= 20 && plot.height >= 20))
        throw Error(Errc::bad_usage, "The chart's box is too small for its labels.");
    return plot;
}

}  // namespace

PointPlaces draw_panel(const Chart& chart, Canvas& canvas, const Box& box) {
    const Box plot = place_plot(canvas, chart, box);
    const bool bars = !chart.bars.empty();
    const AxisScale x(chart.x, extent_of(chart, AxisName::x), plot.x, plot.right());
    const AxisScale y(chart.y, extent_of(chart, AxisName::y), plot.bottom(), plot.y, bars);
    std::vector<Tick> x_ticks = x.ticks(int(plot.width / 60)), y_ticks = y.ticks(int(box.height / 38));
    thin_out(canvas, x, x_ticks, false);
    thin_out(canvas, y, y_ticks, true);

    draw_grid(canvas, plot, y, y_ticks, true);
    if (chart.x.categories.empty()) draw_grid(canvas, plot, x, x_ticks, false);
    canvas.clip(plot);
    for (const Band& band : chart.bands) draw_band(canvas, plot, band, band.axis == AxisName::x ? x : y);
    for (std::size_t i = 0; i < chart.bars.size(); ++i) draw_bars(canvas, chart.bars[i], i, x, y);
    canvas.unclip();
    draw_mark_lines(canvas, plot, chart, x, y);
    canvas.clip(plot);
    for (std::size_t i = 0; i < chart.series.size(); ++i) draw_line(canvas, chart.series[i], i, x, y);
    canvas.unclip();
    for (std::size_t i = 0; i < chart.series.size(); ++i) draw_markers(canvas, plot, chart.series[i], i, x, y);
    draw_tick_labels(canvas, plot, x, x_ticks, y, y_ticks, !chart.x.categories.empty());
    draw_labels(canvas, plot, chart, x, y);

    canvas.text(title_of(chart.x), {plot.middle().x, box.bottom()}, k_axis_style, Align::middle, Align::end);
    canvas.text(title_of(chart.y), {box.x, plot.middle().y}, k_axis_style, Align::middle, Align::start, true);

    PointPlaces places(chart.series.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const DataPoint& point : chart.series[i].points) places[i].emplace_back(x.at(point.x), y.at(point.y));
    return places;
}

}  // namespace chart

using namespace chart;

PointPlaces draw(const Chart& chart, Canvas& canvas, const Box& box) {
    for (const Bars& bars : chart.bars) check_bars(bars);
    Box rest = box;
    const double heading = draw_heading(canvas, box, chart.title, chart.subtitle, k_title_style);
    rest.y += heading;
    rest.height -= heading + draw_note(canvas, box, chart.note);
    std::vector<LegendEntry> entries;
    add_entries(chart, entries);
    if (chart.legend == Legend::top && !entries.empty()) {
        const double height = draw_legend_row(canvas, rest, entries);
        rest.y += height;
        rest.height -= height;
    } else if (chart.legend == Legend::right && !entries.empty()) {
        rest.width -= draw_legend_column(canvas, rest, entries);
    }
    return draw_panel(chart, canvas, rest);
}

PointPlaces draw(const Chart& chart, Canvas& canvas) {
    return draw(chart, canvas, Box{0, 0, canvas.size().x, canvas.size().y}.shrunk(k_margin));
}

void draw(const ChartSheet& sheet, Canvas& canvas) {
    if (sheet.charts.empty() || sheet.columns < 1)
        throw Error(Errc::bad_usage, "A sheet needs at least one chart and one column.");
    Box rest = Box{0, 0, canvas.size().x, canvas.size().y}.shrunk(k_margin);
    double top = draw_heading(canvas, rest, sheet.title, sheet.subtitle, k_sheet_style);
    const double bottom = draw_note(canvas, rest, sheet.note);
    rest.y += top;
    rest.height -= top + bottom;
    std::vector<LegendEntry> entries;
    for (const Chart& chart : sheet.charts) add_entries(chart, entries);
    // Lines drawn through the points of others come last, whichever chart named them first.
    std::stable_partition(entries.begin(), entries.end(),
                          [](const LegendEntry& entry) { return entry.marker != Marker::none; });
    top = entries.empty() ? 0 : draw_legend_row(canvas, rest, entries);
    rest.y += top;
    rest.height -= top;
    const int count = int(sheet.charts.size()), columns = std::min(sheet.columns, count);
    const int rows = (count + columns - 1) / columns;
    const double width = (rest.width - k_gap * (columns - 1)) / columns;
    const double height = (rest.height - k_gap * (rows - 1)) / rows;
    for (int i = 0; i < count; ++i) {
        Chart chart = sheet.charts[std::size_t(i)];
        chart.legend = Legend::none;
        draw(chart, canvas,
             {rest.x + (i % columns) * (width + k_gap), rest.y + (i / columns) * (height + k_gap), width, height});
    }
}

std::string to_svg(const Chart& chart, glm::dvec2 size) {
    Canvas canvas = Canvas::svg(size, chart.title);
    draw(chart, canvas);
    return canvas.finish();
}

std::string to_png(const Chart& chart, glm::dvec2 size, double pixels_per_point) {
    Canvas canvas = Canvas::png(size, pixels_per_point);
    draw(chart, canvas);
    return canvas.finish();
}

namespace {
std::string ending_of(const std::filesystem::path& target) {
    std::string ending = target.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    return ending;
}
}  // namespace

void check_chart_name(const std::filesystem::path& target) {
    const std::string ending = ending_of(target);
    if (ending != ".svg" && ending != ".png" && ending != ".pdf")
        throw Error(Errc::bad_usage, "A chart is written as .svg, .png or .pdf, not as '" + target.string() + "'.");
}

void save(const ChartSheet& sheet, const std::filesystem::path& target, glm::dvec2 panel) {
    check_chart_name(target);
    const std::string ending = ending_of(target);
    const int count = std::max(1, int(sheet.charts.size())), columns = std::clamp(sheet.columns, 1, count);
    const int rows = (count + columns - 1) / columns;
    constexpr double k_heading = 70;
    const glm::dvec2 size(std::max(columns * panel.x, 1.25 * panel.x), rows * panel.y + k_heading);
    // A sheet of very many charts still makes a picture that can be opened.
    const double density = std::min(2.5, 12000 / std::max(size.x, size.y));
    Canvas canvas = ending == ".png"   ? Canvas::png(size, density)
                    : ending == ".pdf" ? Canvas::pdf(size, sheet.title)
                                       : Canvas::svg(size, sheet.title);
    draw(sheet, canvas);
    write_file(target, canvas.finish());
}

}  // namespace lacuna
