#include "ui/features/accuracy_feature.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "core/accuracy/difference_map.h"
#include "ui/core_sentences.h"
#include "ui/number_text.h"
#include "ui/plan_words.h"

namespace lacuna::ui {

namespace {

constexpr int k_chart_height = 270;
constexpr int k_late_ms = 600;         ///< a hand that moves sees pictures sooner
constexpr std::size_t k_reasons = 14;  // of a plan that fit a tooltip

QImage to_image(const DifferenceMap& map) {
    const QImage wrapped(map.rgb.data(), map.size.x, map.size.y, 3 * map.size.x, QImage::Format_RGB888);
    return wrapped.convertToFormat(QImage::Format_RGB32);  // a copy: the map goes
}

QString words_of(const ModePlan& plan, const Plan& brute) {
    const std::string differs = difference_in_words(plan, {plan.mode, brute});
    const QString structure = QString::fromUtf8(name_of(plan.plan.structure).data());
    return plan_words(differs.empty() ? structure : structure + QStringLiteral(", ") + QString::fromStdString(differs));
}

}  // namespace

AccuracyFeature::AccuracyFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      monitor_(new AccuracyMonitor(bench)),
      badge_(new ErrorBadge(bench.views()->volumeView())),
      budget_(new BudgetPanel(bench.window())),
      panel_(new SpeedPanel(bench.window())),
      dock_(bench.addDock(QStringLiteral("speed"), tr("Speed and accuracy"), panel_, Qt::BottomDockWidgetArea)) {
    buildActions();
    bench.needDocument(panel_);
    panel_->clear(tr("Open a volume to measure how fast and how exact each way of drawing it is."));
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, [this, documents] {
        showing_ = Showing::picture;
        budget_->setSettings(documents->document().settings);
        badge_->hide();
    });
    connect(documents, &DocumentController::settingsChanged, this,
            [this, documents] { budget_->setSettings(documents->document().settings); });
    connect(budget_, &BudgetPanel::edited, documents, &DocumentController::edit);
    connect(panel_, &SpeedPanel::planChosen, this, &AccuracyFeature::usePlan);
    connect(panel_, &SpeedPanel::extentChanged, this,
            [this](bool all) { monitor_->setCharting(panel_->isVisible(), all); });
    connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        monitor_->setCharting(visible, panel_->allBox()->isChecked());
        if (!visible) return;
        // A chart wants more room than the tables it stands beside; given once, so that a person can take it back.
        if (std::exchange(wants_room_, false) && dock_->height() < k_chart_height)
            bench_.window()->resizeDocks({dock_}, {k_chart_height}, Qt::Vertical);
        showPoints();
    });
    connect(monitor_, &AccuracyMonitor::boundChanged, this, [this] {
        showBound();
        showPicture();
        showPlan();
        showPoints();
    });
    late_.setSingleShot(true);
    late_.setInterval(k_late_ms);
    connect(&late_, &QTimer::timeout, this, &AccuracyFeature::showStale);
    FrameScheduler* scheduler = bench.scheduler();
    connect(scheduler, &FrameScheduler::busyChanged, this, [this](bool busy) {
        if (!busy) {
            late_.stop();
            showStale();
        } else if (!bench_.scheduler()->current() && !late_.isActive()) {
            late_.start();
        }
    });
    connect(scheduler, &FrameScheduler::frameReady, this, [this] {
        badge_->setStale(false, false);
        bench_.scheduler()->current() ? late_.stop() : late_.start();
    });
    connect(monitor_, &AccuracyMonitor::truthChanged, this, &AccuracyFeature::showPicture);
    connect(monitor_, &AccuracyMonitor::planningChanged, this, &AccuracyFeature::showPlan);
    connect(monitor_, &AccuracyMonitor::pointsChanged, this, &AccuracyFeature::showPoints);
}

void AccuracyFeature::buildActions() {
    QMenu* menu = bench_.submenu(Workbench::Menu::view, tr("Sp&eed and accuracy"));
    bench_.add(menu, tr("Picture, &brute force, difference"), QKeySequence(QStringLiteral("B")), this,
               &AccuracyFeature::cycle);
    QAction* badge =
        bench_.add(menu, tr("&Error badge"), QKeySequence(QStringLiteral("Ctrl+Shift+B")), this, [this](bool on) {
            badge_wanted_ = on;
            showBound();
        });
    badge->setCheckable(true);
    badge->setChecked(true);
    bench_.add(menu, tr("&Faster: a larger budget"), QKeySequence(QStringLiteral("Ctrl+[")), this,
               [this] { stepBudget(-1); });
    bench_.add(menu, tr("&More exact: a smaller budget"), QKeySequence(QStringLiteral("Ctrl+]")), this,
               [this] { stepBudget(1); });
    const auto within = [this](double ms) {
        bench_.edit(tr("Budget"), [ms](ViewSettings& settings) {
            settings.quality.plan.clear();
            settings.quality.error_budget.reset();
            settings.quality.time_budget_ms = ms;
        });
    };
    bench_.add(menu, tr("Most exact at &30 frames a second"), QKeySequence(), this, [within] { within(33); });
    bench_.add(menu, tr("Most exact at &10 frames a second"), QKeySequence(), this, [within] { within(100); });
    bench_.add(menu, tr("&No budget"), QKeySequence(QStringLiteral("Ctrl+\\")), this, [this] {
        bench_.edit(tr("Budget"), [](ViewSettings& settings) {
            settings.quality.plan.clear();
            settings.quality.error_budget.reset();
            settings.quality.time_budget_ms.reset();
        });
    });
    QMenu* go = bench_.menu(Workbench::Menu::go);
    bench_.add(go, tr("&Budget"), QKeySequence(QStringLiteral("Ctrl+B")), this,
               [this] { budget_->slider()->setFocus(Qt::TabFocusReason); });
    bench_.add(go, tr("Speed and accuracy &chart"), QKeySequence(QStringLiteral("Ctrl+J")), this, [this] {
        dock_->show();
        dock_->raise();
        panel_->table()->setFocus(Qt::TabFocusReason);
    });
}

