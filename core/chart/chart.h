#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/canvas.h"
#include "core/chart/palette.h"

namespace lacuna {

enum class Scale { linear, log };
enum class AxisName { x, y };

/// An axis as asked for; what is left open is fitted to what is drawn.
struct Axis {
    std::string title = {}, unit = {};  ///< drawn as "title (unit)"
    Scale scale = Scale::linear;
    std::optional<double> lo = {}, hi = {};  ///< the ends; a log axis needs them above 0
    /// Log only: values of 0 and below stand in a lane of their own at the low end, labelled 0, instead of being left
    /// out. It is there only when such a value is.
    bool zero_lane = false;
    std::vector<std::string> categories = {};  ///< not empty: names of the values 0, 1, 2, ... instead of numbers
    char decimal_mark = '.';                   ///< of the numbers drawn; ',' where readers expect one
};

struct DataPoint {
    double x = 0, y = 0;
    std::string label = {};                                 ///< written beside the point where there is room
    double low = std::numeric_limits<double>::quiet_NaN();  ///< whisker along y from low to high; none where NaN
    double high = std::numeric_limits<double>::quiet_NaN();
};

/// Points drawn alike, with one entry in the legend where it has a name. Points that are not finite, or not above 0 on
/// a log axis without a zero lane, are left out; a line breaks there.
struct Series {
    std::string name = {};
    std::vector<DataPoint> points = {};
    std::optional<Marker> marker = {};     ///< none given: chosen by the series' place in the chart
    std::optional<glm::dvec3> color = {};  ///< likewise
    bool line = false;                     ///< joined in the order given
    bool steps = false;                    ///< joined by level and upright pieces: a staircase
    bool open = false;                     ///< markers filled white
    double size = 5;                       ///< of a marker, points
    double width = 1.3;                    ///< of the line, points
    std::vector<double> dashes = {};
};

/// A histogram: heights[i] stands over [edges[i], edges[i + 1]].
struct Bars {
    std::string name = {};
    std::vector<double> edges = {}, heights = {};
    std::optional<glm::dvec3> color = {};
    double opacity = 0.85;
};

/// A stretch of an axis, shaded across the plot.
struct Band {
    AxisName axis = AxisName::x;
    double lo = 0, hi = 0;
    std::string label = {};
    glm::dvec3 color{0.45, 0.55, 0.65};
    double opacity = 0.16;
};

/// A value of an axis, drawn as a line across the plot.
struct Mark {
    AxisName axis = AxisName::x;
    double at = 0;
    std::string label = {};
    glm::dvec3 color{0.25};
    std::vector<double> dashes = {3, 2};
    double width = 1;
};

enum class Legend { right, top, none };

/// A chart as a value: what is to be seen, no word of where. Drawn in this order: bands, grid, bars, marks, lines,
/// whiskers, markers, labels.
struct Chart {
    std::string title = {}, subtitle = {};
    std::string note = {};  ///< small print under the chart
    Axis x = {}, y = {};
    std::vector<Bars> bars = {};
    std::vector<Series> series = {};
    std::vector<Band> bands = {};
    std::vector<Mark> marks = {};
    Legend legend = Legend::right;  ///< only where something has a name
};

/// Where a chart drew its points, on the canvas: by series, then by point; NaN where a point was left out.
using PointPlaces = std::vector<std::vector<glm::dvec2>>;

/// Draws a chart into a box of a canvas. @throws Error(bad_usage) naming the fault: an axis whose ends are not in order
/// or not above 0 on a log scale, bars whose edges do not ascend or do not fit their heights
PointPlaces draw(const Chart& chart, Canvas& canvas, const Box& box);
/// The same on the whole canvas, less a margin.
PointPlaces draw(const Chart& chart, Canvas& canvas);

/// Several charts in rows, under one title and one legend of all their names.
struct ChartSheet {
    std::string title = {}, subtitle = {}, note = {};
    std::vector<Chart> charts = {};
    int columns = 2;
};

/// @copydoc draw  @throws Error(bad_usage) also for a sheet without charts or columns
void draw(const ChartSheet& sheet, Canvas& canvas);

/// A chart as the text of an SVG element, fit to stand inside HTML beside others. @param size points
std::string to_svg(const Chart& chart, glm::dvec2 size = {480, 300});
/// A chart as the bytes of a PNG file.
std::string to_png(const Chart& chart, glm::dvec2 size = {480, 300}, double pixels_per_point = 2.5);

/// Writes a sheet to OUT.svg, OUT.png or OUT.pdf, all or nothing; its height follows from the number of rows.
/// @param panel size of one chart, points
/// @throws Error(bad_usage) for another ending, Error(io)
void save(const ChartSheet& sheet, const std::filesystem::path& target, glm::dvec2 panel = {330, 230});
/// @throws Error(bad_usage) for a name that does not end in .svg, .png or .pdf
void check_chart_name(const std::filesystem::path& target);

}  // namespace lacuna
