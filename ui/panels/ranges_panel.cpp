#include "ui/panels/ranges_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>

#include "ui/tab_chain.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

RangeRow::RangeRow(int number, ValueRange limits, QWidget* parent)
    : QWidget(parent),
      enabled_(new QCheckBox(tr("Range %1").arg(number), this)),
      slider_(new RangeSlider(this)),
      lo_(new QDoubleSpinBox(this)),
      hi_(new QDoubleSpinBox(this)),
      colors_(new QComboBox(this)),
      remove_(new QPushButton(tr("Remove"), this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 4, 0, 8);
    grid->addWidget(enabled_, 0, 0);
    grid->addWidget(colors_, 0, 1);
    grid->addWidget(remove_, 0, 2);
    grid->addWidget(slider_, 1, 0, 1, 3);
    auto* ends = new QHBoxLayout;
    ends->addWidget(lo_, 1);
    ends->addWidget(new QLabel(tr("to"), this));
    ends->addWidget(hi_, 1);
    grid->addLayout(ends, 2, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    enabled_->setAccessibleName(tr("Range %1 in use").arg(number));
    slider_->setAccessibleName(tr("Range %1").arg(number));
    lo_->setAccessibleName(tr("Lower end of range %1").arg(number));
    hi_->setAccessibleName(tr("Upper end of range %1").arg(number));
    colors_->setAccessibleName(tr("Colours of range %1").arg(number));
    remove_->setAccessibleName(tr("Remove range %1").arg(number));
    const ValueSteps steps = ValueSteps::of(limits);
    slider_->setLimits(limits);
    slider_->setStep(steps.decimals == 0 ? std::max(1.0, std::round(limits.width() / 500)) : steps.step);
    for (QDoubleSpinBox* end : {lo_, hi_}) {
        end->setRange(limits.lo, limits.hi);
        end->setDecimals(steps.decimals);
        end->setSingleStep(steps.step);
        end->setKeyboardTracking(false);
        end->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    }
    chain_tabs({enabled_, colors_, remove_, slider_, lo_, hi_});
    connect(enabled_, &QCheckBox::toggled, this, [this](bool on) {
        setting_.enabled = on;
        Q_EMIT edited(setting_);
    });
    connect(slider_, &RangeSlider::rangeEdited, this, &RangeRow::editEnds);
    connect(lo_, &QDoubleSpinBox::valueChanged, this, [this](double lo) {
        editEnds({lo, std::max(lo, setting_.range.range.hi)});
    });
    connect(hi_, &QDoubleSpinBox::valueChanged, this, [this](double hi) {
        editEnds({std::min(hi, setting_.range.range.lo), hi});
    });
    connect(colors_, &QComboBox::activated, this,
            [this](int i) { Q_EMIT colorsChosen(i == 0 ? QString() : colors_->itemText(i)); });
    connect(remove_, &QPushButton::clicked, this, &RangeRow::removeRequested);
}

void RangeRow::setColors(const QStringList& names) {
    const QSignalBlocker quiet(colors_);
    colors_->clear();
    colors_->addItems(names);
}

void RangeRow::setSetting(const RangeSetting& setting) {
    setting_ = setting;
    const QSignalBlocker quiet[] = {QSignalBlocker(enabled_), QSignalBlocker(lo_), QSignalBlocker(hi_)};
    enabled_->setChecked(setting.enabled);
    if (slider_->range() != setting.range.range) slider_->setRange(setting.range.range);
    lo_->setValue(setting.range.range.lo);
    hi_->setValue(setting.range.range.hi);
    const int known = setting.range.tf ? colors_->findText(QString::fromStdString(setting.range.tf->name)) : 0;
    colors_->setCurrentIndex(std::max(0, known));
}

void RangeRow::editEnds(ValueRange range) {
    setting_.range.range = range;
    setSetting(RangeSetting(setting_));
    Q_EMIT edited(setting_);
}

RangesPanel::RangesPanel(QWidget* parent) : QWidget(parent), add_(new QPushButton(tr("Add a range"), this)) {
    auto* column = new QVBoxLayout(this);
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    auto* inside = new QWidget(area);
    list_ = new QVBoxLayout(inside);
    list_->setContentsMargins(0, 0, 4, 0);
    auto* note =
        new QLabel(tr("No range: every value is kept. With ranges, only values inside them are seen."), inside);
    note->setWordWrap(true);
    note->setEnabled(false);
    empty_note_ = note;
    list_->addWidget(note);
    list_->addStretch(1);
    area->setWidget(inside);
    column->addWidget(area, 1);
    column->addWidget(add_);
    add_->setAccessibleName(tr("Add a segmentation range"));
    connect(add_, &QPushButton::clicked, this, &RangesPanel::addRange);
}

void RangesPanel::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    volume_ = volume;
    statistics_ = std::move(statistics);
    ranges_.clear();
    rebuild();
}

