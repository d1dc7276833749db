#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "core/session/document.h"

namespace lacuna::ui {

/// What the 3D picture may cost: a slider of named stops from the fastest plan to an exact one, and a line on the plan
/// that draws.
class BudgetPanel final : public QWidget {
    Q_OBJECT
public:
    /// The slider's stops, from the fastest to the exact.
    struct Stop {
        double error = 0;  ///< 1/255; of the fastest one the largest there is
        QString name;
    };
    static const std::vector<Stop>& stops();

    explicit BudgetPanel(QWidget* parent = nullptr);
    void setSettings(const lacuna::ViewSettings& settings);
    /// One line on the plan in use; `details` is its tooltip.
    void showPlan(const QString& line, const QString& details);
    QSlider* slider() const { return slider_; }
    QCheckBox* switchBox() const { return on_; }
    QString planLine() const { return plan_->text(); }

Q_SIGNALS:
    void edited(const QString& name, const lacuna::ViewSettings& next);

private:
    void choose(int stop);

    ViewSettings settings_;
    QCheckBox* on_;
    QSlider* slider_;
    QLabel *stop_, *plan_;
};

}  // namespace lacuna::ui
