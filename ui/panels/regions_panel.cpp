#include "ui/panels/regions_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <algorithm>

#include "ui/core_sentences.h"
#include "ui/number_text.h"
#include "ui/tab_chain.h"
#include "ui/widgets/row_table.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

namespace {
constexpr Connectivity k_connectivities[] = {Connectivity::c6, Connectivity::c18, Connectivity::c26};
}

RegionsPanel::RegionsPanel(QWidget* parent)
    : QWidget(parent),
      model_(new RegionModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      method_(new QComboBox(this)),
      connectivity_(new QComboBox(this)),
      lo_(new NumberBox(this)),
      hi_(new NumberBox(this)),
      width_(new NumberBox(this)),
      min_voxels_(new QSpinBox(this)),
      take_(new QPushButton(tr("Current range"), this)),
      compute_(new QPushButton(tr("Compute regions"), this)),
      clear_(new QPushButton(tr("Deselect"), this)),
      export_(new QPushButton(tr("Export CSV…"), this)),
      to_(new QLabel(tr("to"), this)),
      note_(new QLabel(this)),
      view_(new QTableView(this)) {
    build();
    connect(method_, &QComboBox::currentIndexChanged, this, &RegionsPanel::showMethod);
    connect(take_, &QPushButton::clicked, this, &RegionsPanel::takeRange);
    connect(compute_, &QPushButton::clicked, this, [this] { Q_EMIT computeRequested(options()); });
    connect(export_, &QPushButton::clicked, this, &RegionsPanel::exportRequested);
    connect(clear_, &QPushButton::clicked, view_, &QTableView::clearSelection);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        const QModelIndexList rows = view_->selectionModel()->selectedRows();
        clear_->setEnabled(!rows.isEmpty());
        Q_EMIT regionChosen(rows.isEmpty() ? 0u : rows.front().data(RegionModel::k_id_role).toUInt());
    });
    showMethod();
}

void RegionsPanel::build() {
    method_->addItems({tr("Values from"), tr("Homogeneous, width")});
    method_->setAccessibleName(tr("How regions are found"));
    method_->setToolTip(
        tr("Connected voxels of a value range, or regions whose values span at most a share of the "
           "volume's value range"));
    connectivity_->addItems({tr("6 neighbours"), tr("18 neighbours"), tr("26 neighbours")});
    connectivity_->setAccessibleName(tr("Connectivity"));
    lo_->setAccessibleName(tr("Lowest value of a region"));
    hi_->setAccessibleName(tr("Highest value of a region"));
    width_->setAccessibleName(tr("Range width, percent of the volume's value range"));
    width_->setRange(0.1, 100);
    width_->setValue(10);
    width_->setSuffix(tr(" %"));
    min_voxels_->setRange(1, 100000000);
    min_voxels_->setValue(8);
    min_voxels_->setPrefix(tr("at least "));
    min_voxels_->setSuffix(tr(" voxels"));
    min_voxels_->setAccessibleName(tr("Smallest region, voxels"));
    take_->setAccessibleName(tr("Take the current segmentation range"));
    take_->setToolTip(tr("The first segmentation range in use, or what lies above the isovalue"));
    compute_->setAccessibleName(tr("Compute the regions"));
    clear_->setAccessibleName(tr("Select no region"));
    export_->setAccessibleName(tr("Export the region table"));
    note_->setEnabled(false);
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(RegionModel::k_sort_role);
    view_->setModel(sorted_);
    view_->setAccessibleName(tr("Regions"));
    choose_rows_of(view_);
    sort_by_titles(view_);
    chain_tabs({method_, lo_, hi_, width_, take_, connectivity_, min_voxels_, compute_, clear_, export_, view_});
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 6, 6, 6);
    row->addLayout(formColumn());
    row->addWidget(view_, 1);
    export_->setEnabled(false);
    clear_->setEnabled(false);
    compute_->setEnabled(false);
}

