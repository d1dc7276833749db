#include "ui/widgets/chart_view.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna::ui {

namespace {

constexpr double k_pixels_per_point = 96.0 / 72.0;
constexpr double k_reach_px = 9;

bool is_dark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

/// Light for dark with the hue kept: the luma is mirrored, the rest of the colour stays; white becomes the paper.
QRgb mirrored(QRgb color, const QColor& paper) {
    const double r = qRed(color), g = qGreen(color), b = qBlue(color);
    const double shift = 255 - 2 * (0.299 * r + 0.587 * g + 0.114 * b);
    const auto on = [&](double c, int base) {
        return int(std::lround(base + std::clamp(c + shift, 0.0, 255.0) * (255 - base) / 255));
    };
    return qRgb(on(r, paper.red()), on(g, paper.green()), on(b, paper.blue()));
}

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent) { setMouseTracking(true); }

QColor ChartView::shownColor(const QColor& color, const QPalette& palette) {
    return is_dark(palette) ? QColor(mirrored(color.rgb(), palette.color(QPalette::Base))) : color;
}

void ChartView::setChart(const Chart& chart) {
    chart_ = chart;
    empty_ = false;
    stale_ = true;
    update();
}

void ChartView::clear() {
    chart_ = {};
    empty_ = true;
    places_.clear();
    update();
}

void ChartView::redraw() {
    stale_ = false;
    places_.clear();
    image_ = {};
    const double ratio = devicePixelRatioF();
    try {
        Canvas canvas =
            Canvas::png({width() / k_pixels_per_point, height() / k_pixels_per_point}, k_pixels_per_point * ratio);
        places_ = draw(chart_, canvas);
        const std::string png = canvas.finish();
        image_ = QImage::fromData(reinterpret_cast<const uchar*>(png.data()), int(png.size()), "PNG")
                     .convertToFormat(QImage::Format_RGB32);
    } catch (const Error&) {
        return;  // too small for its labels: an empty place says so
    }
    if (is_dark(palette()))
        for (int y = 0; y < image_.height(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
            for (int x = 0; x < image_.width(); ++x) line[x] = mirrored(line[x], palette().color(QPalette::Base));
        }
    image_.setDevicePixelRatio(ratio);
    for (auto& series : places_)
        for (glm::dvec2& at : series) at *= k_pixels_per_point;
}

std::optional<QPointF> ChartView::positionOf(Place place) {
    if (stale_ && !empty_) redraw();
    if (place.series >= places_.size() || place.point >= places_[place.series].size()) return std::nullopt;
    const glm::dvec2 at = places_[place.series][place.point];
    if (!std::isfinite(at.x + at.y)) return std::nullopt;
    return QPointF(at.x, at.y);
}

void ChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (empty_) return;
    if (stale_) redraw();
    painter.drawImage(0, 0, image_);
}

std::optional<ChartView::Place> ChartView::hit(const QPointF& at) const {
    std::optional<Place> nearest;
    double best = k_reach_px;
    for (std::size_t s = 0; s < places_.size(); ++s)
        for (std::size_t p = 0; p < places_[s].size(); ++p) {
            const double away = std::hypot(places_[s][p].x - at.x(), places_[s][p].y - at.y());
            if (away < best) best = away, nearest = Place{s, p};
        }
    return nearest;
}

void ChartView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const auto place = hit(event->position())) Q_EMIT clicked(*place);
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
    setCursor(hit(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void ChartView::resizeEvent(QResizeEvent*) { stale_ = true; }

void ChartView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) stale_ = true;
    QWidget::changeEvent(event);
}

}  // namespace lacuna::ui
