#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "core/accuracy/live_sweep.h"
#include "ui/widgets/chart_view.h"

namespace lacuna::ui {

/// Speed against accuracy of the scene on screen: a chart of the plans measured so far and the same as a list. A click
/// into the chart, or Enter in the list, uses a plan.
class SpeedPanel final : public QWidget {
    Q_OBJECT
public:
    explicit SpeedPanel(QWidget* parent = nullptr);
    void showPoints(const lacuna::LiveSweep& sweep, const lacuna::ModePlan& current);
    void clear(const QString& why);
    ChartView* chart() const { return chart_; }
    QTableWidget* table() const { return table_; }
    QCheckBox* allBox() const { return all_; }
    /// The place in the chart of a point of the sweep.
    std::optional<ChartView::Place> placeOf(std::size_t point) const;

Q_SIGNALS:
    void planChosen(const lacuna::ModePlan& plan);
    void extentChanged(bool all);

private:
    void fillTable(const LiveSweep& sweep, const ModePlan& current);
    void use(std::size_t point);

    ChartView* chart_;
    QTableWidget* table_;
    QLabel* state_;
    QCheckBox* all_;
    std::vector<SweepPoint> points_;
    std::vector<std::vector<std::size_t>> shown_;  ///< points by series and place in the chart
};

}  // namespace lacuna::ui