QLayout* RegionsPanel::formColumn() {
    auto* form = new QGridLayout;
    form->setVerticalSpacing(4);
    form->addWidget(method_, 0, 0);
    auto* ends = new QHBoxLayout;
    ends->setSpacing(5);
    ends->addWidget(lo_, 1);
    ends->addWidget(to_);
    ends->addWidget(hi_, 1);
    ends->addWidget(width_, 1);
    form->addLayout(ends, 0, 1);
    form->addWidget(take_, 1, 0);
    form->addWidget(connectivity_, 1, 1);
    form->addWidget(note_, 2, 0);
    form->addWidget(min_voxels_, 2, 1);
    form->addWidget(compute_, 3, 0, 1, 2);
    form->addWidget(clear_, 4, 0);
    form->addWidget(export_, 4, 1);
    form->setRowStretch(5, 1);
    return form;
}

void RegionsPanel::showMethod() {
    const bool threshold = method_->currentIndex() == 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{lo_, to_, hi_, take_}) widget->setVisible(threshold);
    width_->setVisible(!threshold);
}

void RegionsPanel::setVolume(const Volume& volume, std::shared_ptr<const VolumeStatistics> statistics) {
    statistics_ = std::move(statistics);
    kept_ = {};
    const ValueSteps steps = ValueSteps::of(statistics_->range);
    for (QDoubleSpinBox* end : {lo_, hi_}) {
        end->setDecimals(steps.decimals);
        end->setSingleStep(steps.step);
        // Wider than the data, so that a round number may be typed.
        const double room = std::max(1.0, statistics_->range.width());
        end->setRange(statistics_->range.lo - room, statistics_->range.hi + room);
        end->setSuffix(volume.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(volume.unit));
    }
    const double otsu = otsu_threshold(*statistics_);
    lo_->setValue(otsu);
    hi_->setValue(statistics_->range.hi);
    compute_->setEnabled(true);
    model_->setAxisNames(volume.geometry().axis_names);
    setTable(nullptr);
}

void RegionsPanel::setSettings(const ViewSettings& settings) { settings_ = settings; }

void RegionsPanel::takeRange() {
    if (!statistics_) return;
    ValueRange taken{settings_.iso, statistics_->range.hi};
    for (const RangeSetting& range : settings_.ranges)
        if (range.enabled) {
            taken = range.range.range;
            break;
        }
    lo_->setValue(taken.lo);
    hi_->setValue(taken.hi);
}

RegionOptions RegionsPanel::options() const {
    RegionOptions options = kept_;
    options.threshold.reset();
    options.range_width.reset();
    if (method_->currentIndex() == 0)
        options.threshold = ValueRange{std::min(lo_->value(), hi_->value()), std::max(lo_->value(), hi_->value())};
    else
        options.range_width = width_->value() / 100;
    options.connectivity = k_connectivities[connectivity_->currentIndex()];
    options.min_voxels = min_voxels_->value();
    return options;
}

void RegionsPanel::setOptions(const RegionOptions& options) {
    kept_ = options;
    method_->setCurrentIndex(options.threshold ? 0 : 1);
    if (options.threshold) {
        lo_->setValue(options.threshold->lo);
        hi_->setValue(options.threshold->hi);
    } else if (options.range_width) {
        width_->setValue(100 * *options.range_width);
    }
    for (int i = 0; i < int(std::size(k_connectivities)); ++i)
        if (k_connectivities[i] == options.connectivity) connectivity_->setCurrentIndex(i);
    min_voxels_->setValue(int(std::min<std::int64_t>(options.min_voxels, min_voxels_->maximum())));
}

void RegionsPanel::setTable(std::shared_ptr<const RegionTable> table) {
    const bool some = table && !table->rows.empty();
    note_->setText(!table                    ? QString()
                   : table->rows.size() == 1 ? tr("1 region")
                                             : tr("%1 regions").arg(table->rows.size()));
    note_->setToolTip(table ? core_sentence(table->surface_method) + QStringLiteral("; ") +
                                  core_sentence(table->adjacency)
                            : QString());
    view_->clearSelection();
    model_->setTable(std::move(table));
    export_->setEnabled(some);
    clear_->setEnabled(false);
}

void RegionsPanel::setRunning(bool running) {
    compute_->setEnabled(!running && statistics_ != nullptr);
    compute_->setText(running ? tr("Computing…") : tr("Compute regions"));
}

}  // namespace lacuna::ui
