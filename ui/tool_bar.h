#pragma once

#include <QAction>
#include <QMainWindow>
#include <QToolBar>

#include "ui/icons.h"

namespace lacuna::ui {

/// Parts of the tool bar, from left to right, with a line between them.
enum class ToolGroup { document, history, layout, tools, help };

/// Offers a command of a menu to the tool bar. @param words  what stands under its icon: one or two short words
void offer_tool(QAction* action, ToolGroup group, Icon icon, const QString& words);

/// The tool bar of a window whose menus are complete: every command offered, text under icons.
QToolBar* make_tool_bar(QMainWindow* window);

}  // namespace lacuna::ui
