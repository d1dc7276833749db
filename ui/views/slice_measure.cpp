#include "ui/views/slice_measure.h"

#include <algorithm>
#include <cmath>

#include "ui/number_text.h"
#include "ui/views/slice_view.h"

namespace lacuna::ui {

namespace {

constexpr double k_reach = 7;         ///< pixels from which a handle or a line is taken hold of
constexpr double k_click_travel = 5;  ///< less between press and release is a click, not a drag

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

double distance_to_line(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double length2 = QPointF::dotProduct(along, along);
    const double t = length2 > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / length2, 0.0, 1.0) : 0;
    return distance(p, a + t * along);
}

/// The lines to be grabbed, as they are drawn in a view.
std::vector<QPointF> outline(const Measurement& m, const SliceView& view) {
    std::vector<QPointF> points;
    if (!m.is_region()) {
        for (const glm::dvec3& p : m.points_mm) points.push_back(view.toWidget(p));
        return points;
    }
    const glm::dvec3 across = m.right * glm::dot(m.points_mm[1] - m.points_mm[0], m.right);
    const glm::dvec3 down = m.down * glm::dot(m.points_mm[1] - m.points_mm[0], m.down);
    if (m.kind == MeasurementKind::rectangle) {
        for (const glm::dvec3& off : {glm::dvec3(0), across, across + down, down, glm::dvec3(0)})
            points.push_back(view.toWidget(m.points_mm[0] + off));
        return points;
    }
    const glm::dvec3 middle = m.points_mm[0] + 0.5 * (across + down);
    constexpr int k_corners = 72;
    for (int i = 0; i <= k_corners; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / k_corners;
        points.push_back(view.toWidget(middle + 0.5 * std::cos(angle) * across + 0.5 * std::sin(angle) * down));
    }
    return points;
}

QColor ink_of(bool chosen) { return chosen ? QColor(255, 214, 90) : QColor(120, 226, 236); }

}  // namespace

QRectF free_place(QRectF wanted, const std::vector<QRectF>& taken, const QSizeF& view) {
    constexpr double k_margin = 4;
    wanted.moveRight(std::min(wanted.right(), view.width() - k_margin));
    wanted.moveBottom(std::min(wanted.bottom(), view.height() - k_margin));
    const auto in_the_way = [&](const QRectF& place) {
        return std::find_if(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(place); });
    };
    // Below what is in the way, else above it. Each step passes one of them, so that this ends.
    for (const bool down : {true, false}) {
        QRectF place = wanted;
        for (auto other = in_the_way(place); other != taken.end(); other = in_the_way(place))
            if (down)
                place.moveTop(other->bottom() + 1);
            else
                place.moveBottom(other->top() - 1);
        if (place.top() >= k_margin && place.bottom() <= view.height() - k_margin) return place;
    }
    return wanted;
}

QString measurement_title(MeasurementKind kind) {
    switch (kind) {
        case MeasurementKind::distance:
            return SliceMeasure::tr("Distance");
        case MeasurementKind::angle:
            return SliceMeasure::tr("Angle");
        case MeasurementKind::rectangle:
            return SliceMeasure::tr("Rectangle");
        case MeasurementKind::ellipse:
            return SliceMeasure::tr("Ellipse");
    }
    return {};
}

std::vector<glm::dvec3> handles_of(const Measurement& m) {
    std::vector<glm::dvec3> points = m.points_mm;
    if (m.is_region()) {
        const glm::dvec3 across = m.right * glm::dot(m.points_mm[1] - m.points_mm[0], m.right);
        points.push_back(m.points_mm[0] + across);
        points.push_back(m.points_mm[1] - across);
    }
    return points;
}

Measurement with_handle(Measurement m, int handle, const glm::dvec3& mm) {
    if (handle < int(m.points_mm.size())) {
        m.points_mm[std::size_t(handle)] = mm;
        return m;
    }
    // One of the two other corners: the opposite one is the other of them.
    const std::vector<glm::dvec3> corners = handles_of(m);
    const glm::dvec3 opposite = corners[handle == 2 ? 3 : 2];
    const glm::dvec3 across = m.right * glm::dot(mm - opposite, m.right);
    m.points_mm = {opposite + across, mm - across};
    return m;
}

