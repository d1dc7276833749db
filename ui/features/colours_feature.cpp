#include "ui/features/colours_feature.h"

#include "core/classify/colour_maps.h"

namespace lacuna::ui {

ColoursFeature::ColoursFeature(Workbench& bench, TransferPanel* colours, RangesPanel* ranges, QTabWidget* tabs)
    : QObject(&bench), bench_(bench), colours_(colours), ranges_(ranges), tabs_(tabs) {
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, [this, documents] {
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
    bench_.add(menu, tr("&Load a transfer function…"), {}, colours_, &TransferPanel::load);
    bench_.add(menu, tr("&Save the transfer function…"), {}, colours_, &TransferPanel::save);
    QMenu* maps = menu->addMenu(tr("Colour &map"));
    for (const std::string& name : colour_map_names()) {
        const QString text = QString::fromStdString(name);
        bench_.add(maps, text, {}, this, [this, text] { colours_->applyColorMap(text); });
    }
}

}  // namespace lacuna::ui
