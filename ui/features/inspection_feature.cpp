#include "ui/features/inspection_feature.h"

#include <QDesktopServices>
#include <QDir>
#include <QUrl>

#include "core/base/atomic_file.h"
#include "core/inspect/report.h"
#include "core/io/dicom_source.h"
#include "ui/file_choice.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

InspectionFeature::InspectionFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      panel_(new InspectionPanel(bench.window())),
      dock_(bench.addDock(QStringLiteral("inspection"), tr("Inspection"), panel_, Qt::BottomDockWidgetArea)),
      analyse_(this, bench.tasks()),
      gather_(this),
      writes_(bench),
      read_(this) {
    connect(&writes_, &FileWrites::written, this, &InspectionFeature::written);
    bench.needDocument(panel_);
    QMenu* tools = bench.menu(Workbench::Menu::tools);
    offer_tool(bench.add(tools, tr("&Inspect the part"), QKeySequence(QStringLiteral("Ctrl+I")), this,
                         [this] {
                             dock_->show();
                             dock_->raise();
                             inspect(panel_->form()->criteria().detection);
                         }),
               ToolGroup::tools, Icon::inspect, tr("Inspect"));
    bench.add(bench.submenu(Workbench::Menu::file, tr("&Export")), tr("&Inspection report…"),
              QKeySequence(QStringLiteral("Ctrl+Shift+E")), this, &InspectionFeature::exportReport);
    DocumentController* documents = bench.documents();
    connect(panel_, &InspectionPanel::inspectRequested, this, &InspectionFeature::inspect);
    connect(panel_, &InspectionPanel::defectChosen, this, &InspectionFeature::choose);
    connect(panel_, &InspectionPanel::colorsChanged, this, &InspectionFeature::colorDefects);
    connect(panel_, &InspectionPanel::loadCriteriaRequested, this, &InspectionFeature::loadCriteria);
    connect(panel_, &InspectionPanel::saveCriteriaRequested, this, &InspectionFeature::saveCriteria);
    connect(panel_, &InspectionPanel::reportRequested, this, &InspectionFeature::exportReport);
    connect(panel_, &InspectionPanel::failed, bench.messages(), &MessageBar::showError);
    connect(documents, &DocumentController::opened, this, [this, documents] {
        cancel();
        read_.cancel();  // they were for the part before
        panel_->setVolume(documents->document().volume, *documents->document().statistics);
    });
    connect(documents, &DocumentController::inspectionChanged, this,
            [this, documents] { panel_->setAnalysis(documents->document().inspection); });
    connect(&bench, &Workbench::stateWanted, this, [this](QVariantMap& state) {
        QVariantList words;
        for (const HandDecision& word : panel_->judgement().by_hand)
            words << QVariant(QVariantList{word.defect, word.accepted, QString::fromStdString(word.reason)});
        state[QStringLiteral("inspection/by_hand")] = words;
        state[QStringLiteral("inspection/criteria")] =
            QString::fromStdString(criteria_to_json(panel_->form()->criteria()));
        state[QStringLiteral("inspection/current")] = panel_->isCurrent();
    });
    connect(&bench, &Workbench::stateBack, this, [this](const QVariantMap& state) {
        try {
            panel_->adoptCriteria(
                parse_criteria(state[QStringLiteral("inspection/criteria")].toString().toStdString(), "criteria"),
                state[QStringLiteral("inspection/current")].toBool());
        } catch (const Error& error) {
            bench_.report(error);
        }
        for (const QVariant& word : state[QStringLiteral("inspection/by_hand")].toList())
            panel_->decide(word.toList().value(0).toUInt(), word.toList().value(1).toBool(),
                           word.toList().value(2).toString());
    });
}

void InspectionFeature::inspectAgain(const DetectionOptions& options, std::vector<HandDecision> by_hand) {
    if (!bench_.documents()->hasDocument()) return;
    gather_.cancel();
    panel_->setRunning(true);
    analyse_.start(
        tr("Inspecting"),
        [volume = bench_.documents()->document().volume, options](const JobContext& job) {
            return std::make_shared<const PartAnalysis>(analyse_part(volume, options, job));
        },
        [this, by_hand = std::move(by_hand)](Outcome<Analysis> outcome) {
            panel_->setRunning(false);
            if (const Error* error = std::get_if<Error>(&outcome)) {
                bench_.report(*error);
            } else {
                const Analysis& found = std::get<0>(outcome);
                bench_.documents()->setInspection(found);
                for (const HandDecision& decision : by_hand)
                    if (decision.defect >= 1 && decision.defect <= found->defects.size())
                        panel_->decide(decision.defect, decision.accepted, QString::fromStdString(decision.reason));
            }
            Q_EMIT finished();
        });
}