void SliceMeasure::setVolume(const Volume& volume) {
    volume_ = volume;
    statistics_.clear();
    draft_.reset();
    drag_.reset();
    select(0);
}

void SliceMeasure::setMeasurements(const std::vector<Measurement>& measurements) {
    if (measurements == all_) return;
    all_ = measurements;
    const auto known = [this](std::uint32_t id) {
        return std::any_of(all_.begin(), all_.end(), [id](const Measurement& m) { return m.id == id; });
    };
    std::erase_if(statistics_, [&](const auto& entry) { return !known(entry.first); });
    if (selected_ != 0 && !known(selected_)) select(0);
    Q_EMIT repaintNeeded();
}

void SliceMeasure::setKind(std::optional<MeasurementKind> kind) {
    if (kind == kind_) return;
    kind_ = kind;
    draft_.reset();
    Q_EMIT kindChanged();
    Q_EMIT repaintNeeded();
}

void SliceMeasure::select(std::uint32_t id) {
    if (id == selected_) return;
    selected_ = id;
    Q_EMIT selectedChanged(id);
    Q_EMIT repaintNeeded();
}

void SliceMeasure::removeSelected() {
    if (selected_ == 0) return;
    std::vector<Measurement> next = all_;
    std::erase_if(next, [this](const Measurement& m) { return m.id == selected_; });
    Q_EMIT edited(tr("Remove measurement %1").arg(selected_), next);
}

const RegionStatistics& SliceMeasure::statistics(const Measurement& m) const {
    auto found = statistics_.find(m.id);
    if (found == statistics_.end() || !(found->second.first == m))
        found = statistics_.insert_or_assign(m.id, std::pair{m, region_statistics(volume_, m)}).first;
    return found->second.second;
}

QStringList SliceMeasure::words(const Measurement& m) const {
    const auto number = [](double value) { return number_text(value, 'g', 5); };
    if (int(m.points_mm.size()) < point_count(m.kind)) return {};  // being drawn
    switch (m.kind) {
        case MeasurementKind::distance:
            return {tr("%1 mm").arg(number_text(length_mm(m), 'f', length_mm(m) < 1 ? 4 : 2))};
        case MeasurementKind::angle:
            return {tr("%1°").arg(number_text(angle_deg(m), 'f', 1))};
        case MeasurementKind::rectangle:
        case MeasurementKind::ellipse:
            break;
    }
    const RegionStatistics& s = statistics(m);
    const QString area = tr("%1 mm² · %2 px").arg(number(area_mm2(m))).arg(s.pixels);
    if (s.pixels == 0) return {area};
    const QString unit = volume_.unit.empty() ? QString() : QLatin1Char(' ') + QString::fromStdString(volume_.unit);
    return {tr("Mean %1 ± %2%3").arg(number(s.mean), number(s.stddev), unit),
            tr("%1 to %2").arg(number(s.min), number(s.max)), area};
}

bool SliceMeasure::showsIn(const Measurement& m, const SliceView& view) const {
    return lies_in(m, view.pose().frame, view.depthTolerance());
}

SliceMeasure::Hit SliceMeasure::hitAt(const SliceView& view, const QPointF& position) const {
    // Handles first, those of the selected measurement before all others.
    std::vector<const Measurement*> shown;
    for (const Measurement& m : all_)
        if (showsIn(m, view)) shown.insert(m.id == selected_ ? shown.begin() : shown.end(), &m);
    for (const Measurement* m : shown) {
        const auto handles = handles_of(*m);
        for (std::size_t i = 0; i < handles.size(); ++i)
            if (distance(view.toWidget(handles[i]), position) <= k_reach) return {m->id, int(i)};
    }
    for (const Measurement* m : shown) {
        const auto points = outline(*m, view);
        for (std::size_t i = 1; i < points.size(); ++i)
            if (distance_to_line(position, points[i - 1], points[i]) <= k_reach) return {m->id, -1};
    }
    return {};
}

