#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>
#include <array>

#include "core/inspect/criteria.h"
#include "core/volume/statistics.h"

namespace lacuna::ui {

/// A value that is found by the program unless it is given: a check box and a spin box.
class OptionalValue final : public QWidget {
    Q_OBJECT
public:
    OptionalValue(const QString& label, const QString& accessible_name, QWidget* parent = nullptr);
    std::optional<double> value() const;
    void setValue(std::optional<double> value);  ///< emits nothing
    QDoubleSpinBox* spin() const { return spin_; }
    QCheckBox* box() const { return box_; }

Q_SIGNALS:
    void edited();

private:
    QCheckBox* box_;
    QDoubleSpinBox* spin_;
};

/// Edits what counts as material and as a defect, and the limits of the part as a whole. Zones are kept as loaded.
class CriteriaForm final : public QWidget {
    Q_OBJECT
public:
    explicit CriteriaForm(QWidget* parent = nullptr);
    void setVolume(const lacuna::Volume& volume, const lacuna::VolumeStatistics& statistics);
    void setCriteria(const lacuna::Criteria& criteria);  ///< emits nothing
    const lacuna::Criteria& criteria() const { return criteria_; }
    OptionalValue* limit(Rule rule) const { return limits_[std::size_t(rule)]; }
    OptionalValue* material() const { return material_; }

Q_SIGNALS:
    void detectionEdited();  ///< what is found may change: measure anew
    void limitsEdited();     ///< only the verdicts can change

private:
    void takeDetection();
    void takeLimits();
    void show(const Criteria& criteria);

    Criteria criteria_;
    OptionalValue *material_, *void_below_, *inclusion_above_;
    QCheckBox *voids_, *inclusions_;
    QSpinBox* min_voxels_;
    std::array<OptionalValue*, k_rules.size()> limits_{};
    QLabel* zones_;
    double highest_ = 0;  ///< of the volume's values: the upper end of a material range
};

}  // namespace lacuna::ui
