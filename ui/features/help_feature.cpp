#include "ui/features/help_feature.h"

#include <QMenuBar>

#include "core/compute/device.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

HelpFeature::HelpFeature(Workbench& bench) : QObject(&bench), bench_(bench) {
    QMenu* help = bench.menu(Workbench::Menu::help);
    offer_tool(bench.addAlways(help, tr("&Find a command…"), QKeySequence(QStringLiteral("Ctrl+K")), this,
                               &HelpFeature::showPalette),
               ToolGroup::help, Icon::search, tr("Commands"));
    offer_tool(bench.addAlways(help, tr("&Keys and mouse…"), QKeySequence(Qt::Key_F1), this, &HelpFeature::showSheet),
               ToolGroup::help, Icon::help, tr("Keys"));
    help->addSeparator();
    bench.addAlways(help, tr("&Log…"), QKeySequence(QStringLiteral("Ctrl+Shift+L")), this, &HelpFeature::showLog);
    bench.addAlways(help, tr("&About Lacuna…"), QKeySequence(QStringLiteral("Shift+F1")), this,
                    &HelpFeature::showAbout);
}

void HelpFeature::showPalette() {
    if (palette_) palette_->close();
    QMainWindow* window = bench_.window();
    palette_ = new CommandPalette(catalog_of(window->menuBar()), window);
    palette_->setAttribute(Qt::WA_DeleteOnClose);
    const QPoint top = window->mapToGlobal(QPoint((window->width() - palette_->width()) / 2, window->height() / 8));
    palette_->move(top);
    palette_->open();
}

void HelpFeature::showSheet() {
    if (!sheet_) {
        sheet_ = new ShortcutSheet(catalog_of(bench_.window()->menuBar()), bench_.window());
        sheet_->setAttribute(Qt::WA_DeleteOnClose);
    }
    sheet_->show();
    sheet_->raise();
    sheet_->activateWindow();
}

void HelpFeature::showLog() {
    if (!log_) {
        log_ = new LogWindow(bench_.window());
        log_->setAttribute(Qt::WA_DeleteOnClose);
    }
    log_->show();
    log_->raise();
    log_->activateWindow();
}

void HelpFeature::showAbout() {
    QString device = tr("being looked for"), driver;
    if (bench_.engine()) {
        const std::string name = bench_.engine()->device_name();
        device = QString::fromStdString(name);
        for (const DeviceInfo& info : list_devices(false))
            if (info.name == name)
                driver = QString::fromStdString(info.platform + ", " + info.driver + ", " + info.opencl_version);
    }
    auto* about = new AboutDialog(version_rows(device, driver), bench_.window());
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->open();
}

}  // namespace lacuna::ui
