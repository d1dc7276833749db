#include "ui/features/hand_feature.h"

#include "core/session/level_drag.h"
#include "ui/preferences.h"
#include "ui/view_action.h"

namespace lacuna::ui {

namespace {
constexpr double k_px_per_width = 300, k_px_per_factor = 150;  // as on the slices
constexpr double k_key_shift = 0.04, k_key_factor = 0.08;
}  // namespace

HandFeature::HandFeature(Workbench& bench) : QObject(bench.window()), bench_(bench) {
    VolumeView* view = bench.views()->volumeView();
    view->addTool(this);
    free_ = bench.addAlways(bench.menu(Workbench::Menu::view), tr("Turn freel&y (arcball)"),
                            QKeySequence(QStringLiteral("Ctrl+Shift+Y")), this, [view](bool on) {
                                view->setFreeRotation(on);
                                preferences::set_free_rotation(on);
                            });
    free_->setCheckable(true);
    free_->setChecked(preferences::free_rotation());
    view->setFreeRotation(free_->isChecked());
    QMenu* levels = bench.submenu(Workbench::Menu::view, tr("Le&vels of the 3D view"));
    const auto add = [&](const QString& text, const char* keys, double higher, double wider) {
        bind_to_view(
            bench.add(levels, text, QKeySequence(QString::fromLatin1(keys)), this,
                      [this, higher, wider] { changeLevels(bench_.documents()->document().settings, higher, wider); }),
            view);
    };
    add(tr("&Lower: more is seen"), "Ctrl+Up", -k_key_shift, 0);
    add(tr("&Higher: less is seen"), "Ctrl+Down", k_key_shift, 0);
    add(tr("&Wider"), "Ctrl+Right", 0, k_key_factor);
    add(tr("&Narrower"), "Ctrl+Left", 0, -k_key_factor);
}

bool HandFeature::press(const ViewRays&, const QMouseEvent& event) {
    if (event.button() != Qt::RightButton || !(event.modifiers() & Qt::ControlModifier)) return false;
    if (!bench_.documents()->hasDocument()) return false;
    from_ = event.position();
    before_ = bench_.documents()->document().settings;
    return true;
}

void HandFeature::drag(const ViewRays&, const QMouseEvent& event) {
    const QPointF moved = event.position() - from_;
    if (before_) changeLevels(*before_, moved.y() / k_px_per_width, moved.x() / k_px_per_factor);
}

void HandFeature::changeLevels(const ViewSettings& from, double higher, double wider) {
    const Document& document = bench_.documents()->document();
    bench_.documents()->edit(tr("Levels"), with_levels(from, document.statistics->range, higher, wider));
}

}  // namespace lacuna::ui