void SliceMeasure::setPoint(SliceView& view, const glm::dvec3& mm, const QPointF& at) {
    // One begun in another view or on another page has no end here.
    if (!draft_ || draft_->view != &view || !lies_in(draft_->measurement, view.pose().frame, 1e-6)) {
        Measurement m;
        m.id = next_measurement_id(all_);
        m.kind = *kind_;
        m.points_mm = {mm, mm};
        m.right = view.pose().frame.right;
        m.down = view.pose().frame.down;
        draft_ = Draft{std::move(m), &view, at};
        return;
    }
    std::vector<glm::dvec3>& points = draft_->measurement.points_mm;
    points.back() = mm;
    if (int(points.size()) == point_count(draft_->measurement.kind))
        finish();
    else
        points.push_back(mm);
}

void SliceMeasure::finish() {
    const Measurement m = draft_->measurement;
    draft_.reset();
    const glm::dvec3 span = m.points_mm.back() - m.points_mm.front();
    const bool flat = m.is_region() && (glm::dot(span, m.right) == 0 || glm::dot(span, m.down) == 0);
    if (flat || (m.kind == MeasurementKind::distance && span == glm::dvec3(0))) return;
    std::vector<Measurement> next = all_;
    next.push_back(m);
    // Numbered, so that two made in quick succession are two steps of undo.
    Q_EMIT edited(tr("Measurement %1").arg(m.id), next);
    select(m.id);
}

bool SliceMeasure::press(SliceView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const glm::dvec3 mm = view.toMm(event.position());
    if (kind_) {
        setPoint(view, mm, event.position());
        Q_EMIT repaintNeeded();
        return true;
    }
    if (event.modifiers() & Qt::ShiftModifier) return false;
    const Hit hit = hitAt(view, event.position());
    select(hit.id);
    if (hit.id == 0) return false;
    const auto m = std::find_if(all_.begin(), all_.end(), [&](const Measurement& each) { return each.id == hit.id; });
    drag_ = Drag{*m, hit.handle, mm};
    return true;
}

void SliceMeasure::dragTo(const glm::dvec3& mm) {
    Measurement moved = drag_->before;
    if (drag_->handle >= 0) {
        // Within its own plane, which may lie a little before or behind the view's.
        const glm::dvec3 start = handles_of(moved)[std::size_t(drag_->handle)];
        const glm::dvec3 off = mm - drag_->from_mm;
        moved = with_handle(moved, drag_->handle, start + off);
    } else {
        for (glm::dvec3& point : moved.points_mm) point += mm - drag_->from_mm;
    }
    std::vector<Measurement> next = all_;
    for (Measurement& m : next)
        if (m.id == moved.id) m = moved;
    Q_EMIT edited(tr("Move measurement %1").arg(moved.id), next);
}

bool SliceMeasure::move(SliceView& view, const QMouseEvent& event) {
    const bool held = event.buttons() & Qt::LeftButton;
    if (drag_ && held) {
        dragTo(view.toMm(event.position()));
        return true;
    }
    if (draft_ && draft_->view == &view &&
        std::abs(view.pose().frame.depth_mm(draft_->measurement.points_mm[0])) < 1e-6) {
        draft_->measurement.points_mm.back() = view.toMm(event.position());
        Q_EMIT repaintNeeded();
        return true;
    }
    if (kind_) {
        if (event.buttons() == Qt::NoButton) view.setCursor(Qt::CrossCursor);
        return held || event.buttons() == Qt::NoButton;
    }
    if (event.buttons() != Qt::NoButton) return false;
    const Hit hit = hitAt(view, event.position());
    if (hit.id == 0) return false;
    view.setCursor(hit.handle >= 0 ? Qt::PointingHandCursor : Qt::SizeAllCursor);
    return true;
}

