#include "ui/gestures.h"

#include <QCoreApplication>

namespace lacuna::ui {

namespace {

struct Row {
    const char *where, *input, *effect;
};

constexpr Row k_rows[] = {
    {QT_TRANSLATE_NOOP("Gestures", "3D view"), QT_TRANSLATE_NOOP("Gestures", "Left drag"),
     QT_TRANSLATE_NOOP("Gestures", "Turn")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Middle or Shift+left drag"), QT_TRANSLATE_NOOP("Gestures", "Move")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Right drag, wheel"), QT_TRANSLATE_NOOP("Gestures", "Zoom")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Double click, Enter"),
     QT_TRANSLATE_NOOP("Gestures", "This view alone, or all again")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Arrow keys"), QT_TRANSLATE_NOOP("Gestures", "Turn")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Shift+arrow keys"), QT_TRANSLATE_NOOP("Gestures", "Move")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "+ and −"), QT_TRANSLATE_NOOP("Gestures", "Zoom")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Comma, full stop"), QT_TRANSLATE_NOOP("Gestures", "Roll")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Ctrl+right drag"),
     QT_TRANSLATE_NOOP("Gestures", "Shift and widen the transfer function, the isovalue or the grey window")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Click, Space"),
     QT_TRANSLATE_NOOP("Gestures", "Read out and mark a point")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Shift+click, Shift and moving, Shift+Space"),
     QT_TRANSLATE_NOOP("Gestures", "Slices through a point")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Right click"),
     QT_TRANSLATE_NOOP("Gestures", "What can be done at a point")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Drag of a cut's arrow or outline"),
     QT_TRANSLATE_NOOP("Gestures", "Move the cut")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Drag of a cut's round handle, with Ctrl to axes"),
     QT_TRANSLATE_NOOP("Gestures", "Tilt the cut")},
    {"3D view", QT_TRANSLATE_NOOP("Gestures", "Drag of a box's square handle"),
     QT_TRANSLATE_NOOP("Gestures", "Move a side of the box, or all of it")},
    {QT_TRANSLATE_NOOP("Gestures", "Slices"), QT_TRANSLATE_NOOP("Gestures", "Left drag"),
     QT_TRANSLATE_NOOP("Gestures", "Set the cross-hair")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Wheel, Page Up and Page Down"),
     QT_TRANSLATE_NOOP("Gestures", "Turn the pages")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Right drag, Shift+arrow keys"),
     QT_TRANSLATE_NOOP("Gestures", "Window and level")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Middle drag"), QT_TRANSLATE_NOOP("Gestures", "Move the picture")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Ctrl+wheel, + and −"), QT_TRANSLATE_NOOP("Gestures", "Zoom")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Double click, Enter"),
     QT_TRANSLATE_NOOP("Gestures", "This view alone, or all again")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Arrow keys"), QT_TRANSLATE_NOOP("Gestures", "Move the cross-hair")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Home"), QT_TRANSLATE_NOOP("Gestures", "Show all")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Drag of a cross-hair's handle, Shift+left drag, Ctrl+Left and Right"),
     QT_TRANSLATE_NOOP("Gestures", "Tilt the two other planes")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Left drag or clicks while measuring, Space"),
     QT_TRANSLATE_NOOP("Gestures", "Set the points of a measurement")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Left drag of a measurement"),
     QT_TRANSLATE_NOOP("Gestures", "Move it or one of its points")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Delete"), QT_TRANSLATE_NOOP("Gestures", "Remove the measurement")},
    {"Slices", QT_TRANSLATE_NOOP("Gestures", "Escape"), QT_TRANSLATE_NOOP("Gestures", "End measuring")},
    {QT_TRANSLATE_NOOP("Gestures", "Transfer function"), QT_TRANSLATE_NOOP("Gestures", "Left drag of a point"),
     QT_TRANSLATE_NOOP("Gestures", "Move it")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Double click, Insert"),
     QT_TRANSLATE_NOOP("Gestures", "Add a point")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Delete"), QT_TRANSLATE_NOOP("Gestures", "Remove the point")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Right click, Enter"),
     QT_TRANSLATE_NOOP("Gestures", "Choose its colour")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Arrow keys"), QT_TRANSLATE_NOOP("Gestures", "Move the point")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Page Up and Page Down"),
     QT_TRANSLATE_NOOP("Gestures", "Choose another point")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Wheel"),
     QT_TRANSLATE_NOOP("Gestures", "Widen or narrow the values shown")},
    {"Transfer function", QT_TRANSLATE_NOOP("Gestures", "Drag of a box, Ctrl+A"),
     QT_TRANSLATE_NOOP("Gestures", "Choose several points")},
    {QT_TRANSLATE_NOOP("Gestures", "Range sliders"), QT_TRANSLATE_NOOP("Gestures", "Drag of an end"),
     QT_TRANSLATE_NOOP("Gestures", "Move it")},
    {"Range sliders", QT_TRANSLATE_NOOP("Gestures", "Drag between the ends"),
     QT_TRANSLATE_NOOP("Gestures", "Move both")},
    {"Range sliders", QT_TRANSLATE_NOOP("Gestures", "Tab, arrow keys"),
     QT_TRANSLATE_NOOP("Gestures", "Go to the other end, move it")},
    {QT_TRANSLATE_NOOP("Gestures", "All views"), QT_TRANSLATE_NOOP("Gestures", "Side buttons of the mouse"),
     QT_TRANSLATE_NOOP("Gestures", "Previous or next view")},
    {QT_TRANSLATE_NOOP("Gestures", "Everywhere"), QT_TRANSLATE_NOOP("Gestures", "Drop a file or folder"),
     QT_TRANSLATE_NOOP("Gestures", "Open it")},
    {"Everywhere", QT_TRANSLATE_NOOP("Gestures", "Tab, Shift+Tab"),
     QT_TRANSLATE_NOOP("Gestures", "Next or previous control")},
    {"Everywhere", QT_TRANSLATE_NOOP("Gestures", "Ctrl+full stop"),
     QT_TRANSLATE_NOOP("Gestures", "Cancel what is running")},
    {"Everywhere", QT_TRANSLATE_NOOP("Gestures", "Escape"), QT_TRANSLATE_NOOP("Gestures", "Dismiss the message")},
};

}  // namespace

QList<Gesture> gestures() {
    const auto words = [](const char* text) { return QCoreApplication::translate("Gestures", text); };
    QList<Gesture> list;
    for (const Row& row : k_rows) list.push_back({words(row.where), words(row.input), words(row.effect)});
    return list;
}

}  // namespace lacuna::ui
