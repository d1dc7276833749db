// The window's inspection: what the panel asks for, and what becomes of it.
#include <QDockWidget>
#include <QFileDialog>

#include "core/base/atomic_file.h"
#include "core/inspect/report.h"
#include "core/io/dicom_source.h"
#include "ui/main_window.h"

namespace lacuna::ui {

void MainWindow::connectInspection() {
    connect(inspection_panel_, &InspectionPanel::inspectRequested, this, [this](const DetectionOptions& options) {
        if (documents_->hasDocument()) inspections_->analyse(documents_->document().volume, options);
    });
    connect(inspection_panel_, &InspectionPanel::defectChosen, this, &MainWindow::chooseDefect);
    connect(inspection_panel_, &InspectionPanel::colorsChanged, this, &MainWindow::colorDefects);
    connect(inspection_panel_, &InspectionPanel::loadCriteriaRequested, this, &MainWindow::loadCriteria);
    connect(inspection_panel_, &InspectionPanel::saveCriteriaRequested, this, &MainWindow::saveCriteria);
    connect(inspection_panel_, &InspectionPanel::reportRequested, this, &MainWindow::exportReport);
    connect(inspection_panel_, &InspectionPanel::failed, messages_, &MessageBar::showError);
    connect(inspections_, &InspectionController::started, this, [this] {
        inspection_panel_->setRunning(true);
        inspection_share_ = 0;
        updateProgress();
    });
    connect(inspections_, &InspectionController::progressed, this, [this](double share) {
        inspection_share_ = share;
        updateProgress();
    });
    connect(inspections_, &InspectionController::finished, this, [this] {
        inspection_panel_->setRunning(false);
        inspection_share_ = -1;
        updateProgress();
    });
    connect(inspections_, &InspectionController::failed, messages_, &MessageBar::showError);
    connect(inspections_, &InspectionController::analysed, documents_, &DocumentController::setInspection);
    connect(inspections_, &InspectionController::gathered, documents_, &DocumentController::showDefects);
    connect(documents_, &DocumentController::inspectionChanged, this,
            [this] { inspection_panel_->setAnalysis(documents_->document().inspection); });
}

void MainWindow::colorDefects() {
    if (!documents_->hasDocument()) return;
    std::vector<glm::dvec3> colors;
    for (const QColor& color : inspection_panel_->model()->colors())
        colors.emplace_back(color.redF(), color.greenF(), color.blueF());
    inspections_->gather(documents_->document().inspection, colors);
}

void MainWindow::chooseDefect(std::uint32_t id) {
    if (!documents_->hasDocument()) return;
    documents_->selectDefect(id);
    const Document& document = documents_->document();
    if (!document.inspection || id == 0 || id > document.inspection->defects.size()) return;
    const glm::dvec3 at = document.inspection->defects[id - 1].centroid_mm;
    documents_->setCursor(at);
    Camera camera = document.camera;
    camera.center_mm = at;
    documents_->setCamera(camera);
}

void MainWindow::loadCriteria() {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Load criteria"), {}, tr("Criteria (*.json);;All files (*)"));
    if (file.isEmpty()) return;
    try {
        inspection_panel_->setCriteria(read_criteria(file.toStdString()));
    } catch (const Error& error) {
        messages_->showError(QString::fromStdString(error.what()));
    }
}

void MainWindow::saveCriteria() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save the criteria"), QStringLiteral("criteria.json"),
                                                      tr("Criteria (*.json)"));
    if (file.isEmpty()) return;
    try {
        write_file(file.toStdString(), criteria_to_json(inspection_panel_->form()->criteria()) + "\n");
    } catch (const Error& error) {
        messages_->showError(QString::fromStdString(error.what()));
    }
}

void MainWindow::exportReport() {
    const QString folder = QFileDialog::getSaveFileName(this, tr("Write the report to a new folder"),
                                                        QStringLiteral("report"), tr("Folders (*)"));
    if (!folder.isEmpty()) writeReport(folder);
}

void MainWindow::writeReport(const QString& folder) {
    if (!documents_->hasDocument() || !engine_) return;
    InspectOptions options;
    options.input = documents_->document().input;
    options.software = "Lacuna " LACUNA_VERSION;
    options.by_hand = inspection_panel_->judgement().by_hand;
    const Volume volume = documents_->document().volume;
    const Criteria criteria = inspection_panel_->form()->criteria();
    report_share_ = 0;
    updateProgress();
    report_job_.start(
        [volume, criteria, options, folder, engine = engine_](const JobContext& job) mutable {
            if (volume.dicom) options.source = find_dicom_source(options.input, {}, job);
            const std::filesystem::path path = folder.toStdString();
            check_report_folder(path);
            const std::vector<ZoneMask> zones = lay_zones(criteria, volume.geometry(), job);
            write_report(inspect_part(volume, criteria, zones, *engine, options, job), volume, path, job);
            return folder;
        },
        [this](Outcome<QString> outcome) {
            report_share_ = -1;
            updateProgress();
            if (const Error* error = std::get_if<Error>(&outcome))
                messages_->showError(QString::fromStdString(error->what()));
            else
                messages_->showNotice(tr("The report stands in %1.").arg(std::get<0>(outcome)));
        },
        [this](double share) {
            report_share_ = share;
            updateProgress();
        });
}

}  // namespace lacuna::ui