bool SliceMeasure::release(SliceView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    if (drag_) {
        drag_.reset();
        return true;
    }
    if (!draft_ || draft_->view != &view) return kind_.has_value();
    if (distance(event.position(), draft_->pressed_at) > k_click_travel && draft_->measurement.points_mm.size() == 2)
        setPoint(view, view.toMm(event.position()), event.position());
    Q_EMIT repaintNeeded();
    return true;
}

bool SliceMeasure::doubleClick(SliceView& view, const QMouseEvent& event) {
    if (!kind_) return hitAt(view, event.position()).id != 0;
    return press(view, event);  // the second of two quick clicks
}

bool SliceMeasure::escape() {
    if (draft_)
        draft_.reset();
    else if (kind_)
        setKind(std::nullopt);
    else if (selected_ != 0)
        select(0);
    else
        return false;
    Q_EMIT repaintNeeded();
    return true;
}

bool SliceMeasure::key(SliceView& view, const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Space: {
            if (!kind_) return false;
            const glm::dvec3 off = view.pose().frame.normal() * view.pose().frame.depth_mm(view.cursorMm());
            setPoint(view, view.cursorMm() - off, view.toWidget(view.cursorMm()));
            Q_EMIT repaintNeeded();
            return true;
        }
        case Qt::Key_Escape:
            return escape();
        default:
            return false;
    }
}

void SliceMeasure::leave(SliceView&) {}

void SliceMeasure::paintOne(const Measurement& m, const SliceView& view, QPainter& painter, bool chosen) const {
    const QColor ink = ink_of(chosen);
    const std::vector<QPointF> points = outline(m, view);
    for (const bool shadow : {true, false}) {
        painter.setPen(shadow ? QPen(QColor(0, 0, 0, 170), 3.2) : QPen(ink, 1.5));
        painter.drawPolyline(points.data(), int(points.size()));
    }
    painter.setBrush(chosen ? ink : QColor(0, 0, 0, 120));
    painter.setPen(QPen(ink, 1.2));
    if (chosen || !m.is_region())
        for (const glm::dvec3& handle : handles_of(m)) painter.drawEllipse(view.toWidget(handle), 3, 3);
    painter.setBrush(Qt::NoBrush);
}

std::vector<SliceMeasure::Label> SliceMeasure::labels(const SliceView& view, const QFontMetrics& metrics) const {
    std::vector<Label> all;
    if (volume_.empty()) return all;
    std::vector<QRectF> taken;
    const auto add = [&](const Measurement& m, bool chosen) {
        if (!showsIn(m, view)) return;
        const QStringList lines = words(m);
        if (lines.isEmpty()) return;
        QRectF box;
        for (const glm::dvec3& handle : handles_of(m)) box = box.united(QRectF(view.toWidget(handle), QSizeF(1, 1)));
        // Beside the lower right end, an angle's by its vertex.
        const QPointF anchor = m.kind == MeasurementKind::angle ? view.toWidget(m.points_mm[1]) : box.bottomRight();
        int wide = 0;
        for (const QString& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line));
        const QRectF wanted(anchor + QPointF(8, 2), QSizeF(wide + 8, metrics.height() * lines.size() + 4));
        taken.push_back(free_place(wanted, taken, view.size()));
        all.push_back({lines.join(QLatin1Char('\n')), taken.back(), chosen});
    };
    for (const Measurement& m : all_) add(m, m.id == selected_);
    if (draft_ && draft_->view == &view) add(draft_->measurement, true);
    return all;
}

void SliceMeasure::paint(const SliceView& view, QPainter& painter) const {
    if (volume_.empty()) return;
    for (const Measurement& m : all_)
        if (showsIn(m, view)) paintOne(m, view, painter, m.id == selected_);
    if (draft_ && draft_->view == &view && showsIn(draft_->measurement, view))
        paintOne(draft_->measurement, view, painter, true);
    for (const Label& label : labels(view, QFontMetrics(painter.font()))) {
        painter.fillRect(label.where, QColor(0, 0, 0, 180));
        painter.setPen(ink_of(label.chosen));
        painter.drawText(label.where.adjusted(4, 2, -4, -2), Qt::AlignLeft | Qt::AlignTop, label.text);
    }
}

}  // namespace lacuna::ui
