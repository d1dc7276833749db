#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QWidget>

#include "core/session/document.h"
#include "ui/widgets/transfer_plot.h"

namespace lacuna::ui {

/// Edits the transfer function: the plot, the selected point's numbers and colour, presets and files.
class TransferPanel final : public QWidget {
    Q_OBJECT
public:
    explicit TransferPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    void setFunction(const lacuna::TransferFunction& function);
    TransferPlot* plot() const { return plot_; }
    QComboBox* presetBox() const { return preset_; }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::TransferFunction& next);
    void failed(const QString& sentence);

private:
    void build();
    void showPoint();
    void editPoint();
    void pickColor(int point);
    void applyPreset(int index);
    void load();
    void save();

    Volume volume_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    TransferPlot* plot_;
    QComboBox* preset_;
    QDoubleSpinBox *value_, *opacity_;
    QPushButton *color_, *add_, *remove_, *load_, *save_;
};

}  // namespace lacuna::ui
