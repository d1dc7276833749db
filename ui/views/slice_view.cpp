#include "ui/views/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/session/document.h"
#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

SliceView::SliceView(SliceKind kind, QWidget* parent) : QWidget(parent), kind_(kind), picture_(new SlicePicture(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setMinimumSize(120, 100);
    nameView();
    setAccessibleDescription(
        tr("Arrow keys move the cross-hair, Page Up and Page Down turn the pages, Shift and arrow keys change window "
           "and level."));
    connect(picture_, &SlicePicture::ready, this, qOverload<>(&QWidget::update));
}

void SliceView::setVolume(const Volume& volume, const std::vector<std::shared_ptr<const VoiTable>>& tables) {
    volume_ = volume;
    nameView();
    tables_ = tables;
    picture_->setVolume(volume);
    showWindow();
    cuts_.clear();
    settings_.tilt = {1, 0, 0, 0};
    if (!volume.empty()) cursor_mm_ = volume.geometry().voxel_to_mm(glm::dvec3(volume.geometry().size / 2));
    place();
    resetView();
}

void SliceView::nameView() {
    setAccessibleName(
        tr("%1 slice").arg(slice_title(kind_, volume_.empty() ? AxisNames::patient : volume_.geometry().axis_names)));
}

/// Finds the plane anew after the cross-hair or the tilt has moved.
void SliceView::place() {
    if (!volume_.empty()) {
        pose_ = slice_pose(volume_.geometry(), kind_, settings_.tilt, cursor_mm_);
        picture_->request(pose_.frame, settings_.slab);
    }
    update();
}

void SliceView::setCursor3d(const glm::dvec3& mm) {
    if (volume_.empty() || mm == cursor_mm_) return;
    cursor_mm_ = mm;
    place();
}

void SliceView::setSettings(ValueRange window, const SliceSettings& settings) {
    if (window == window_ && settings == settings_) return;
    window_ = window;
    settings_ = settings;
    showWindow();
    picture_->setOverlayOpacity(settings.overlay_opacity);
    place();
}

void SliceView::showWindow() {
    VoiWindow shown = VoiWindow::of(window_.lo, window_.hi, settings_.function);
    if (settings_.function == VoiFunction::table && std::size_t(settings_.table) < tables_.size())
        shown.table = tables_[std::size_t(settings_.table)];
    picture_->setWindow(shown);
}

void SliceView::setOverlay(const SliceOverlay& overlay) {
    picture_->setOverlay(overlay);
    update();
}

void SliceView::setCuts(const std::vector<CuttingPlane>& cuts) {
    if (cuts == cuts_) return;
    cuts_ = cuts;
    update();
}

void SliceView::setCornerWords(const QStringList& patient, const QStringList& study) {
    patient_ = patient;
    study_ = study;
    update();
}

void SliceView::setNotesShown(bool shown) {
    notes_shown_ = shown;
    update();
}

void SliceView::resetView() { setZoom({}); }

void SliceView::setZoom(const SliceZoom& zoom) {
    if (zoom == this->zoom()) return;
    zoom_ = zoom.zoom;
    pan_ = {zoom.pan.x, zoom.pan.y};
    update();
    Q_EMIT zoomChanged();
}

double SliceView::depthTolerance() const { return 0.5 * std::max(pose_.page_mm, settings_.slab.thickness_mm) + 1e-6; }

double SliceView::pixelsPerMm() const { return pictureRect().width() / (pose_.frame.size.x * pose_.frame.pixel_mm.x); }

QRectF SliceView::pictureRect() const {
    const glm::dvec2 mm = glm::dvec2(pose_.frame.size) * pose_.frame.pixel_mm;
    // A tilted picture is larger than what it shows; the scale stays that of the slices along the grid.
    const GridGeometry& geometry = volume_.geometry();
    const SlicePlane& plane = pose_.plane;
    const double width_mm = geometry.size[plane.u] * geometry.spacing[plane.u];
    const double height_mm = geometry.size[plane.v] * geometry.spacing[plane.v];
    const double margin = 18;
    const double scale = zoom_ * std::min(std::max(20.0, width() - 2 * margin) / width_mm,
                                          std::max(20.0, height() - 2 * margin) / height_mm);
    const QSizeF size(mm.x * scale, mm.y * scale);
    return {QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())) + pan_, size};
}

glm::dvec3 SliceView::toMm(const QPointF& position) const {
    const QRectF rect = pictureRect();
    return pose_.frame.to_mm({(position.x() - rect.left()) / rect.width() * pose_.frame.size.x,
                              (position.y() - rect.top()) / rect.height() * pose_.frame.size.y});
}

QPointF SliceView::toWidget(const glm::dvec3& mm) const {
    const QRectF rect = pictureRect();
    const glm::dvec2 picture = pose_.frame.to_picture(mm);
    return {rect.left() + picture.x / pose_.frame.size.x * rect.width(),
            rect.top() + picture.y / pose_.frame.size.y * rect.height()};
}

