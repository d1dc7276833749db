#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "core/session/document.h"
#include "ui/widgets/range_slider.h"

namespace lacuna::ui {

/// One segmentation range: on or off, its ends, its colours.
class RangeRow final : public QWidget {
    Q_OBJECT
public:
    RangeRow(int number, lacuna::ValueRange limits, QWidget* parent = nullptr);
    void setSetting(const lacuna::RangeSetting& setting);
    const lacuna::RangeSetting& setting() const { return setting_; }
    RangeSlider* slider() const { return slider_; }
    /// Told which transfer functions can be chosen; the first entry is the scene's.
    void setColors(const QStringList& names);

Q_SIGNALS:
    void edited(const lacuna::RangeSetting& setting);
    void colorsChosen(const QString& preset);  ///< empty: the scene's
    void removeRequested();

private:
    void editEnds(ValueRange range);

    RangeSetting setting_;
    QCheckBox* enabled_;
    RangeSlider* slider_;
    QDoubleSpinBox *lo_, *hi_;
    QComboBox* colors_;
    QPushButton* remove_;
};

/// The list of segmentation ranges. With none, all values are kept.
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
    void failed(const QString& sentence);

private:
    void rebuild();
    void connectRow(std::size_t i);

    Volume volume_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    std::vector<RangeSetting> ranges_;
    std::vector<RangeRow*> rows_;
    QVBoxLayout* list_;
    QWidget* empty_note_;
    QPushButton* add_;
};

}  // namespace lacuna::ui
