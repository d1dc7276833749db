#include "ui/panels/slices_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace lacuna::ui {

SlicesPanel::SlicesPanel(QWidget* parent)
    : QWidget(parent),
      preset_(new QComboBox(this)),
      level_(new ValueSlider(tr("Level"), this)),
      width_(new ValueSlider(tr("Window width"), this)),
      projection_(new RangeSlider(this)),
      same_(new QPushButton(tr("As the slices"), this)) {
    build();
    connect(preset_, &QComboBox::activated, this, [this](int i) {
        if (i < 1 || std::size_t(i) > windows_.size()) return;
        ViewSettings next = settings_;
        next.window = windows_[std::size_t(i - 1)].second;
        Q_EMIT edited(tr("Window preset"), next);
    });
    connect(level_, &ValueSlider::valueEdited, this,
            [this](double level) { editWindow(level, settings_.window.width()); });
    connect(width_, &ValueSlider::valueEdited, this,
            [this](double width) { editWindow(0.5 * (settings_.window.lo + settings_.window.hi), width); });
    connect(projection_, &RangeSlider::rangeEdited, this, [this](ValueRange range) {
        ViewSettings next = settings_;
        next.projection_window = range;
        Q_EMIT edited(tr("Grey levels of the 3D view"), next);
    });
    connect(same_, &QPushButton::clicked, this, [this] {
        ViewSettings next = settings_;
        next.projection_window = next.window;
        Q_EMIT edited(tr("Grey levels of the 3D view"), next);
    });
}

void SlicesPanel::build() {
    preset_->setAccessibleName(tr("Window preset"));
    projection_->setAccessibleName(tr("Grey levels of the 3D view"));
    same_->setAccessibleName(tr("Grey levels of the 3D view as in the slices"));
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->addRow(tr("&Window"), preset_);
    form->addRow(tr("Level"), level_);
    form->addRow(tr("Width"), width_);
    column->addLayout(form);
    auto* title = new QLabel(tr("Grey levels of projections and cut faces in 3D"), this);
    title->setContentsMargins(0, 10, 0, 0);
    column->addWidget(title);
    column->addWidget(projection_);
    column->addWidget(same_, 0, Qt::AlignLeft);
    column->addStretch(1);
}

void SlicesPanel::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    statistics_ = std::move(statistics);
    unit_ = volume.unit;
    own_ = default_window(volume, *statistics_);
    const ValueRange values = statistics_->range;
    const double span = std::max(values.width(), 1e-6);
    level_->setLimits({std::min(values.lo, own_.lo), std::max(values.hi, own_.hi)});
    width_->setLimits({span / 1000, std::max(2 * span, own_.width())});
    projection_->setLimits({std::min(values.lo, own_.lo), std::max(values.hi, own_.hi)});
    projection_->setStep(ValueSteps::of(values).step);
    fillPresets();
}

void SlicesPanel::fillPresets() {
    windows_.clear();
    windows_.emplace_back(tr("As opened"), own_);
    windows_.emplace_back(tr("Full range"), statistics_->range.width() > 0
                                                ? statistics_->range
                                                : ValueRange{statistics_->range.lo - 0.5, statistics_->range.lo + 0.5});
    if (unit_ == "HU")
        for (const WindowPreset& preset : hounsfield_windows())
            windows_.emplace_back(tr("%1 (L %2, W %3)").arg(tr(preset.name)).arg(preset.center).arg(preset.width),
                                  ValueRange{preset.center - 0.5 * preset.width, preset.center + 0.5 * preset.width});
    const QSignalBlocker quiet(preset_);
    preset_->clear();
    preset_->addItem(tr("Custom"));
    for (const auto& [name, window] : windows_) preset_->addItem(name);
}

void SlicesPanel::setSettings(const ViewSettings& settings) {
    settings_ = settings;
    const QSignalBlocker quiet(preset_);
    int chosen = 0;
    for (std::size_t i = 0; i < windows_.size() && chosen == 0; ++i)
        if (windows_[i].second == settings.window) chosen = int(i) + 1;
    preset_->setCurrentIndex(chosen);
    level_->setValue(0.5 * (settings.window.lo + settings.window.hi));
    width_->setValue(settings.window.width());
    if (projection_->range() != settings.projection_window) projection_->setRange(settings.projection_window);
}

void SlicesPanel::editWindow(double level, double width) {
    ViewSettings next = settings_;
    next.window = {level - 0.5 * width, level + 0.5 * width};
    Q_EMIT edited(tr("Window and level"), next);
}

}  // namespace lacuna::ui
