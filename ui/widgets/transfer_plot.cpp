#include "ui/widgets/transfer_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/theme.h"

namespace lacuna::ui {

namespace {
constexpr double k_margin = 10, k_foot = 26, k_pick_px = 10;
}

QColor to_qcolor(const glm::dvec3& color) {
    const auto part = [](double c) { return float(std::clamp(c, 0.0, 1.0)); };
    return QColor::fromRgbF(part(color.r), part(color.g), part(color.b));
}

glm::dvec3 from_qcolor(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

TransferPlot::TransferPlot(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Transfer function"));
    setAccessibleDescription(
        tr("Arrow keys move the selected point, Page Up and Page Down select another, Insert adds one, Delete removes "
           "it, Enter chooses its colour."));
    setToolTip(
        tr("Drag points · double click adds one · Delete removes it · right click chooses its colour · wheel "
           "zooms the value axis"));
}

void TransferPlot::setHistogram(const std::vector<std::uint64_t>& counts, ValueRange range) {
    counts_ = counts;
    range_ = range.width() > 0 ? range : ValueRange{range.lo - 0.5, range.lo + 0.5};
    showAll();
}

void TransferPlot::setFunction(const TransferFunction& function) {
    if (function == function_) return;
    function_ = function;
    select(std::clamp(selected_, 0, std::max(0, int(function_.points.size()) - 1)));
    update();
}

void TransferPlot::select(int point) {
    if (point == selected_) return;
    selected_ = point;
    update();
    Q_EMIT selectionChanged(selected_);
}

void TransferPlot::showAll() {
    shown_ = range_;
    update();
}

QRectF TransferPlot::plotRect() const { return QRectF(rect()).adjusted(k_margin, k_margin, -k_margin, -k_foot); }
double TransferPlot::valueAt(double x) const {
    return shown_.lo + (x - plotRect().left()) / plotRect().width() * shown_.width();
}
double TransferPlot::xOf(double value) const {
    return plotRect().left() + (value - shown_.lo) / shown_.width() * plotRect().width();
}
double TransferPlot::opacityAt(double y) const {
    return std::clamp((plotRect().bottom() - y) / plotRect().height(), 0.0, 1.0);
}
double TransferPlot::yOf(double opacity) const { return plotRect().bottom() - opacity * plotRect().height(); }

QPointF TransferPlot::pointPosition(int point) const {
    const TransferPoint& p = function_.points[std::size_t(point)];
    return {xOf(p.value), yOf(p.opacity)};
}

int TransferPlot::pointAt(const QPointF& position) const {
    int nearest = -1;
    double nearest_px = k_pick_px;
    for (int i = 0; i < int(function_.points.size()); ++i) {
        const QPointF to = pointPosition(i) - position;
        const double px = std::hypot(to.x(), to.y());
        if (px < nearest_px) nearest_px = px, nearest = i;
    }
    return nearest;
}

void TransferPlot::movePoint(int point, double value, double opacity) {
    auto& points = function_.points;
    const std::size_t i = std::size_t(point);
    if (i >= points.size()) return;
    const double lowest = i > 0 ? points[i - 1].value : range_.lo;
    const double highest = i + 1 < points.size() ? points[i + 1].value : range_.hi;
    TransferPoint moved = points[i];
    // A preset's outer points may lie beyond the data; they are not pulled in by an edit of their opacity.
    moved.value = std::clamp(value, std::min(lowest, moved.value), std::max(highest, moved.value));
    moved.opacity = std::clamp(opacity, 0.0, 1.0);
    if (moved == points[i]) return;
    points[i] = moved;
    update();
    Q_EMIT functionEdited(function_);
}

void TransferPlot::addPoint(double value, double opacity) {
    auto& points = function_.points;
    const auto next = std::upper_bound(points.begin(), points.end(), value,
                                       [](double v, const TransferPoint& p) { return v < p.value; });
    const auto added = points.insert(next, {value, function_.at(value).color, opacity});
    selected_ = int(added - points.begin());
    update();
    Q_EMIT selectionChanged(selected_);
    Q_EMIT functionEdited(function_);
}

void TransferPlot::addPointBeside() {
    const auto& points = function_.points;
    const std::size_t i = std::size_t(std::max(0, selected_));
    const double from = i < points.size() ? points[i].value : range_.lo;
    const double to = i + 1 < points.size() ? points[i + 1].value : std::max(from, range_.hi);
    const double value = 0.5 * (from + to);
    addPoint(value, function_.at(value).opacity);
}

void TransferPlot::removeSelected() {
    if (function_.points.size() < 2 || selected_ < 0 || selected_ >= int(function_.points.size())) return;
    function_.points.erase(function_.points.begin() + selected_);
    selected_ = std::min(selected_, int(function_.points.size()) - 1);
    update();
    Q_EMIT selectionChanged(selected_);
    Q_EMIT functionEdited(function_);
}

void TransferPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::colors().base);
    painter.save();
    painter.setClipRect(plotRect().adjusted(-6, -6, 6, 14));
    paintHistogram(painter);
    paintFunction(painter);
    painter.restore();
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.85);
    painter.setFont(small);
    painter.setPen(theme::colors().dim);
    const QRectF foot(plotRect().left(), plotRect().bottom() + 9, plotRect().width(), k_foot - 9);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, QString::number(shown_.lo, 'g', 5));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, QString::number(shown_.hi, 'g', 5));
    if (selected_ >= 0 && selected_ < int(function_.points.size())) {
        const TransferPoint& p = function_.points[std::size_t(selected_)];
        painter.setPen(theme::colors().text);
        painter.drawText(foot, Qt::AlignCenter, tr("%1 → %2").arg(p.value, 0, 'g', 5).arg(p.opacity, 0, 'f', 3));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(hasFocus() ? theme::colors().accent : theme::colors().border, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void TransferPlot::paintHistogram(QPainter& painter) const {
    if (counts_.empty()) return;
    const QRectF plot = plotRect();
    const int columns = std::max(1, int(plot.width()));
    std::vector<double> column(std::size_t(columns), 0.0);
    const double bins_per_value = double(counts_.size()) / range_.width();
    double highest = 1;
    for (int x = 0; x < columns; ++x) {
        const double from = (valueAt(plot.left() + x) - range_.lo) * bins_per_value;
        const double to = (valueAt(plot.left() + x + 1) - range_.lo) * bins_per_value;
        const int first = std::max(0, int(std::floor(from)));
        const int last = std::min(int(counts_.size()) - 1, std::max(int(std::floor(from)), int(std::ceil(to)) - 1));
        std::uint64_t peak = 0;
        for (int bin = first; bin <= last; ++bin) peak = std::max(peak, counts_[std::size_t(bin)]);
        column[std::size_t(x)] = std::log1p(double(peak));
        highest = std::max(highest, column[std::size_t(x)]);
    }
    QPainterPath path(QPointF(plot.left(), plot.bottom()));
    for (int x = 0; x < columns; ++x)
        path.lineTo(plot.left() + x + 0.5, plot.bottom() - column[std::size_t(x)] / highest * plot.height());
    path.lineTo(plot.right(), plot.bottom());
    painter.fillPath(path, theme::colors().plot_fill);
}

void TransferPlot::paintFunction(QPainter& painter) const {
    if (function_.points.empty()) return;
    const QRectF plot = plotRect();
    // The colours run along the foot, and under the curve as far as it is opaque.
    QLinearGradient colors(plot.left(), 0, plot.right(), 0);
    const int stops = 64;
    for (int i = 0; i <= stops; ++i) {
        const double share = double(i) / stops;
        colors.setColorAt(share, to_qcolor(function_.at(shown_.lo + share * shown_.width()).color));
    }
    painter.fillRect(QRectF(plot.left(), plot.bottom() + 2, plot.width(), 5), colors);
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
    for (int i = 0; i < int(function_.points.size()); ++i) {
        const bool chosen = i == selected_;
        painter.setBrush(to_qcolor(function_.points[std::size_t(i)].color));
        painter.setPen(QPen(chosen ? theme::colors().accent : theme::colors().plot_line, chosen ? 2.5 : 1.2));
        painter.drawEllipse(pointPosition(i), chosen ? 6 : 5, chosen ? 6 : 5);
    }
}

void TransferPlot::mousePressEvent(QMouseEvent* event) {
    const int point = pointAt(event->position());
    if (point < 0) return;
    select(point);
    if (event->button() == Qt::LeftButton) dragging_ = true;
    if (event->button() == Qt::RightButton) Q_EMIT colorRequested(point);
}

void TransferPlot::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_) movePoint(selected_, valueAt(event->position().x()), opacityAt(event->position().y()));
}

