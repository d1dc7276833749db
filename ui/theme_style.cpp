#include "ui/theme_style.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

#include "ui/theme.h"

namespace lacuna::ui {

namespace {

QColor edge_of(const QStyleOption& option) {
    const ThemeColors& c = theme::colors();
    if (!(option.state & QStyle::State_Enabled)) return c.disabled;
    if (option.state & (QStyle::State_HasFocus | QStyle::State_MouseOver)) return c.accent;
    return c.control;
}

/// A square or a circle, filled with the highlight colour and a mark where it is on.
void draw_box(const QStyleOption& option, QPainter& painter, bool round) {
    const ThemeColors& c = theme::colors();
    const bool on = option.state & (QStyle::State_On | QStyle::State_NoChange);
    const bool enabled = option.state & QStyle::State_Enabled;
    const double side = std::min(option.rect.width(), option.rect.height()) - 1;
    const QRectF box(option.rect.center().x() + 0.5 - side / 2 + 0.5, option.rect.center().y() + 0.5 - side / 2 + 0.5,
                     side - 1, side - 1);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(
        QPen(on && enabled && !(option.state & QStyle::State_HasFocus) ? c.highlight : edge_of(option), 1.2));
    painter.setBrush(on ? (enabled ? c.highlight : c.disabled) : c.base);
    const double corner = round ? box.width() / 2 : 2.5;
    painter.drawRoundedRect(box, corner, corner);
    const QColor ink = enabled ? c.highlighted_text : c.window;
    if (on && round) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(box.center(), box.width() * 0.2, box.width() * 0.2);
    } else if (on) {
        QPainterPath mark;
        const auto at = [&box](double x, double y) {
            return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
        };
        if (option.state & QStyle::State_NoChange) {
            mark.moveTo(at(0.24, 0.5));
            mark.lineTo(at(0.76, 0.5));
        } else {
            mark.moveTo(at(0.22, 0.53));
            mark.lineTo(at(0.42, 0.73));
            mark.lineTo(at(0.79, 0.29));
        }
        painter.setPen(QPen(ink, std::max(1.5, box.width() * 0.13), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(mark);
    }
    painter.restore();
}

void draw_field(const QStyleOption& option, QPainter& painter) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge_of(option), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.5, 2.5);
    painter.restore();
}

/// Groove, the part before the handle filled, and the handle.
void draw_slider(const QStyleOptionSlider& option, QPainter& painter, const QRect& groove, const QRect& handle) {
    const ThemeColors& c = theme::colors();
    const bool across = option.orientation == Qt::Horizontal, enabled = option.state & QStyle::State_Enabled;
    QRectF line = across ? QRectF(groove.left() + 2, groove.center().y() - 1.5, groove.width() - 4, 4)
                         : QRectF(groove.center().x() - 1.5, groove.top() + 2, 4, groove.height() - 4);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(enabled ? c.control : c.disabled, 1));
    painter.setBrush(c.base);
    painter.drawRoundedRect(line, 2, 2);
    QRectF filled = line;
    if (across)
        option.upsideDown ? filled.setLeft(handle.center().x()) : filled.setRight(handle.center().x());
    else
        option.upsideDown ? filled.setTop(handle.center().y()) : filled.setBottom(handle.center().y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(enabled ? c.highlight : c.border);
    painter.drawRoundedRect(filled, 2, 2);
    const double size = std::min({double(handle.width()), double(handle.height()), 15.0}) - 2;
    const QRectF knob(handle.center().x() + 0.5 - size / 2, handle.center().y() + 0.5 - size / 2, size, size);
    painter.setPen(QPen(edge_of(option), option.state & QStyle::State_HasFocus ? 2 : 1.2));
    painter.setBrush(enabled ? c.plot_line : c.border);
    if (theme::scheme() == Scheme::light && enabled) painter.setBrush(c.base);
    painter.drawEllipse(knob);
    painter.restore();
}

}  // namespace

ThemeStyle::ThemeStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    switch (element) {
        case PE_IndicatorCheckBox:
        case PE_IndicatorItemViewItemCheck:
            return draw_box(*option, *painter, false);
        case PE_IndicatorRadioButton:
            return draw_box(*option, *painter, true);
        case PE_FrameLineEdit:
            return draw_field(*option, *painter);
        default:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void ThemeStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
    if (control == CC_Slider)
        if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option))
            return draw_slider(*slider, *painter, subControlRect(CC_Slider, option, SC_SliderGroove, widget),
                               subControlRect(CC_Slider, option, SC_SliderHandle, widget));
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox) draw_field(*option, *painter);
    if (control == CC_ComboBox) {
        const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (box && box->frame) draw_field(*option, *painter);
    }
}

void ThemeStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (element != CE_ComboBoxLabel || !box || box->editable)
        return QProxyStyle::drawControl(element, option, painter, widget);
    QStyleOptionComboBox fitted(*box);
    const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - 4 -
                     (box->currentIcon.isNull() ? 0 : box->iconSize.width() + 4);
    fitted.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
    QProxyStyle::drawControl(element, &fitted, painter, widget);
}

QSize ThemeStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                   const QWidget* widget) const {
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    // The arrow of a menu stands beside the words, not on them.
    constexpr int k_arrow = 14;
    if (const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
        type == CT_ToolButton && button && (button->features & QStyleOptionToolButton::HasMenu) &&
        button->toolButtonStyle != Qt::ToolButtonIconOnly)
        size.rwidth() += k_arrow;
    return size;
}

int ThemeStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    if (metric == PM_IndicatorWidth || metric == PM_IndicatorHeight || metric == PM_ExclusiveIndicatorWidth ||
        metric == PM_ExclusiveIndicatorHeight)
        return std::max(16, QProxyStyle::pixelMetric(metric, option, widget));
    if (metric == PM_TabBarTabHSpace) return 14;  // German words, five in a row
    return QProxyStyle::pixelMetric(metric, option, widget);
}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* answer) const {
    // A click on a slider's groove goes there, instead of a page towards it.
    if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
    // Words alone: the platform's little pictures of ticks and crosses fit neither theme.
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(hint, option, widget, answer);
}

}  // namespace lacuna::ui
