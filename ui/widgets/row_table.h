#pragma once

#include <QHeaderView>
#include <QTableView>
#include <algorithm>

namespace lacuna::ui {

/// Makes a table one to read and choose a row of: rows as high as the font asks for and without numbers, nothing to be
/// edited in place, and Tab leaves it.
inline void choose_rows_of(QTableView* table) {
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
}

/// Makes one that is sorted by the columns' titles, each wide enough for its title. @pre its model has its columns
inline void sort_by_titles(QTableView* table) {
    constexpr int k_least_px = 84;
    table->setSortingEnabled(true);
    table->sortByColumn(0, Qt::AscendingOrder);
    table->setAlternatingRowColors(true);
    QHeaderView* header = table->horizontalHeader();
    for (int column = 0; column < header->count(); ++column)
        header->resizeSection(column, std::max(k_least_px, header->sectionSizeHint(column)));
}

}  // namespace lacuna::ui
