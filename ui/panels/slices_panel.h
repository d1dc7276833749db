#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>
#include <optional>

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
    void setDocument(const lacuna::Document& document);
    void setSettings(const lacuna::ViewSettings& settings);
    QComboBox* presetBox() const { return preset_; }
    QComboBox* functionBox() const { return function_; }
    ValueSlider* overlaySlider() const { return overlay_; }
    /// A window a person can choose.
    struct NamedWindow {
        QString name;
        ValueRange range;
        std::optional<int> table;  ///< with this table of the file
    };
    /// Those for this volume: as opened, the full range, of HU the presets, and the file's own tables.
    const std::vector<NamedWindow>& windows() const { return windows_; }
    /// The settings with a window chosen. A table goes with its own window alone.
    static void choose(lacuna::ViewSettings& settings, const NamedWindow& window);

Q_SIGNALS:
    void edited(const QString& name, const lacuna::ViewSettings& next);

private:
    void build();
    void connectSlices();
    void editSlices(const QString& name, const SliceSettings& slices);
    void editWindow(double level, double width);
    void fillPresets(const Document& document);
    void setTablesAllowed(bool there);

    ViewSettings settings_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    std::vector<NamedWindow> windows_;
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
