#include "ui/dialogs/shortcut_sheet.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTextDocument>
#include <QVBoxLayout>

#include "ui/gestures.h"

namespace lacuna::ui {

ShortcutSheet::ShortcutSheet(const QList<CatalogEntry>& entries, QWidget* parent)
    : QDialog(parent), edit_(new QLineEdit(this)), table_(new QTreeWidget(this)) {
    setWindowTitle(tr("Keys and mouse"));
    resize(840, 680);
    edit_->setPlaceholderText(tr("Search keys and commands"));
    edit_->setAccessibleName(tr("Words to look for"));
    edit_->setClearButtonEnabled(true);
    table_->setAccessibleName(tr("Keys and mouse"));
    table_->setColumnCount(2);
    table_->setHeaderLabels({tr("Command"), tr("Keys or mouse")});
    table_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table_->header()->setStretchLastSection(true);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    for (const CatalogEntry& entry : entries) {
        if (entry.shortcut.isEmpty()) continue;
        const QStringList inner = entry.path.mid(1) + QStringList{entry.text};
        addRow(entry.path.value(0), inner.join(QStringLiteral(" › ")), entry.shortcut);
    }
    for (const Gesture& gesture : gestures()) addRow(tr("Mouse: %1").arg(gesture.where), gesture.effect, gesture.input);
    table_->expandAll();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* print = buttons->addButton(tr("&Print…"), QDialogButtonBox::ActionRole);
    print->setAutoDefault(false);
    print->setAccessibleName(tr("Print the sheet"));
    buttons->button(QDialogButtonBox::Close)->setAccessibleName(tr("Close the sheet"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(edit_);
    column->addWidget(table_, 1);
    column->addWidget(buttons);
    connect(edit_, &QLineEdit::textChanged, this, &ShortcutSheet::filter);
    connect(print, &QPushButton::clicked, this, &ShortcutSheet::askPrinter);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    edit_->setFocus();
}

void ShortcutSheet::addRow(const QString& group, const QString& what, const QString& keys) {
    QTreeWidgetItem* heading = nullptr;
    for (int i = 0; i < table_->topLevelItemCount() && !heading; ++i)
        if (table_->topLevelItem(i)->text(0) == group) heading = table_->topLevelItem(i);
    if (!heading) {
        heading = new QTreeWidgetItem(table_, {group});
        QFont bold = table_->font();
        bold.setBold(true);
        heading->setFont(0, bold);
        heading->setFlags(Qt::ItemIsEnabled);
    }
    new QTreeWidgetItem(heading, {what, keys});
}

void ShortcutSheet::filter(const QString& words) {
    for (int i = 0; i < table_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* heading = table_->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < heading->childCount(); ++k) {
            QTreeWidgetItem* row = heading->child(k);
            bool all = true;
            const QString text = heading->text(0) + QLatin1Char(' ') + row->text(0) + QLatin1Char(' ') + row->text(1);
            for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts))
                all = all && text.contains(word, Qt::CaseInsensitive);
            row->setHidden(!all);
            any = any || all;
        }
        heading->setHidden(!any);
    }
}

int ShortcutSheet::shownRows() const {
    int rows = 0;
    for (int i = 0; i < table_->topLevelItemCount(); ++i)
        for (int k = 0; k < table_->topLevelItem(i)->childCount(); ++k)
            rows += !table_->topLevelItem(i)->child(k)->isHidden();
    return rows;
}

void ShortcutSheet::print(QPagedPaintDevice* device) const {
    QString html = QStringLiteral("<h2>%1</h2>").arg(tr("Lacuna: keys and mouse").toHtmlEscaped());
    for (int i = 0; i < table_->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* heading = table_->topLevelItem(i);
        html +=
            QStringLiteral("<h4>%1</h4><table width=\"100%\" cellpadding=\"2\">").arg(heading->text(0).toHtmlEscaped());
        for (int k = 0; k < heading->childCount(); ++k)
            html += QStringLiteral("<tr><td width=\"62%\">%1</td><td><b>%2</b></td></tr>")
                        .arg(heading->child(k)->text(0).toHtmlEscaped(), heading->child(k)->text(1).toHtmlEscaped());
        html += QStringLiteral("</table>");
    }
    QTextDocument document;
    document.setDefaultStyleSheet(QStringLiteral("body { color: black; }"));
    document.setHtml(QStringLiteral("<body>%1</body>").arg(html));
    document.print(device);
}

void ShortcutSheet::askPrinter() {
    auto* printer = new QPrinter(QPrinter::HighResolution);
    auto* dialog = new QPrintDialog(printer, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, printer] { print(printer); });
    connect(dialog, &QObject::destroyed, this, [printer] { delete printer; });
    dialog->open();
}

}  // namespace lacuna::ui
