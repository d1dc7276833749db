#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QSortFilterProxyModel>
#include <memory>
#include <vector>

#include "core/inspect/verdict.h"

namespace lacuna::ui {

/// What a defect's colour tells.
enum class DefectColoring { verdict, size, depth };

/// Colours of all defects, by row: green, yellow, vermilion by verdict (Okabe & Ito 2008); dark to bright by size
/// (logarithmic, from the part's smallest to its largest defect) or by depth below the part's surface (bright: near).
std::vector<QColor> defect_colors(const PartAnalysis& part, const Judgement& judgement, DefectColoring coloring);

/// The rows of a defect table with their verdicts. The sort role gives numbers, so that 10 comes after 9.
class DefectModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int k_sort_role = Qt::UserRole;
    static constexpr int k_id_role = Qt::UserRole + 1;

    explicit DefectModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
    /// @param judgement  of this part; as many rows
    void set(std::shared_ptr<const lacuna::PartAnalysis> part, const lacuna::Judgement& judgement);
    /// New verdicts on the same part: the selection stays.
    void setJudgement(const lacuna::Judgement& judgement);
    void setColoring(DefectColoring coloring);
    const std::vector<QColor>& colors() const { return colors_; }
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(std::size_t row, int column) const;
    void recolor();

    std::shared_ptr<const PartAnalysis> part_;
    Judgement judgement_;
    DefectColoring coloring_ = DefectColoring::verdict;
    std::vector<QColor> colors_;
};

/// Rows whose type, verdict or reason holds the words typed; or, as "column > number" (volume, diameter, gap, depth,
/// voxels; also < >= <=), whose value is on that side.
class DefectFilter final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit DefectFilter(QObject* parent = nullptr) : QSortFilterProxyModel(parent) {}
    void setText(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString words_;
    int column_ = -1;
    QString side_;
    double limit_ = 0;
};

}  // namespace lacuna::ui
