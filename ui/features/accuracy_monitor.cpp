#include "ui/features/accuracy_monitor.h"

namespace lacuna::ui {

namespace {

std::string identity(ModePlan plan) {
    plan.plan.why.clear();
    return to_json(plan);
}

/// The settings less what only says how to draw them, and what only slices show.
ViewSettings seen(const ViewSettings& settings) {
    ViewSettings made = settings;
    made.window = {};
    made.slices = {};
    made.measurements.clear();
    made.quality = {};
    made.quality.step = settings.quality.step;
    return made;
}

/// The same with the budget asked for.
ViewSettings asked(const ViewSettings& settings) {
    ViewSettings made = seen(settings);
    made.quality.error_budget = settings.quality.error_budget;
    made.quality.time_budget_ms = settings.quality.time_budget_ms;
    return made;
}

}  // namespace

AccuracyMonitor::AccuracyMonitor(Workbench& bench)
    : QObject(&bench), bench_(bench), plan_(this, bench.tasks(), AtStake::nothing), measure_(this), visit_(this) {
    idle_.setSingleShot(true);

    connect(&idle_, &QTimer::timeout, this, &AccuracyMonitor::work);
    connect(bench.scheduler(), &FrameScheduler::frameReady, this,
            [this](const QImage&, const FrameFacts& facts) { takeFrame(facts); });
    connect(bench.scheduler(), &FrameScheduler::busyChanged, this, [this](bool busy) {
        if (busy)
            interrupt();
        else
            idle_.start(k_idle_ms);
    });
    connect(bench.tasks(), &TaskList::changed, this, [this] {
        if (!interrupting_ && !idle_.isActive()) idle_.start(k_idle_ms);
    });
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        interrupt();
        shown_ = {};
        truth_.reset();
        levels_.clear();
        answer_.reset();
        gave_up_ = false;
        points_key_.reset();
        points_ = {};
        Q_EMIT truthChanged();
        Q_EMIT boundChanged();
        Q_EMIT planningChanged();
        Q_EMIT pointsChanged();
    });
    connect(bench.documents(), &DocumentController::settingsChanged, this, [this] {
        const ViewSettings& settings = bench_.documents()->document().settings;
        if (asked(settings) != planned_for_) gave_up_ = false;
        if (!bench_.documents()->document().planned && answer_) answer_.reset();
        Q_EMIT planningChanged();
    });
}

AccuracyMonitor::Key AccuracyMonitor::keyNow() const {
    const Document& document = bench_.documents()->document();
    return {seen(document.settings),  document.camera,          shown_.scene ? shown_.scene->size : glm::ivec2(0),
            document.selected_region, document.selected_defect, document.volume.buffer().data(),
            document.highlight.get(), document.defects.get()};
}

void AccuracyMonitor::takeFrame(const FrameFacts& facts) {
    if (!bench_.documents()->hasDocument()) return;
    shown_ = facts;
    if (!facts.coarse) {
        Key key = keyNow();
        if (!(key == key_)) {
            key_ = std::move(key);
            truth_.reset();
            levels_.clear();
            measuring_failed_ = false;
            Q_EMIT truthChanged();
        }
        judge();
    }
    Q_EMIT boundChanged();
}

double AccuracyMonitor::quietStep() const { return bench_.documents()->document().settings.quality.step; }

/// What is known of the picture shown: by rule, else by measurement.
void AccuracyMonitor::judge() {
    bound_ = known_bound(shown_.drawn, *shown_.scene, brute_force(*shown_.scene, quietStep()));
    if (bound_.known == ErrorKnown::exact) return;
    const auto at = levels_.find(identity(plan()));
    if (at == levels_.end()) return;
    bound_.known = ErrorKnown::measured;
    bound_.levels = at->second;
}

void AccuracyMonitor::interrupt() {
    interrupting_ = true;
    idle_.stop();
    measure_.cancel();
    visit_.cancel();
    plan_.cancel();
    interrupting_ = false;
}

bool AccuracyMonitor::idle() const {
    return bench_.engine() && bench_.documents()->hasDocument() && shown_.frame && !shown_.coarse &&
           !bench_.scheduler()->busy() && bench_.tasks()->rows().empty() && !measure_.running() && !visit_.running();
}

void AccuracyMonitor::wantTruth(bool wanted) {
    want_truth_ = wanted;
    if (wanted && !idle_.isActive()) idle_.start(k_idle_ms);
}

void AccuracyMonitor::setCharting(bool on, bool full) {
    if (full != full_) points_key_.reset();
    charting_ = on;
    full_ = full;
    if (!on) visit_.cancel();
    if (on && !idle_.isActive()) idle_.start(k_idle_ms);
}

