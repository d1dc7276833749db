#pragma once

#include <QList>
#include <QPointer>
#include <QString>
#include <QStringList>

class QAction;
class QMenu;
class QMenuBar;

namespace lacuna::ui {

/// A command as it stands in the menus.
struct CatalogEntry {
    QStringList path;  ///< titles of the menus it stands in, outermost first, without mnemonics
    QString text;      ///< its own, without mnemonic and dots
    QPointer<QAction> action;
    QString shortcut;  ///< as the platform writes it; empty for none
};

/// Every command of every visible menu, in their order. Menus that fill themselves when they open are asked to.
QList<CatalogEntry> catalog_of(QMenuBar* bar);

/// A menu text without the ampersand of its mnemonic and without the dots at its end.
QString plain_text(const QString& text);

/// How well what was typed matches a text: its letters must come in this order; higher for letters in a row and at the
/// beginning of words. Below 0: no match. Case and accents do not count. An empty pattern matches everything with 0.
int fuzzy_score(const QString& pattern, const QString& text);

}  // namespace lacuna::ui
