#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <vector>

#include "core/session/measurement.h"
#include "ui/views/slice_tool.h"

namespace lacuna::ui {

/// Measurements in the slice views: draws those that lie in a view's plane, lets handles and whole shapes be dragged,
/// and makes new ones with a chosen kind: press and drag, or click point by point; from the keyboard Space sets a point
/// at the cross-hair. Delete removes the selected one; Escape leaves the one begun, then the kind, then the selection.
/// One tool serves all views. Values in, edits out: nothing changes until setMeasurements().
class SliceMeasure final : public QObject, public SliceTool {
    Q_OBJECT
public:
    explicit SliceMeasure(QObject* parent = nullptr) : QObject(parent) {}

    void setVolume(const lacuna::Volume& volume);
    void setMeasurements(const std::vector<Measurement>& measurements);
    const std::vector<Measurement>& measurements() const { return all_; }
    /// The kind drawn next; none: the mouse sets the cross-hair.
    void setKind(std::optional<MeasurementKind> kind);
    std::optional<MeasurementKind> kind() const { return kind_; }
    void select(std::uint32_t id);
    std::uint32_t selected() const { return selected_; }
    void removeSelected();
    /// Of a shape's pixels; kept until it or the volume changes.
    const RegionStatistics& statistics(const Measurement& m) const;
    /// What stands beside it: "12.34 mm", "45.0°", "40.2 ± 9.1 HU", ...
    QStringList words(const Measurement& m) const;

    /// What is written beside the measurements a view shows, each in a place of its own.
    struct Label {
        QString text;
        QRectF where;
        bool chosen = false;
    };
    std::vector<Label> labels(const SliceView& view, const QFontMetrics& metrics) const;

    bool press(SliceView& view, const QMouseEvent& event) override;
    bool move(SliceView& view, const QMouseEvent& event) override;
    bool release(SliceView& view, const QMouseEvent& event) override;
    bool doubleClick(SliceView& view, const QMouseEvent& event) override;
    bool key(SliceView& view, const QKeyEvent& event) override;
    void leave(SliceView& view) override;
    void paint(const SliceView& view, QPainter& painter) const override;

Q_SIGNALS:
    void edited(const QString& name, const std::vector<lacuna::Measurement>& next);
    void selectedChanged(std::uint32_t id);
    void kindChanged();
    void repaintNeeded();

private:
    /// A measurement being drawn: its last point follows the mouse.
    struct Draft {
        Measurement measurement;
        const SliceView* view;
        QPointF pressed_at;
    };
    /// A handle (index of handles_of()) or, with -1, the whole being dragged.
    struct Drag {
        Measurement before;
        int handle;
        glm::dvec3 from_mm;
    };
    struct Hit {
        std::uint32_t id = 0;
        int handle = -1;
    };
    Hit hitAt(const SliceView& view, const QPointF& position) const;
    bool showsIn(const Measurement& m, const SliceView& view) const;
    void setPoint(SliceView& view, const glm::dvec3& mm, const QPointF& at);
    void finish();
    void dragTo(const glm::dvec3& mm);
    bool escape();
    void paintOne(const Measurement& m, const SliceView& view, QPainter& painter, bool chosen) const;

    Volume volume_;
    std::vector<Measurement> all_;
    std::optional<MeasurementKind> kind_;
    std::optional<Draft> draft_;
    std::optional<Drag> drag_;
    std::uint32_t selected_ = 0;
    mutable std::map<std::uint32_t, std::pair<Measurement, RegionStatistics>> statistics_;
};

/// The place nearest to `wanted`, moved up or down within a view, that covers none of those taken; `wanted`, within the
/// view, where there is none.
QRectF free_place(QRectF wanted, const std::vector<QRectF>& taken, const QSizeF& view);

/// Where a measurement can be taken hold of: its points, and of a shape the two other corners of its box as well.
std::vector<glm::dvec3> handles_of(const Measurement& m);
/// The measurement with one handle elsewhere; the corner opposite stays where it is.
Measurement with_handle(Measurement m, int handle, const glm::dvec3& mm);

/// "Distance", "Angle", "Rectangle", "Ellipse" in the person's language.
QString measurement_title(MeasurementKind kind);

}  // namespace lacuna::ui
