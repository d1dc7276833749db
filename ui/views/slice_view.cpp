#include "ui/views/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/session/document.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {

QString title_of(SliceKind kind) {
    switch (kind) {
        case SliceKind::axial:
            return QObject::tr("Axial");
        case SliceKind::coronal:
            return QObject::tr("Coronal");
        case SliceKind::sagittal:
            return QObject::tr("Sagittal");
    }
    return {};
}

}  // namespace

SliceView::SliceView(SliceKind kind, QWidget* parent) : QWidget(parent), kind_(kind) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setMinimumSize(120, 100);
    setAccessibleName(tr("%1 slice").arg(title_of(kind)));
    setAccessibleDescription(
        tr("Arrow keys move the cross-hair, Page Up and Page Down turn the pages, Shift and arrow keys change window "
           "and level."));
}

QColor SliceView::color() const {
    switch (kind_) {
        case SliceKind::axial:
            return theme::k_axial;
        case SliceKind::coronal:
            return theme::k_coronal;
        case SliceKind::sagittal:
            return theme::k_sagittal;
    }
    return theme::k_text;
}

void SliceView::setVolume(const Volume& volume) {
    volume_ = volume;
    plane_ = volume.empty() ? SlicePlane{} : slice_plane(volume.geometry(), kind_);
    voxel_ = volume.empty() ? glm::ivec3(0) : volume.geometry().size / 2;
    overlay_ = {};
    cuts_.clear();
    image_ = {};
    resetView();
}

void SliceView::setCursor3d(const glm::dvec3& mm) {
    if (volume_.empty()) return;
    const glm::ivec3 voxel = nearest_voxel(volume_.geometry(), mm);
    if (voxel == voxel_) return;
    if (voxel[plane_.w] != voxel_[plane_.w]) image_ = {};
    voxel_ = voxel;
    update();
}

void SliceView::setWindow(ValueRange window) {
    if (window == window_) return;
    window_ = window;
    image_ = {};
    update();
}

void SliceView::setOverlay(const SliceOverlay& overlay) {
    overlay_ = overlay;
    image_ = {};
    update();
}

void SliceView::setCuts(const std::vector<CuttingPlane>& cuts) {
    if (cuts == cuts_) return;
    cuts_ = cuts;
    update();
}

void SliceView::resetView() {
    zoom_ = 1;
    pan_ = {};
    update();
}

QRectF SliceView::pictureRect() const {
    const GridGeometry& geometry = volume_.geometry();
    const double width_mm = geometry.size[plane_.u] * geometry.spacing[plane_.u];
    const double height_mm = geometry.size[plane_.v] * geometry.spacing[plane_.v];
    const double margin = 18;
    const double scale = zoom_ * std::min(std::max(20.0, width() - 2 * margin) / width_mm,
                                          std::max(20.0, height() - 2 * margin) / height_mm);
    const QSizeF size(width_mm * scale, height_mm * scale);
    return {QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())) + pan_, size};
}

glm::dvec2 SliceView::toPicture(const QPointF& position) const {
    const QRectF rect = pictureRect();
    const glm::ivec3 size = volume_.geometry().size;
    return {(position.x() - rect.left()) / rect.width() * size[plane_.u],
            (position.y() - rect.top()) / rect.height() * size[plane_.v]};
}

QPointF SliceView::toWidget(const glm::dvec2& picture) const {
    const QRectF rect = pictureRect();
    const glm::ivec3 size = volume_.geometry().size;
    return {rect.left() + picture.x / size[plane_.u] * rect.width(),
            rect.top() + picture.y / size[plane_.v] * rect.height()};
}

