#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "core/classify/part_histogram.h"
#include "core/session/document.h"
#include "ui/widgets/range_slider.h"

namespace lacuna::ui {

/// One segmentation range: its name and colour, on or off, its ends, whose colours it is drawn in, what it holds.
class RangeRow final : public QWidget {
    Q_OBJECT
public:
    /// Where the entries for the colours stand before the presets.
    enum Colors { k_scene, k_own, k_one_color, k_first_preset };

    RangeRow(int number, lacuna::ValueRange limits, const QString& unit, QWidget* parent = nullptr);
    /// What the opacity of a function of one colour is stated for.
    void setUnitDistance(double mm) { unit_distance_mm_ = mm; }
    void setSetting(const lacuna::RangeSetting& setting);
    const lacuna::RangeSetting& setting() const { return setting_; }
    /// What it holds of the volume; nothing is said while that is being counted.
    void setCount(const std::optional<lacuna::RangeCount>& count);
    RangeSlider* slider() const { return slider_; }
    QLineEdit* nameField() const { return name_; }
    QComboBox* colorsBox() const { return colors_; }
    QString countText() const { return count_->text(); }

Q_SIGNALS:
    /// @param what  the undo step's name
    void edited(const QString& what, const lacuna::RangeSetting& setting);
    void presetChosen(const QString& preset);
    void ownColorsRequested();  ///< its own transfer function is to be edited
    void colorRequested();
    void upRequested();  ///< one place earlier: where ranges overlap, the first counts
    void removeRequested();

private:
    void build(int number);
    void connectParts();
    void chooseColors(int index);
    void editEnds(ValueRange range);

    RangeSetting setting_;
    double unit_distance_mm_ = 1;
    QCheckBox* enabled_;
    QLineEdit* name_;
    QToolButton *color_, *up_;
    RangeSlider* slider_;
    QDoubleSpinBox *lo_, *hi_;
    QComboBox* colors_;
    QPushButton* remove_;
    QLabel* count_;
};

/// A function that draws all of a range in its colour.
lacuna::TransferFunction one_color_function(const lacuna::RangeSetting& setting, double unit_distance_mm);
inline constexpr const char* k_one_color_name = "one colour";

}  // namespace lacuna::ui
