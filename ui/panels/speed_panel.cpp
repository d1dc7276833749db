#include "ui/panels/speed_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QScrollBar>
#include <QSplitter>
#include <algorithm>
#include <map>

#include "core/accuracy/sweep_report.h"
#include "ui/core_sentences.h"
#include "ui/number_text.h"
#include "ui/plan_words.h"
#include "ui/widgets/error_badge.h"
#include "ui/widgets/row_table.h"

namespace lacuna::ui {

namespace {

enum Column { k_plan, k_time, k_error, k_build, k_memory, k_columns };
constexpr int k_point_role = Qt::UserRole;

QString words_of(const ModePlan& plan, const ModePlan& brute) {
    const std::string differs = difference_in_words(plan, brute);
    const QString structure = QString::fromUtf8(name_of(plan.plan.structure).data());
    return plan_words(differs.empty() ? structure : structure + QStringLiteral(", ") + QString::fromStdString(differs));
}

/// A structure's marker as the chart draws it.
QIcon marker_icon(Structure structure, const QPalette& palette, double ratio) {
    constexpr double k_points = 9;
    std::size_t rank = 0;
    for (const auto& [value, name] : structure_names()) {
        if (value == structure) break;
        ++rank;
    }
    Canvas canvas = Canvas::png({k_points, k_points}, 96.0 / 72.0 * ratio);
    draw_marker(canvas, series_marker(rank), {k_points / 2, k_points / 2}, 7, glm::dvec3(0));
    const std::string png = canvas.finish();
    QImage shape = QImage::fromData(reinterpret_cast<const uchar*>(png.data()), int(png.size()), "PNG")
                       .convertToFormat(QImage::Format_ARGB32);
    const glm::dvec3 color = 255.0 * series_color(rank);
    const QColor drawn = ChartView::shownColor(QColor(int(color.x), int(color.y), int(color.z)), palette);
    for (int y = 0; y < shape.height(); ++y)
        for (int x = 0; x < shape.width(); ++x)
            shape.setPixel(x, y, qRgba(drawn.red(), drawn.green(), drawn.blue(), 255 - qGray(shape.pixel(x, y))));
    shape.setDevicePixelRatio(ratio);
    return QIcon(QPixmap::fromImage(shape));
}

/// The chart's words and numbers as the window writes them; the core's are English.
void speak(Chart& chart) {
    const char mark = QLocale().decimalPoint() == QLatin1String(",") ? ',' : '.';
    for (Axis* axis : {&chart.x, &chart.y}) axis->decimal_mark = mark;
    chart.x.title = SpeedPanel::tr("largest error").toStdString();
    chart.y.title = SpeedPanel::tr("time a frame").toStdString();
    for (Mark& line : chart.marks)
        line.label =
            (line.at == 1 ? SpeedPanel::tr("1 grey level") : SpeedPanel::tr("the reference itself")).toStdString();
    for (Series& series : chart.series)
        for (DataPoint& point : series.points)
            point.label = plan_words(QString::fromStdString(point.label)).toStdString();
}

QString number(double value) { return number_text(value, 'f', value < 9.95 ? 1 : 0); }

}  // namespace

SpeedPanel::SpeedPanel(QWidget* parent)
    : QWidget(parent),
      chart_(new ChartView(this)),
      table_(new QTableWidget(0, k_columns, this)),
      state_(new QLabel(this)),
      all_(new QCheckBox(tr("All pla&ns"), this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    auto* row = new QHBoxLayout;
    row->addWidget(state_, 1);
    row->addWidget(all_);
    column->addLayout(row);
    auto* both = new QSplitter(Qt::Horizontal, this);
    both->addWidget(chart_);
    both->addWidget(table_);
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 1);
    table_->setMinimumWidth(380);
    column->addWidget(both, 1);
    state_->setAccessibleName(tr("Progress of measuring"));
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    all_->setToolTip(
        tr("Every structure with every step, sampler, termination and sparse casting, instead of one "
           "example each; takes its time"));
    chart_->setAccessibleName(tr("Time of a frame against its error"));
    chart_->setAccessibleDescription(tr("The list beside it has the same plans."));
    table_->setAccessibleName(tr("Plans measured"));
    table_->setToolTip(tr("Enter or a double click uses a plan"));
    table_->setHorizontalHeaderLabels({tr("Plan"), tr("ms"), tr("Error /255"), tr("Build ms"), tr("MiB")});
    choose_rows_of(table_);
    table_->setShowGrid(false);
    table_->setAlternatingRowColors(true);
    table_->horizontalHeader()->setSectionResizeMode(k_plan, QHeaderView::Stretch);
    for (int c = k_time; c < k_columns; ++c)
        table_->horizontalHeader()->setSectionResizeMode(c, QHeaderView::ResizeToContents);
    connect(table_, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        use(table_->item(item->row(), k_plan)->data(k_point_role).toULongLong());
    });
    connect(chart_, &ChartView::clicked, this, [this](ChartView::Place place) {
        if (place.series < shown_.size() && place.point < shown_[place.series].size())
            use(shown_[place.series][place.point]);
    });
    connect(all_, &QCheckBox::toggled, this, &SpeedPanel::extentChanged);
}

