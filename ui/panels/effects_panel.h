#pragma once

#include <QCheckBox>
#include <QWidget>
#include <vector>

#include "core/render/effects.h"
#include "core/render/scene.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

/// Switches the effects on the 3D picture on and off and sets their values; they are applied in the order shown.
class EffectsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit EffectsPanel(QWidget* parent = nullptr);
    /// Shows a list of effects; emits nothing. What the mode has no use for is disabled.
    void setEffects(const std::vector<lacuna::Effect>& effects, lacuna::ViewMode mode);
    QCheckBox* box(lacuna::EffectKind kind) const;
    /// @param value  which of the effect's values, in the order of core/render/effects.h
    ValueSlider* slider(lacuna::EffectKind kind, int value) const;

Q_SIGNALS:
    void edited(const QString& name, const std::vector<lacuna::Effect>& effects);

private:
    struct Row {
        EffectKind kind;
        QString name;
        QCheckBox* box = nullptr;
        std::vector<ValueSlider*> sliders;  ///< of the effect's first values; those behind them keep their default
    };
    void addRow(EffectKind kind, const QString& name, const QString& hint);
    std::vector<Effect> effects() const;

    std::vector<Row> rows_;
};

}  // namespace lacuna::ui
