#include "ui/tool_bar.h"

#include <QMenuBar>
#include <QVariant>
#include <algorithm>

#include "ui/action_catalog.h"

namespace lacuna::ui {

namespace {
constexpr char k_group_property[] = "lacuna_tool_group";
}

void offer_tool(QAction* action, ToolGroup group, Icon icon, const QString& words) {
    action->setIcon(make_icon(icon));
    action->setIconText(words);
    action->setIconVisibleInMenu(false);
    action->setProperty(k_group_property, int(group));
}

QToolBar* make_tool_bar(QMainWindow* window) {
    QList<QAction*> offered;
    for (const CatalogEntry& entry : catalog_of(window->menuBar()))
        if (entry.action->property(k_group_property).isValid()) offered << entry.action;
    const auto group = [](const QAction* action) { return action->property(k_group_property).toInt(); };
    std::stable_sort(offered.begin(), offered.end(),
                     [&](const QAction* a, const QAction* b) { return group(a) < group(b); });
    auto* bar = new QToolBar(QToolBar::tr("Tool bar"), window);
    bar->setObjectName(QStringLiteral("tools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    bar->setIconSize(QSize(24, 24));
    bar->setMovable(false);
    for (qsizetype i = 0; i < offered.size(); ++i) {
        if (i > 0 && group(offered[i]) != group(offered[i - 1])) bar->addSeparator();
        bar->addAction(offered[i]);
        QWidget* button = bar->widgetForAction(offered[i]);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(plain_text(offered[i]->text()));
    }
    window->addToolBar(Qt::TopToolBarArea, bar);
    return bar;
}

}  // namespace lacuna::ui
