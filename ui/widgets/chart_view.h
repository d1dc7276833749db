#pragma once

#include <QColor>
#include <QImage>
#include <QPalette>
#include <QWidget>
#include <optional>

#include "core/chart/chart.h"

namespace lacuna::ui {

/// Shows a chart, in dark colours where the palette is dark; its points can be clicked.
class ChartView final : public QWidget {
    Q_OBJECT
public:
    struct Place {
        std::size_t series = 0, point = 0;
    };

    explicit ChartView(QWidget* parent = nullptr);
    void setChart(const lacuna::Chart& chart);
    void clear();
    const lacuna::Chart& chart() const { return chart_; }
    /// What a colour of the chart is shown as: dark papers mirror its lightness.
    static QColor shownColor(const QColor& color, const QPalette& palette);
    /// Where a point is drawn, widget coordinates; none where it is left out or nothing was painted yet.
    std::optional<QPointF> positionOf(Place place);
    QSize sizeHint() const override { return {460, 240}; }
    QSize minimumSizeHint() const override { return {220, 160}; }

Q_SIGNALS:
    void clicked(lacuna::ui::ChartView::Place place);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void changeEvent(QEvent*) override;

private:
    void redraw();
    std::optional<Place> hit(const QPointF& at) const;

    Chart chart_;
    bool empty_ = true, stale_ = true;
    QImage image_;
    PointPlaces places_;  ///< widget coordinates
};

}  // namespace lacuna::ui
