#include "ui/panels/budget_panel.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {

/// The stop of a budget; -1 where it is none of them.
int stop_of(const Quality& quality) {
    const auto& stops = BudgetPanel::stops();
    for (std::size_t i = 0; i < stops.size(); ++i)
        if (stops[i].error == quality.error_budget && !quality.time_budget_ms) return int(i);
    return -1;
}

}  // namespace

const std::vector<BudgetPanel::Stop>& BudgetPanel::stops() {
    static const std::vector<Stop> list = {{255.0, tr("Fastest: however far off")},
                                           {32.0, tr("At most 32/255 off: the shape is right")},
                                           {8.0, tr("At most 8/255 off: plain to see beside it")},
                                           {2.0, tr("At most 2/255 off: hardly to be seen")},
                                           {0.5, tr("At most 0.5/255 off: the same on a screen")},
                                           {0.0, tr("Exact: equal to brute force")}};
    return list;
}

BudgetPanel::BudgetPanel(QWidget* parent)
    : QWidget(parent),
      on_(new QCheckBox(tr("&Within a budget"), this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      stop_(new QLabel(this)),
      plan_(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    slider_->setRange(0, int(stops().size()) - 1);
    slider_->setPageStep(1);
    slider_->setValue(slider_->maximum());
    slider_->setTracking(false);  // a plan is looked for where the handle is let go
    slider_->setAccessibleName(tr("Budget from fastest to exact"));
    slider_->setToolTip(
        tr("The plan that draws the full picture is chosen by measuring this very view: the fastest one within the "
           "error."));
    on_->setAccessibleName(tr("Draw within a budget"));
    on_->setToolTip(tr("Off: the usual plan of the view mode, at the quality above"));
    auto* fastest = new QLabel(tr("fastest"), this);
    auto* exact = new QLabel(tr("exact"), this);
    for (QLabel* label : {fastest, exact, stop_, plan_}) {
        QFont small = label->font();
        small.setPointSizeF(small.pointSizeF() * 0.92);
        label->setFont(small);
    }
    for (QLabel* label : {stop_, plan_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    plan_->setAccessibleName(tr("Plan in use"));
    stop_->setAccessibleName(tr("Budget"));
    plan_->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(on_, 0, 0, 1, 2);
    grid->addWidget(slider_, 1, 0, 1, 2);
    grid->addWidget(fastest, 2, 0, Qt::AlignLeft);
    grid->addWidget(exact, 2, 1, Qt::AlignRight);
    grid->addWidget(stop_, 3, 0, 1, 2);
    grid->addWidget(plan_, 4, 0, 1, 2);
    connect(on_, &QCheckBox::toggled, this, [this](bool on) { choose(on ? slider_->value() : -1); });
    connect(slider_, &QSlider::valueChanged, this, &BudgetPanel::choose);
    connect(slider_, &QSlider::sliderMoved, this,
            [this](int stop) { stop_->setText(stops()[std::size_t(stop)].name); });
    setSettings({});
}

void BudgetPanel::choose(int stop) {
    ViewSettings next = settings_;
    next.quality.plan.clear();
    next.quality.error_budget.reset();
    next.quality.time_budget_ms.reset();
    if (stop >= 0) next.quality.error_budget = stops()[std::size_t(stop)].error;
    Q_EMIT edited(tr("Budget"), next);
}

void BudgetPanel::setSettings(const ViewSettings& settings) {
    settings_ = settings;
    const QSignalBlocker blockers[] = {QSignalBlocker(on_), QSignalBlocker(slider_)};
    const bool budget = settings.quality.has_budget();
    on_->setChecked(budget);
    const int stop = stop_of(settings.quality);
    if (stop >= 0) slider_->setValue(stop);
    const bool chosen = !settings.quality.plan.empty();
    stop_->setText(chosen      ? tr("A plan chosen by hand")
                   : !budget   ? tr("No budget: the usual plan")
                   : stop >= 0 ? stops()[std::size_t(stop)].name
                   : settings.quality.error_budget
                       ? tr("At most %1/255 off").arg(number_text(*settings.quality.error_budget))
                       : tr("A frame in %1 ms").arg(number_text(*settings.quality.time_budget_ms)));
    setEnabled(settings.mode != ViewMode::shear_warp);
}

void BudgetPanel::showPlan(const QString& line, const QString& details) {
    plan_->setText(line);
    plan_->setToolTip(details);
}

}  // namespace lacuna::ui
