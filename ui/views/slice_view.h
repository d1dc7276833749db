#pragma once

#include <QPoint>
#include <QWidget>
#include <vector>

#include "core/render/scene.h"
#include "core/session/slice_settings.h"
#include "core/session/view_history.h"
#include "ui/views/slice_annotations.h"
#include "ui/views/slice_picture.h"
#include "ui/views/slice_plane.h"
#include "ui/views/slice_tool.h"

namespace lacuna::ui {

/// One slice of a volume with the linked cross-hair. Left drag sets the cross-hair, the wheel turns the pages, right
/// drag changes window and level, middle drag pans, Ctrl+wheel zooms. Keys: arrows move the cross-hair, Page Up/Down
/// turn the pages, Shift+arrows change window and level, + and - zoom, Home shows all. Tools come first.
class SliceView final : public QWidget {
    Q_OBJECT
public:
    explicit SliceView(SliceKind kind, QWidget* parent = nullptr);

    /// @param tables  what VoiFunction::table may mean
    void setVolume(const lacuna::Volume& volume,
                   const std::vector<std::shared_ptr<const lacuna::VoiTable>>& tables = {});
    void setCursor3d(const glm::dvec3& mm);
    void setSettings(lacuna::ValueRange window, const lacuna::SliceSettings& settings);
    void setOverlay(const SliceOverlay& overlay);
    void setCuts(const std::vector<lacuna::CuttingPlane>& cuts);
    /// Words under the title and on the other side; what a person wants to see of patient and study.
    void setCornerWords(const QStringList& patient, const QStringList& study);
    /// Corner words, letters, scale bar and cross-hair are drawn.
    void setNotesShown(bool shown);
    /// @param tool  outlives the view; asked after those added before
    void addTool(SliceTool* tool) { tools_.push_back(tool); }

    SliceKind kind() const { return kind_; }
    const Volume& volume() const { return volume_; }
    const SliceSettings& settings() const { return settings_; }
    const SlicePose& pose() const { return pose_; }
    int index() const { return pose_.index; }
    const glm::dvec3& cursorMm() const { return cursor_mm_; }
    const QStringList& patientWords() const { return patient_; }
    /// The picture shown is that of an older plane: the newest is still being sampled.
    bool waiting() const { return picture_->waiting(); }
    /// How far from the plane something still belongs to the picture: half a slice, or half the slab.
    double depthTolerance() const;

    double pixelsPerMm() const;
    glm::dvec3 toMm(const QPointF& position) const;  ///< in the plane
    QPointF toWidget(const glm::dvec3& mm) const;    ///< of the foot of the perpendicular onto the plane
    QPointF directionInWidget(const glm::dvec3& direction) const;
    lacuna::SliceZoom zoom() const { return {zoom_, {pan_.x(), pan_.y()}}; }
    void setZoom(const lacuna::SliceZoom& zoom);
    QRectF pictureRect() const;  ///< where the slice lies in the widget, its sizes in mm kept
    QSize sizeHint() const override { return {360, 300}; }

public Q_SLOTS:
    void resetView();

Q_SIGNALS:
    void cursorMoved(const glm::dvec3& mm);
    void windowEdited(lacuna::ValueRange window);
    void tiltEdited(const glm::dquat& tilt);
    void hovered(const glm::ivec3& voxel);  ///< the voxel under the mouse, always inside the grid
    void left();                            ///< the mouse is over no voxel
    void zoomChanged();                     ///< also by setZoom()
    void maximizeRequested();

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void leaveEvent(QEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    void showWindow();
    void nameView();
    void place();
    void moveCursorTo(const glm::dvec3& mm);
    void moveCursorBy(int right, int down);
    void turnPages(int pages);
    void windowBy(double width_share, double level_share);
    void zoomBy(double factor);
    void hover(const QPointF& position);
    void paintCuts(QPainter& painter) const;
    void paintNotes(QPainter& painter) const;
    bool handleKey(int key, bool shift);

    SliceKind kind_;
    Volume volume_;
    std::vector<std::shared_ptr<const VoiTable>> tables_;
    SliceSettings settings_;
    ValueRange window_{0, 255};
    SlicePose pose_;
    glm::dvec3 cursor_mm_{0};
    SlicePicture* picture_;
    std::vector<CuttingPlane> cuts_;
    std::vector<SliceTool*> tools_;
    QStringList patient_, study_;
    bool notes_shown_ = true;
    double zoom_ = 1;
    QPointF pan_;  ///< of the picture's middle from the widget's, pixels
    QPointF drag_from_;
    bool tool_drag_ = false;  ///< a tool took the press: the moves are its own
    int wheel_rest_ = 0;
};

}  // namespace lacuna::ui
