#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "core/session/document.h"
#include "ui/widgets/range_slider.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

/// Grey window of the slices and of the 3D projections.
class SlicesPanel final : public QWidget {
    Q_OBJECT
public:
    explicit SlicesPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    void setSettings(const lacuna::ViewSettings& settings);
    QComboBox* presetBox() const { return preset_; }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::ViewSettings& next);

private:
    void build();
    void editWindow(double level, double width);
    void fillPresets();

    ViewSettings settings_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    std::vector<std::pair<QString, ValueRange>> windows_;
    QComboBox* preset_;
    ValueSlider *level_, *width_;
    RangeSlider* projection_;
    QPushButton* same_;
    std::string unit_;
    ValueRange own_{0, 1};
};

}  // namespace lacuna::ui