void InspectionFeature::cancel() {
    gather_.cancel();
    analyse_.cancel();
}

void InspectionFeature::colorDefects() {
    gather_.cancel();
    if (!bench_.documents()->hasDocument() || !bench_.documents()->document().inspection) return;
    std::vector<glm::dvec3> colors;
    for (const QColor& color : panel_->model()->colors())
        colors.emplace_back(color.redF(), color.greenF(), color.blueF());
    gather_.start(
        [analysis = bench_.documents()->document().inspection, colors](const JobContext& job) -> Highlights {
            return std::make_shared<const std::vector<Highlight>>(defect_highlights(*analysis, colors, job));
        },
        [this](Outcome<Highlights> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            bench_.documents()->showDefects(std::get<0>(outcome));
            Q_EMIT gathered();
        });
}

void InspectionFeature::choose(std::uint32_t id) {
    DocumentController* documents = bench_.documents();
    if (!documents->hasDocument()) return;
    documents->selectDefect(id);
    const Document& document = documents->document();
    if (!document.inspection || id == 0 || id > document.inspection->defects.size()) return;
    const glm::dvec3 at = document.inspection->defects[id - 1].centroid_mm;
    documents->setCursor(at);
    Camera camera = document.camera;
    camera.center_mm = at;
    documents->setCamera(camera);
}

void InspectionFeature::loadCriteria() {
    const QString file = file_choice::open_file(bench_.window(), tr("Load criteria"), FileKind::criteria,
                                                tr("Criteria (*.json);;All files (*)"));
    if (!file.isEmpty()) readCriteria(file);
}

void InspectionFeature::readCriteria(const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    read_.start([path = file.toStdString()](const JobContext&) { return read_criteria(path); },
                [this](Outcome<Criteria> outcome) {
                    if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
                    panel_->setCriteria(std::get<0>(outcome));
                    Q_EMIT criteriaRead();
                });
}

void InspectionFeature::saveCriteria() {
    const QString file = file_choice::save_file(bench_.window(), tr("Save the criteria"), FileKind::criteria,
                                                QStringLiteral("criteria.json"), tr("Criteria (*.json)"));
    if (!file.isEmpty()) writeCriteria(file);
}

void InspectionFeature::writeCriteria(const QString& file) {
    writes_.start(tr("Saving the criteria"), file, [criteria = panel_->form()->criteria(), file](const JobContext&) {
        write_file(file.toStdString(), criteria_to_json(criteria) + "\n");
    });
}

void InspectionFeature::exportReport() {
    const QString folder = file_choice::save_file(bench_.window(), tr("Write the report to a new folder"),
                                                  FileKind::report, QStringLiteral("report"), tr("Folders (*)"));
    if (!folder.isEmpty()) writeReport(folder);
}

void InspectionFeature::writeReport(const QString& folder) {
    if (!bench_.documents()->hasDocument() || !bench_.engine()) return;
    // What was decided by hand belongs to the defects shown, by their numbers.
    if (!panel_->isCurrent())
        return bench_.messages()->showError(
            tr("The settings were changed since the part was inspected: inspect it again, then write the report."));
    InspectOptions options;
    options.input = bench_.documents()->document().input;
    options.software = "Lacuna " LACUNA_VERSION;
    options.by_hand = panel_->judgement().by_hand;
    const Volume volume = bench_.documents()->document().volume;
    const OpenOptions open = bench_.documents()->document().options;  // which series of several it is
    const Criteria criteria = panel_->form()->criteria();
    writes_.start(tr("Writing the report"), folder,
                  [volume, criteria, options, open, folder, engine = bench_.engine()](const JobContext& job) mutable {
                      if (volume.dicom) options.source = find_dicom_source(options.input, open, {job.stop});
                      const std::filesystem::path path = folder.toStdString();
                      check_report_folder(path);
                      const std::vector<ZoneMask> zones = lay_zones(criteria, volume.geometry(), {job.stop});
                      write_report(inspect_part(volume, criteria, zones, *engine, options, job.part(0, 0.9)), volume,
                                   path, job.part(0.9, 1));
                  },
                  tr("The report stands in %1."),
                  {{tr("Open the report"), [page = QDir(folder).filePath(QStringLiteral("report.html"))] {
                        QDesktopServices::openUrl(QUrl::fromLocalFile(page));
                    }}});
}

}  // namespace lacuna::ui
