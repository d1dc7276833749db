#include "ui/workbench.h"

#include <QEvent>
#include <QMenuBar>

#include "ui/widgets/panel_scroll.h"

namespace lacuna::ui {

Workbench::Workbench(QMainWindow* window, FourUp* views, MessageBar* messages)
    : QObject(window),
      window_(window),
      documents_(new DocumentController(this)),
      loader_(new LoadController(this)),
      scheduler_(new FrameScheduler(this)),
      views_(views),
      messages_(messages),
      tasks_(new TaskList(this)) {
    const QString titles[] = {tr("&File"),    tr("&Edit"),  tr("&View"), tr("&Go"),
                              tr("&Measure"), tr("&Tools"), tr("&Help")};
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        menus_[i] = window->menuBar()->addMenu(titles[i]);
        menus_[i]->menuAction()->setVisible(false);
        // An empty menu would be a dead end: it shows once something was added.
        menus_[i]->installEventFilter(this);
    }
}

bool Workbench::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ActionAdded)
        if (auto* menu = qobject_cast<QMenu*>(watched)) menu->menuAction()->setVisible(true);
    return QObject::eventFilter(watched, event);
}

void Workbench::setEngine(std::shared_ptr<Engine> engine) {
    engine_ = engine;
    scheduler_->setEngine(std::move(engine));
    Q_EMIT engineReady();
}

QMenu* Workbench::submenu(Menu which, const QString& title) {
    for (QAction* action : menu(which)->actions())
        if (action->menu() && action->text() == title) return action->menu();
    return menu(which)->addMenu(title);
}

void Workbench::needDocument(QAction* action) {
    action->setEnabled(documents_->hasDocument());
    connect(documents_, &DocumentController::opened, action, [action] { action->setEnabled(true); });
}

void Workbench::needDocument(QWidget* panel) {
    panel->setEnabled(documents_->hasDocument());
    connect(documents_, &DocumentController::opened, panel, [panel] { panel->setEnabled(true); });
}

QDockWidget* Workbench::addDock(const QString& id, const QString& title, QWidget* panel, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, window_);
    dock->setObjectName(id);
    // Beside the views a panel keeps its width, below them it may be scrolled both ways.
    const bool beside = area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
    dock->setWidget(new PanelScroll(panel, beside ? QSize(QWIDGETSIZE_MAX, 160) : QSize(340, 120), dock));
    window_->addDockWidget(area, dock);
    submenu(Menu::view, tr("&Panels"))->addAction(dock->toggleViewAction());
    return dock;
}

void Workbench::report(const Error& error) {
    if (error.code() != Errc::cancelled) messages_->showError(QString::fromStdString(error.what()));
}

}  // namespace lacuna::ui