void TransferPlot::mouseReleaseEvent(QMouseEvent*) { dragging_ = false; }

void TransferPlot::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || pointAt(event->position()) >= 0) return;
    addPoint(std::clamp(valueAt(event->position().x()), range_.lo, range_.hi), opacityAt(event->position().y()));
    dragging_ = true;
}

void TransferPlot::wheelEvent(QWheelEvent* event) {
    const double factor = std::exp(-event->angleDelta().y() / 500.0);
    const double width = std::clamp(shown_.width() * factor, range_.width() * 0.005, range_.width());
    const double share = std::clamp((event->position().x() - plotRect().left()) / plotRect().width(), 0.0, 1.0);
    const double lo = valueAt(event->position().x()) - share * width;
    shown_.lo = std::clamp(lo, range_.lo, range_.hi - width);
    shown_.hi = shown_.lo + width;
    update();
    event->accept();
}

void TransferPlot::keyPressEvent(QKeyEvent* event) {
    const int count = int(function_.points.size());
    if (count == 0 || selected_ < 0 || selected_ >= count) return QWidget::keyPressEvent(event);
    const TransferPoint& p = function_.points[std::size_t(selected_)];
    const double step = shown_.width() / 100, rise = 0.02;
    switch (event->key()) {
        case Qt::Key_Left:
            return movePoint(selected_, p.value - step, p.opacity);
        case Qt::Key_Right:
            return movePoint(selected_, p.value + step, p.opacity);
        case Qt::Key_Up:
            return movePoint(selected_, p.value, p.opacity + rise);
        case Qt::Key_Down:
            return movePoint(selected_, p.value, p.opacity - rise);
        case Qt::Key_PageUp:
            return select((selected_ + 1) % count);
        case Qt::Key_PageDown:
            return select((selected_ + count - 1) % count);
        case Qt::Key_Insert:
            return addPointBeside();
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected();
        case Qt::Key_Home:
            return showAll();
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            Q_EMIT colorRequested(selected_);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void TransferPlot::focusInEvent(QFocusEvent*) { update(); }
void TransferPlot::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
