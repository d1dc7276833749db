#include "ui/views/volume_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/volume/axis_names.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {
constexpr double k_degrees_per_pixel = 0.4, k_degrees_per_key = 5, k_pixels_per_key = 20;
}

VolumeView::VolumeView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(120, 100);
    setMouseTracking(true);
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(
        tr("Arrow keys turn the volume, Shift and arrow keys move it, plus and minus zoom, Home resets; A, P, L, R, H "
           "and F look from a side."));
}

QSize VolumeView::pixelSize() const {
    const double ratio = devicePixelRatioF();
    return {std::max(1, int(std::lround(width() * ratio))), std::max(1, int(std::lround(height() * ratio)))};
}

void VolumeView::setGeometry3d(const GridGeometry& geometry) {
    geometry_ = geometry;
    image_ = {};
    update();
}

void VolumeView::setCamera(const Camera& camera) {
    if (camera == camera_) return;
    camera_ = camera;
    update();
}

void VolumeView::setImage(const QImage& image) {
    image_ = image;
    update();
}

void VolumeView::setCaption(const QString& text) {
    caption_ = text;
    update();
}

void VolumeView::setPlainBackground(bool plain) {
    plain_background_ = plain;
    update();
}

void VolumeView::setOrthographic(bool always) {
    orthographic_ = always;
    update();
}

ViewRays VolumeView::rays() const {
    Camera camera = camera_;
    if (orthographic_) camera.fov_deg.reset();
    return resolve(camera, *geometry_, {std::max(1, width()), std::max(1, height())});
}

void VolumeView::edit(const Camera& camera) {
    if (!geometry_ || camera == camera_) return;
    camera_ = camera;
    update();
    Q_EMIT cameraEdited(camera_);
}

void VolumeView::rotate(double azimuth_deg, double elevation_deg, double roll_deg) {
    Camera camera = camera_;
    camera.azimuth_deg = std::remainder(camera.azimuth_deg + azimuth_deg, 360.0);
    camera.elevation_deg = std::clamp(camera.elevation_deg + elevation_deg, -90.0, 90.0);
    camera.roll_deg = std::remainder(camera.roll_deg + roll_deg, 360.0);
    edit(camera);
}

void VolumeView::pan(double right_px, double down_px) {
    if (!geometry_) return;
    const ViewRays rays = this->rays();
    Camera camera = camera_;
    camera.center_mm = rays.target - rays.right * (right_px * rays.pixel_mm) + rays.up * (down_px * rays.pixel_mm);
    edit(camera);
}

void VolumeView::zoom(double factor) {
    Camera camera = camera_;
    camera.zoom = std::clamp(camera.zoom * factor, 0.1, 100.0);
    edit(camera);
}

void VolumeView::resetCamera() {
    Camera camera = home_;
    camera.fov_deg = camera_.fov_deg;
    edit(camera);
}

void VolumeView::lookFrom(char side) {
    Camera camera = camera_;
    camera.roll_deg = 0;
    camera.elevation_deg = side == 'H' ? 90 : side == 'F' ? -90 : 0;
    camera.azimuth_deg = side == 'L' ? 90 : side == 'P' ? 180 : side == 'R' ? -90 : 0;
    edit(camera);
}

