#pragma once

#include <QTimer>
#include <map>
#include <optional>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/live_sweep.h"
#include "core/accuracy/planner.h"
#include "ui/task.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Knows how wrong the 3D picture is, and finds it out where no rule says: when nothing else runs, it draws brute
/// force, compares, plans for the budget, and measures other plans for the chart. Whatever a person does stops it at
/// once.
class AccuracyMonitor final : public QObject {
    Q_OBJECT
public:
    static constexpr int k_idle_ms = 350;  ///< after this long without anything to do, measuring begins

    explicit AccuracyMonitor(Workbench& bench);

    /// What is known of the picture shown; meaningless while coarse() or before the first picture.
    const ErrorBound& bound() const { return bound_; }
    bool hasPicture() const { return shown_.frame != nullptr; }
    bool coarse() const { return shown_.coarse; }
    const FrameFacts& shown() const { return shown_; }
    ModePlan plan() const { return {shown_.scene->mode, shown_.drawn}; }
    /// Brute force of the picture shown; null until it was drawn.
    const std::shared_ptr<const TruePicture>& truth() const { return truth_; }
    bool planning() const { return plan_.running(); }
    /// The planner's last answer for the document; none where there is no budget or no answer yet.
    const std::optional<PlannedPlan>& answer() const { return answer_; }
    const LiveSweep& points() const { return points_; }
    /// False while the view has changed and no plan was measured on it yet.
    bool pointsAreOfThisView() const { return points_key_ && *points_key_ == key_; }
    bool charting() const { return charting_; }

    /// Brute force is wanted whatever is known of the error.
    void wantTruth(bool wanted);
    /// Other plans are to be measured as well; `full`: all of them.
    void setCharting(bool on, bool full);

Q_SIGNALS:
    void boundChanged();
    void truthChanged();
    void planningChanged();
    void pointsChanged();
    void settled();  ///< nothing is left to find out

private:
    /// All that brute force depends on.
    struct Key {
        ViewSettings settings;
        Camera camera;
        glm::ivec2 size{0};
        std::uint32_t region = 0, defect = 0;
        const void *voxels = nullptr, *highlight = nullptr, *defects = nullptr;
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Measured {
        std::shared_ptr<const TruePicture> truth;
        double levels = 0;
    };

    Key keyNow() const;
    void takeFrame(const FrameFacts& facts);
    void interrupt();
    bool idle() const;
    void work();
    bool planIsDue() const;
    void startPlanning();
    void startMeasuring();
    void startVisit();
    void judge();
    double quietStep() const;

    Workbench& bench_;
    QTimer idle_;
    FrameFacts shown_;
    Key key_;
    ErrorBound bound_;
    std::shared_ptr<const TruePicture> truth_;
    std::map<std::string, double> levels_;  ///< measured against truth_, by plan
    std::optional<PlannedPlan> answer_;
    ViewSettings planned_for_;  ///< answer_ is for these, whatever the camera
    bool gave_up_ = false;      ///< planning was cancelled or failed for planned_for_
    LiveSweep points_;
    std::optional<Key> points_key_;
    bool want_truth_ = false, charting_ = false, full_ = false, interrupting_ = false, measuring_failed_ = false;
    Task<PlannedPlan> plan_;
    LatestJob<Measured> measure_;
    LatestJob<LiveSweep::Visit> visit_;
};

}  // namespace lacuna::ui
