#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QListView>

#include "ui/action_catalog.h"

namespace lacuna::ui {

/// Finds commands by a few of their letters: every one of the menus with its path and key, the best match first;
/// those that cannot be used now are grey. Enter runs the chosen one, Escape leaves.
class CommandPalette final : public QDialog {
    Q_OBJECT
public:
    explicit CommandPalette(QList<CatalogEntry> entries, QWidget* parent);
    QLineEdit* edit() const { return edit_; }
    QListView* list() const { return list_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void runCurrent();
    QLineEdit* edit_;
    QListView* list_;
};

}  // namespace lacuna::ui
