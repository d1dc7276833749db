#pragma once

#include <QHeaderView>
#include <QTableView>
#include <algorithm>

namespace lacuna::ui {

/// Makes every column wide enough for its title, and rows as high as the font asks for.
inline void fit_headers(QTableView* table, int least_px = 84) {
    QHeaderView* header = table->horizontalHeader();
    for (int column = 0; column < header->count(); ++column)
        header->resizeSection(column, std::max(least_px, header->sectionSizeHint(column)));
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
}

}  // namespace lacuna::ui
