#include "ui/dialogs/command_palette.h"

#include <QAbstractListModel>
#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme.h"

namespace lacuna::ui {

namespace {

enum Role { k_path_role = Qt::UserRole, k_key_role, k_usable_role };

class CommandModel final : public QAbstractListModel {
public:
    CommandModel(QList<CatalogEntry> entries, QObject* parent)
        : QAbstractListModel(parent), entries_(std::move(entries)) {
        filter({});
    }

    void filter(const QString& pattern) {
        beginResetModel();
        std::vector<std::pair<int, qsizetype>> found;
        for (qsizetype i = 0; i < entries_.size(); ++i) {
            const CatalogEntry& entry = entries_[i];
            if (!entry.action) continue;
            // What the command itself is called counts more than where it stands.
            const int own = fuzzy_score(pattern, entry.text);
            const int whole = fuzzy_score(pattern, path_of(entry) + QLatin1Char(' ') + entry.text);
            const int score = std::max(own < 0 ? -1 : own + k_own_name, whole);
            if (score >= 0) found.emplace_back(score, i);
        }
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        shown_.clear();
        for (const auto& [score, i] : found) shown_.push_back(i);
        endResetModel();
    }

    QAction* action(int row) const { return entries_[shown_[std::size_t(row)]].action; }
    int rowCount(const QModelIndex& parent) const override { return parent.isValid() ? 0 : int(shown_.size()); }

    QVariant data(const QModelIndex& index, int role) const override {
        const CatalogEntry& entry = entries_[shown_[std::size_t(index.row())]];
        switch (role) {
            case Qt::DisplayRole:
                return entry.text;
            case k_path_role:
                return path_of(entry);
            case k_key_role:
                return entry.shortcut;
            case k_usable_role:
                return entry.action && entry.action->isEnabled();
            case Qt::AccessibleTextRole:
                return QStringLiteral("%1, %2 %3").arg(entry.text, path_of(entry), entry.shortcut).trimmed();
            default:
                return {};
        }
    }

private:
    static constexpr int k_own_name = 12;
    static QString path_of(const CatalogEntry& entry) { return entry.path.join(QStringLiteral(" › ")); }

    QList<CatalogEntry> entries_;
    std::vector<qsizetype> shown_;
};

/// The command, beneath it in small letters where it stands, at the right its key.
class CommandDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return {200, int(option.fontMetrics.height() * 1.85) + 8};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const ThemeColors& c = theme::colors();
        const bool chosen = option.state & QStyle::State_Selected, usable = index.data(k_usable_role).toBool();
        painter->save();
        if (chosen) painter->fillRect(option.rect, usable ? c.highlight : c.border);
        const QColor ink = chosen && usable ? c.highlighted_text : usable || chosen ? c.text : c.disabled;
        const QColor quiet = chosen ? ink : usable ? c.dim : c.disabled;
        const QRect inner = option.rect.adjusted(12, 4, -12, -4);
        painter->setPen(ink);
        painter->drawText(inner, Qt::AlignLeft | Qt::AlignTop, index.data().toString());
        painter->setPen(quiet);
        painter->drawText(inner, Qt::AlignRight | Qt::AlignVCenter, index.data(k_key_role).toString());
        QFont small = option.font;
        small.setPointSizeF(option.font.pointSizeF() * 0.85);
        painter->setFont(small);
        painter->drawText(inner, Qt::AlignLeft | Qt::AlignBottom, index.data(k_path_role).toString());
        painter->restore();
    }
};

}  // namespace

CommandPalette::CommandPalette(QList<CatalogEntry> entries, QWidget* parent)
    : QDialog(parent), edit_(new QLineEdit(this)), list_(new QListView(this)) {
    setWindowTitle(tr("Find a command"));
    auto* model = new CommandModel(std::move(entries), this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    edit_->setPlaceholderText(tr("Type a few letters of a command"));
    edit_->setAccessibleName(tr("Command to look for"));
    edit_->setClearButtonEnabled(true);
    edit_->installEventFilter(this);
    list_->setModel(model);
    list_->setItemDelegate(new CommandDelegate(list_));
    list_->setAccessibleName(tr("Commands found"));
    list_->setUniformItemSizes(true);
    list_->setFocusPolicy(Qt::NoFocus);  // the keys stay in the field, which passes arrows on
    column->addWidget(edit_);
    column->addWidget(list_, 1);
    resize(560, 440);
    const auto choose_first = [this, model] { list_->setCurrentIndex(model->index(0)); };
    choose_first();
    connect(edit_, &QLineEdit::textChanged, this, [model, choose_first](const QString& pattern) {
        model->filter(pattern);
        choose_first();
    });
    connect(list_, &QListView::clicked, this, &CommandPalette::runCurrent);
    connect(edit_, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
    edit_->setFocus();
}

void CommandPalette::runCurrent() {
    const QModelIndex index = list_->currentIndex();
    if (!index.isValid()) return;
    QAction* action = static_cast<CommandModel*>(list_->model())->action(index.row());
    if (!action || !action->isEnabled()) return;
    accept();
    // After this window has gone, so that the command finds the focus where it was.
    QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == edit_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(list_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace lacuna::ui