QPointF SliceView::directionInWidget(const glm::dvec3& direction) const {
    return {glm::dot(direction, pose_.frame.right), glm::dot(direction, pose_.frame.down)};
}

void SliceView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!volume_.empty()) {
        const QImage& image = picture_->image();
        if (!image.isNull() && picture_->frame().right == pose_.frame.right &&
            picture_->frame().down == pose_.frame.down) {
            const QPointF from = toWidget(picture_->frame().to_mm({0, 0}));
            const QPointF to = toWidget(picture_->frame().to_mm(glm::dvec2(picture_->frame().size)));
            // Up close the voxels themselves are of interest, so they are not blurred away.
            const bool close = (to.x() - from.x()) / image.width() > 12;
            painter.setRenderHint(QPainter::SmoothPixmapTransform, !close);
            painter.drawImage(QRectF(from, to), image);
        } else if (!image.isNull()) {
            painter.drawImage(pictureRect(), image);  // of the plane before, until this one is sampled
        }
        painter.setRenderHint(QPainter::Antialiasing);
        paintCuts(painter);
        for (const SliceTool* tool : tools_) tool->paint(*this, painter);
        if (notes_shown_) paintNotes(painter);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(hasFocus() ? theme::k_accent : theme::k_border, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void SliceView::paintCuts(QPainter& painter) const {
    const glm::dvec2 size(pose_.frame.size);
    const glm::dvec3 corner[4] = {pose_.frame.to_mm({0, 0}), pose_.frame.to_mm({size.x, 0}), pose_.frame.to_mm(size),
                                  pose_.frame.to_mm({0, size.y})};
    painter.setPen(QPen(theme::k_volume, 1, Qt::DashLine));
    for (const CuttingPlane& cut : cuts_) {
        std::vector<QPointF> ends;  // where the plane crosses the picture's border
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 &a = corner[i], &b = corner[(i + 1) % 4];
            const double da = glm::dot(cut.normal, a) + cut.offset, db = glm::dot(cut.normal, b) + cut.offset;
            if ((da < 0) == (db < 0)) continue;
            ends.push_back(toWidget(glm::mix(a, b, da / (da - db))));
        }
        if (ends.size() == 2) painter.drawLine(ends[0], ends[1]);
    }
}

void SliceView::paintNotes(QPainter& painter) const {
    SliceNotes notes;
    const AxisNames names = volume_.geometry().axis_names;
    const QString title = slice_title(kind_, names);
    notes.title = pose_.oblique ? tr("%1, tilted").arg(title) : title;
    notes.title_color = slice_color(kind_);
    notes.patient = patient_;
    notes.study = study_;
    const Slab& slab = settings_.slab;
    if (slab.thickness_mm > 0)
        notes.position << (slab.mode == SlabMode::mip     ? tr("MIP of %1 mm")
                           : slab.mode == SlabMode::minip ? tr("MinIP of %1 mm")
                                                          : tr("Mean of %1 mm"))
                              .arg(number_text(slab.thickness_mm, 'g', 4));
    notes.position << position_text(names, pose_.frame.to_mm({0, 0}), pose_.frame.normal());
    if (!pose_.oblique) notes.position << tr("%1 / %2").arg(index() + 1).arg(volume_.geometry().size[pose_.plane.w]);
    notes.grey << tr("Zoom %1 %").arg(number_text(100 * zoom_, 'f', 0));
    if (settings_.function == VoiFunction::sigmoid) notes.grey << tr("sigmoid");
    notes.grey << tr("L %1  W %2")
                      .arg(number_text(0.5 * (window_.lo + window_.hi), 'g', 5), number_text(window_.width(), 'g', 5));
    paint_notes(painter, rect(), pose_, notes, pixelsPerMm());
}

void SliceView::moveCursorTo(const glm::dvec3& mm) {
    const GridGeometry& geometry = volume_.geometry();
    glm::dvec3 voxel = geometry.mm_to_voxel(mm);
    if (is_upright(settings_.tilt)) voxel = glm::round(voxel);
    Q_EMIT cursorMoved(geometry.voxel_to_mm(glm::clamp(voxel, glm::dvec3(0), glm::dvec3(geometry.size - 1))));
}

void SliceView::moveCursorBy(int right, int down) {
    const SliceFrame& frame = pose_.frame;
    moveCursorTo(cursor_mm_ + frame.right * (right * frame.pixel_mm.x) + frame.down * (down * frame.pixel_mm.y));
}

void SliceView::turnPages(int pages) {
    // Towards the end of the grid axis along the grid; along the normal where it is tilted.
    const glm::dvec3 axis = volume_.geometry().direction[pose_.plane.w];
    const double sign = glm::dot(axis, pose_.frame.normal()) < 0 ? -1 : 1;
    moveCursorTo(cursor_mm_ + pose_.frame.normal() * (sign * pages * pose_.page_mm));
}

void SliceView::windowBy(double width_share, double level_share) {
    // PS3.3 C.11.2.1.2.1: the width of LINEAR is 1 or more.
    const double least = settings_.function == VoiFunction::linear ? 1 : 1e-6;
    const double width = std::max(window_.width() * std::exp(width_share), least);
    const double level = 0.5 * (window_.lo + window_.hi) + level_share * window_.width();
    Q_EMIT windowEdited({level - 0.5 * width, level + 0.5 * width});
}

void SliceView::zoomBy(double factor) {
    const double zoom = std::clamp(zoom_ * factor, 0.2, 60.0);
    const QPointF pan = pan_ * (zoom / zoom_);
    setZoom({zoom, {pan.x(), pan.y()}});
}

void SliceView::hover(const QPointF& position) {
    const glm::ivec3 size = volume_.geometry().size;
    const glm::dvec3 voxel = glm::round(volume_.geometry().mm_to_voxel(toMm(position)));
    for (int axis = 0; axis < 3; ++axis)
        if (!(voxel[axis] >= 0 && voxel[axis] <= size[axis] - 1)) {
            Q_EMIT left();
            return;
        }
    Q_EMIT hovered(glm::ivec3(voxel));
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    if (volume_.empty()) return;
    drag_from_ = event->position();
    tool_drag_ = std::any_of(tools_.begin(), tools_.end(), [&](SliceTool* tool) { return tool->press(*this, *event); });
    if (!tool_drag_ && event->button() == Qt::LeftButton) moveCursorTo(toMm(event->position()));
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    if (volume_.empty()) return;
    const QPointF moved = event->position() - drag_from_;
    drag_from_ = event->position();
    const bool taken =
        std::any_of(tools_.begin(), tools_.end(), [&](SliceTool* tool) { return tool->move(*this, *event); });
    if (!taken && !tool_drag_ && (event->buttons() & Qt::LeftButton)) moveCursorTo(toMm(event->position()));
    if (event->buttons() & Qt::MiddleButton) setZoom({zoom_, {pan_.x() + moved.x(), pan_.y() + moved.y()}});
    if (event->buttons() & Qt::RightButton) windowBy(moved.x() / 150, moved.y() / 300);
    if (!taken && event->buttons() == Qt::NoButton) setCursor(Qt::CrossCursor);
    hover(event->position());
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    if (volume_.empty()) return;
    for (SliceTool* tool : tools_)
        if (tool->release(*this, *event)) break;
    if (event->buttons() == Qt::NoButton) tool_drag_ = false;
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    for (SliceTool* tool : tools_)
        if (tool->doubleClick(*this, *event)) return;
    if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

void SliceView::wheelEvent(QWheelEvent* event) {
    if (volume_.empty()) return;
    if (event->modifiers() & Qt::ControlModifier) {
        zoomBy(std::exp(event->angleDelta().y() / 600.0));
    } else {
        wheel_rest_ += event->angleDelta().y();
        const int pages = wheel_rest_ / 120;  // touch pads send fractions of a notch
        wheel_rest_ -= pages * 120;
        if (pages != 0) turnPages(pages);
        hover(event->position());
    }
    event->accept();
}

bool SliceView::handleKey(int key, bool shift) {
    switch (key) {
        case Qt::Key_Left:
            return shift ? windowBy(-0.08, 0) : moveCursorBy(-1, 0), true;
        case Qt::Key_Right:
            return shift ? windowBy(0.08, 0) : moveCursorBy(1, 0), true;
        case Qt::Key_Up:
            return shift ? windowBy(0, -0.04) : moveCursorBy(0, -1), true;
        case Qt::Key_Down:
            return shift ? windowBy(0, 0.04) : moveCursorBy(0, 1), true;
        case Qt::Key_PageUp:
            return turnPages(1), true;
        case Qt::Key_PageDown:
            return turnPages(-1), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoomBy(1.2), true;
        case Qt::Key_Minus:
            return zoomBy(1 / 1.2), true;
        case Qt::Key_Home:
            return resetView(), true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            Q_EMIT maximizeRequested();
            return true;
        default:
            return false;
    }
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    if (volume_.empty() || (event->modifiers() & Qt::AltModifier)) return QWidget::keyPressEvent(event);
    for (SliceTool* tool : tools_)
        if (tool->key(*this, *event)) return;
    if (!handleKey(event->key(), event->modifiers() & Qt::ShiftModifier)) QWidget::keyPressEvent(event);
}

void SliceView::leaveEvent(QEvent*) {
    for (SliceTool* tool : tools_) tool->leave(*this);
    update();
    Q_EMIT left();
}

void SliceView::focusInEvent(QFocusEvent*) { update(); }
void SliceView::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