void SliceView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!volume_.empty()) {
        if (image_.isNull()) image_ = slice_image(volume_, plane_, index(), window_, overlay_);
        const QRectF target = pictureRect();
        // Up close the voxels themselves are of interest, so they are not blurred away.
        const bool close = target.width() / image_.width() > 12;
        painter.setRenderHint(QPainter::SmoothPixmapTransform, !close);
        painter.drawImage(target, image_);
        painter.setRenderHint(QPainter::Antialiasing);
        paintCuts(painter);
        paintCrossHair(painter);
        paintText(painter);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(hasFocus() ? theme::k_accent : theme::k_border, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void SliceView::paintCrossHair(QPainter& painter) const {
    // The lines are where the two other views lie, in their colours; the middle stays free.
    const auto color_of = [&](int axis) {
        const std::array<int, 3> grid = closest_grid_axes(volume_.geometry());
        if (axis == grid[2]) return theme::k_axial;
        return axis == grid[1] ? theme::k_coronal : theme::k_sagittal;
    };
    const QRectF rect = pictureRect();
    const QPointF at = toWidget(plane_.to_picture(glm::dvec3(voxel_), volume_.geometry().size));
    const double gap = 7;
    QColor vertical = color_of(plane_.u), horizontal = color_of(plane_.v);
    vertical.setAlpha(190), horizontal.setAlpha(190);
    painter.setPen(QPen(vertical, 1));
    painter.drawLine(QPointF(at.x(), rect.top()), QPointF(at.x(), std::max(rect.top(), at.y() - gap)));
    painter.drawLine(QPointF(at.x(), std::min(rect.bottom(), at.y() + gap)), QPointF(at.x(), rect.bottom()));
    painter.setPen(QPen(horizontal, 1));
    painter.drawLine(QPointF(rect.left(), at.y()), QPointF(std::max(rect.left(), at.x() - gap), at.y()));
    painter.drawLine(QPointF(std::min(rect.right(), at.x() + gap), at.y()), QPointF(rect.right(), at.y()));
}

void SliceView::paintCuts(QPainter& painter) const {
    const GridGeometry& geometry = volume_.geometry();
    const glm::dvec3 corner[4] = {
        plane_.to_voxel({0, 0}, index(), geometry.size),
        plane_.to_voxel({geometry.size[plane_.u], 0}, index(), geometry.size),
        plane_.to_voxel(glm::dvec2(geometry.size[plane_.u], geometry.size[plane_.v]), index(), geometry.size),
        plane_.to_voxel({0, geometry.size[plane_.v]}, index(), geometry.size)};
    painter.setPen(QPen(theme::k_volume, 1, Qt::DashLine));
    for (const CuttingPlane& cut : cuts_) {
        std::vector<QPointF> ends;  // where the plane crosses the picture's border
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 a = geometry.voxel_to_mm(corner[i]), b = geometry.voxel_to_mm(corner[(i + 1) % 4]);
            const double da = glm::dot(cut.normal, a) + cut.offset, db = glm::dot(cut.normal, b) + cut.offset;
            if ((da < 0) == (db < 0)) continue;
            const glm::dvec3 voxel = glm::mix(corner[i], corner[(i + 1) % 4], da / (da - db));
            ends.push_back(toWidget(plane_.to_picture(voxel, geometry.size)));
        }
        if (ends.size() == 2) painter.drawLine(ends[0], ends[1]);
    }
}

void SliceView::paintText(QPainter& painter) const {
    const auto text = [&](const QRect& where, int flags, const QString& words, const QColor& ink) {
        painter.setPen(QColor(0, 0, 0, 200));
        painter.drawText(where.translated(1, 1), flags, words);
        painter.setPen(ink);
        painter.drawText(where, flags, words);
    };
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.9);
    const QRect inner = rect().adjusted(6, 4, -6, -4);
    painter.setFont(small);
    text(inner, Qt::AlignLeft | Qt::AlignTop, title_of(kind_), color());
    text(inner, Qt::AlignLeft | Qt::AlignBottom, tr("%1 / %2").arg(index() + 1).arg(volume_.geometry().size[plane_.w]),
         theme::k_text);
    text(inner, Qt::AlignRight | Qt::AlignBottom,
         tr("L %1  W %2").arg(0.5 * (window_.lo + window_.hi), 0, 'g', 5).arg(window_.width(), 0, 'g', 5),
         theme::k_text);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const QColor ink(250, 225, 150);
    text(inner, Qt::AlignLeft | Qt::AlignVCenter, QString(QLatin1Char(plane_.left)), ink);
    text(inner, Qt::AlignRight | Qt::AlignVCenter, QString(QLatin1Char(plane_.right)), ink);
    text(inner, Qt::AlignHCenter | Qt::AlignTop, QString(QLatin1Char(plane_.top)), ink);
    text(inner, Qt::AlignHCenter | Qt::AlignBottom, QString(QLatin1Char(plane_.bottom)), ink);
}

