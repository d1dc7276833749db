#include "ui/features/import_feature.h"

#include <QCoreApplication>

#include "core/io/dicom_anonymise.h"
#include "core/io/dicom_source.h"
#include "ui/core_sentences.h"
#include "ui/file_choice.h"

namespace lacuna::ui {

ImportFeature::ImportFeature(Workbench& bench) : QObject(&bench), bench_(bench), exports_(this, bench.tasks()) {
    QMenu* file = bench.menu(Workbench::Menu::file);
    bench.addAlways(file, tr("&DICOM browser…"), QKeySequence(QStringLiteral("Ctrl+D")), this, &ImportFeature::browse);
    bench.addAlways(file, tr("&Import a raw volume…"), QKeySequence(QStringLiteral("Ctrl+Shift+I")), this,
                    &ImportFeature::chooseRaw);
    QAction* anonymised =
        bench.addAlways(bench.submenu(Workbench::Menu::file, tr("&Export")), tr("&Anonymised DICOM…"),
                        QKeySequence(QStringLiteral("Ctrl+Alt+A")), this, &ImportFeature::chooseAnonymised);
    anonymised->setToolTip(tr("The images of the open series without the patient's data, as PS3.15 describes it"));
    anonymised->setEnabled(false);
    connect(bench.documents(), &DocumentController::opened, this,
            [this, anonymised] { anonymised->setEnabled(bench_.documents()->document().volume.dicom.has_value()); });
    connect(bench.loader(), &LoadController::layoutNeeded, this, &ImportFeature::importRaw);
}

void ImportFeature::chooseRaw() {
    const QString file = file_choice::open_file(bench_.window(), tr("Import a raw volume"), FileKind::volume,
                                                tr("Raw volumes (*.raw *.img *.vol *.bin *.dat);;All files (*)"));
    if (!file.isEmpty()) importRaw(file);
}

RawImportDialog* ImportFeature::importRaw(const QString& file) {
    auto* dialog = new RawImportDialog(file, bench_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RawImportDialog::chosen, this, [this, file](const QString& raw) {
        OpenOptions options;
        options.raw = raw.toStdString();
        bench_.loader()->open(file, options);
    });
    dialog->open();
    return dialog;
}

DicomBrowser* ImportFeature::browse() {
    if (!browser_) {
        browser_ = new DicomBrowser(bench_.tasks(), bench_.window());
        connect(browser_, &DicomBrowser::openRequested, this, [this](const QString& folder, const QString& uid) {
            OpenOptions options;
            options.series = uid.toStdString();
            bench_.loader()->open(folder, options);
        });
    }
    browser_->show();
    browser_->raise();
    browser_->activateWindow();
    return browser_;
}

void ImportFeature::chooseAnonymised() {
    const QString folder = file_choice::save_file(bench_.window(), tr("New folder for the anonymised images"),
                                                  FileKind::copy, QStringLiteral("anonymised"));
    if (!folder.isEmpty()) anonymise(folder);
}

void ImportFeature::anonymise(const QString& folder) {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    AnonymiseOptions options;
    options.software = "Lacuna " LACUNA_VERSION;
    exports_.start(
        tr("Anonymising"),
        [input = document.input, open = document.options, target = folder.toStdString(),
         options](const JobContext& job) {
            const auto source = find_dicom_source(input, open, job.part(0, 0.3));
            std::vector<std::filesystem::path> files;
            if (source)
                for (const DicomSourceImage& image : source->images)
                    if (files.empty() || files.back() != image.file) files.push_back(image.file);
            const AnonymiseReport report = anonymise_dicom(files, target, options, job.part(0.3, 1));
            QString words = tr("%n anonymised images were written.", nullptr, report.images);
            for (const std::string& note : report.notes()) words += QLatin1Char(' ') + core_sentence(note);
            return words;
        },
        [this](Outcome<QString> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome))
                bench_.report(*error);
            else
                bench_.messages()->showNotice(std::get<0>(outcome));
            Q_EMIT anonymised();
        });
}

}  // namespace lacuna::ui
