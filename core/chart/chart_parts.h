#pragma once

#include "core/chart/axis_scale.h"
#include "core/chart/chart.h"

// The pieces a chart is drawn of; used by the files of core/chart alone.
namespace lacuna::chart {

inline constexpr glm::dvec3 k_ink{0.13}, k_axis_color{0.25}, k_quiet{0.38};
inline constexpr double k_margin = 10, k_gap = 14;
inline const TextStyle k_sheet_style{12, true, k_ink}, k_title_style{10, true, k_ink},
    k_subtitle_style{8, false, k_quiet}, k_axis_style{8.5, false, k_ink}, k_tick_style{7.5, false, k_axis_color, true},
    k_legend_style{8, false, k_ink}, k_label_style{7, false, k_axis_color}, k_note_style{7, false, k_quiet};

struct LegendEntry {
    std::string name;
    glm::dvec3 color{0};
    Marker marker = Marker::none;
    bool line = false, open = false, bar = false;
    std::vector<double> dashes;
};

/// Adds what the chart names and the list lacks.
void add_entries(const Chart& chart, std::vector<LegendEntry>& entries);
/// Entries side by side from the box's top left, in rows. @return height with the gap below
double draw_legend_row(Canvas& canvas, const Box& box, const std::vector<LegendEntry>& entries);
/// Entries under each other at the box's right. @return width with the gap to its left
double draw_legend_column(Canvas& canvas, const Box& box, const std::vector<LegendEntry>& entries);

void draw_band(Canvas& canvas, const Box& plot, const Band& band, const AxisScale& scale);
void draw_bars(Canvas& canvas, const Bars& bars, std::size_t place, const AxisScale& x, const AxisScale& y);
void draw_mark_lines(Canvas& canvas, const Box& plot, const Chart& chart, const AxisScale& x, const AxisScale& y);
void draw_line(Canvas& canvas, const Series& series, std::size_t place, const AxisScale& x, const AxisScale& y);
void draw_markers(Canvas& canvas, const Box& plot, const Series& series, std::size_t place, const AxisScale& x,
                  const AxisScale& y);
/// Labels of bands, marks and points, placed where they cover neither each other nor a marker; a point's label that
/// finds no such place is left out.
void draw_labels(Canvas& canvas, const Box& plot, const Chart& chart, const AxisScale& x, const AxisScale& y);

}  // namespace lacuna::chart
