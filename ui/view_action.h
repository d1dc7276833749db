#pragma once

#include <QAction>
#include <QWidget>

namespace lacuna::ui {

/// Makes an action's key work while a view has the focus, and nowhere else: single letters and arrows mean other things
/// in other places. The action stays in its menu, and so in the palette and the sheet of keys.
inline void bind_to_view(QAction* action, QWidget* view) {
    action->setShortcutContext(Qt::WidgetShortcut);
    view->addAction(action);
}

}  // namespace lacuna::ui
