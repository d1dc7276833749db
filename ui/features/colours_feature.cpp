#include "ui/features/colours_feature.h"

#include <QFileInfo>

#include "core/classify/colour_maps.h"
#include "ui/colour_map_titles.h"
#include "ui/file_choice.h"

namespace lacuna::ui {

ColoursFeature::ColoursFeature(Workbench& bench, TransferPanel* colours, RangesPanel* ranges, QTabWidget* tabs)
    : QObject(&bench), bench_(bench), colours_(colours), ranges_(ranges), tabs_(tabs), read_(this), writes_(bench) {
    connect(&writes_, &FileWrites::written, this, &ColoursFeature::written);
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, [this, documents] {
        read_.cancel();  // it was to colour other data
        const Document& document = documents->document();
        colours_->setVolume(document.volume, document.statistics);
        ranges_->setVolume(document.volume, document.statistics);
        colours_->setSettings(document.settings);
        ranges_->setRanges(document.settings.ranges);
    });
    connect(documents, &DocumentController::settingsChanged, this, [this, documents] {
        colours_->setSettings(documents->document().settings);
        ranges_->setRanges(documents->document().settings.ranges);
    });
    connect(colours_, &TransferPanel::edited, documents, &DocumentController::edit);
    connect(colours_, &TransferPanel::gestureEnded, documents, &DocumentController::endGesture);
    connect(ranges_, &RangesPanel::edited, this, [this](const QString& name, const std::vector<RangeSetting>& next) {
        bench_.edit(name, [&](ViewSettings& settings) { settings.ranges = next; });
    });
    connect(ranges_, &RangesPanel::ownColorsRequested, this, [this](int index) {
        colours_->setTarget(index);
        tabs_->setCurrentWidget(colours_);
        colours_->showPage(TransferPanel::k_values);
        colours_->plot()->setFocus();
    });
    connect(colours_, &TransferPanel::loadRequested, this, &ColoursFeature::askForLoad);
    connect(colours_, &TransferPanel::saveRequested, this, &ColoursFeature::askForSave);
    connect(colours_, &TransferPanel::failed, bench.messages(), &MessageBar::showError);
    connect(ranges_, &RangesPanel::failed, bench.messages(), &MessageBar::showError);
    addActions();
}

void ColoursFeature::addActions() {
    QMenu* menu = bench_.submenu(Workbench::Menu::tools, tr("&Colours"));
    const auto show = [this] { tabs_->setCurrentWidget(colours_); };
    bench_.add(menu, tr("&Values"), {}, this, [this, show] {
        show();
        colours_->showPage(TransferPanel::k_values);
        colours_->plot()->setFocus();
    });
    bench_.add(menu, tr("&Gradient opacity"), {}, this, [this, show] {
        show();
        colours_->showPage(TransferPanel::k_gradients);
        colours_->gradientPage()->use()->setFocus();
    });
    bench_.add(menu, tr("Value and gradient (&2D)"), {}, this, [this, show] {
        show();
        colours_->showPage(TransferPanel::k_shapes);
        colours_->shapesPage()->plot()->setFocus();
    });
    menu->addSeparator();
    bench_.add(menu, tr("&Load a transfer function…"), {}, this, &ColoursFeature::askForLoad);
    bench_.add(menu, tr("&Save the transfer function…"), {}, this, &ColoursFeature::askForSave);
    QMenu* maps = menu->addMenu(tr("Colour &map"));
    for (const std::string& name : colour_map_names()) {
        const QString text = QString::fromStdString(name);
        bench_.add(maps, colour_map_title(name), {}, this, [this, text] { colours_->applyColorMap(text); });
    }
}

void ColoursFeature::askForLoad() {
    const QString file = file_choice::open_file(bench_.window(), tr("Load a transfer function"), FileKind::preset,
                                                tr("Transfer functions (*.json);;All files (*)"));
    if (!file.isEmpty()) loadFunction(file);
}

void ColoursFeature::loadFunction(const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    read_.start([path = file.toStdString()](const JobContext&) { return load_transfer_function(path); },
                [this](Outcome<TransferFunction> outcome) {
                    if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
                    colours_->load(std::get<0>(outcome));
                    Q_EMIT loaded();
                });
}

void ColoursFeature::askForSave() {
    const QString file = file_choice::save_file(bench_.window(), tr("Save the transfer function"), FileKind::preset,
                                                QStringLiteral("colours.json"), tr("Transfer functions (*.json)"));
    if (!file.isEmpty()) saveFunction(file);
}

void ColoursFeature::saveFunction(const QString& file) {
    writes_.start(tr("Saving the transfer function"), file, [function = colours_->function(), file](const JobContext&) {
        save_transfer_function(function, file.toStdString());
    });
}

}  // namespace lacuna::ui
