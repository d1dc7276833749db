#include "ui/features/slices_feature.h"

#include <QActionGroup>
#include <algorithm>
#include <cmath>

namespace lacuna::ui {

SlicesFeature::SlicesFeature(Workbench& bench, SlicesPanel* panel) : QObject(&bench), bench_(bench), panel_(panel) {
    addWindows();
    addSlabs();
    QMenu* menu = bench.submenu(Workbench::Menu::view, tr("S&lices"));
    menu->addSeparator();
    bench.add(menu, tr("Planes along the &grid"), QKeySequence(QStringLiteral("Shift+O")), this, [this] {
        bench_.edit(tr("Planes along the grid"),
                    [](ViewSettings& settings) { settings.slices.tilt = glm::dquat(1, 0, 0, 0); });
    });
    QAction* notes = bench.addAlways(menu, tr("&Words, sides and scale"), QKeySequence(QStringLiteral("Shift+N")), this,
                                     [this](bool on) {
                                         for (SliceView* slice : bench_.views()->slices()) slice->setNotesShown(on);
                                     });
    notes->setCheckable(true);
    notes->setChecked(true);
    for (SliceView* slice : bench.views()->slices()) {
        slice->addTool(&cross_hair_);
        connect(slice, &SliceView::tiltEdited, this, [this](const glm::dquat& tilt) {
            bench_.edit(tr("Tilt the planes"), [&](ViewSettings& settings) { settings.slices.tilt = tilt; });
        });
    }
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        const bool known = bench_.documents()->document().volume.unit == "HU";
        for (QAction* action : hounsfield_) action->setEnabled(known);
    });
}

void SlicesFeature::chooseWindow(ValueRange window) {
    bench_.edit(tr("Window preset"), [&](ViewSettings& settings) { SlicesPanel::choose(settings, {{}, window, {}}); });
}

void SlicesFeature::addWindows() {
    QMenu* menu = bench_.submenu(Workbench::Menu::view, tr("&Window"));
    const auto key = [](int digit) { return QKeySequence(QStringLiteral("Alt+%1").arg(digit)); };
    int digit = 0;
    for (const WindowPreset& preset : hounsfield_windows()) {
        const ValueRange window{preset.center - 0.5 * preset.width, preset.center + 0.5 * preset.width};
        hounsfield_.push_back(
            bench_.addAlways(menu, window_title(preset), key(++digit), this, [this, window] { chooseWindow(window); }));
        hounsfield_.back()->setEnabled(false);  // until a volume in Hounsfield units is open
    }
    // The panel knows what the volume opened with and its full range: its first two.
    for (const auto& [text, number, row] :
         {std::tuple{tr("&Full range"), ++digit, std::size_t(1)}, {tr("As &opened"), 0, std::size_t(0)}})
        bench_.add(menu, text, key(number), this, [this, row = row] {
            if (row >= panel_->windows().size()) return;
            bench_.edit(tr("Window preset"),
                        [&](ViewSettings& settings) { SlicesPanel::choose(settings, panel_->windows()[row]); });
        });
}

void SlicesFeature::addSlabs() {
    QMenu* menu = bench_.submenu(Workbench::Menu::view, tr("S&lices"));
    auto* modes = new QActionGroup(this);
    const std::tuple<QString, QString, SlabMode> rows[] = {
        {tr("Slab: &mean"), QStringLiteral("Shift+1"), SlabMode::mean},
        {tr("Slab: ma&ximum (MIP)"), QStringLiteral("Shift+2"), SlabMode::mip},
        {tr("Slab: m&inimum (MinIP)"), QStringLiteral("Shift+3"), SlabMode::minip}};
    for (const auto& [text, key, mode] : rows) {
        QAction* action = bench_.add(menu, text, QKeySequence(key), this, [this, mode = mode] {
            bench_.edit(tr("Slab"), [&](ViewSettings& settings) {
                settings.slices.slab.mode = mode;
                // A slab of one voxel would show nothing of the choice.
                if (settings.slices.slab.thickness_mm == 0) settings.slices.slab.thickness_mm = 10;
            });
        });
        action->setCheckable(true);
        action->setData(int(mode));
        modes->addAction(action);
    }
    bench_.add(menu, tr("Thicker slab"), QKeySequence(QStringLiteral("Shift+PgUp")), this, [this] { thickenBy(1); });
    bench_.add(menu, tr("Thinner slab"), QKeySequence(QStringLiteral("Shift+PgDown")), this, [this] { thickenBy(-1); });
    bench_.add(menu, tr("&No slab"), QKeySequence(QStringLiteral("Shift+Home")), this, [this] {
        bench_.edit(tr("Slab thickness"), [](ViewSettings& settings) { settings.slices.slab.thickness_mm = 0; });
    });
    const auto show = [this, modes] {
        const Slab& slab = bench_.documents()->document().settings.slices.slab;
        for (QAction* action : modes->actions())
            action->setChecked(slab.thickness_mm > 0 && action->data().toInt() == int(slab.mode));
    };
    modes->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    connect(bench_.documents(), &DocumentController::settingsChanged, this, show);
    connect(bench_.documents(), &DocumentController::opened, this, show);
}

/// By whole voxels of the smallest spacing, as many as make a tenth more where it is thick already.
void SlicesFeature::thickenBy(int slices) {
    if (!bench_.documents()->hasDocument()) return;
    const GridGeometry& geometry = bench_.documents()->document().volume.geometry();
    bench_.edit(tr("Slab thickness"), [&](ViewSettings& settings) {
        const double unit = geometry.smallest_spacing_mm();
        const double step = unit * std::max(1.0, std::round(0.1 * settings.slices.slab.thickness_mm / unit));
        settings.slices.slab.thickness_mm =
            std::clamp(settings.slices.slab.thickness_mm + slices * step, 0.0, geometry.diameter_mm() / 2);
    });
}

}  // namespace lacuna::ui