void AccuracyFeature::stepBudget(int by) {
    if (!budget_->isEnabled()) return;
    const bool on = budget_->switchBox()->isChecked();
    QSlider* slider = budget_->slider();
    const int now = slider->value(), next = std::clamp(now + by, slider->minimum(), slider->maximum());
    if (!on)
        budget_->switchBox()->setChecked(true);  // begins where the slider stands
    else
        slider->setValue(next);
}

void AccuracyFeature::usePlan(const ModePlan& plan) {
    bench_.edit(tr("Plan"), [&](ViewSettings& settings) {
        ModePlan bare = plan;
        bare.plan.why.clear();
        switch_mode(settings, plan.mode);
        settings.quality.plan = to_json(bare);
        settings.quality.error_budget.reset();
        settings.quality.time_budget_ms.reset();
    });
}

void AccuracyFeature::cycle() {
    showing_ = showing_ == Showing::picture       ? Showing::brute_force
               : showing_ == Showing::brute_force ? Showing::difference
                                                  : Showing::picture;
    monitor_->wantTruth(showing_ != Showing::picture);
    showPicture();
}

void AccuracyFeature::showBound() {
    const bool known = monitor_->hasPicture();
    if (known) {
        badge_->setPending(true);
        badge_->showBound(monitor_->bound(), monitor_->coarse());
    }
    badge_->setVisible(known && badge_wanted_);
}

void AccuracyFeature::showStale() {
    const FrameScheduler* scheduler = bench_.scheduler();
    badge_->setStale(!scheduler->current(), scheduler->busy());
}

void AccuracyFeature::showPicture() {
    if (!monitor_->hasPicture() || monitor_->coarse()) return;
    VolumeView* view = bench_.views()->volumeView();
    const FrameFacts& shown = monitor_->shown();
    const auto& truth = monitor_->truth();
    if (showing_ == Showing::picture) {
        badge_->showHeadline({});
        view->setImage(ui::to_image(*shown.frame));
        return;
    }
    if (shown.scene->mode == ViewMode::shear_warp) {
        badge_->showHeadline(tr("Shear-warp has no brute force to show"));
        return;
    }
    if (!truth) {
        badge_->showHeadline(tr("Drawing brute force…"));
        return;
    }
    if (showing_ == Showing::brute_force) {
        badge_->showHeadline(tr("This is brute force; key B: the difference. The picture is"));
        view->setImage(ui::to_image(truth->frame()));
        return;
    }
    const DifferenceMap map = difference_map(*shown.frame, truth->frame(), shown.scene->background);
    badge_->showHeadline(map.full_scale > 0
                             ? tr("Difference ×%1, brightest %2/255; key B: the picture. The picture is")
                                   .arg(number_text(255 / map.full_scale, 'f', 0), levels_text(map.full_scale))
                             : tr("No difference in any pixel; key B: the picture. The picture is"));
    view->setImage(to_image(map));
}

void AccuracyFeature::showPlan() {
    if (!monitor_->hasPicture() || !bench_.documents()->hasDocument()) return;
    const Quality& quality = bench_.documents()->document().settings.quality;
    if (monitor_->planning()) return budget_->showPlan(tr("Looking for the plan on this view…"), {});
    if (monitor_->coarse()) return;
    const FrameFacts& shown = monitor_->shown();
    QString line = tr("%1 · %2 ms a frame")
                       .arg(words_of(monitor_->plan(), brute_force(*shown.scene, quality.step)))
                       .arg(number_text(shown.ms, 'f', shown.ms < 9.95 ? 1 : 0));
    const auto& answer = monitor_->answer();
    if (quality.has_budget() && answer && !answer->meets_budget)
        line += QLatin1Char('\n') + tr("No plan tried fits the budget; this is the fastest.");
    QStringList why;
    for (const std::string& reason : shown.drawn.why) {
        if (std::size_t(why.size()) == k_reasons) {
            why << tr("… and %1 more").arg(shown.drawn.why.size() - k_reasons);
            break;
        }
        why << core_sentence(reason);
    }
    budget_->showPlan(line, why.join(QLatin1Char('\n')));
}

void AccuracyFeature::showPoints() {
    if (!monitor_->charting() || !monitor_->hasPicture()) return;
    if (monitor_->shown().scene->mode == ViewMode::shear_warp)
        panel_->clear(tr("Shear-warp has one way of drawing; choose another view mode."));
    else if (monitor_->coarse() || monitor_->points().measured() == 0 || !monitor_->pointsAreOfThisView())
        panel_->clear(tr("Measuring begins when the picture rests."));
    else
        panel_->showPoints(monitor_->points(), monitor_->plan());
}

}  // namespace lacuna::ui
