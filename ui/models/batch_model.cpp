#include "ui/models/batch_model.h"

#include <algorithm>

#include "ui/core_sentences.h"

namespace lacuna::ui {

namespace {

QString state_text(PartState state) {
    switch (state) {
        case PartState::waiting:
            return BatchModel::tr("waiting");
        case PartState::running:
            return BatchModel::tr("running");
        case PartState::done:
            return BatchModel::tr("done");
        case PartState::broken:
            return BatchModel::tr("broken");
    }
    return {};
}

QString verdict_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return BatchModel::tr("pass");
        case Verdict::fail:
            return BatchModel::tr("fail");
        case Verdict::cannot_tell:
            return BatchModel::tr("cannot tell");
    }
    return {};
}

}  // namespace

void BatchModel::setParts(const std::vector<BatchPart>& parts) {
    beginResetModel();
    rows_.clear();
    for (const BatchPart& part : parts) {
        Row row;
        row.name = QString::fromStdString(part.name);
        rows_.push_back(std::move(row));
    }
    endResetModel();
}

void BatchModel::setState(std::size_t part, PartState state, double progress) {
    if (part >= rows_.size()) return;
    rows_[part].state = state;
    rows_[part].progress = progress;
    Q_EMIT dataChanged(index(int(part), 0), index(int(part), k_columns - 1));
}

void BatchModel::setRows(const std::vector<BatchRow>& rows) {
    for (const BatchRow& found : rows)
        for (Row& row : rows_) {
            if (row.name != QString::fromStdString(found.name)) continue;
            row.state = found.verdict ? PartState::done : PartState::broken;
            row.progress = 1;
            row.verdict = found.verdict;
            row.reasons.clear();
            for (const std::string& reason : reasons_of(found)) row.reasons << core_sentence(reason);
        }
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(int(rows_.size()) - 1, k_columns - 1));
}

void BatchModel::stopRunning() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].state == PartState::running) setState(i, PartState::waiting, 0);
}

int BatchModel::finishedParts() const {
    return int(std::count_if(rows_.begin(), rows_.end(), [](const Row& row) {
        return row.state == PartState::done || row.state == PartState::broken;
    }));
}

int BatchModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(rows_.size()); }
int BatchModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(k_columns); }

QString BatchModel::text(const Row& row, int column) const {
    switch (column) {
        case k_name:
            return row.name;
        case k_state:
            return state_text(row.state);
        case k_progress:
            return row.state == PartState::waiting ? QString() : tr("%1 %").arg(int(100 * row.progress));
        case k_verdict:
            return row.verdict ? verdict_text(*row.verdict) : QString();
        case k_reason:
            if (row.reasons.size() < 2) return row.reasons.join(QString());
            return tr("%1 (and %n more)", nullptr, int(row.reasons.size()) - 1).arg(row.reasons.front());
        default:
            return {};
    }
}

QVariant BatchModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = rows_[std::size_t(index.row())];
    if (role == Qt::ToolTipRole && index.column() == k_reason) return row.reasons.join(QLatin1Char('\n'));
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return text(row, index.column());
    if (role == Qt::TextAlignmentRole && index.column() == k_progress) return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant BatchModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section + 1;
    const QString titles[] = {tr("Part"), tr("State"), tr("Progress"), tr("Verdict"), tr("Reason")};
    return section < k_columns ? titles[section] : QVariant();
}

}  // namespace lacuna::ui
