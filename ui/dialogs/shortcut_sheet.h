#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

#include "ui/action_catalog.h"

class QPagedPaintDevice;

namespace lacuna::ui {

/// Every key and every gesture of the mouse on one sheet, made from the menus and the list of gestures; can be
/// searched and printed.
class ShortcutSheet final : public QDialog {
    Q_OBJECT
public:
    ShortcutSheet(const QList<CatalogEntry>& entries, QWidget* parent);
    QLineEdit* edit() const { return edit_; }
    QTreeWidget* table() const { return table_; }
    /// Rows now shown, without the headings.
    int shownRows() const;
    /// The whole sheet as a document of the printer's page size.
    void print(QPagedPaintDevice* device) const;

private:
    void addRow(const QString& group, const QString& what, const QString& keys);
    void filter(const QString& words);
    void askPrinter();

    QLineEdit* edit_;
    QTreeWidget* table_;
};

}  // namespace lacuna::ui