void SliceView::moveCursorTo(const QPointF& position) {
    const GridGeometry& geometry = volume_.geometry();
    const glm::dvec3 voxel = plane_.to_voxel(toPicture(position), index(), geometry.size);
    const glm::dvec3 inside = glm::clamp(glm::round(voxel), glm::dvec3(0), glm::dvec3(geometry.size - 1));
    Q_EMIT cursorMoved(geometry.voxel_to_mm(inside));
}

void SliceView::moveCursorBy(int axis, int voxels) {
    glm::ivec3 voxel = voxel_;
    voxel[axis] = std::clamp(voxel[axis] + voxels, 0, volume_.geometry().size[axis] - 1);
    Q_EMIT cursorMoved(volume_.geometry().voxel_to_mm(glm::dvec3(voxel)));
}

void SliceView::turnPages(int pages) { moveCursorBy(plane_.w, pages); }

void SliceView::windowBy(double width_share, double level_share) {
    const double width = std::max(window_.width() * std::exp(width_share), 1e-6);
    const double level = 0.5 * (window_.lo + window_.hi) + level_share * window_.width();
    Q_EMIT windowEdited({level - 0.5 * width, level + 0.5 * width});
}

void SliceView::zoomBy(double factor) {
    const double zoom = std::clamp(zoom_ * factor, 0.2, 60.0);
    pan_ *= zoom / zoom_;
    zoom_ = zoom;
    update();
}

void SliceView::hover(const QPointF& position) {
    const glm::ivec3 size = volume_.geometry().size;
    const glm::dvec3 voxel = glm::round(plane_.to_voxel(toPicture(position), index(), size));
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
    if (event->button() == Qt::LeftButton) moveCursorTo(event->position());
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    if (volume_.empty()) return;
    const QPointF moved = event->position() - drag_from_;
    if (event->buttons() & Qt::LeftButton) moveCursorTo(event->position());
    if (event->buttons() & Qt::MiddleButton) {
        pan_ += moved;
        update();
    }
    if (event->buttons() & Qt::RightButton) windowBy(moved.x() / 150, moved.y() / 300);
    drag_from_ = event->position();
    hover(event->position());
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
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

void SliceView::keyPressEvent(QKeyEvent* event) {
    if (volume_.empty()) return QWidget::keyPressEvent(event);
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    switch (event->key()) {
        case Qt::Key_Left:
            return shift ? windowBy(-0.08, 0) : moveCursorBy(plane_.u, plane_.flip_u ? 1 : -1);
        case Qt::Key_Right:
            return shift ? windowBy(0.08, 0) : moveCursorBy(plane_.u, plane_.flip_u ? -1 : 1);
        case Qt::Key_Up:
            return shift ? windowBy(0, -0.04) : moveCursorBy(plane_.v, plane_.flip_v ? 1 : -1);
        case Qt::Key_Down:
            return shift ? windowBy(0, 0.04) : moveCursorBy(plane_.v, plane_.flip_v ? -1 : 1);
        case Qt::Key_PageUp:
            return turnPages(1);
        case Qt::Key_PageDown:
            return turnPages(-1);
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoomBy(1.2);
        case Qt::Key_Minus:
            return zoomBy(1 / 1.2);
        case Qt::Key_Home:
            return resetView();
        case Qt::Key_Return:
        case Qt::Key_Enter:
            Q_EMIT maximizeRequested();
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void SliceView::leaveEvent(QEvent*) { Q_EMIT left(); }
void SliceView::focusInEvent(QFocusEvent*) { update(); }
void SliceView::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
