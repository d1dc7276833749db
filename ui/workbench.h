#pragma once

#include <QAction>
#include <QDockWidget>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>
#include <QVariantMap>
#include <array>
#include <functional>
#include <memory>

#include "core/render/engine.h"
#include "ui/document_controller.h"
#include "ui/four_up.h"
#include "ui/frame_scheduler.h"
#include "ui/load_controller.h"
#include "ui/task_list.h"
#include "ui/widgets/message_bar.h"

namespace lacuna::ui {

/// What the window offers its features (ui/features): the document and the views, places for menus and docks, and one
/// way to say things. A feature is a QObject that takes a Workbench, adds its own actions and panels, and connects
/// itself; the window knows no more of it than its name.
class Workbench final : public QObject {
    Q_OBJECT
public:
    /// In the order of the menu bar. A menu nobody adds to stays hidden.
    enum class Menu { file, edit, view, go, measure, tools, help };

    Workbench(QMainWindow* window, FourUp* views, MessageBar* messages);

    QMainWindow* window() const { return window_; }
    DocumentController* documents() const { return documents_; }
    LoadController* loader() const { return loader_; }
    FrameScheduler* scheduler() const { return scheduler_; }
    FourUp* views() const { return views_; }
    MessageBar* messages() const { return messages_; }
    TaskList* tasks() const { return tasks_; }
    /// Null until the device was found; see engineReady().
    const std::shared_ptr<Engine>& engine() const { return engine_; }
    void setEngine(std::shared_ptr<Engine> engine);

    QMenu* menu(Menu which) const { return menus_[std::size_t(which)]; }
    /// A submenu of that title; made when it does not exist yet.
    QMenu* submenu(Menu which, const QString& title);
    /// A command for the open document: disabled while there is none.
    template <class Context, class Slot>
    QAction* add(QMenu* menu, const QString& text, const QKeySequence& key, Context* context, Slot&& slot) {
        QAction* action = addAlways(menu, text, key, context, std::forward<Slot>(slot));
        needDocument(action);
        return action;
    }
    /// A command that needs no document.
    template <class Context, class Slot>
    QAction* addAlways(QMenu* menu, const QString& text, const QKeySequence& key, Context* context, Slot&& slot) {
        QAction* action = menu->addAction(text);
        action->setShortcut(key);
        QObject::connect(action, &QAction::triggered, context, std::forward<Slot>(slot));
        return action;
    }
    /// Disables an action or a panel until a document is open.
    void needDocument(QAction* action);
    void needDocument(QWidget* panel);

    /// A dock with its place in View > Panels. `id` names it in the remembered layout.
    QDockWidget* addDock(const QString& id, const QString& title, QWidget* panel, Qt::DockWidgetArea area);

    /// Changes the view settings as a named step of undo.
    template <class Apply>
    void edit(const QString& name, Apply&& apply) {
        if (!documents_->hasDocument()) return;
        ViewSettings next = documents_->document().settings;
        apply(next);
        documents_->edit(name, next);
    }
    /// Shows an error in the message bar; says nothing of what a person cancelled.
    void report(const Error& error);

Q_SIGNALS:
    void engineReady();
    /// The window is about to be made anew (in another language): a feature puts what it holds besides the document into
    /// `state`, under keys that begin with its name, ...
    void stateWanted(QVariantMap& state);
    /// ... and takes it back in the new window, after the document.
    void stateBack(const QVariantMap& state);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMainWindow* window_;
    DocumentController* documents_;
    LoadController* loader_;
    FrameScheduler* scheduler_;
    FourUp* views_;
    MessageBar* messages_;
    TaskList* tasks_;
    std::array<QMenu*, 7> menus_{};
    std::shared_ptr<Engine> engine_;
};

}  // namespace lacuna::ui
