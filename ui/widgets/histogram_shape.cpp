#include "ui/widgets/histogram_shape.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ui {

QPainterPath histogram_shape(const std::vector<std::uint64_t>& counts, ValueRange range, ValueRange shown,
                             bool logarithmic, const QRectF& plot) {
    if (counts.empty() || !(range.width() > 0)) return {};
    const int columns = std::max(1, int(plot.width()));
    std::vector<double> column(std::size_t(columns), 0.0);
    const double bins_per_value = double(counts.size()) / range.width();
    const double values_per_column = shown.width() / columns;
    double highest = logarithmic ? 1 : 1e-9;
    for (int x = 0; x < columns; ++x) {
        // Values far beside a narrow range lie more bins away than an int can count.
        const auto bin_at = [&](double columns_on) {
            return std::clamp((shown.lo + columns_on * values_per_column - range.lo) * bins_per_value, -1.0,
                              double(counts.size()));
        };
        const int from = int(std::floor(bin_at(x))), to = int(std::ceil(bin_at(x + 1)));
        const int first = std::max(0, from), last = std::min(int(counts.size()) - 1, std::max(from, to - 1));
        std::uint64_t peak = 0;
        for (int bin = first; bin <= last; ++bin) peak = std::max(peak, counts[std::size_t(bin)]);
        column[std::size_t(x)] = logarithmic ? std::log1p(double(peak)) : double(peak);
        highest = std::max(highest, column[std::size_t(x)]);
    }
    QPainterPath path(QPointF(plot.left(), plot.bottom()));
    for (int x = 0; x < columns; ++x)
        path.lineTo(plot.left() + x + 0.5, plot.bottom() - column[std::size_t(x)] / highest * plot.height());
    path.lineTo(plot.right(), plot.bottom());
    return path;
}

}  // namespace lacuna::ui
