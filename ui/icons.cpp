#include "ui/icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/theme.h"

namespace lacuna::ui {

namespace {

/// Draws on a field of 24 by 24: lines in one ink, what matters most in the accent's.
class Pencil {
public:
    Pencil(QPainter& painter, const QColor& ink, const QColor& accent)
        : painter_(painter), ink_(ink), accent_(accent) {}

    void line(std::initializer_list<QPointF> points, bool accent = false) {
        painter_.setPen(pen(accent));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPolyline(QPolygonF(QList<QPointF>(points)));
    }
    void closed(std::initializer_list<QPointF> points, bool accent = false) {
        painter_.setPen(pen(accent));
        painter_.setBrush(wash(accent));
        painter_.drawPolygon(QPolygonF(QList<QPointF>(points)));
    }
    void box(double x, double y, double width, double height, bool accent = false) {
        painter_.setPen(pen(accent));
        painter_.setBrush(wash(accent));
        painter_.drawRoundedRect(QRectF(x, y, width, height), 1, 1);
    }
    void circle(double x, double y, double radius, bool accent = false) {
        painter_.setPen(pen(accent));
        painter_.setBrush(wash(accent));
        painter_.drawEllipse(QPointF(x, y), radius, radius);
    }
    /// Degrees as QPainter::drawArc takes them: 0 at three o'clock, counter-clockwise.
    void arc(double x, double y, double radius, double from_deg, double span_deg, bool accent = false) {
        painter_.setPen(pen(accent));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawArc(QRectF(x - radius, y - radius, 2 * radius, 2 * radius), int(from_deg * 16),
                         int(span_deg * 16));
    }
    void letter(const QString& text) {
        QFont font = painter_.font();
        font.setPixelSize(15);
        font.setBold(true);
        painter_.setFont(font);
        painter_.setPen(accent_);
        painter_.drawText(QRectF(0, 0, 24, 24), Qt::AlignCenter, text);
    }

private:
    QPen pen(bool accent) const {
        return QPen(accent ? accent_ : ink_, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    }
    QBrush wash(bool accent) const {
        if (!accent) return Qt::NoBrush;
        QColor color = accent_;
        color.setAlpha(60);
        return color;
    }

    QPainter& painter_;
    QColor ink_, accent_;
};

void draw_document(Pencil& p, Icon icon) {
    switch (icon) {
        case Icon::folder:
            return p.closed({{3, 19}, {3, 6}, {9, 6}, {11, 8.5}, {21, 8.5}, {21, 19}}, true);
        case Icon::file:
            p.closed({{5.5, 21}, {5.5, 3}, {14, 3}, {18.5, 7.5}, {18.5, 21}});
            return p.line({{14, 3}, {14, 7.5}, {18.5, 7.5}}, true);
        case Icon::save:
            p.closed({{4, 20}, {4, 4}, {16.5, 4}, {20, 7.5}, {20, 20}});
            p.box(8, 13, 8, 7, true);
            return p.line({{8.5, 4}, {8.5, 8.5}, {14.5, 8.5}, {14.5, 4}});
        case Icon::picture:
            p.box(3, 5, 18, 14);
            p.closed({{5, 17}, {9.5, 11}, {12.5, 14.5}, {15, 12}, {19, 17}}, true);
            return p.circle(15.5, 8.7, 1.3, true);
        case Icon::undo:
            p.arc(12.5, 13.5, 6.5, -60, 215, true);
            return p.line({{3.2, 7.2}, {5.8, 12.6}, {11, 10}});
        case Icon::redo:
            p.arc(11.5, 13.5, 6.5, 25, 215, true);
            return p.line({{20.8, 7.2}, {18.2, 12.6}, {13, 10}});
        default:
            return;
    }
}

void draw_views(Pencil& p, Icon icon) {
    switch (icon) {
        case Icon::four_views:
            p.box(3, 4, 8, 7, true);
            p.box(13, 4, 8, 7);
            p.box(3, 13, 8, 7);
            return p.box(13, 13, 8, 7);
        case Icon::one_and_three:
            p.box(3, 4, 11, 16, true);
            for (const double y : {4.0, 10.0, 16.0}) p.box(16, y, 5, 4);
            return;
        case Icon::single_view:
            return p.box(3, 4, 18, 16, true);
        case Icon::reset_view:
            p.closed({{12, 9}, {15, 10.7}, {15, 14.2}, {12, 16}, {9, 14.2}, {9, 10.7}}, true);
            p.arc(12, 12.5, 8, 120, 290);
            return p.line({{4.6, 3.6}, {8.2, 5.4}, {6.6, 9.2}});
        default:
            return;
    }
}

void draw_tools(Pencil& p, Icon icon) {
    switch (icon) {
        case Icon::range:
            p.line({{3, 18}, {6, 16}, {8.5, 6}, {11, 14}, {14, 10}, {17, 16.5}, {21, 18}});
            p.line({{7, 3}, {7, 21}}, true);
            return p.line({{16, 3}, {16, 21}}, true);
        case Icon::cut:
            p.closed({{12, 3}, {20, 7.5}, {20, 16.5}, {12, 21}, {4, 16.5}, {4, 7.5}});
            return p.closed({{12, 3}, {15.5, 12}, {12, 21}, {8.5, 12}}, true);
        case Icon::regions:
            p.circle(8, 8.5, 4.5, true);
            p.circle(16.5, 15.5, 4, true);
            p.circle(17, 6, 2);
            return p.circle(6.5, 17.5, 2.2);
        case Icon::inspect:
            p.circle(10.5, 10.5, 7);
            p.line({{15.7, 15.7}, {21, 21}});
            return p.line({{7.2, 10.6}, {9.8, 13.2}, {14, 8}}, true);
        case Icon::measure:
            p.closed({{2.5, 16.5}, {16.5, 2.5}, {21.5, 7.5}, {7.5, 21.5}});
            for (const double t : {0.0, 3.3, 6.6, 9.9}) p.line({{5.6 + t, 13.4 - t}, {7.8 + t, 15.6 - t}}, true);
            return;
        case Icon::search:
            p.circle(10, 10, 6.5, true);
            return p.line({{15, 15}, {21, 21}});
        case Icon::settings: {
            const double offset[] = {8, 15, 11};
            for (int i = 0; i < 3; ++i) {
                const double y = 6 + 6 * i;
                p.line({{3, y}, {offset[i] - 2.2, y}});
                p.line({{offset[i] + 2.2, y}, {21, y}});
                p.circle(offset[i], y, 2.2, true);
            }
            return;
        }
        case Icon::help:
            p.circle(12, 12, 9);
            return p.letter(QStringLiteral("?"));
        default:
            return;
    }
}

class ThemedIcon final : public QIconEngine {
public:
    explicit ThemedIcon(Icon icon) : icon_(icon) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const ThemeColors& c = theme::colors();
        const double side = std::min(rect.width(), rect.height());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(QRectF(rect).center() - QPointF(side, side) / 2);
        painter->scale(side / 24, side / 24);
        const bool off = mode == QIcon::Disabled;
        Pencil pencil(*painter, off ? c.disabled : c.text, off ? c.disabled : c.accent);
        draw_document(pencil, icon_);
        draw_views(pencil, icon_);
        draw_tools(pencil, icon_);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect({}, size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new ThemedIcon(icon_); }

private:
    Icon icon_;
};

}  // namespace

QIcon make_icon(Icon icon) { return QIcon(new ThemedIcon(icon)); }

}  // namespace lacuna::ui
