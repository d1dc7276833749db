#include "ui/features/measure_feature.h"

#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>

#include "core/base/atomic_file.h"
#include "ui/file_choice.h"
#include "ui/number_text.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

namespace {
constexpr MeasurementKind k_kinds[] = {MeasurementKind::distance, MeasurementKind::angle, MeasurementKind::rectangle,
                                       MeasurementKind::ellipse};
}

MeasureFeature::MeasureFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      tool_(new SliceMeasure(this)),
      panel_(new MeasurePanel(bench.window())),
      dock_(bench.addDock(QStringLiteral("measurements"), tr("Measurements"), panel_, Qt::BottomDockWidgetArea)),
      writes_(bench) {
    bench.needDocument(panel_);
    buildMenu();
    for (SliceView* slice : bench.views()->slices()) {
        slice->addTool(tool_);
        connect(tool_, &SliceMeasure::repaintNeeded, slice, qOverload<>(&QWidget::update));
    }
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, [this, documents] {
        tool_->setVolume(documents->document().volume);
        showSettings();
    });
    connect(documents, &DocumentController::settingsChanged, this, &MeasureFeature::showSettings);
    connect(tool_, &SliceMeasure::edited, this, [this](const QString& name, const std::vector<Measurement>& next) {
        bench_.edit(name, [&](ViewSettings& settings) { settings.measurements = next; });
    });
    connect(tool_, &SliceMeasure::selectedChanged, this, [this](std::uint32_t id) {
        panel_->select(id);
        remove_->setEnabled(id != 0);
    });
    connect(tool_, &SliceMeasure::kindChanged, this, &MeasureFeature::showKind);
    connect(panel_, &MeasurePanel::chosen, this, &MeasureFeature::choose);
    connect(panel_, &MeasurePanel::removeRequested, tool_, &SliceMeasure::removeSelected);
    connect(panel_, &MeasurePanel::copyRequested, this, &MeasureFeature::copyTable);
    connect(panel_, &MeasurePanel::exportRequested, this, &MeasureFeature::exportTable);
}

void MeasureFeature::buildMenu() {
    QMenu* menu = bench_.menu(Workbench::Menu::measure);
    kinds_ = new QActionGroup(this);
    const auto add_kind = [&](const QString& text, const QString& key, std::optional<MeasurementKind> kind) {
        QAction* action = bench_.add(menu, text, QKeySequence(key), this, [this, kind] { tool_->setKind(kind); });
        action->setCheckable(true);
        kinds_->addAction(action);
    };
    add_kind(tr("&Cross-hair"), QStringLiteral("X"), std::nullopt);
    const QString texts[] = {tr("&Distance"), tr("A&ngle"), tr("&Rectangle"), tr("&Ellipse")};
    const QString keys[] = {QStringLiteral("D"), QStringLiteral("N"), QStringLiteral("Q"), QStringLiteral("E")};
    for (std::size_t i = 0; i < std::size(k_kinds); ++i) add_kind(texts[i], keys[i], k_kinds[i]);
    kinds_->actions().front()->setChecked(true);
    offer_tool(kinds_->actions()[1], ToolGroup::tools, Icon::measure, tr("Distance"));
    menu->addSeparator();
    remove_ = bench_.addAlways(menu, tr("Re&move the measurement"), QKeySequence(Qt::Key_Delete), tool_,
                               &SliceMeasure::removeSelected);
    // Delete belongs to whatever has the focus; to the views only while one of them has it.
    remove_->setShortcutContext(Qt::WidgetShortcut);
    for (SliceView* slice : bench_.views()->slices()) slice->addAction(remove_);
    panel_->table()->addAction(remove_);
    remove_->setEnabled(false);
    bench_.add(menu, tr("Remove &all measurements"), QKeySequence(QStringLiteral("Ctrl+Shift+Del")), this,
               &MeasureFeature::removeAll);
    menu->addSeparator();
    bench_.add(menu, tr("Cop&y the table"), QKeySequence(QStringLiteral("Ctrl+Alt+C")), this,
               &MeasureFeature::copyTable);
    bench_.add(menu, tr("E&xport the table…"), QKeySequence(QStringLiteral("Ctrl+Alt+E")), this,
               &MeasureFeature::exportTable);
}

