#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "core/session/document.h"
#include "ui/widgets/range_slider.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

/// A preset's name in the person's language.
QString window_title(const lacuna::WindowPreset& preset);

/// Grey window of the slices and of the 3D projections; slab, tilt and overlay of the slices.
class SlicesPanel final : public QWidget {
    Q_OBJECT
public:
    explicit SlicesPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    void setSettings(const lacuna::ViewSettings& settings);
    QComboBox* presetBox() const { return preset_; }
    QComboBox* functionBox() const { return function_; }
    QComboBox* slabBox() const { return slab_mode_; }
    ValueSlider* slabSlider() const { return slab_; }
    ValueSlider* overlaySlider() const { return overlay_; }
    QPushButton* uprightButton() const { return upright_; }
    /// The windows a person can choose for this volume, by name: as opened, the full range, and of HU the presets.
    const std::vector<std::pair<QString, ValueRange>>& windows() const { return windows_; }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::ViewSettings& next);

private:
    void build();
    void connectSlices();
    void editSlices(const QString& name, const SliceSettings& slices);
    void editWindow(double level, double width);
    void fillPresets();

    ViewSettings settings_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    std::vector<std::pair<QString, ValueRange>> windows_;
    QComboBox *preset_, *function_;
    ValueSlider *level_, *width_;
    QComboBox* slab_mode_;
    ValueSlider *slab_, *overlay_;
    QPushButton* upright_;
    RangeSlider* projection_;
    QPushButton* same_;
    std::string unit_;
    ValueRange own_{0, 1};
};

}  // namespace lacuna::ui
