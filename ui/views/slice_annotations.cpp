#include "ui/views/slice_annotations.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/axis_words.h"
#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {

const QColor k_side_ink(250, 225, 150);

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SliceAnnotations)
};

QFont sized(const QFont& font, double factor, bool bold = false) {
    QFont out = font;
    out.setPointSizeF(font.pointSizeF() * factor);
    out.setBold(bold);
    return out;
}

/// Lines in a corner, from the edge inwards: as many as `most`, each cut to the width.
void draw_lines(QPainter& painter, const QRect& inner, Qt::Alignment corner, const QStringList& lines, int most,
                int first_line = 0) {
    const QFontMetrics metrics(painter.font());
    const bool at_foot = corner & Qt::AlignBottom;
    const int count = std::min(int(lines.size()), most);
    for (int i = 0; i < count; ++i) {
        const int row = at_foot ? count - 1 - i : i + first_line;
        const QRect where = at_foot ? inner.adjusted(0, 0, 0, -row * metrics.height())
                                    : inner.adjusted(0, row * metrics.height(), 0, 0);
        draw_words(painter, where, corner, metrics.elidedText(lines[i], Qt::ElideRight, inner.width() * 9 / 20),
                   theme::k_text);
    }
}

void paint_sides(QPainter& painter, const QRect& inner, const SlicePose& pose, int foot) {
    const auto text = [](const std::string& letters) { return QString::fromStdString(letters); };
    draw_words(painter, inner, Qt::AlignLeft | Qt::AlignVCenter, text(pose.left), k_side_ink);
    draw_words(painter, inner, Qt::AlignRight | Qt::AlignVCenter, text(pose.right), k_side_ink);
    draw_words(painter, inner, Qt::AlignHCenter | Qt::AlignTop, text(pose.top), k_side_ink);
    draw_words(painter, inner.adjusted(0, 0, 0, -foot), Qt::AlignHCenter | Qt::AlignBottom, text(pose.bottom),
               k_side_ink);
}

/// A bar with end ticks along the foot of the view; returns the height it takes.
int paint_scale(QPainter& painter, const QRect& inner, double pixels_per_mm) {
    if (inner.width() < 220 || inner.height() < 120) return 0;
    const ScaleLength length = scale_length(0.22 * inner.width() / pixels_per_mm);
    const double width = length.mm * pixels_per_mm, middle = inner.center().x(), y = inner.bottom() - 3.5;
    const QFontMetrics metrics(painter.font());
    for (const bool shadow : {true, false}) {
        painter.setPen(QPen(shadow ? QColor(0, 0, 0, 200) : theme::k_text, shadow ? 3.4 : 1.4));
        const QPointF a(middle - 0.5 * width, y), b(middle + 0.5 * width, y);
        painter.drawLine(a, b);
        for (const QPointF& end : {a, b}) painter.drawLine(end - QPointF(0, 4), end + QPointF(0, 3));
    }
    draw_words(painter, QRectF(middle - 60, y - 5 - metrics.height(), 120, metrics.height()), Qt::AlignCenter,
               length.name, theme::k_text);
    return metrics.height() + 15;  // the side's letter is no part of the bar's label
}

}  // namespace

QString slice_title(SliceKind kind, AxisNames names) {
    const bool patient = names == AxisNames::patient;
    switch (kind) {
        case SliceKind::axial:
            return patient ? Words::tr("Axial") : QStringLiteral("XY");
        case SliceKind::coronal:
            return patient ? Words::tr("Coronal") : QStringLiteral("XZ");
        case SliceKind::sagittal:
            return patient ? Words::tr("Sagittal") : QStringLiteral("YZ");
    }
    return {};
}

QColor slice_color(SliceKind kind) {
    switch (kind) {
        case SliceKind::axial:
            return theme::k_axial;
        case SliceKind::coronal:
            return theme::k_coronal;
        case SliceKind::sagittal:
            return theme::k_sagittal;
    }
    return theme::k_text;
}

ScaleLength scale_length(double most_mm) {
    if (!(most_mm > 0) || !std::isfinite(most_mm)) return {1, Words::tr("%1 mm").arg(1)};
    const double power = std::pow(10.0, std::floor(std::log10(most_mm) + 1e-9));
    double mm = power;
    for (const double factor : {2.0, 5.0})
        if (factor * power <= most_mm * (1 + 1e-9)) mm = factor * power;
    if (mm >= 1000) return {mm, Words::tr("%1 m").arg(number_text(mm / 1000))};
    if (mm >= 10) return {mm, Words::tr("%1 cm").arg(number_text(mm / 10))};
    if (mm >= 0.1 * (1 - 1e-9)) return {mm, Words::tr("%1 mm").arg(number_text(mm))};
    return {mm, Words::tr("%1 µm").arg(number_text(mm * 1000))};
}

QString position_text(AxisNames names, const glm::dvec3& mm, const glm::dvec3& direction) {
    const int axis = closest_axis(direction);
    const double along = glm::dot(mm, direction) * (direction[axis] < 0 ? -1 : 1);
    return Words::tr("%1 mm").arg(coordinate_words(names, axis, along));
}

void draw_words(QPainter& painter, const QRectF& where, int flags, const QString& words, const QColor& ink) {
    // An edge all around: the words are read over bright voxels, too, and most of them are light.
    painter.setPen(QColor(0, 0, 0, 160));
    for (const double dx : {-1.0, 0.0, 1.0})
        for (const double dy : {-1.0, 0.0, 1.0})
            if (dx != 0 || dy != 0) painter.drawText(where.translated(dx, dy), flags, words);
    painter.setPen(ink);
    painter.drawText(where, flags, words);
}

void paint_notes(QPainter& painter, const QRect& view, const SlicePose& pose, const SliceNotes& notes,
                 double pixels_per_mm) {
    const QRect inner = view.adjusted(6, 4, -6, -4);
    const QFont font = painter.font();
    painter.setFont(sized(font, 0.9));
    const int line = QFontMetrics(painter.font()).height();
    // Half the height is for the picture's sides and the words at the foot.
    const int most = std::max(0, inner.height() / 2 / line - 1);
    draw_words(painter, inner, Qt::AlignLeft | Qt::AlignTop, notes.title, notes.title_color);
    draw_lines(painter, inner, Qt::AlignLeft | Qt::AlignTop, notes.patient, most, 1);
    draw_lines(painter, inner, Qt::AlignRight | Qt::AlignTop, notes.study, most);
    draw_lines(painter, inner, Qt::AlignLeft | Qt::AlignBottom, notes.position, 3);
    draw_lines(painter, inner, Qt::AlignRight | Qt::AlignBottom, notes.grey, 3);
    const int foot = paint_scale(painter, inner, pixels_per_mm);
    painter.setFont(sized(font, 1, true));
    paint_sides(painter, inner, pose, foot);
    painter.setFont(font);
}

}  // namespace lacuna::ui
