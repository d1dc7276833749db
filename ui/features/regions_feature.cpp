#include "ui/features/regions_feature.h"

#include "core/base/atomic_file.h"
#include "ui/file_choice.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

RegionsFeature::RegionsFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      panel_(new RegionsPanel(bench.window())),
      dock_(bench.addDock(QStringLiteral("regions"), tr("Regions"), panel_, Qt::BottomDockWidgetArea)),
      find_(this, bench.tasks()),
      gather_(this),
      writes_(bench) {
    bench.needDocument(panel_);
    offer_tool(bench.add(bench.menu(Workbench::Menu::tools), tr("Compute re&gions"),
                         QKeySequence(QStringLiteral("Ctrl+R")), this, &RegionsFeature::compute),
               ToolGroup::tools, Icon::regions, tr("Regions"));
    bench.add(bench.submenu(Workbench::Menu::file, tr("&Export")), tr("&Region table…"),
              QKeySequence(QStringLiteral("Ctrl+E")), this, &RegionsFeature::exportTable);
    DocumentController* documents = bench.documents();
    connect(panel_, &RegionsPanel::computeRequested, this, &RegionsFeature::compute);
    connect(panel_, &RegionsPanel::exportRequested, this, &RegionsFeature::exportTable);
    connect(panel_, &RegionsPanel::regionChosen, this, &RegionsFeature::choose);
    connect(documents, &DocumentController::opened, this, [this, documents] {
        cancel();
        panel_->setVolume(documents->document().volume, documents->document().statistics);
        panel_->setSettings(documents->document().settings);
    });
    connect(documents, &DocumentController::settingsChanged, this,
            [this, documents] { panel_->setSettings(documents->document().settings); });
    connect(documents, &DocumentController::regionsChanged, this,
            [this, documents] { panel_->setTable(documents->document().regions); });
    connect(&bench, &Workbench::stateWanted, this, [this](QVariantMap& state) {
        state[QStringLiteral("regions/options")] = QVariant::fromValue(panel_->options());
    });
    connect(&bench, &Workbench::stateBack, this, [this](const QVariantMap& state) {
        const QVariant kept = state[QStringLiteral("regions/options")];
        if (kept.canConvert<RegionOptions>()) panel_->setOptions(kept.value<RegionOptions>());
    });
}

void RegionsFeature::computeThen(std::function<void()> found) {
    if (!bench_.documents()->hasDocument()) return;
    panel_->setRunning(true);
    find_.start(
        tr("Finding regions"),
        [volume = bench_.documents()->document().volume, options = panel_->options()](const JobContext& job) {
            return std::make_shared<const RegionTable>(find_regions(volume, options, job));
        },
        [this, found = std::move(found)](Outcome<std::shared_ptr<const RegionTable>> outcome) {
            panel_->setRunning(false);
            if (const Error* error = std::get_if<Error>(&outcome)) {
                bench_.report(*error);
            } else {
                bench_.documents()->setRegions(std::get<0>(outcome));
                if (found) found();
            }
            Q_EMIT finished();
        });
}

void RegionsFeature::cancel() {
    gather_.cancel();
    find_.cancel();
}

void RegionsFeature::select(std::uint32_t id) {
    const QAbstractItemModel* rows = panel_->table()->model();
    for (int row = 0; row < rows->rowCount(); ++row)
        if (rows->index(row, 0).data(RegionModel::k_id_role).toUInt() == id) return panel_->table()->selectRow(row);
}

void RegionsFeature::choose(std::uint32_t id) {
    DocumentController* documents = bench_.documents();
    if (!documents->hasDocument()) return;
    const std::shared_ptr<const RegionTable> table = documents->document().regions;
    documents->selectRegion(id, nullptr);
    gather_.cancel();
    if (!table || id == 0) return;
    gather_.start(
        [table, id](const JobContext&) -> std::shared_ptr<const Highlight> {
            for (const RegionCharacteristics& row : table->rows)
                if (row.id == id) return std::make_shared<const Highlight>(highlight_of(*table, row));
            return nullptr;
        },
        [this, id](Outcome<std::shared_ptr<const Highlight>> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            bench_.documents()->selectRegion(id, std::get<0>(outcome));
            Q_EMIT gathered(id);
        });
    for (const RegionCharacteristics& row : table->rows)
        if (row.id == id) documents->setCursor(row.centroid_mm);
}

void RegionsFeature::exportTable() {
    const DocumentController* documents = bench_.documents();
    if (!documents->hasDocument() || !documents->document().regions) {
        bench_.messages()->showNotice(tr("There is no region table yet; compute the regions first."));
        return;
    }
    // Jobs end while the dialog asks: the table is the one it asked about.
    const Volume volume = documents->document().volume;
    const std::shared_ptr<const RegionTable> table = documents->document().regions;
    const QString file = file_choice::save_file(bench_.window(), tr("Export the region table"), FileKind::table,
                                                QStringLiteral("regions.csv"), tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    writes_.start(tr("Writing the region table"), file, [volume, table, file](const JobContext& job) {
        // The panel shows what the voxels tell; the file also holds what surfaces and distances do.
        RegionTable measured = *table;
        measure_surfaces(volume, measured, job);
        write_file(file.toStdString(), regions_to_csv(measured));
    });
}

}  // namespace lacuna::ui
