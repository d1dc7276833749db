#pragma once

#include <QPainter>
#include <QStringList>

#include "core/volume/reslice.h"
#include "core/volume/voi_window.h"
#include "ui/views/slice_plane.h"

namespace lacuna::ui {

/// Words in the corners of a slice.
struct SliceNotes {
    QString title;
    QColor title_color;
    QStringList patient, study;  ///< under the title on the left; on the right
    QStringList position, grey;  ///< at the foot, on the left and on the right
};

/// "Axial", of a part "XY".
QString slice_title(SliceKind kind, AxisNames names);
QColor slice_color(SliceKind kind);

/// A length of 1, 2 or 5 times a power of ten, mm, that is at most `most_mm` long, and its name ("5 cm", "200 µm").
struct ScaleLength {
    double mm = 1;
    QString name;
};
ScaleLength scale_length(double most_mm);

/// "H 12.50 mm", "Z -3.00 mm": how far a position lies along a direction from the origin, by the axis closest to it.
QString position_text(AxisNames names, const glm::dvec3& mm, const glm::dvec3& direction);

/// Words with a shadow, readable on any grey.
void draw_words(QPainter& painter, const QRectF& where, int flags, const QString& words, const QColor& ink);

/// Corner words, the names of the sides at the edges and the scale bar; what does not fit is left out, outermost last.
void paint_notes(QPainter& painter, const QRect& view, const SlicePose& pose, const SliceNotes& notes,
                 double pixels_per_mm);

}  // namespace lacuna::ui
