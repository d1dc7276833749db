#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>
#include <QWidget>

#include "core/session/document.h"
#include "ui/models/region_model.h"

namespace lacuna::ui {

/// Asks for the regions of the volume and shows their characteristics. Choosing a row names its region.
class RegionsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit RegionsPanel(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, std::shared_ptr<const lacuna::VolumeStatistics> statistics);
    /// What "from the current range" takes: the first range in use, or what lies above the isovalue.
    void setSettings(const lacuna::ViewSettings& settings);
    void setTable(std::shared_ptr<const lacuna::RegionTable> table);
    void setRunning(bool running);
    lacuna::RegionOptions options() const;
    /// Asks as those options do; what the panel has no field for stays part of options().
    void setOptions(const lacuna::RegionOptions& options);
    QTableView* table() const { return view_; }
    QPushButton* computeButton() const { return compute_; }
    RegionModel* model() const { return model_; }

Q_SIGNALS:
    void computeRequested(const lacuna::RegionOptions& options);
    void regionChosen(std::uint32_t id);  ///< 0: none
    void exportRequested();

private:
    void build();
    QLayout* formColumn();
    void showMethod();
    void takeRange();

    std::shared_ptr<const VolumeStatistics> statistics_;
    ViewSettings settings_;
    RegionOptions kept_;  ///< of setOptions(): what has no field here
    RegionModel* model_;
    QSortFilterProxyModel* sorted_;
    QComboBox *method_, *connectivity_;
    QDoubleSpinBox *lo_, *hi_, *width_;
    QSpinBox* min_voxels_;
    QPushButton *take_, *compute_, *clear_, *export_;
    QLabel *to_, *note_;
    QTableView* view_;
};

}  // namespace lacuna::ui
