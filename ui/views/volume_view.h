#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/session/arcball.h"
#include "ui/views/view_tool.h"

namespace lacuna::ui {

/// The 3D picture and its camera. Left drag turns (turntable: the head stays up; or freely, as a ball), middle or
/// Shift+left drag pans, right drag and the wheel zoom; tools may take the mouse before. Keys: arrows turn,
/// Shift+arrows pan, + and - zoom, comma and full stop roll, Home resets, A P L R H F look from a side.
class VolumeView final : public QWidget {
    Q_OBJECT
public:
    explicit VolumeView(QWidget* parent = nullptr);

    /// Size of the picture wanted, in device pixels.
    QSize pixelSize() const;
    void setGeometry3d(const lacuna::GridGeometry& geometry);
    void setCamera(const lacuna::Camera& camera);
    /// Where resetCamera() goes.
    void setHome(const lacuna::Camera& camera) { home_ = camera; }
    const lacuna::Camera& camera() const { return camera_; }
    /// Shows a picture of any size, scaled to the view; kept until the next.
    void setImage(const QImage& image);
    const QImage& image() const { return image_; }
    void setCaption(const QString& text);
    void setPlainBackground(bool plain);
    /// Some pictures are orthographic whatever the camera says; what is drawn over them must be, too.
    void setOrthographic(bool always);
    /// Left drag turns freely about any axis, not as a turntable.
    void setFreeRotation(bool free) { free_rotation_ = free; }
    /// Drawn over the picture, in the order added, and asked for the mouse. It must live as long as the view.
    void addTool(ViewTool* tool) { tools_.push_back(tool); }
    /// The rays of the view in logical pixels. @pre a geometry was set
    lacuna::ViewRays rays() const;
    QSize sizeHint() const override { return {480, 400}; }

public Q_SLOTS:
    void resetCamera();
    /// Looks at the volume from one side: 'A', 'P', 'L', 'R', 'H' or 'F'.
    void lookFrom(char side);

Q_SIGNALS:
    void cameraEdited(const lacuna::Camera& camera);
    void resized(QSize pixels);
    void maximizeRequested();
    /// A left click that dragged nothing.
    void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers);
    /// The mouse moves over the view without a button.
    void hovered(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void left();
    /// A right click that dragged nothing, or the menu key (then the middle is meant).
    void menuRequested(const QPointF& at);

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;
    void leaveEvent(QEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    void edit(const Camera& camera);
    void rotate(double azimuth_deg, double elevation_deg, double roll_deg = 0);
    void pan(double right_px, double down_px);
    void zoom(double factor);
    void paintAxes(QPainter& painter) const;
    void hover(const QMouseEvent& event);
    glm::dvec2 onBall(const QPointF& at) const;

    std::optional<GridGeometry> geometry_;
    Camera camera_, home_;
    QImage image_;
    QString caption_;
    bool plain_background_ = false, orthographic_ = false, free_rotation_ = false;
    QPointF press_at_, drag_from_;
    bool dragged_ = false;  ///< what began with the last press is no click
    std::vector<ViewTool*> tools_;
    ViewTool* active_ = nullptr;  ///< holds the mouse
    std::optional<Arcball> arcball_;
};

}  // namespace lacuna::ui
