#pragma once

#include <QDir>
#include <QFile>
#include <QTabWidget>
#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "core/compute/device.h"
#include "core/io/dicom_writer.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "ui/action_catalog.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/batch_dialog.h"
#include "ui/dialogs/close_dialog.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/log_window.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/dicom_browser.h"
#include "ui/log_store.h"
#include "ui/pacs_dialog.h"
#include "ui/pacs_server_dialog.h"
#include "ui/raw_import_dialog.h"
#include "ui/series_dialog.h"

namespace lacuna::ui::test {

/// A dialog of the window, filled as in use. `settle` waits for what it fills in the background.
struct DialogMaker {
    const char* name;
    std::function<std::unique_ptr<QDialog>()> make;
    std::function<void(QDialog&)> settle = [](QDialog&) {};
};

/// Every dialog class of the sources (a test compares), with data of their own in `folder`.
inline std::vector<DialogMaker> every_dialog(MainWindow& window, const QString& folder) {
    MainWindow* const parent = &window;
    const QString raw = folder + QStringLiteral("/part.raw"), series = folder + QStringLiteral("/series");
    if (!QFile::exists(raw)) {
        SampleOptions options;
        options.dims = {72, 60, 48};
        Volume volume = make_sample("casting", options).volume;
        QFile out(raw);
        if (out.open(QIODevice::WriteOnly))
            out.write(reinterpret_cast<const char*>(volume.data()), qint64(volume.bytes()));
        QDir().mkpath(series);
        for (const char* name : {"casting", "head"}) {
            volume = make_sample(name, options).volume;
            volume.name = name;
            write_dicom_series(volume, (series + QLatin1Char('/') + QLatin1String(name)).toStdString());
        }
    }
    const PacsServer server{"Archive, ward 3", "pacs.example.org", 11112, "ARCHIVE", "LACUNA", 30, {}, {}};
    const auto wait_for = [](auto* dialog, auto signal) {
        QSignalSpy spy(dialog, signal);
        if (spy.count() == 0) spy.wait(20000);
    };
    std::vector<DialogMaker> all;
    all.push_back({"settings", [parent] { return std::make_unique<SettingsDialog>(parent); },
                   [wait_for](QDialog& d) { wait_for(static_cast<SettingsDialog*>(&d), &SettingsDialog::measured); }});
    all.push_back({"log", [parent] {
                       log(LogLevel::info, "A note.");
                       log(LogLevel::warning, "A warning of what could not be read as it stands.");
                       return std::make_unique<LogWindow>(parent);
                   }});
    all.push_back(
        {"keys", [parent] { return std::make_unique<ShortcutSheet>(catalog_of(parent->menuBar()), parent); }});
    all.push_back({"about", [parent] {
                       return std::make_unique<AboutDialog>(
                           version_rows(QStringLiteral("cpu-haswell"), QStringLiteral("PoCL 3.1")), parent);
                   }});
    all.push_back(
        {"palette", [parent] { return std::make_unique<CommandPalette>(catalog_of(parent->menuBar()), parent); }});
    all.push_back({"close", [parent] {
                       auto tasks = std::make_unique<TaskList>();
                       tasks->begin(ExportFeature::tr("Saving the volume"), {}, AtStake::work);
                       tasks->begin(ExportFeature::tr("Drawing a turntable"), {}, AtStake::work);
                       auto dialog = std::make_unique<CloseDialog>(tasks.get(), parent);
                       tasks.release()->setParent(dialog.get());
                       return dialog;
                   }});
    all.push_back({"batch", [parent] {
                       const auto device = [](const JobContext&) { return std::shared_ptr<ComputeDevice>(); };
                       return std::make_unique<BatchDialog>(parent->bench()->tasks(), device, parent);
                   }});
    all.push_back({"pacs", [parent, server] {
                       auto dialog = std::make_unique<PacsDialog>(parent->bench()->tasks(), parent);
                       dialog->setServers({server});
                       return dialog;
                   }});
    all.push_back({"pacs-server", [parent, server] { return std::make_unique<PacsServerDialog>(server, parent); }});
    all.push_back(
        {"raw-import", [parent, raw] { return std::make_unique<RawImportDialog>(raw, parent); },
         [wait_for](QDialog& d) { wait_for(static_cast<RawImportDialog*>(&d), &RawImportDialog::previewed); }});
    all.push_back(
        {"series", [parent] {
             const std::vector<SeriesEntry> entries = {
                 {1, "Thorax 1.0 B70f", "1.2.3", "CT", {512, 512, 320}, 320, {}},
                 {2, "Thorax 5.0 B30f, reconstructed again for the lung", "1.2.4", "CT", {512, 512, 64}, 64, {}}};
             return std::make_unique<SeriesDialog>(entries, parent);
         }});
    all.push_back({"browser",
                   [parent, series] {
                       auto dialog = std::make_unique<DicomBrowser>(parent->bench()->tasks(), parent);
                       dialog->look(series);
                       return dialog;
                   },
                   [wait_for](QDialog& d) { wait_for(static_cast<DicomBrowser*>(&d), &DicomBrowser::pictured); }});
    return all;
}

/// Shows each dialog in turn, filled and settled, and calls look(dialog, its name, page, pages) for every page of its
/// tabs; a dialog without tabs has page 0 of 0.
template <class Look>
void for_each_dialog_page(MainWindow& window, const QString& folder, const Look& look) {
    for (const DialogMaker& maker : every_dialog(window, folder)) {
        const std::unique_ptr<QDialog> dialog = maker.make();
        dialog->show();
        maker.settle(*dialog);
        dialog->activateWindow();
        (void)QTest::qWaitForWindowActive(dialog.get());
        auto* tabs = dialog->findChild<QTabWidget*>();
        const int pages = tabs ? tabs->count() : 0;
        for (int page = 0; page < std::max(1, pages); ++page) {
            if (tabs) tabs->setCurrentIndex(page);
            QApplication::processEvents();
            look(*dialog, maker.name, page, pages);
        }
    }
}

}  // namespace lacuna::ui::test
