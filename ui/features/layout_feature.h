#pragma once

#include <QActionGroup>
#include <QToolBar>

#include "ui/workbench.h"

namespace lacuna::ui {

/// How the window is laid out: arrangement of the views, panels, tool bar; remembered from one run to the next. Made
/// after all other features, so that it finds their docks and commands.
class LayoutFeature final : public QObject {
    Q_OBJECT
public:
    explicit LayoutFeature(Workbench& bench);
    QToolBar* toolBar() const { return bar_; }

public Q_SLOTS:
    /// As in the first run.
    void reset();
    void save();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addArrangements();
    void addThemes();

    Workbench& bench_;
    QActionGroup* arrangements_;
    QToolBar* bar_ = nullptr;
    QByteArray first_state_;
};

}  // namespace lacuna::ui
