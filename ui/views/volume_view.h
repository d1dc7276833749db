#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>

#include "core/render/camera.h"

namespace lacuna::ui {

/// The 3D picture and its camera. Left drag turns (turntable: the head stays up), middle or Shift+left drag pans,
/// right drag and the wheel zoom. Keys: arrows turn, Shift+arrows pan, + and - zoom, comma and full stop roll, Home
/// resets, A P L R H F look from a side.
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
    void clear();
    QSize sizeHint() const override { return {480, 400}; }

public Q_SLOTS:
    void resetCamera();
    /// Looks at the volume from one side: 'A', 'P', 'L', 'R', 'H' or 'F'.
    void lookFrom(char side);

Q_SIGNALS:
    void cameraEdited(const lacuna::Camera& camera);
    void resized(QSize pixels);
    void maximizeRequested();

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
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

    std::optional<GridGeometry> geometry_;
    Camera camera_, home_;
    QImage image_;
    QString caption_;
    bool plain_background_ = false;
    QPointF drag_from_;
};

}  // namespace lacuna::ui