void SpeedPanel::use(std::size_t point) {
    if (point < points_.size() && points_[point].refused.empty()) Q_EMIT planChosen(points_[point].plan);
}

std::optional<ChartView::Place> SpeedPanel::placeOf(std::size_t point) const {
    for (std::size_t s = 0; s < shown_.size(); ++s)
        for (std::size_t p = 0; p < shown_[s].size(); ++p)
            if (shown_[s][p] == point) return ChartView::Place{s, p};
    return std::nullopt;
}

void SpeedPanel::clear(const QString& why) {
    points_.clear();
    shown_.clear();
    table_->setRowCount(0);
    chart_->clear();
    state_->setText(why);
}

void SpeedPanel::showPoints(const LiveSweep& sweep, const ModePlan& current) {
    points_ = sweep.result().points;
    Chart chart = scene_chart(sweep.result(), FrontError::max);
    chart.title.clear();
    chart.subtitle.clear();
    chart.legend = Legend::none;  // the list shows each plan's marker
    speak(chart);
    shown_.assign(chart.series.size(), {});
    for (std::size_t s = 0; s < chart.series.size(); ++s)
        for (const DataPoint& at : chart.series[s].points)
            for (std::size_t i = 0; i < points_.size(); ++i)
                if (points_[i].refused.empty() && points_[i].ms == at.y && points_[i].error.max == at.x) {
                    shown_[s].push_back(i);
                    break;
                }
    const std::optional<std::size_t> used = sweep.find(current);
    if (used && points_[*used].refused.empty()) {
        Series mark{.name = tr("in use").toStdString(), .marker = Marker::star, .color = glm::dvec3(0.85, 0.1, 0.1)};
        mark.points.push_back({points_[*used].error.max, points_[*used].ms});
        mark.size = 12;
        chart.series.push_back(std::move(mark));
        shown_.push_back({*used});
    }
    if (sweep.measured() > 0)
        chart_->setChart(chart);
    else
        chart_->clear();
    const int open = int(std::count_if(points_.begin(), points_.end(), [&](const SweepPoint& p) {
        return sweep.pending(std::size_t(&p - points_.data()));
    }));
    state_->setText(open > 0 ? tr("Plans measured: %1 of %2; measuring goes on while nothing else runs")
                                   .arg(sweep.measured())
                                   .arg(sweep.measured() + std::size_t(open))
                             : tr("Plans measured: %1, in %2 of %3 rounds")
                                   .arg(sweep.measured())
                                   .arg(std::max(1, sweep.result().rounds))
                                   .arg(LiveSweep::k_rounds));
    fillTable(sweep, current);
}

void SpeedPanel::fillTable(const LiveSweep& sweep, const ModePlan& current) {
    const QTableWidgetItem* chosen = table_->item(table_->currentRow(), k_plan);
    const qulonglong kept = chosen ? chosen->data(k_point_role).toULongLong() : ~qulonglong(0);
    const int scrolled = table_->verticalScrollBar()->value();
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points_.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const bool x = points_[a].refused.empty(), y = points_[b].refused.empty();
        return x != y ? x : x && points_[a].ms < points_[b].ms;
    });
    const std::optional<std::size_t> used = sweep.find(current);
    std::map<Structure, QIcon> icons;
    const auto icon_of = [&](Structure structure) {
        const auto at = icons.find(structure);
        if (at != icons.end()) return at->second;
        return icons.emplace(structure, marker_icon(structure, palette(), devicePixelRatioF())).first->second;
    };
    table_->setRowCount(int(order.size()));
    for (int row = 0; row < int(order.size()); ++row) {
        const std::size_t i = order[std::size_t(row)];
        const SweepPoint& point = points_[i];
        const bool measured = point.refused.empty();
        QString name = words_of(point.plan, points_.front().plan);
        if (used == i) name = tr("%1 (in use)").arg(name);
        const QString cells[] = {name, measured ? number(point.ms) : QString(),
                                 measured ? levels_text(point.error.max) : QString(),
                                 measured ? number(point.build_ms) : QString(),
                                 measured ? number(double(point.bytes) / 1048576.0) : QString()};
        const QString tip = !measured        ? core_sentence(point.refused)
                            : point.on_front ? tr("No other plan is both faster and more exact")
                                             : QString();
        for (int c = 0; c < k_columns; ++c) {
            auto* item = new QTableWidgetItem(cells[c]);
            if (c != k_plan) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            if (!measured) item->setForeground(palette().brush(QPalette::PlaceholderText));
            QFont font = table_->font();
            font.setBold(measured && point.on_front);
            item->setFont(font);
            item->setToolTip(tip);
            item->setData(k_point_role, qulonglong(i));
            if (c == k_plan) item->setIcon(icon_of(point.plan.plan.structure));
            table_->setItem(row, c, item);
        }
        if (qulonglong(i) == kept) table_->setCurrentCell(row, k_plan);
    }
    table_->verticalScrollBar()->setValue(scrolled);
}

}  // namespace lacuna::ui
