#include "ui/panels/measure_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/views/slice_measure.h"
#include "ui/widgets/row_table.h"

namespace lacuna::ui {

MeasurePanel::MeasurePanel(QWidget* parent)
    : QWidget(parent),
      table_(new QTableWidget(this)),
      remove_(new QPushButton(tr("&Remove"), this)),
      copy_(new QPushButton(tr("&Copy"), this)),
      export_(new QPushButton(tr("E&xport…"), this)) {
    table_->setAccessibleName(tr("Measurements"));
    const QStringList heads = {tr("No."),    tr("Kind"),    tr("Slice"),   tr("Size"),  tr("Mean"),
                               tr("Stddev"), tr("Minimum"), tr("Maximum"), tr("Pixels")};
    table_->setColumnCount(int(heads.size()));
    table_->setHorizontalHeaderLabels(heads);
    choose_rows_of(table_);
    table_->setAlternatingRowColors(true);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    remove_->setToolTip(tr("Removes the chosen measurement"));
    copy_->setToolTip(tr("Copies the table to the clipboard, for a spreadsheet"));
    export_->setToolTip(tr("Writes the table as CSV"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {remove_, copy_, export_}) {
        button->setEnabled(false);
        row->addWidget(button);
    }
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(table_, 1);
    column->addLayout(row);
    connect(remove_, &QPushButton::clicked, this, &MeasurePanel::removeRequested);
    connect(copy_, &QPushButton::clicked, this, &MeasurePanel::copyRequested);
    connect(export_, &QPushButton::clicked, this, &MeasurePanel::exportRequested);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
        const auto rows = table_->selectionModel()->selectedRows();
        const std::uint32_t id = rows.isEmpty() ? 0 : ids_[std::size_t(rows.front().row())];
        remove_->setEnabled(id != 0);
        Q_EMIT chosen(id);
    });
}

void MeasurePanel::setRows(const std::vector<Row>& rows) {
    const QSignalBlocker quiet(table_);
    const auto selected = table_->selectionModel()->selectedRows();
    const std::uint32_t chosen_id = selected.isEmpty() || selected.front().row() >= int(ids_.size())
                                        ? 0
                                        : ids_[std::size_t(selected.front().row())];
    table_->setRowCount(int(rows.size()));
    ids_.clear();
    for (const Row& row : rows) {
        const int at = int(ids_.size());
        ids_.push_back(row.measurement.id);
        const QStringList cells = {QString::number(row.measurement.id),
                                   measurement_title(row.measurement.kind),
                                   row.where,
                                   row.size,
                                   row.mean,
                                   row.spread,
                                   row.least,
                                   row.most,
                                   row.pixels};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            if (column == 0 || column >= 3) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(at, column, item);
        }
    }
    copy_->setEnabled(!rows.empty());
    export_->setEnabled(!rows.empty());
    select(chosen_id);
}

void MeasurePanel::select(std::uint32_t id) {
    const QSignalBlocker quiet(table_);
    const auto at = std::find(ids_.begin(), ids_.end(), id);
    if (id == 0 || at == ids_.end())
        table_->clearSelection();
    else
        table_->selectRow(int(at - ids_.begin()));
    remove_->setEnabled(id != 0 && at != ids_.end());
}

}  // namespace lacuna::ui
