#include "ui/series_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/widgets/row_table.h"

namespace lacuna::ui {

SeriesDialog::SeriesDialog(const std::vector<SeriesEntry>& entries, QWidget* parent)
    : QDialog(parent), table_(new QTableWidget(int(entries.size()), 5, this)) {
    setWindowTitle(tr("Choose a series"));
    resize(720, 320);
    auto* column = new QVBoxLayout(this);
    column->addWidget(
        new QLabel(tr("There are %1 volumes here. Which one should be opened?").arg(entries.size()), this));
    table_->setHorizontalHeaderLabels({tr("No."), tr("Modality"), tr("Description"), tr("Size"), tr("Slices")});
    table_->setAccessibleName(tr("Series found"));
    choose_rows_of(table_);
    // Only the description gives way: a size in two lines reads as two.
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    for (int row = 0; row < int(entries.size()); ++row) {
        const SeriesEntry& entry = entries[std::size_t(row)];
        const QString cells[] = {QString::number(entry.number), QString::fromStdString(entry.modality),
                                 QString::fromStdString(entry.description),
                                 QStringLiteral("%1 × %2 × %3").arg(entry.size.x).arg(entry.size.y).arg(entry.size.z),
                                 QString::number(entry.slices)};
        for (int cell = 0; cell < 5; ++cell) table_->setItem(row, cell, new QTableWidgetItem(cells[cell]));
        table_->item(row, 2)->setToolTip(QString::fromStdString(entry.uid));
    }
    table_->selectRow(0);
    column->addWidget(table_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(table_, &QTableWidget::itemActivated, this, &QDialog::accept);
    connect(this, &QDialog::accepted, this, [this] {
        if (const int row = table_->currentRow(); row >= 0) Q_EMIT chosen(table_->item(row, 0)->text());
    });
    table_->setFocus();
}

}  // namespace lacuna::ui
