#include "ui/panels/effects_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace lacuna::ui {

namespace {

/// A value people move, within limits that make sense on a slider (the effect itself may allow more).
struct Dial {
    EffectKind kind;
    const char* name;
    ValueRange limits;
    int decimals;
    double step, start;
};
constexpr Dial k_dials[] = {
    {EffectKind::ssao, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Strength"), {0, 4}, 2, 0.05, 1},
    {EffectKind::ao, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Samples"), {1, 256}, 0, 1, 16},
    {EffectKind::dof, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Focus"), {0, 1}, 2, 0.01, 0.3},
    {EffectKind::dof, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Strength"), {0, 8}, 1, 0.1, 1},
    {EffectKind::dof, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Dimming"), {0, 1}, 2, 0.05, 0},
    {EffectKind::tonemap, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "White"), {0.1, 5}, 2, 0.05, 1.2},
    {EffectKind::gamma, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Gamma"), {0.2, 4}, 2, 0.05, 1.2},
    {EffectKind::brightness, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Brightness"), {-1, 1}, 2, 0.02, 0.1},
    {EffectKind::contrast, QT_TRANSLATE_NOOP("lacuna::ui::EffectsPanel", "Contrast"), {0, 4}, 2, 0.05, 1.2}};

}  // namespace

EffectsPanel::EffectsPanel(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    addRow(EffectKind::ssao, tr("Ambient occlusion, of the screen"), tr("Darkens creases seen in the depth image"));
    addRow(EffectKind::ao, tr("Ambient occlusion, of the volume"),
           tr("Share of the hemisphere that is blocked, by rays through the volume; takes its time"));
    addRow(EffectKind::dof, tr("Depth of field"), tr("Blurs by distance from the focal plane"));
    addRow(EffectKind::tonemap, tr("Tone mapping"), tr("Compresses what is bright"));
    addRow(EffectKind::gamma, tr("Gamma"), tr("Colour to the power of one over gamma"));
    addRow(EffectKind::brightness, tr("Brightness"), tr("Added to every colour"));
    addRow(EffectKind::contrast, tr("Contrast"), tr("A factor about mid grey"));
    grid->setRowStretch(grid->rowCount(), 1);
}

void EffectsPanel::addRow(EffectKind kind, const QString& name, const QString& hint) {
    auto* grid = static_cast<QGridLayout*>(layout());
    Row row{kind, name, new QCheckBox(name, this), {}};
    row.box->setToolTip(hint);
    row.box->setAccessibleName(name);
    int at = grid->rowCount();
    grid->addWidget(row.box, at++, 0, 1, 2);
    const auto tell = [this, name] { Q_EMIT edited(name, effects()); };
    for (const Dial& dial : k_dials) {
        if (dial.kind != kind) continue;
        auto* slider = new ValueSlider(tr("%1: %2").arg(name, tr(dial.name)), this);
        slider->setLimits(dial.limits);
        slider->setSteps(dial.decimals, dial.step);
        slider->setValue(dial.start);
        slider->setVisible(false);
        auto* label = new QLabel(tr(dial.name), this);
        label->setVisible(false);
        label->setBuddy(slider->slider());
        connect(row.box, &QCheckBox::toggled, slider, &QWidget::setVisible);
        connect(row.box, &QCheckBox::toggled, label, &QWidget::setVisible);
        connect(slider, &ValueSlider::valueEdited, this, tell);
        grid->addWidget(label, at, 0);
        grid->addWidget(slider, at++, 1);
        row.sliders.push_back(slider);
    }
    connect(row.box, &QCheckBox::toggled, this, tell);
    rows_.push_back(row);
}

std::vector<Effect> EffectsPanel::effects() const {
    std::vector<Effect> effects;
    for (const Row& row : rows_) {
        if (!row.box->isChecked() || !row.box->isEnabled()) continue;
        Effect effect{row.kind, {}};
        // The dials of dof stand in the order of its values; so do those of the others, which have one.
        for (const ValueSlider* slider : row.sliders) effect.values.push_back(slider->value());
        effects.push_back(effect);
    }
    return effects;
}

void EffectsPanel::setEffects(const std::vector<Effect>& effects, ViewMode mode) {
    for (const Row& row : rows_) {
        const Effect* found = nullptr;
        for (const Effect& effect : effects)
            if (effect.kind == row.kind) found = &effect;
        row.box->setEnabled(serves(row.kind, mode));
        if (found)
            for (std::size_t i = 0; i < row.sliders.size() && i < found->values.size(); ++i)
                row.sliders[i]->setValue(found->values[i]);
        // The sliders follow the box's signal; the document must not hear of it.
        const QSignalBlocker quiet(this);
        row.box->setChecked(found != nullptr);
    }
}

QCheckBox* EffectsPanel::box(EffectKind kind) const {
    for (const Row& row : rows_)
        if (row.kind == kind) return row.box;
    return nullptr;
}

ValueSlider* EffectsPanel::slider(EffectKind kind, int value) const {
    for (const Row& row : rows_)
        if (row.kind == kind && value < int(row.sliders.size())) return row.sliders[std::size_t(value)];
    return nullptr;
}

}  // namespace lacuna::ui