void RangesPanel::setRanges(const std::vector<RangeSetting>& ranges) {
    if (!statistics_) return;
    const bool same_rows = ranges.size() == rows_.size();
    ranges_ = ranges;
    if (!same_rows) return rebuild();
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->setSetting(ranges_[i]);
}

void RangesPanel::rebuild() {
    for (RangeRow* row : rows_) {
        row->hide();
        row->deleteLater();  // it may be the sender
    }
    rows_.clear();
    QStringList colors{tr("Scene's colours")};
    for (const std::string& name : preset_names()) colors << QString::fromStdString(name);
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        auto* row = new RangeRow(int(i + 1), statistics_->range, this);
        row->setColors(colors);
        row->setSetting(ranges_[i]);
        list_->insertWidget(int(i) + 1, row);
        rows_.push_back(row);
        connectRow(i);
    }
    QWidget* before = nullptr;
    for (RangeRow* row : rows_) {
        if (before) setTabOrder(before, row);
        before = row;
    }
    if (before) setTabOrder(before, add_);
    empty_note_->setVisible(ranges_.empty());
    add_->setEnabled(statistics_ && ranges_.size() < Classification::k_max_ranges);
}

void RangesPanel::connectRow(std::size_t i) {
    RangeRow* row = rows_[i];
    connect(row, &RangeRow::edited, this, [this, i](const RangeSetting& setting) {
        std::vector<RangeSetting> next = ranges_;
        next[i] = setting;
        Q_EMIT edited(tr("Range %1").arg(i + 1), next);
    });
    connect(row, &RangeRow::colorsChosen, this, [this, i](const QString& preset) {
        std::vector<RangeSetting> next = ranges_;
        try {
            if (preset.isEmpty())
                next[i].range.tf.reset();
            else
                next[i].range.tf = make_preset(preset.toStdString(), volume_, *statistics_);
            Q_EMIT edited(tr("Colours of range %1").arg(i + 1), next);
        } catch (const Error& error) {
            Q_EMIT failed(QString::fromStdString(error.what()));
        }
    });
    connect(row, &RangeRow::removeRequested, this, [this, i] {
        std::vector<RangeSetting> next = ranges_;
        next.erase(next.begin() + std::ptrdiff_t(i));
        add_->setFocus();  // the focus must not vanish with the row
        Q_EMIT edited(tr("Remove range %1").arg(i + 1), next);
    });
}

void RangesPanel::addRange() {
    if (!statistics_ || ranges_.size() >= Classification::k_max_ranges) return;
    std::vector<RangeSetting> next = ranges_;
    RangeSetting added;
    added.range.name = tr("Range %1").arg(next.size() + 1).toStdString();
    // The first is the object, the second what lies around it, further ones the middle of the values.
    const ValueRange values = statistics_->range;
    const double otsu = otsu_threshold(*statistics_);
    added.range.range = next.empty()       ? ValueRange{otsu, values.hi}
                        : next.size() == 1 ? ValueRange{values.lo, otsu}
                                           : ValueRange{values.lo + values.width() / 3, values.hi - values.width() / 3};
    next.push_back(added);
    Q_EMIT edited(tr("Add a range"), next);
}

}  // namespace lacuna::ui
