#pragma once

#include <QTimer>

#include "core/session/view_history.h"
#include "ui/gesture_end.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// View > Previous view and Next view: back and forward through where one looked from, where the slices were and how
/// near, by menu, keys and the mouse's side buttons. A drag, a run of keys or of wheel notches is one step.
class ViewHistoryFeature final : public QObject {
    Q_OBJECT
public:
    explicit ViewHistoryFeature(Workbench& bench);
    const ViewHistory& history() const { return history_; }

public Q_SLOTS:
    void back();
    void forward();
    /// What is shown now has nothing before it.
    void reset();

Q_SIGNALS:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Bits: what moves in one turn is one step.
    enum Moved : unsigned { nothing = 0, camera = 1, cursor = 2, zoom = 4 };
    Viewpoint viewpoint() const;
    void note(Moved moved);
    void go(const Viewpoint& to);
    void seal();
    void show();

    Workbench& bench_;
    ViewHistory history_;
    QAction *back_, *forward_;
    GestureEnd gesture_end_;
    QTimer turn_end_;
    unsigned in_turn_ = nothing;  ///< within this turn of the event loop
    unsigned last_ = nothing;
    bool going_ = false;
};

}  // namespace lacuna::ui
