#include "ui/features/cut_feature.h"

#include <cmath>

#include "ui/tool_bar.h"
#include "ui/view_action.h"

namespace lacuna::ui {

namespace {
constexpr double k_tilt_deg = 2;
constexpr int k_voxels = 1, k_many_voxels = 10;

QKeySequence key(const char* keys) { return QKeySequence(QString::fromLatin1(keys)); }
}  // namespace

CutFeature::CutFeature(Workbench& bench, CutsPanel* panel) : QObject(bench.window()), bench_(bench), panel_(panel) {
    VolumeView* view = bench.views()->volumeView();
    view->addTool(&tool_);
    connect(&tool_, &CutTool::repaintNeeded, view, qOverload<>(&QWidget::update));
    connect(&tool_, &CutTool::cutChosen, panel, &CutsPanel::select);
    connect(&tool_, &CutTool::cutsEdited, this, [this](const QString& name, const std::vector<CutSetting>& cuts) {
        bench_.edit(name, [&](ViewSettings& settings) { settings.cuts = cuts; });
    });
    connect(&tool_, &CutTool::boxEdited, this, [this](const QString& name, const BoxRoi& box) {
        bench_.edit(name, [&](ViewSettings& settings) { settings.roi = box; });
    });
    connect(panel, &CutsPanel::currentChanged, this, &CutFeature::show);
    connect(bench.documents(), &DocumentController::opened, this, [this] {
        tool_.setGeometry3d(bench_.documents()->document().volume.geometry());
        show();
    });
    connect(bench.documents(), &DocumentController::settingsChanged, this, &CutFeature::show);
    buildMenu();
}

void CutFeature::buildMenu() {
    QMenu* menu = bench_.submenu(Workbench::Menu::tools, tr("&Cutting planes"));
    QAction* cut = bench_.add(menu, tr("&Add a cutting plane"), key("Ctrl+Alt+X"), this, [this] {
        Q_EMIT cutAdded();
        panel_->addCut();
    });
    offer_tool(cut, ToolGroup::tools, Icon::cut, tr("Cut"));
    bench_.add(menu, tr("Cut here, &facing the viewer"), key("Ctrl+Shift+X"), this, &CutFeature::addFacing);
    menu->addSeparator();
    inView(bench_.add(menu, tr("Choose the &next plane"), key("C"), panel_,
                      [this] { panel_->select(panel_->current() + 1); }),
           false);
    inView(bench_.add(menu, tr("F&lip the plane"), key("Shift+C"), panel_, &CutsPanel::flipCurrent), true);
    open_ =
        inView(bench_.add(menu, tr("Data values on the cut face (ca&p)"), key("O"), this,
                          [this](bool cap) {
                              editCut(CutsPanel::tr("Cut face"), [cap](CutSetting& chosen) { chosen.plane.cap = cap; });
                          }),
               true);
    open_->setCheckable(true);
    inView(bench_.add(menu, tr("&Remove the plane"), key("Shift+Del"), panel_, &CutsPanel::removeCurrent), true);
    addMoves(menu->addMenu(tr("&Move and tilt the plane")));
    menu->addSeparator();
    addBox(menu);
    QAction* handles = bench_.add(menu, tr("Show &handles in the 3D view"), key("Ctrl+Alt+H"), this, [this](bool on) {
        tool_.setVisible(on);
        bench_.views()->volumeView()->update();
    });
    handles->setCheckable(true);
    handles->setChecked(true);
}

void CutFeature::addMoves(QMenu* menu) {
    const auto moves = [&](const QString& text, const char* keys, int voxels) {
        inView(bench_.add(menu, text, key(keys), this, [this, voxels] { moveBy(voxels); }), false);
    };
    moves(tr("Cut away &more"), "PgDown", k_voxels);
    moves(tr("Cut away &less"), "PgUp", -k_voxels);
    moves(tr("Cut away much more"), "Ctrl+PgDown", k_many_voxels);
    moves(tr("Cut away much less"), "Ctrl+PgUp", -k_many_voxels);
    const auto tilts = [&](const QString& text, const char* keys, double right, double up) {
        inView(bench_.add(menu, text, key(keys), this, [this, right, up] { tiltBy(right, up); }), false);
    };
    tilts(tr("Tilt to the left"), "Alt+Shift+Left", -k_tilt_deg, 0);
    tilts(tr("Tilt to the right"), "Alt+Shift+Right", k_tilt_deg, 0);
    tilts(tr("Tilt up"), "Alt+Shift+Up", 0, k_tilt_deg);
    tilts(tr("Tilt down"), "Alt+Shift+Down", 0, -k_tilt_deg);
}

void CutFeature::addBox(QMenu* menu) {
    box_ = inView(bench_.add(menu, tr("Show a &box of the volume alone"), key("Shift+B"), this,
                             [this](bool on) {
                                 bench_.edit(BoxPanel::tr("Switch the box"), [on](ViewSettings& settings) {
                                     BoxRoi& box = settings.roi;
                                     box.enabled = on;
                                     // A box as large as the volume shows no effect: its handles begin inside.
                                     if (on && box.lo == glm::dvec3(0) && box.hi == glm::dvec3(1))
                                         box.lo = glm::dvec3(0.1), box.hi = glm::dvec3(0.9);
                                 });
                             }),
                  false);
    box_->setCheckable(true);
}

QAction* CutFeature::inView(QAction* action, bool of_cut) {
    bind_to_view(action, bench_.views()->volumeView());
    if (of_cut) of_cut_ << action;
    return action;
}

void CutFeature::show() {
    if (!bench_.documents()->hasDocument()) return;
    const ViewSettings& settings = bench_.documents()->document().settings;
    tool_.setCuts(settings.cuts);
    tool_.setBox(settings.roi);
    tool_.setSelected(panel_->current());
    const bool some = panel_->current() >= 0 && std::size_t(panel_->current()) < settings.cuts.size();
    for (QAction* action : of_cut_) action->setEnabled(some);
    open_->setChecked(some && settings.cuts[std::size_t(panel_->current())].plane.cap);
    box_->setChecked(settings.roi.enabled);
    bench_.views()->volumeView()->update();
}

template <class Change>
void CutFeature::editCut(const QString& name, Change&& change) {
    const int cut = panel_->current();
    bench_.edit(name, [&](ViewSettings& settings) {
        if (cut >= 0 && std::size_t(cut) < settings.cuts.size()) change(settings.cuts[std::size_t(cut)]);
    });
}

void CutFeature::addFacing() {
    const Document& document = bench_.documents()->document();
    if (document.settings.cuts.size() >= ViewSettings::k_max_planes) return;
    const GridGeometry& geometry = document.volume.geometry();
    const glm::dvec3 normal = bench_.views()->volumeView()->rays().forward;
    const CuttingPlane plane = moved({normal, -glm::dot(normal, document.cursor_mm), true}, 0, geometry);
    Q_EMIT cutAdded();
    bench_.edit(CutsPanel::tr("Add a cut"), [&](ViewSettings& settings) { settings.cuts.push_back({plane, true}); });
}

void CutFeature::moveBy(int voxels) {
    const GridGeometry& geometry = bench_.documents()->document().volume.geometry();
    editCut(tr("Move a cut"),
            [&](CutSetting& cut) { cut.plane = moved(cut.plane, voxels * geometry.smallest_spacing_mm(), geometry); });
}

void CutFeature::tiltBy(double right_deg, double up_deg) {
    const GridGeometry& geometry = bench_.documents()->document().volume.geometry();
    const ViewRays rays = bench_.views()->volumeView()->rays();
    editCut(tr("Tilt a cut"), [&](CutSetting& cut) {
        const glm::dvec3 anchor = gizmo_of(cut.plane, geometry, rays).anchor;
        cut.plane = turned(cut.plane, rays.up, right_deg, anchor);
        cut.plane = turned(cut.plane, rays.right, up_deg, anchor);
    });
}

}  // namespace lacuna::ui
