#include "core/chart/chart_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna::chart {

namespace {

constexpr double k_sample_width = 16, k_row = 12.5;  // of a legend entry

glm::dvec3 color_of(const Series& series, std::size_t place) { return series.color.value_or(series_color(place)); }

Marker marker_of(const Series& series, std::size_t place) {
    if (series.marker) return *series.marker;
    return series.line || series.steps ? Marker::none : series_marker(place);
}

glm::dvec2 place_of(const DataPoint& point, const AxisScale& x, const AxisScale& y) {
    return {x.at(point.x), y.at(point.y)};
}

bool drawn(const glm::dvec2& at) { return std::isfinite(at.x) && std::isfinite(at.y); }

/// The box of a stretch or, where lo == hi, the line of a value across the plot.
Box across(const Box& plot, AxisName axis, double from, double to) {
    if (from > to) std::swap(from, to);
    return axis == AxisName::x ? Box{from, plot.y, to - from, plot.height} : Box{plot.x, from, plot.width, to - from};
}

void draw_entry(Canvas& canvas, const glm::dvec2& at, const LegendEntry& entry) {
    const glm::dvec2 middle(at.x + 0.5 * k_sample_width, at.y + 0.5 * k_row);
    if (entry.bar) canvas.rectangle({at.x + 2, middle.y - 4, k_sample_width - 4, 8}, {entry.color, 0.85});
    if (entry.line)
        canvas.line({at.x, middle.y}, {at.x + k_sample_width, middle.y}, {entry.color, 1.3, 1, entry.dashes});
    draw_marker(canvas, entry.marker, middle, 5.5, entry.color, entry.open);
    canvas.text(entry.name, {at.x + k_sample_width + 4, middle.y}, k_legend_style);
}

double entry_width(const Canvas& canvas, const LegendEntry& entry) {
    return k_sample_width + 4 + canvas.measure(entry.name, k_legend_style).x;
}

}  // namespace

void add_entries(const Chart& chart, std::vector<LegendEntry>& entries) {
    const auto add = [&](LegendEntry entry) {
        const bool known =
            std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return e.name == entry.name; });
        if (!entry.name.empty() && !known) entries.push_back(std::move(entry));
    };
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
        const Bars& bars = chart.bars[i];
        add({bars.name, bars.color.value_or(series_color(i)), Marker::none, false, false, true, {}});
    }
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& s = chart.series[i];
        add({s.name, color_of(s, i), marker_of(s, i), s.line || s.steps, s.open, false, s.dashes});
    }
}

double draw_legend_row(Canvas& canvas, const Box& box, const std::vector<LegendEntry>& entries) {
    glm::dvec2 at(box.x, box.y);
    for (const LegendEntry& entry : entries) {
        const double width = entry_width(canvas, entry);
        if (at.x > box.x && at.x + width > box.right()) at = {box.x, at.y + k_row};
        draw_entry(canvas, at, entry);
        at.x += width + 14;
    }
    return at.y + k_row + 6 - box.y;
}

double draw_legend_column(Canvas& canvas, const Box& box, const std::vector<LegendEntry>& entries) {
    double width = 0;
    for (const LegendEntry& entry : entries) width = std::max(width, entry_width(canvas, entry));
    glm::dvec2 at(box.right() - width, box.y + 5);
    for (const LegendEntry& entry : entries) {
        draw_entry(canvas, at, entry);
        at.y += k_row;
    }
    return width + 12;
}

void draw_band(Canvas& canvas, const Box& plot, const Band& band, const AxisScale& scale) {
    const double from = scale.at(band.lo), to = scale.at(band.hi);
    if (std::isfinite(from) && std::isfinite(to))
        canvas.rectangle(across(plot, band.axis, from, to), {band.color, band.opacity});
}

void draw_bars(Canvas& canvas, const Bars& bars, std::size_t place, const AxisScale& x, const AxisScale& y) {
    const glm::dvec3 color = bars.color.value_or(series_color(place));
    for (std::size_t i = 0; i < bars.heights.size(); ++i) {
        const double left = x.at(bars.edges[i]), right = x.at(bars.edges[i + 1]), top = y.at(bars.heights[i]);
        // On a log axis bars stand on the axis, for it has no 0.
        double foot = y.at(0);
        if (!std::isfinite(foot)) foot = y.at(y.lo());
        if (!std::isfinite(left) || !std::isfinite(right) || !std::isfinite(top) || top == foot) continue;
        const double gap = right - left > 3 ? 0.4 : 0;
        canvas.rectangle({left + gap, std::min(top, foot), right - left - 2 * gap, std::fabs(foot - top)},
                         {color, bars.opacity});
    }
}

