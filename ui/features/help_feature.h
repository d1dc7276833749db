#pragma once

#include <QPointer>

#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/log_window.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Finding one's way: command palette, sheet of keys, log, about box. None of them stops the window.
class HelpFeature final : public QObject {
    Q_OBJECT
public:
    explicit HelpFeature(Workbench& bench);

public Q_SLOTS:
    void showPalette();
    void showSheet();
    void showLog();
    void showAbout();

private:
    Workbench& bench_;
    QPointer<CommandPalette> palette_;
    QPointer<ShortcutSheet> sheet_;
    QPointer<LogWindow> log_;
};

}  // namespace lacuna::ui
