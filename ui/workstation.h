#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/main_window.h"

namespace lacuna::ui {

/// The running program: one window, and what outlives it. A change of language makes the window anew around the same
/// document, undo history and engine; see docs/design.md.
class Workstation final : public QObject {
    Q_OBJECT
public:
    explicit Workstation(EngineFactory make_engine, QObject* parent = nullptr);
    MainWindow* window() const { return window_.get(); }

Q_SIGNALS:
    void windowMade();

private:
    void makeWindow(EngineFactory make_engine);
    void changeLanguage();

    std::unique_ptr<MainWindow> window_;
    QTimer later_;  ///< the language waits for a dialog
};

}  // namespace lacuna::ui