void draw_mark_lines(Canvas& canvas, const Box& plot, const Chart& chart, const AxisScale& x, const AxisScale& y) {
    for (const Mark& mark : chart.marks) {
        const double at = (mark.axis == AxisName::x ? x : y).at(mark.at);
        if (!std::isfinite(at)) continue;
        const Stroke stroke{mark.color, mark.width, 1, mark.dashes};
        if (mark.axis == AxisName::x)
            canvas.line({at, plot.y}, {at, plot.bottom()}, stroke);
        else
            canvas.line({plot.x, at}, {plot.right(), at}, stroke);
    }
}

void draw_line(Canvas& canvas, const Series& series, std::size_t place, const AxisScale& x, const AxisScale& y) {
    if (!series.line && !series.steps) return;
    const Stroke stroke{color_of(series, place), series.width, 1, series.dashes};
    std::vector<glm::dvec2> piece;
    const auto flush = [&] {
        if (piece.size() > 1) canvas.polyline(piece, stroke);
        piece.clear();
    };
    for (const DataPoint& point : series.points) {
        const glm::dvec2 at = place_of(point, x, y);
        if (!drawn(at)) {
            flush();
            continue;
        }
        if (series.steps && !piece.empty()) piece.push_back({at.x, piece.back().y});
        piece.push_back(at);
    }
    flush();
}

void draw_markers(Canvas& canvas, const Box& plot, const Series& series, std::size_t place, const AxisScale& x,
                  const AxisScale& y) {
    const glm::dvec3 color = color_of(series, place);
    const Marker marker = marker_of(series, place);
    const Box visible = plot.shrunk(-0.5);
    for (const DataPoint& point : series.points) {
        const double low = y.at(point.low), high = y.at(point.high), at = x.at(point.x);
        if (std::isfinite(low) && std::isfinite(high) && std::isfinite(at) && visible.contains({at, high}) &&
            visible.contains({at, low}))
            canvas.line({at, low}, {at, high}, {color, 0.8, 0.7});
    }
    for (const DataPoint& point : series.points) {
        const glm::dvec2 at = place_of(point, x, y);
        if (drawn(at) && visible.contains(at)) draw_marker(canvas, marker, at, series.size, color, series.open);
    }
}

namespace {

/// Finds free room for labels.
class Labeller {
public:
    Labeller(Canvas& canvas, const Box& plot) : canvas_(canvas), plot_(plot) {}

    void keep_free(const Box& box) { taken_.push_back(box); }

    /// Places a text at the first of the corners that is free. @return false where none is
    bool place(const std::string& text, const std::vector<glm::dvec2>& corners, const glm::dvec3& color,
               const Box* own = nullptr, double veil = 0.75) {
        const glm::dvec2 size = canvas_.measure(text, k_label_style);
        for (const glm::dvec2& corner : corners) {
            const Box box{corner.x, corner.y, size.x, size.y};
            if (!free(box, own)) continue;
            canvas_.rectangle(box.shrunk(-0.5), {glm::dvec3(1), veil});
            TextStyle style = k_label_style;
            style.color = color;
            canvas_.text(text, corner, style, Align::start, Align::start);
            taken_.push_back(box);
            return true;
        }
        return false;
    }

private:
    bool free(const Box& box, const Box* own) const {
        if (box.x < plot_.x + 1 || box.y < plot_.y || box.right() > plot_.right() || box.bottom() > plot_.bottom())
            return false;
        return std::none_of(taken_.begin(), taken_.end(),
                            [&](const Box& b) { return b.meets(box) && !(own && b.x == own->x && b.y == own->y); });
    }

