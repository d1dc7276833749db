#pragma once

#include <QList>
#include <QString>

namespace lacuna::ui {

/// What the mouse, and keys that are no command of a menu, do somewhere.
struct Gesture {
    QString where, input, effect;
};

/// All of them, in the order of the places; every view and widget that takes one is listed here.
QList<Gesture> gestures();

}  // namespace lacuna::ui
