#include "ui/widgets/plot_paint.h"

#include <algorithm>

#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

QColor to_qcolor(const glm::dvec3& color) {
    const auto part = [](double c) { return float(std::clamp(c, 0.0, 1.0)); };
    return QColor::fromRgbF(part(color.r), part(color.g), part(color.b));
}

glm::dvec3 from_qcolor(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

void paint_axis_ends(QPainter& painter, const QWidget& plot, const QRectF& foot, const ValueRange& values) {
    QFont small = plot.font();
    small.setPointSizeF(plot.font().pointSizeF() * 0.85);
    painter.setFont(small);
    painter.setPen(theme::colors().dim);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, number_text(values.lo, 'g', 5));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, number_text(values.hi, 'g', 5));
}

void paint_frame(QPainter& painter, const QWidget& plot) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(plot.hasFocus() ? theme::colors().accent : theme::colors().border, 1));
    painter.drawRect(plot.rect().adjusted(0, 0, -1, -1));
}

}  // namespace lacuna::ui
