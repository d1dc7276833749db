#pragma once

#include <QColor>
#include <QLabel>

#include "core/accuracy/error_bound.h"

namespace lacuna::ui {

/// "exact: same samples as brute force", "at most 0.61/255, by early termination's bound", ...
QString bound_text(const ErrorBound& bound);
/// Losses in a few words: "longer steps, nearest voxels".
QString losses_text(const std::vector<Loss>& losses);
/// Levels of 255 as a person wants them: 0, 0.04, 1.3, 17.
QString levels_text(double levels);

/// A plate in the lower right corner of a view that says how wrong its picture is and how that is known. Not for
/// clicking: the mouse goes to the view below.
class ErrorBadge final : public QLabel {
    Q_OBJECT
public:
    explicit ErrorBadge(QWidget* view);
    void showBound(const ErrorBound& bound, bool coarse);
    /// A line above, for what the view shows instead of its own picture; empty: none.
    void showHeadline(const QString& text);
    /// The view's picture is not what was asked for last.
    /// @param drawing  it is on its way; else it does not come
    void setStale(bool stale, bool drawing);
    /// For what is being found out; takes the place of "unknown".
    void setPending(bool pending);
    QColor color() const { return color_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent*) override;

private:
    void place();
    void refresh();

    ErrorBound bound_;
    bool coarse_ = false, pending_ = false, stale_ = false, drawing_ = false;
    QString headline_;
    QColor color_;
};

}  // namespace lacuna::ui
