#include "ui/panels/ranges_panel.h"

#include <QColorDialog>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>
#include <array>

#include "ui/widgets/plot_paint.h"

namespace lacuna::ui {

namespace {

/// Told apart also by most who see colours differently (after Okabe & Ito 2008).
constexpr std::array<glm::dvec3, 8> k_palette{{{0.34, 0.71, 0.91},
                                               {0.90, 0.62, 0.00},
                                               {0.00, 0.62, 0.45},
                                               {0.80, 0.47, 0.65},
                                               {0.94, 0.89, 0.26},
                                               {0.84, 0.37, 0.00},
                                               {0.00, 0.45, 0.70},
                                               {0.60, 0.60, 0.60}}};

}  // namespace

RangesPanel::RangesPanel(QWidget* parent)
    : QWidget(parent), add_(new QPushButton(tr("Add a range"), this)), count_job_(this) {
    auto* column = new QVBoxLayout(this);
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    auto* inside = new QWidget(area);
    list_ = new QVBoxLayout(inside);
    list_->setContentsMargins(0, 0, 4, 0);
    auto* note = new QLabel(
        tr("No range: every value is kept. With ranges, only values inside them are seen; where they overlap, the "
           "upper one counts."),
        inside);
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
    count();
}

void RangesPanel::rebuild() {
    for (RangeRow* row : rows_) {
        row->hide();
        row->deleteLater();  // it may be the sender
    }
    rows_.clear();
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        auto* row = new RangeRow(int(i + 1), statistics_->range, QString::fromStdString(volume_.unit), this);
        row->setUnitDistance(volume_.geometry().smallest_spacing_mm());
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
    counted_.clear();
    count();
}

void RangesPanel::count() {
    std::vector<ValueRange> wanted;
    for (const RangeSetting& range : ranges_) wanted.push_back(range.range.range);
    // What is not in use takes nothing from those below it.
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (!ranges_[i].enabled) wanted[i] = {1, 0};
    std::vector<ValueRange> all = wanted;
    for (const RangeSetting& range : ranges_) all.push_back(range.range.range);
    if (all == counted_) return;
    counted_ = all;
    if (wanted.empty()) return count_job_.cancel();
    for (RangeRow* row : rows_) row->setCount({});
    count_job_.start(
        [volume = volume_, statistics = statistics_, wanted, ranges = ranges_](const JobContext& job) {
            std::vector<RangeCount> counts = count_ranges(volume, *statistics, wanted, job);
            std::vector<ValueRange> unused;
            for (const RangeSetting& range : ranges)
                if (!range.enabled) unused.push_back(range.range.range);
            if (unused.empty()) return counts;
            const std::vector<RangeCount> of_unused = count_ranges(volume, *statistics, unused, job);
            for (std::size_t i = 0, k = 0; i < ranges.size(); ++i) {
                if (ranges[i].enabled) continue;
                counts[i] = of_unused[k++];
                counts[i].own = counts[i].voxels;
            }
            return counts;
        },
        [this](Outcome<std::vector<RangeCount>> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                counted_.clear();
                Q_EMIT failed(QString::fromStdString(error->what()));
                return;
            }
            const std::vector<RangeCount>& counts = std::get<0>(outcome);
            for (std::size_t i = 0; i < rows_.size() && i < counts.size(); ++i) rows_[i]->setCount(counts[i]);
            Q_EMIT counted();
        });
}

void RangesPanel::change(std::size_t i, const QString& name, const RangeSetting& setting) {
    std::vector<RangeSetting> next = ranges_;
    next[i] = setting;
    Q_EMIT edited(name, next);
}

void RangesPanel::connectRow(std::size_t i) {
    RangeRow* row = rows_[i];
    connect(row, &RangeRow::edited, this,
            [this, i](const QString& what, const RangeSetting& setting) { change(i, what, setting); });
    connect(row, &RangeRow::presetChosen, this, [this, i](const QString& preset) { usePreset(i, preset); });
    connect(row, &RangeRow::ownColorsRequested, this, [this, i] { Q_EMIT ownColorsRequested(int(i)); });
    connect(row, &RangeRow::colorRequested, this, [this, i] { pickColor(i); });
    connect(row, &RangeRow::upRequested, this, [this, i] {
        if (i == 0) return;
        std::vector<RangeSetting> next = ranges_;
        std::swap(next[i - 1], next[i]);
        Q_EMIT edited(tr("Order of the ranges"), next);
    });
    connect(row, &RangeRow::removeRequested, this, [this, i] {
        std::vector<RangeSetting> next = ranges_;
        next.erase(next.begin() + std::ptrdiff_t(i));
        add_->setFocus();  // the focus must not vanish with the row
        Q_EMIT edited(tr("Remove range %1").arg(i + 1), next);
    });
}

void RangesPanel::usePreset(std::size_t i, const QString& preset) {
    try {
        RangeSetting next = ranges_[i];
        next.range.tf = make_preset(preset.toStdString(), volume_, *statistics_);
        change(i, tr("Colours of range %1").arg(i + 1), next);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

void RangesPanel::pickColor(std::size_t i) {
    auto* dialog = new QColorDialog(to_qcolor(ranges_[i].color), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(tr("Colour of the range"));
    connect(dialog, &QColorDialog::colorSelected, this, [this, i](const QColor& color) {
        if (i < ranges_.size()) setColor(i, from_qcolor(color));
    });
    dialog->open();
}

void RangesPanel::setColor(std::size_t i, const glm::dvec3& color) {
    RangeSetting next = ranges_[i];
    next.color = color;
    if (next.range.tf && next.range.tf->name == k_one_color_name)
        next.range.tf = one_color_function(next, next.range.tf->unit_distance_mm);
    change(i, tr("Colour of range %1").arg(i + 1), next);
}

void RangesPanel::addRange() {
    if (!statistics_ || ranges_.size() >= Classification::k_max_ranges) return;
    std::vector<RangeSetting> next = ranges_;
    RangeSetting added;
    // After one in the middle was removed the last has the name and the colour that would come next.
    const auto taken = [&](std::size_t number) {
        const std::string name = tr("Range %1").arg(number).toStdString();
        return std::any_of(next.begin(), next.end(), [&](const RangeSetting& at) { return at.range.name == name; });
    };
    std::size_t number = next.size() + 1;
    while (taken(number)) ++number;
    added.range.name = tr("Range %1").arg(number).toStdString();
    added.color = k_palette[(number - 1) % k_palette.size()];
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
