#include "ui/features/settings_feature.h"

#include "ui/tool_bar.h"

namespace lacuna::ui {

SettingsFeature::SettingsFeature(Workbench& bench) : QObject(&bench), bench_(bench) {
    QMenu* edit = bench.menu(Workbench::Menu::edit);
    edit->addSeparator();
    offer_tool(
        bench.addAlways(edit, tr("&Settings…"), QKeySequence(QStringLiteral("Ctrl+,")), this, &SettingsFeature::show),
        ToolGroup::help, Icon::settings, tr("Settings"));
}

void SettingsFeature::show() {
    if (!dialog_) {
        dialog_ = new SettingsDialog(bench_.window());
        dialog_->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog_, &SettingsDialog::engineChosen, this, &SettingsFeature::engineChosen);
        connect(dialog_, &SettingsDialog::preferencesChanged, this, &SettingsFeature::preferencesChanged);
        connect(dialog_, &SettingsDialog::languageChosen, this, &SettingsFeature::languageChosen);
    }
    dialog_->open();
}

}  // namespace lacuna::ui
