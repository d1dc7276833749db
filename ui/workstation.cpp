#include "ui/workstation.h"

#include <QApplication>
#include <QThread>

#include "ui/language.h"
#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

constexpr int k_look_again_ms = 200;

/// What is being answered belongs to the window, and what asked goes on in it afterwards: most dialogs about files run
/// a loop of their own on the stack of a window's function.
bool in_a_dialog() { return QApplication::activeModalWidget() || QThread::currentThread()->loopLevel() > 1; }

}  // namespace

Workstation::Workstation(EngineFactory make_engine, QObject* parent) : QObject(parent) {
    later_.setSingleShot(true);
    later_.setInterval(k_look_again_ms);
    connect(&later_, &QTimer::timeout, this, &Workstation::changeLanguage);
    Language::instance();
    makeWindow(std::move(make_engine));
}

void Workstation::makeWindow(EngineFactory make_engine) {
    window_ = std::make_unique<MainWindow>(std::move(make_engine));
    // Queued: the dialog that asked belongs to the window that goes.
    connect(window_->settingsFeature(), &SettingsFeature::languageChosen, this, &Workstation::changeLanguage,
            Qt::QueuedConnection);
    window_->show();
    Q_EMIT windowMade();
}

void Workstation::changeLanguage() {
    TaskList* tasks = window_->bench()->tasks();
    if (!tasks->rows().empty()) {
        // Nobody loses work over words.
        window_->messageBar()->showNotice(tr("The language changes as soon as the running jobs have ended."));
        connect(tasks, &TaskList::changed, this, &Workstation::changeLanguage,
                Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        return;
    }
    if (in_a_dialog()) return later_.start();
    const bool quits = QGuiApplication::quitOnLastWindowClosed();
    QGuiApplication::setQuitOnLastWindowClosed(false);
    std::shared_ptr<Engine> engine = window_->bench()->engine();
    DocumentController* documents = window_->documents();
    std::optional<Document> document;
    if (documents->hasDocument()) document = documents->document();
    const EditHistory history = documents->history();
    QVariantMap state;
    Q_EMIT window_->bench()->stateWanted(state);
    const bool closed = window_->close();  // which keeps layout and session
    if (!closed) {
        QGuiApplication::setQuitOnLastWindowClosed(quits);
        return;
    }
    window_.reset();
    Language::instance()->apply();
    EngineFactory make_engine = [engine](const JobContext&) { return engine; };
    if (!engine) make_engine = engine_on(preferences::device().toStdString(), preferences::memory_limit_mib());
    makeWindow(std::move(make_engine));
    if (document) window_->documents()->adopt(*document, history);
    Q_EMIT window_->bench()->stateBack(state);
    QGuiApplication::setQuitOnLastWindowClosed(quits);
}

}  // namespace lacuna::ui
