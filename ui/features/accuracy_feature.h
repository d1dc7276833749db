#pragma once

#include <QTimer>

#include "ui/features/accuracy_monitor.h"
#include "ui/panels/budget_panel.h"
#include "ui/panels/speed_panel.h"
#include "ui/widgets/error_badge.h"

namespace lacuna::ui {

/// Speed against accuracy in the window: the badge that says how wrong the 3D picture is, the key that shows brute
/// force and the difference, the budget from fastest to exact, and the chart of the plans for the scene on screen.
class AccuracyFeature final : public QObject {
    Q_OBJECT
public:
    /// What the 3D view shows.
    enum class Showing { picture, brute_force, difference };

    explicit AccuracyFeature(Workbench& bench);

    AccuracyMonitor* monitor() const { return monitor_; }
    /// Stands with the other settings of the view; the window puts it there.
    BudgetPanel* budget() const { return budget_; }
    SpeedPanel* panel() const { return panel_; }
    QDockWidget* dock() const { return dock_; }
    ErrorBadge* badge() const { return badge_; }
    Showing showing() const { return showing_; }

public Q_SLOTS:
    /// Picture, brute force, amplified difference, picture, ...
    void cycle();
    void usePlan(const lacuna::ModePlan& plan);

private:
    void buildActions();
    void showBound();
    void showStale();
    void showPicture();
    void showPlan();
    void showPoints();
    void stepBudget(int by);

    Workbench& bench_;
    AccuracyMonitor* monitor_;
    ErrorBadge* badge_;
    BudgetPanel* budget_;
    SpeedPanel* panel_;
    QDockWidget* dock_;
    Showing showing_ = Showing::picture;
    QTimer late_;  ///< a picture that takes its time: what is shown is not what was asked for
    bool badge_wanted_ = true, wants_room_ = true;
};

}  // namespace lacuna::ui
