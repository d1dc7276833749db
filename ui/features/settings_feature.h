#pragma once

#include <QPointer>

#include "ui/dialogs/settings_dialog.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Opens the settings and tells the window what of them changed.
class SettingsFeature final : public QObject {
    Q_OBJECT
public:
    explicit SettingsFeature(Workbench& bench);
    SettingsDialog* dialog() const { return dialog_; }

public Q_SLOTS:
    void show();

Q_SIGNALS:
    void engineChosen();
    void preferencesChanged();
    void languageChosen();

private:
    Workbench& bench_;
    QPointer<SettingsDialog> dialog_;
};

}  // namespace lacuna::ui
