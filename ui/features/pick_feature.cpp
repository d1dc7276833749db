#include "ui/features/pick_feature.h"

#include "ui/theme.h"
#include "ui/view_action.h"

namespace lacuna::ui {

PickFeature::PickFeature(Workbench& bench, CutFeature* cuts) : QObject(bench.window()), bench_(bench), cuts_(cuts) {
    VolumeView* view = bench.views()->volumeView();
    view->addTool(this);
    connect(bench.scheduler(), &FrameScheduler::frameReady, this, [this](const QImage&, const FrameFacts& facts) {
        scene_ = facts.scene;
        frame_ = facts.frame;
    });
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        frame_.reset();
        marked_.reset();
    });
    connect(view, &VolumeView::clicked, this,
            [this](const QPointF& at, Qt::KeyboardModifiers modifiers) { mark(at, modifiers & Qt::ShiftModifier); });
    connect(view, &VolumeView::hovered, this, &PickFeature::hover);
    connect(view, &VolumeView::left, this, &PickFeature::readOutEnded);
    connect(view, &VolumeView::menuRequested, this, &PickFeature::showMenu);
    buildMenu();
}

void PickFeature::buildMenu() {
    QMenu* menu = bench_.submenu(Workbench::Menu::tools, tr("&Point in the 3D view"));
    VolumeView* view = bench_.views()->volumeView();
    const auto middle = [view] { return QRectF(view->rect()).center(); };
    const auto add = [&](const QString& text, const char* keys, auto&& slot) {
        bind_to_view(bench_.add(menu, text, QKeySequence(QString::fromLatin1(keys)), this, slot), view);
    };
    add(tr("&Read out the point in the middle"), "Space", [this, middle] { mark(middle(), false); });
    add(tr("&Slices through the point in the middle"), "Shift+Space", [this, middle] { mark(middle(), true); });
    add(tr("&Focus on the point in the middle"), "Ctrl+Space", [this, middle] {
        if (const auto mm = pointAt(middle())) focusOn(*mm);
    });
    add(tr("&Turn about the point marked"), "Ctrl+Shift+Space", [this] {
        if (marked_) turnAbout(*marked_);
    });
    add(tr("&Unmark the point"), "Backspace", [this] {
        marked_.reset();
        bench_.views()->volumeView()->update();
        Q_EMIT readOutEnded();
    });
}

std::optional<glm::dvec3> PickFeature::pointAt(const QPointF& at) const {
    const QSize size = bench_.views()->volumeView()->size();
    if (!frame_ || size.isEmpty() || !bench_.documents()->hasDocument()) return std::nullopt;
    return point_at(*frame_, *scene_, {at.x() / size.width(), at.y() / size.height()});
}

void PickFeature::mark(const QPointF& at, bool slices_too) {
    marked_ = pointAt(at);
    bench_.views()->volumeView()->update();
    if (!marked_) {
        Q_EMIT readOutEnded();
        return;
    }
    if (slices_too) bench_.documents()->setCursor(*marked_);
    Q_EMIT readOut(nearest_voxel(bench_.documents()->document().volume.geometry(), *marked_));
}

void PickFeature::hover(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ShiftModifier) return mark(at, true);
    const auto mm = pointAt(at);
    if (mm)
        Q_EMIT readOut(nearest_voxel(bench_.documents()->document().volume.geometry(), *mm));
    else
        Q_EMIT readOutEnded();
}

void PickFeature::focusOn(const glm::dvec3& mm) {
    const GridGeometry& geometry = bench_.documents()->document().volume.geometry();
    const double focus = focus_at(mm, bench_.views()->volumeView()->rays(), geometry);
    bench_.edit(tr("Focus"), [&](ViewSettings& settings) {
        for (Effect& effect : settings.effects)
            if (effect.kind == EffectKind::dof) {
                effect.values.resize(std::max<std::size_t>(effect.values.size(), 1));
                effect.values[0] = focus;
                return;
            }
        settings.effects.push_back({EffectKind::dof, {focus, 1, 0}});
    });
}

void PickFeature::turnAbout(const glm::dvec3& mm) {
    Camera camera = bench_.documents()->document().camera;
    camera.center_mm = mm;
    bench_.documents()->setCamera(camera);
}

void PickFeature::showMenu(const QPointF& at) {
    VolumeView* view = bench_.views()->volumeView();
    const std::optional<glm::dvec3> mm = pointAt(at);
    auto* menu = new QMenu(view);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("view_menu"));
    const auto add = [&](const QString& text, auto&& slot) {
        menu->addAction(text, this, slot)->setEnabled(mm.has_value());
    };
    add(tr("&Slices through this point"), [this, at] { mark(at, true); });
    add(tr("&Turn about this point"), [this, mm] { turnAbout(*mm); });
    add(tr("&Focus here"), [this, mm] { focusOn(*mm); });
    menu->addSeparator();
    menu->addActions(cuts_->cutActions());
    menu->addAction(cuts_->boxAction());
    menu->addSeparator();
    menu->addAction(tr("&Reset the view"), view, &VolumeView::resetCamera);
    menu->popup(view->mapToGlobal(at.toPoint()));
}

void PickFeature::paint(QPainter& painter, const ViewRays& rays) const {
    if (!marked_) return;
    const std::optional<glm::dvec2> at = in_picture(rays, *marked_);
    if (!at) return;
    const QPointF middle = to_point(*at);
    for (const auto& [ink, width] : {std::pair{QColor(0, 0, 0, 160), 3.5}, std::pair{theme::k_warning, 1.5}}) {
        painter.setPen(QPen(ink, width));
        for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(middle + 3 * arm, middle + 9 * arm);
    }
}

}  // namespace lacuna::ui