bool AccuracyMonitor::planIsDue() const {
    const Document& document = bench_.documents()->document();
    if (!document.settings.quality.has_budget() || document.settings.mode == ViewMode::shear_warp) return false;
    const bool same = asked(document.settings) == planned_for_;
    if (gave_up_ && same) return false;
    if (!document.planned || !answer_ || !same) return true;
    // The plan in use was made for another view: does it keep the budget in this one?
    const std::optional<double>& budget = document.settings.quality.error_budget;
    return budget && bound_.known == ErrorKnown::measured && !(bound_.levels <= *budget);
}

void AccuracyMonitor::work() {
    if (!idle()) return;
    if (planIsDue()) return startPlanning();
    const bool warped = shown_.scene->mode == ViewMode::shear_warp;
    const bool unknown = bound_.known == ErrorKnown::unknown;
    if (!warped && !measuring_failed_ && ((want_truth_ && !truth_) || unknown || (charting_ && !truth_)))
        return startMeasuring();
    if (charting_ && truth_) return startVisit();
    Q_EMIT settled();
}

void AccuracyMonitor::startPlanning() {
    const Document& document = bench_.documents()->document();
    const Quality& quality = document.settings.quality;
    Budget budget;
    budget.error = quality.error_budget;
    budget.time_ms = quality.time_budget_ms;
    budget.step = quality.step;
    planned_for_ = asked(document.settings);
    plan_.start(
        tr("Choosing a plan"),
        [engine = bench_.engine(), scene = shown_.scene, budget](const JobContext& job) mutable {
            budget.costs = costs_of(*engine, job.part(0, 0.1));  // measured the first time alone
            return choose_plan(*engine, *scene, budget, job.part(0.1, 1));
        },
        [this, mode = shown_.scene->mode](Outcome<PlannedPlan> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                // By hand it stays cancelled; by a change of the view it begins again.
                if (!interrupting_) gave_up_ = true;
                bench_.report(*error);
                Q_EMIT planningChanged();
                return;
            }
            answer_ = std::get<PlannedPlan>(std::move(outcome));
            const auto planned = std::make_shared<const ModePlan>(ModePlan{mode, answer_->plan});
            levels_[identity(*planned)] = answer_->error;
            Q_EMIT planningChanged();
            bench_.documents()->setPlanned(planned);
            if (!idle_.isActive()) idle_.start(k_idle_ms);
        });
    Q_EMIT planningChanged();
}

void AccuracyMonitor::startMeasuring() {
    measure_.start(
        [engine = bench_.engine(), scene = shown_.scene, frame = shown_.frame, truth = truth_,
         brute = brute_force(*shown_.scene, quietStep())](const JobContext& job) {
            Measured made{truth, 0};
            if (!made.truth)
                made.truth = std::make_shared<const TruePicture>(engine->render(*scene, brute, {job.stop}).frame,
                                                                 scene->background);
            job.check();
            made.levels = made.truth->largest(*frame);
            return made;
        },
        [this, shown = identity(plan())](Outcome<Measured> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                measuring_failed_ = true;
                return bench_.report(*error);
            }
            Measured& made = std::get<Measured>(outcome);
            const bool first = !truth_;
            truth_ = std::move(made.truth);
            levels_[shown] = made.levels;
            judge();
            if (first) Q_EMIT truthChanged();
            Q_EMIT boundChanged();
            idle_.start(0);
        });
}

void AccuracyMonitor::startVisit() {
    if (!points_key_ || !(*points_key_ == key_)) {
        points_key_ = key_;
        points_ = LiveSweep(*shown_.scene, quietStep(), full_ ? SweepExtent::full : SweepExtent::quick, plan());
        Q_EMIT pointsChanged();
    }
    points_.include(plan());
    const std::optional<std::size_t> next = points_.next();
    if (!next) {
        Q_EMIT settled();
        return;
    }
    const bool first = points_.pending(*next);
    visit_.start([engine = bench_.engine(), scene = shown_.scene, plan = points_.result().points[*next].plan,
                  truth = first ? truth_ : nullptr](
                     const JobContext& job) { return draw_visit(*engine, *scene, plan, truth.get(), job); },
                 [this](Outcome<LiveSweep::Visit> outcome) {
                     if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
                     points_.add(std::get<LiveSweep::Visit>(outcome));
                     Q_EMIT pointsChanged();
                     idle_.start(0);
                 });
}

}  // namespace lacuna::ui