void MeasureFeature::showKind() {
    const auto kind = tool_->kind();
    const qsizetype at = kind ? 1 + (std::find(std::begin(k_kinds), std::end(k_kinds), *kind) - k_kinds) : 0;
    kinds_->actions().at(at)->setChecked(true);
    if (!kind) return;
    // A measurement needs a slice to be drawn in and the keys to go there.
    for (SliceView* slice : bench_.views()->slices())
        if (slice->hasFocus()) return;
    for (SliceView* slice : bench_.views()->slices())
        if (slice->isVisible()) return slice->setFocus(Qt::OtherFocusReason);
}

void MeasureFeature::showSettings() {
    tool_->setMeasurements(bench_.documents()->document().settings.measurements);
    std::vector<MeasurePanel::Row> rows;
    for (const Measurement& m : tool_->measurements()) rows.push_back(rowOf(m));
    panel_->setRows(rows);
    panel_->select(tool_->selected());
}

MeasurePanel::Row MeasureFeature::rowOf(const Measurement& m) const {
    MeasurePanel::Row row;
    row.measurement = m;
    const GridGeometry& geometry = bench_.documents()->document().volume.geometry();
    for (const SliceKind kind : k_slice_kinds) {
        const SlicePlane plane = slice_plane(geometry, kind);
        if (!(std::abs(glm::dot(plane.normal(), m.normal())) > 1 - 1e-9)) continue;
        row.where = tr("%1 %2")
                        .arg(slice_title(kind, geometry.axis_names))
                        .arg(nearest_voxel(geometry, m.points_mm[0])[plane.w] + 1);
    }
    if (row.where.isEmpty()) row.where = tr("tilted");
    if (!m.is_region()) {
        row.size = tool_->words(m).join(QString());
        return row;
    }
    row.size = tr("%1 mm²").arg(number_text(area_mm2(m)));
    const RegionStatistics& s = tool_->statistics(m);
    row.pixels = QString::number(s.pixels);
    if (s.pixels == 0) return row;
    row.mean = number_text(s.mean);
    row.spread = number_text(s.stddev);
    row.least = number_text(s.min);
    row.most = number_text(s.max);
    return row;
}

void MeasureFeature::choose(std::uint32_t id) {
    tool_->select(id);
    for (const Measurement& m : tool_->measurements()) {
        if (m.id != id) continue;
        glm::dvec3 middle(0);
        for (const glm::dvec3& point : m.points_mm) middle += point / double(m.points_mm.size());
        bench_.documents()->setCursor(middle);
    }
}

void MeasureFeature::removeAll() {
    bench_.edit(tr("Remove all measurements"), [](ViewSettings& settings) { settings.measurements.clear(); });
}

QString MeasureFeature::tableText() const {
    const QTableWidget* table = panel_->table();
    QString text;
    for (int row = -1; row < table->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < table->columnCount(); ++column)
            cells << (row < 0 ? table->horizontalHeaderItem(column) : table->item(row, column))->text();
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return text;
}

void MeasureFeature::copyTable() {
    QGuiApplication::clipboard()->setText(tableText());
    bench_.messages()->showNotice(
        tr("The table of %n measurement(s) is on the clipboard.", nullptr, int(tool_->measurements().size())));
}

void MeasureFeature::exportTable() {
    if (tool_->measurements().empty())
        return bench_.messages()->showNotice(tr("There is nothing measured yet; choose what to draw in this menu."));
    const QString file = file_choice::save_file(bench_.window(), tr("Export the measurements"), FileKind::table,
                                                QStringLiteral("measurements.csv"), tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    const Document& document = bench_.documents()->document();
    writes_.start(tr("Writing the measurements"), file,
                  [volume = document.volume, all = document.settings.measurements, file](const JobContext& job) {
                      write_file(file.toStdString(), measurements_to_csv(volume, all, job));
                  });
}

}  // namespace lacuna::ui
