#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QWidget>

#include "core/session/document.h"
#include "ui/histogram_controller.h"
#include "ui/panels/gradient_page.h"
#include "ui/panels/shapes_page.h"
#include "ui/widgets/point_fields.h"
#include "ui/widgets/transfer_plot.h"

namespace lacuna::ui {

/// Edits a transfer function, the scene's or a segmentation range's own: its points over the histogram, its
/// gradient-opacity curve, its shapes of value and gradient, its colours by a colour map, and files.
class TransferPanel final : public QWidget {
    Q_OBJECT
public:
    enum Page { k_values, k_gradients, k_shapes };

    explicit TransferPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    void setSettings(const lacuna::ViewSettings& settings);
    /// Edits range `index`'s own function, which it gets if it has none; -1: the scene's.
    void setTarget(int index);
    void showPage(Page page);
    /// The one being edited.
    const TransferFunction& function() const;
    TransferPlot* plot() const { return plot_; }
    GradientPage* gradientPage() const { return gradients_; }
    ShapesPage* shapesPage() const { return shapes_; }
    QComboBox* targetBox() const { return target_box_; }
    QComboBox* histogramBox() const { return histogram_box_; }
    HistogramController* histograms() const { return histograms_; }

public Q_SLOTS:
    void applyColorMap(const QString& name);
    /// Takes a function for the one being edited, as a step of undo of its own.
    void load(const lacuna::TransferFunction& function);

Q_SIGNALS:
    void loadRequested();
    void saveRequested();
    void edited(const QString& name, const lacuna::ViewSettings& next);
    void gestureEnded();
    void failed(const QString& sentence);

private:
    void build();
    QWidget* buildTools();
    void connectParts();
    void fillColorMaps();
    void fillTargets();
    /// The settings with this function where the one being edited stands.
    ViewSettings with(const TransferFunction& function) const;
    /// @param whole  a step of undo of its own
    void edit(const QString& name, const TransferFunction& function, bool whole);
    void showFunction();
    void countPart();

    Volume volume_;
    std::shared_ptr<const VolumeStatistics> statistics_;
    ViewSettings settings_;
    int target_ = -1;
    HistogramController* histograms_;
    QTabBar* pages_;
    QStackedWidget* stack_;
    TransferPlot* plot_;
    PointFields* fields_;
    QLabel* shapes_note_;
    GradientPage* gradients_;
    ShapesPage* shapes_;
    QComboBox *target_box_, *histogram_box_;
    QCheckBox* logarithmic_;
    QToolButton* maps_;
    QPushButton *load_, *save_;
};

}  // namespace lacuna::ui
