#include "ui/features/view_history_feature.h"

#include <QMouseEvent>

namespace lacuna::ui {

namespace {
/// Every command within a menu and the menus in it.
template <class Visit>
void for_commands(QMenu* menu, const Visit& visit) {
    for (QAction* action : menu->actions()) action->menu() ? for_commands(action->menu(), visit) : visit(action);
}
}  // namespace

ViewHistoryFeature::ViewHistoryFeature(Workbench& bench)
    : QObject(&bench), bench_(bench), gesture_end_([this] { history_.seal(); }, this) {
    QMenu* view = bench.menu(Workbench::Menu::view);
    back_ = bench.addAlways(view, tr("Prev&ious view"), QKeySequence(QStringLiteral("Alt+Left")), this,
                            &ViewHistoryFeature::back);
    forward_ = bench.addAlways(view, tr("&Next view"), QKeySequence(QStringLiteral("Alt+Right")), this,
                               &ViewHistoryFeature::forward);
    turn_end_.setSingleShot(true);
    turn_end_.setInterval(0);
    connect(&turn_end_, &QTimer::timeout, this, [this] { in_turn_ = nothing; });
    DocumentController* documents = bench.documents();
    connect(documents, &DocumentController::opened, this, &ViewHistoryFeature::reset);
    connect(documents, &DocumentController::cameraChanged, this, [this] { note(camera); });
    connect(documents, &DocumentController::cursorChanged, this, [this] { note(cursor); });
    bench.views()->volumeView()->installEventFilter(this);
    for (SliceView* slice : bench.views()->slices()) {
        slice->installEventFilter(this);
        connect(slice, &SliceView::zoomChanged, this, [this] { note(zoom); });
    }
    // A command is a step of its own: "from the left" after "from the front" can be taken back alone.
    for_commands(view, [this](QAction* action) { connect(action, &QAction::triggered, this, [this] { seal(); }); });
    connect(&bench, &Workbench::stateWanted, this,
            [this](QVariantMap& state) { state[QStringLiteral("views/history")] = QVariant::fromValue(history_); });
    connect(&bench, &Workbench::stateBack, this, [this](const QVariantMap& state) {
        const QVariant kept = state[QStringLiteral("views/history")];
        if (!kept.canConvert<ViewHistory>()) return;
        history_ = kept.value<ViewHistory>();
        going_ = true;
        for (std::size_t i = 0; i < history_.now().slices.size(); ++i)
            bench_.views()->slices()[i]->setZoom(history_.now().slices[i]);
        going_ = false;
        show();
    });
    show();
}

Viewpoint ViewHistoryFeature::viewpoint() const {
    const Document& document = bench_.documents()->document();
    Viewpoint now{document.camera, document.cursor_mm};
    for (std::size_t i = 0; i < now.slices.size(); ++i) now.slices[i] = bench_.views()->slices()[i]->zoom();
    return now;
}

void ViewHistoryFeature::reset() {
    if (bench_.documents()->hasDocument()) history_.reset(viewpoint());
    in_turn_ = last_ = nothing;
    show();
}

void ViewHistoryFeature::seal() {
    history_.seal();
    last_ = nothing;
}

void ViewHistoryFeature::note(Moved moved) {
    if (going_ || !bench_.documents()->hasDocument()) return;
    const bool joins = in_turn_ != nothing && in_turn_ != moved;  // a row chosen moves the slices, then the view
    in_turn_ |= moved;
    turn_end_.start();
    gesture_end_.start();
    if (!joins && last_ != in_turn_) history_.seal();
    last_ = in_turn_;
    const QString name = in_turn_ == camera              ? tr("3D view")
                         : in_turn_ == cursor            ? tr("cross-hair")
                         : in_turn_ == zoom              ? tr("zoom of a slice")
                         : in_turn_ == (camera | cursor) ? tr("3D view and cross-hair")
                                                         : tr("several views");
    history_.note(name.toStdString(), viewpoint(), joins);
    show();
}

void ViewHistoryFeature::back() {
    if (history_.can_go_back()) go(history_.back());
}

void ViewHistoryFeature::forward() {
    if (history_.can_go_forward()) go(history_.forward());
}

void ViewHistoryFeature::go(const Viewpoint& to) {
    const Viewpoint there = to;
    going_ = true;
    bench_.documents()->setCamera(there.camera);
    bench_.documents()->setCursor(there.cursor_mm);
    for (std::size_t i = 0; i < there.slices.size(); ++i) bench_.views()->slices()[i]->setZoom(there.slices[i]);
    going_ = false;
    seal();
    show();
}

void ViewHistoryFeature::show() {
    back_->setEnabled(history_.can_go_back());
    forward_->setEnabled(history_.can_go_forward());
    back_->setText(history_.can_go_back() ? tr("Prev&ious view: %1").arg(QString::fromStdString(history_.back_name()))
                                          : tr("Prev&ious view"));
    forward_->setText(history_.can_go_forward()
                          ? tr("&Next view: %1").arg(QString::fromStdString(history_.forward_name()))
                          : tr("&Next view"));
    Q_EMIT changed();
}

bool ViewHistoryFeature::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease)
        return QObject::eventFilter(watched, event);
    const Qt::MouseButton button = static_cast<QMouseEvent*>(event)->button();
    const bool side = button == Qt::BackButton || button == Qt::ForwardButton;
    if (!side) {
        seal();  // each press begins a gesture, each release ends one
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::MouseButtonPress) button == Qt::BackButton ? back() : forward();
    return true;
}

}  // namespace lacuna::ui