void VolumeView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (plain_background_) {
        painter.fillRect(rect(), Qt::black);
    } else {
        QLinearGradient sky(0, 0, 0, height());
        sky.setColorAt(0, QColor(44, 50, 60));
        sky.setColorAt(1, QColor(14, 15, 18));
        painter.fillRect(rect(), sky);
    }
    if (!image_.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != pixelSize());
        painter.drawImage(QRectF(rect()), image_);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (geometry_)
        for (const ViewTool* tool : tools_) tool->paint(painter, rays());
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.9);
    painter.setFont(small);
    painter.setPen(theme::k_volume);
    painter.drawText(rect().adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignTop, caption_);
    if (geometry_) paintAxes(painter);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(hasFocus() ? theme::k_accent : theme::k_border, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void VolumeView::paintAxes(QPainter& painter) const {
    // A small cross of the space's axes in the corner; those that point away are dimmer.
    const ViewRays rays = resolve(camera_, *geometry_, {100, 100});
    const QPointF centre(42, height() - 40.0);
    struct Arm {
        glm::dvec3 direction{0};
        QString end;
        QColor color;
    };
    constexpr double k_apart_px = 7;
    const QColor colors[] = {theme::k_sagittal, theme::k_coronal, theme::k_axial};
    std::array<Arm, 6> arms;
    for (int i = 0; i < 6; ++i) {
        Arm& arm = arms[std::size_t(i)];
        const std::string_view end = axis_end(geometry_->axis_names, i / 2, i % 2 != 0);
        arm.direction[i / 2] = i % 2 ? -1 : 1;
        arm.end = QString::fromUtf8(end.data(), qsizetype(end.size()));
        arm.color = colors[i / 2];
    }
    std::sort(arms.begin(), arms.end(), [&](const Arm& a, const Arm& b) {
        return glm::dot(a.direction, rays.forward) > glm::dot(b.direction, rays.forward);
    });
    for (const Arm& arm : arms) {
        const QPointF tip =
            centre + 20 * QPointF(glm::dot(arm.direction, rays.right), -glm::dot(arm.direction, rays.up));
        QColor ink = arm.color;
        ink.setAlpha(glm::dot(arm.direction, rays.forward) > 0.01 ? 90 : 255);
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(centre, tip);
        // Of two ends behind each other the nearer one is named: both would be read as one word.
        const bool behind = glm::dot(arm.direction, rays.forward) > 0;
        if (behind && QLineF(centre, tip).length() < k_apart_px) continue;
        const QPointF at = centre + 1.45 * (tip - centre);
        painter.drawText(QRectF(at.x() - 12, at.y() - 8, 24, 16), Qt::AlignCenter, arm.end);
    }
}

void VolumeView::resizeEvent(QResizeEvent*) { Q_EMIT resized(pixelSize()); }

glm::dvec2 VolumeView::onBall(const QPointF& at) const {
    const double radius = 0.5 * std::max(1, std::min(width(), height()));
    return {(at.x() - 0.5 * width()) / radius, (0.5 * height() - at.y()) / radius};
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
    press_at_ = drag_from_ = event->position();
    dragged_ = false;
    arcball_.reset();
    if (!geometry_ || active_) return;
    for (auto tool = tools_.rbegin(); tool != tools_.rend() && !active_; ++tool)
        if ((*tool)->press(rays(), *event)) active_ = *tool;
    if (!active_ && free_rotation_ && event->button() == Qt::LeftButton)
        arcball_.emplace(camera_, onBall(event->position()));
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
    if (active_) {
        if (event->buttons() != Qt::NoButton) return;
        std::exchange(active_, nullptr)->release();
        return;
    }
    if (std::exchange(dragged_, true) || !geometry_) return;
    if (event->button() == Qt::LeftButton) Q_EMIT clicked(event->position(), event->modifiers());
    if (event->button() == Qt::RightButton) Q_EMIT menuRequested(event->position());
}

void VolumeView::contextMenuEvent(QContextMenuEvent* event) {
    // By mouse the menu comes when the button goes up again: until then it may be a drag.
    if (event->reason() == QContextMenuEvent::Keyboard && geometry_) Q_EMIT menuRequested(QRectF(rect()).center());
    event->accept();
}

void VolumeView::hover(const QMouseEvent& event) {
    bool on_handle = false;
    for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool)
        on_handle = (*tool)->hover(rays(), event) || on_handle;
    on_handle ? setCursor(Qt::PointingHandCursor) : unsetCursor();
    Q_EMIT hovered(event.position(), event.modifiers());
}

void VolumeView::leaveEvent(QEvent*) {
    for (ViewTool* tool : tools_) tool->leave();
    Q_EMIT left();
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
    if (!geometry_) return;
    if (active_) return active_->drag(rays(), *event);
    if (event->buttons() == Qt::NoButton) return hover(*event);
    if (!dragged_ && (event->position() - press_at_).manhattanLength() < QApplication::startDragDistance()) return;
    dragged_ = true;
    const QPointF moved = event->position() - drag_from_;
    drag_from_ = event->position();
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    if ((event->buttons() & Qt::MiddleButton) || ((event->buttons() & Qt::LeftButton) && shift))
        pan(moved.x(), moved.y());
    else if (arcball_ && (event->buttons() & Qt::LeftButton))
        edit(arcball_->to(onBall(event->position())));
    else if (event->buttons() & Qt::LeftButton)
        rotate(-moved.x() * k_degrees_per_pixel, moved.y() * k_degrees_per_pixel);
    else if (event->buttons() & Qt::RightButton)
        zoom(std::exp(-moved.y() / 150));
}

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
    dragged_ = true;
    if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
    zoom(std::exp(event->angleDelta().y() / 900.0));
    event->accept();
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
    if (event->modifiers() & Qt::AltModifier) return QWidget::keyPressEvent(event);  // commands, also disabled ones
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    const double px = k_pixels_per_key, deg = k_degrees_per_key;
    switch (event->key()) {
        case Qt::Key_Left:
            return shift ? pan(-px, 0) : rotate(deg, 0);
        case Qt::Key_Right:
            return shift ? pan(px, 0) : rotate(-deg, 0);
        case Qt::Key_Up:
            return shift ? pan(0, -px) : rotate(0, -deg);
        case Qt::Key_Down:
            return shift ? pan(0, px) : rotate(0, deg);
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(1.15);
        case Qt::Key_Minus:
            return zoom(1 / 1.15);
        case Qt::Key_Comma:
            return rotate(0, 0, -deg);
        case Qt::Key_Period:
            return rotate(0, 0, deg);
        case Qt::Key_Home:
            return resetCamera();
        case Qt::Key_Return:
        case Qt::Key_Enter:
            Q_EMIT maximizeRequested();
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void VolumeView::focusInEvent(QFocusEvent*) { update(); }
void VolumeView::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
