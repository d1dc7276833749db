#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/number_text.h"
#include "ui/theme.h"
#include "ui/widgets/histogram_shape.h"
#include "ui/widgets/plot_paint.h"
#include "ui/widgets/transfer_plot.h"

namespace lacuna::ui {

void TransferPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::colors().base);
    painter.save();
    painter.setClipRect(plotRect().adjusted(-6, -6, 6, 14));
    painter.fillPath(histogram_shape(counts_, range_, shown_, logarithmic_, plotRect()), theme::colors().plot_fill);
    if (!function_.points.empty()) paintFunction(painter);
    if (snapped_to_) {
        painter.setPen(QPen(theme::colors().accent, 1, Qt::DashLine));
        painter.drawLine(QPointF(xOf(*snapped_to_), plotRect().top()), QPointF(xOf(*snapped_to_), plotRect().bottom()));
    }
    paintPoints(painter);
    if (box_) {
        painter.setPen(QPen(theme::colors().accent, 1));
        QColor fill = theme::colors().accent;
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.drawRect(box_->normalized());
    }
    painter.restore();
    paintFoot(painter);
    paint_frame(painter, *this);
}

void TransferPlot::paintFoot(QPainter& painter) const {
    const QRectF foot(plotRect().left(), plotRect().bottom() + 9, plotRect().width(),
                      height() - plotRect().bottom() - 9);
    paint_axis_ends(painter, *this, foot, shown_);
    painter.setPen(theme::colors().text);
    if (selection_.size() > 1) {
        painter.drawText(foot, Qt::AlignCenter, tr("%n points selected", nullptr, int(selection_.size())));
    } else if (selected_ >= 0 && selected_ < int(function_.points.size())) {
        const TransferPoint& p = function_.points[std::size_t(selected_)];
        painter.drawText(foot, Qt::AlignCenter,
                         tr("%1 → %2").arg(number_text(p.value, 'g', 5), number_text(p.opacity, 'f', 3)));
    }
}

void TransferPlot::paintFunction(QPainter& painter) const {
    const QRectF plot = plotRect();
    TransferFunction by_points = function_;
    by_points.by_shapes = false;
    // The colours run along the foot, and under the curve as far as it is opaque.
    QLinearGradient colors(plot.left(), 0, plot.right(), 0);
    const int stops = 64;
    for (int i = 0; i <= stops; ++i) {
        const double share = double(i) / stops;
        colors.setColorAt(share, to_qcolor(by_points.at(shown_.lo + share * shown_.width()).color));
    }
    if (!colorless_) painter.fillRect(QRectF(plot.left(), plot.bottom() + 2, plot.width(), 5), colors);
    QPolygonF curve;
    curve << QPointF(plot.left() - 10, yOf(function_.points.front().opacity));
    for (int i = 0; i < int(function_.points.size()); ++i) curve << pointPosition(i);
    curve << QPointF(std::max(plot.right(), curve.back().x()) + 10, yOf(function_.points.back().opacity));
    curve.front().setX(std::min(curve.front().x(), curve.at(1).x() - 1));
    QPainterPath under;
    under.addPolygon(curve);
    under.lineTo(curve.back().x(), plot.bottom());
    under.lineTo(curve.front().x(), plot.bottom());
    under.closeSubpath();
    painter.setOpacity(0.45);
    painter.fillPath(under, colors);
    painter.setOpacity(1);
    painter.setPen(QPen(theme::colors().plot_line, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(curve);
}

void TransferPlot::paintPoints(QPainter& painter) const {
    for (int i = 0; i < int(function_.points.size()); ++i) {
        const bool chosen = selection_.contains(i);
        painter.setBrush(to_qcolor(function_.points[std::size_t(i)].color));
        painter.setPen(QPen(chosen ? theme::colors().accent : theme::colors().plot_line, chosen ? 2.5 : 1.2));
        painter.drawEllipse(pointPosition(i), chosen ? 6 : 5, chosen ? 6 : 5);
    }
}

}  // namespace lacuna::ui
