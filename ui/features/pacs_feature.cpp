#include "ui/features/pacs_feature.h"

namespace lacuna::ui {

PacsFeature::PacsFeature(Workbench& bench) : QObject(&bench), bench_(bench) {
    bench.addAlways(bench.menu(Workbench::Menu::file), tr("DICOM ser&vers (PACS)…"),
                    QKeySequence(QStringLiteral("Ctrl+Shift+D")), this, &PacsFeature::showDialog);
    bench.menu(Workbench::Menu::file)->addSeparator();
}

void PacsFeature::showDialog() {
    if (!dialog_) {
        dialog_ = new PacsDialog(bench_.tasks(), bench_.window());
        connect(dialog_, &PacsDialog::retrieved, this,
                [this](const QString& folder) { bench_.loader()->open(folder); });
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

}  // namespace lacuna::ui
