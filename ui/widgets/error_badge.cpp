#include "ui/widgets/error_badge.h"

#include <QAccessible>
#include <QEvent>
#include <QPainter>
#include <QStringList>
#include <cmath>

#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {

constexpr int k_margin = 10, k_pad = 8, k_dot = 9;
// Read on a picture of any brightness, in either theme.
const QColor k_plate(16, 18, 22, 205), k_ink(236, 239, 243);
const QColor k_exact(96, 200, 128), k_within(104, 172, 255), k_off(240, 180, 70), k_unknown(150, 156, 166);

QString loss_text(Loss loss) {
    switch (loss) {
        case Loss::termination:
            return ErrorBadge::tr("early termination");
        case Loss::step:
            return ErrorBadge::tr("another step");
        case Loss::nearest:
            return ErrorBadge::tr("nearest voxels");
        case Loss::sparse:
            return ErrorBadge::tr("sparse casting");
        case Loss::thresholds:
            return ErrorBadge::tr("thresholds of homogeneity");
        case Loss::quantised:
            return ErrorBadge::tr("quantised leaps");
        case Loss::stored_gradients:
            return ErrorBadge::tr("stored gradients");
        case Loss::gradient_filter:
            return ErrorBadge::tr("another gradient");
        case Loss::refinement:
            return ErrorBadge::tr("another refinement");
        case Loss::segments:
            return ErrorBadge::tr("integrated segments");
        case Loss::shear_warp:
            return ErrorBadge::tr("shear-warp has no brute force");
    }
    return {};
}

}  // namespace

QString levels_text(double levels) {
    if (!std::isfinite(levels)) return ErrorBadge::tr("not a number");
    if (levels == 0) return QStringLiteral("0");
    if (levels < 0.005) return QStringLiteral("<\u2009%1").arg(number_text(0.01, 'f', 2));
    return number_text(levels, 'f', levels < 0.995 ? 2 : levels < 9.95 ? 1 : 0);
}

QString losses_text(const std::vector<Loss>& losses) {
    QStringList words;
    for (const Loss loss : losses) words << loss_text(loss);
    return words.join(QStringLiteral(", "));
}

QString bound_text(const ErrorBound& bound) {
    switch (bound.known) {
        case ErrorKnown::exact:
            return ErrorBadge::tr("exact: same samples as brute force");
        case ErrorKnown::bounded:
            return ErrorBadge::tr("at most %1/255, by early termination's bound").arg(levels_text(bound.levels));
        case ErrorKnown::measured:
            return ErrorBadge::tr("measured %1/255 on this view").arg(levels_text(bound.levels));
        case ErrorKnown::unknown:
            break;
    }
    return ErrorBadge::tr("error unknown: %1").arg(losses_text(bound.losses));
}

ErrorBadge::ErrorBadge(QWidget* view) : QLabel(view), color_(k_unknown) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Error of the 3D picture"));
    setContentsMargins(2 * k_pad + k_dot, k_pad - 2, k_pad, k_pad - 2);
    view->installEventFilter(this);
    hide();
}

void ErrorBadge::showBound(const ErrorBound& bound, bool coarse) {
    bound_ = bound;
    coarse_ = coarse;
    refresh();
}

void ErrorBadge::showHeadline(const QString& text) {
    headline_ = text;
    refresh();
}

void ErrorBadge::setStale(bool stale, bool drawing) {
    stale_ = stale;
    drawing_ = drawing;
    refresh();
}

void ErrorBadge::setPending(bool pending) {
    pending_ = pending;
    refresh();
}

void ErrorBadge::refresh() {
    QString words = coarse_ ? tr("coarse while moving") : bound_text(bound_);
    color_ = k_unknown;
    if (stale_) {
        words = drawing_ ? tr("still the picture before; drawing…")
                         : tr("still the picture before; this one was not drawn");
        color_ = k_off;
    } else if (!coarse_) {
        if (bound_.known == ErrorKnown::exact) color_ = k_exact;
        if (bound_.known == ErrorKnown::bounded || bound_.known == ErrorKnown::measured)
            color_ = bound_.levels <= 1 ? k_within : k_off;
        if (bound_.known == ErrorKnown::unknown && pending_ && bound_.losses != std::vector{Loss::shear_warp})
            words = tr("measuring: %1").arg(losses_text(bound_.losses));
    }
    if (!headline_.isEmpty() && !coarse_) words = headline_ + QLatin1Char('\n') + words;
    if (words != text()) {
        setText(words);
        setAccessibleDescription(words);
        QAccessibleEvent told(this, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&told);
    }
    place();
    update();
}

void ErrorBadge::place() {
    const QWidget* view = parentWidget();
    QSize wanted = sizeHint();
    wanted.setWidth(std::min(wanted.width(), view->width() - 2 * k_margin));
    resize(wanted);
    move(view->width() - width() - k_margin, view->height() - height() - k_margin);
}

bool ErrorBadge::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QLabel::eventFilter(watched, event);
}

void ErrorBadge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 46), 1));
    painter.setBrush(k_plate);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color_);
    const int lines = int(text().count(QLatin1Char('\n'))) + 1;
    const double line = double(contentsRect().height()) / lines;
    painter.drawEllipse(QPointF(k_pad + 0.5 * k_dot, contentsRect().top() + (lines - 0.5) * line), 0.5 * k_dot,
                        0.5 * k_dot);
    painter.setPen(k_ink);
    QStringList rows;  // in a small view only their beginnings
    for (const QString& row : text().split(QLatin1Char('\n')))
        rows << fontMetrics().elidedText(row, Qt::ElideRight, contentsRect().width());
    painter.drawText(contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, rows.join(QLatin1Char('\n')));
}

}  // namespace lacuna::ui
