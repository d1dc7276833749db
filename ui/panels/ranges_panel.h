#pragma once

#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "core/session/document.h"
#include "ui/latest_job.h"
#include "ui/panels/range_row.h"

namespace lacuna::ui {

/// The list of segmentation ranges, with what each holds of the volume. With none, all values are kept.
class RangesPanel final : public QWidget {
    Q_OBJECT
public:
    explicit RangesPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    void setRanges(const std::vector<lacuna::RangeSetting>& ranges);
    RangeRow* row(int index) const { return rows_[std::size_t(index)]; }
    QPushButton* addButton() const { return add_; }

public Q_SLOTS:
    void addRange();

Q_SIGNALS:
    void edited(const QString& name, const std::vector<lacuna::RangeSetting>& ranges);
    void ownColorsRequested(int index);
    void counted();  ///< the rows say what the ranges hold
    void failed(const QString& sentence);

private:
    void rebuild();
    void connectRow(std::size_t i);
    void count();
    void pickColor(std::size_t i);
    void setColor(std::size_t i, const glm::dvec3& color);
    void usePreset(std::size_t i, const QString& preset);
    void change(std::size_t i, const QString& name, const RangeSetting& setting);

    Volume volume_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    std::vector<RangeSetting> ranges_;
    std::vector<RangeRow*> rows_;
    std::vector<ValueRange> counted_;  ///< the ranges the counts shown are of
    QVBoxLayout* list_;
    QWidget* empty_note_;
    QPushButton* add_;
    LatestJob<std::vector<RangeCount>> count_job_;
};

}  // namespace lacuna::ui