    Canvas& canvas_;
    Box plot_;
    std::vector<Box> taken_;
};

/// Keeps a line's course free, in pieces short enough that their boxes hug it.
void keep_line_free(Labeller& labeller, const Series& series, const AxisScale& x, const AxisScale& y) {
    constexpr double k_piece = 5;
    glm::dvec2 before(std::numeric_limits<double>::quiet_NaN());
    const auto run = [&](const glm::dvec2& from, const glm::dvec2& to) {
        const int pieces = std::min(200, 1 + int(glm::length(to - from) / k_piece));
        for (int i = 0; i < pieces; ++i) {
            const glm::dvec2 a = glm::mix(from, to, double(i) / pieces), b = glm::mix(from, to, (i + 1.0) / pieces);
            const glm::dvec2 low = glm::min(a, b) - 0.5, high = glm::max(a, b) + 0.5;
            labeller.keep_free({low.x, low.y, high.x - low.x, high.y - low.y});
        }
    };
    for (const DataPoint& point : series.points) {
        const glm::dvec2 at = place_of(point, x, y);
        if (drawn(at) && drawn(before)) {
            const glm::dvec2 corner = series.steps ? glm::dvec2(at.x, before.y) : at;
            run(before, corner);
            if (series.steps) run(corner, at);
        }
        before = at;
    }
}

/// Along the line, from its high end down, on either side.
std::vector<glm::dvec2> corners_along(const Box& plot, AxisName axis, double at, const glm::dvec2& size) {
    std::vector<glm::dvec2> corners;
    constexpr int k_tries = 12;
    for (int i = 0; i < k_tries; ++i)
        for (const bool far : {true, false}) {
            if (axis == AxisName::x) {
                const double y = plot.y + 2 + i * (plot.height - size.y - 4) / (k_tries - 1);
                corners.push_back({far ? at + 3 : at - 3 - size.x, y});
            } else {
                const double x = plot.right() - size.x - 3 - i * (plot.width - size.x - 6) / (k_tries - 1);
                corners.push_back({x, far ? at - size.y - 1.5 : at + 1.5});
            }
        }
    return corners;
}

/// Around a point, near first.
std::vector<glm::dvec2> corners_about(const glm::dvec2& at, double radius, const glm::dvec2& size) {
    std::vector<glm::dvec2> corners;
    for (const double gap : {radius + 2, radius + 9}) {
        const double left = at.x - gap - size.x, right = at.x + gap, up = at.y - gap - size.y, down = at.y + gap;
        const double mid_x = at.x - 0.5 * size.x, mid_y = at.y - 0.5 * size.y;
        for (const glm::dvec2& corner : std::array<glm::dvec2, 8>{{{right, mid_y},
                                                                   {right - gap, up},
                                                                   {left, mid_y},
                                                                   {right - gap, down},
                                                                   {mid_x, up},
                                                                   {mid_x, down},
                                                                   {left + gap, up},
                                                                   {left + gap, down}}})
            corners.push_back(corner);
    }
    return corners;
}

}  // namespace

void draw_labels(Canvas& canvas, const Box& plot, const Chart& chart, const AxisScale& x, const AxisScale& y) {
    Labeller labeller(canvas, plot);
    const auto box_of = [&](const Series& series, const glm::dvec2& at) {
        const double r = 0.5 * series.size + 0.5;
        return Box{at.x - r, at.y - r, 2 * r, 2 * r};
    };
    for (std::size_t i = 0; i < chart.series.size(); ++i)
        for (const DataPoint& point : chart.series[i].points)
            if (const glm::dvec2 at = place_of(point, x, y); drawn(at) && marker_of(chart.series[i], i) != Marker::none)
                labeller.keep_free(box_of(chart.series[i], at));
    for (const Series& series : chart.series)
        if (series.line || series.steps) keep_line_free(labeller, series, x, y);
    for (const Mark& mark : chart.marks) {
        const double at = (mark.axis == AxisName::x ? x : y).at(mark.at);
        if (mark.label.empty() || !std::isfinite(at)) continue;
        labeller.place(mark.label, corners_along(plot, mark.axis, at, canvas.measure(mark.label, k_label_style)),
                       mark.color);
        labeller.keep_free(across(plot, mark.axis, at - 0.5, at + 0.5));
    }
    for (const Band& band : chart.bands) {
        const AxisScale& scale = band.axis == AxisName::x ? x : y;
        const double middle = 0.5 * (scale.at(band.lo) + scale.at(band.hi));
        if (band.label.empty() || !std::isfinite(middle)) continue;
        const glm::dvec2 size = canvas.measure(band.label, k_label_style);
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 10; ++i)
            corners.push_back(band.axis == AxisName::x
                                  ? glm::dvec2(middle - 0.5 * size.x, plot.y + 2 + i * (size.y + 1))
                                  : glm::dvec2(plot.x + 4 + i * 0.1 * plot.width, middle - 0.5 * size.y));
        labeller.place(band.label, corners, 0.7 * band.color, nullptr, 0);
    }
    for (const Series& series : chart.series)
        for (const DataPoint& point : series.points) {
            const glm::dvec2 at = place_of(point, x, y);
            if (point.label.empty() || !drawn(at)) continue;
            const glm::dvec2 size = canvas.measure(point.label, k_label_style);
            const Box own = box_of(series, at);
            labeller.place(point.label, corners_about(at, 0.5 * series.size, size), k_axis_color, &own);
        }
}

}  // namespace lacuna::chart
