#pragma once

#include <QPoint>
#include <QWidget>
#include <vector>

#include "core/render/scene.h"
#include "ui/views/slice_image.h"

namespace lacuna::ui {

/// One slice of a volume with the linked cross-hair. Left drag sets the cross-hair, the wheel turns the pages, right
/// drag changes window and level, middle drag pans, Ctrl+wheel zooms. Keys: arrows move the cross-hair, Page Up/Down
/// turn the pages, Shift+arrows change window and level, + and - zoom, Home shows all.
class SliceView final : public QWidget {
    Q_OBJECT
public:
    explicit SliceView(SliceKind kind, QWidget* parent = nullptr);

    void setVolume(const lacuna::Volume& volume);
    void setCursor3d(const glm::dvec3& mm);
    void setWindow(lacuna::ValueRange window);
    void setOverlay(const SliceOverlay& overlay);
    void setCuts(const std::vector<lacuna::CuttingPlane>& cuts);
    const SlicePlane& plane() const { return plane_; }
    int index() const { return voxel_[plane_.w]; }
    QSize sizeHint() const override { return {360, 300}; }

public Q_SLOTS:
    void resetView();

Q_SIGNALS:
    void cursorMoved(const glm::dvec3& mm);
    void windowEdited(lacuna::ValueRange window);
    void hovered(const glm::ivec3& voxel);  ///< the voxel under the mouse, always inside the grid
    void left();                            ///< the mouse is over no voxel
    void maximizeRequested();

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void leaveEvent(QEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    QRectF pictureRect() const;  ///< where the slice lies in the widget, aspect ratio in mm kept
    glm::dvec2 toPicture(const QPointF& position) const;
    QPointF toWidget(const glm::dvec2& picture) const;
    void moveCursorTo(const QPointF& position);
    void moveCursorBy(int axis, int voxels);
    void turnPages(int pages);
    void windowBy(double width_share, double level_share);
    void zoomBy(double factor);
    void hover(const QPointF& position);
    void paintCrossHair(QPainter& painter) const;
    void paintCuts(QPainter& painter) const;
    void paintText(QPainter& painter) const;
    QColor color() const;

    SliceKind kind_;
    Volume volume_;
    SlicePlane plane_;
    glm::ivec3 voxel_{0};
    ValueRange window_{0, 255};
    SliceOverlay overlay_;
    std::vector<CuttingPlane> cuts_;
    QImage image_;  ///< null: to be made at the next paint
    double zoom_ = 1;
    QPointF pan_;  ///< of the picture's middle from the widget's, pixels
    QPointF drag_from_;
    int wheel_rest_ = 0;
};

}  // namespace lacuna::ui
