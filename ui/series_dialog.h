#pragma once

#include <QDialog>
#include <QTableWidget>
#include <vector>

#include "core/io/volume_reader.h"

namespace lacuna::ui {

/// Asks which of several volumes to open.
class SeriesDialog final : public QDialog {
    Q_OBJECT
public:
    SeriesDialog(const std::vector<lacuna::SeriesEntry>& entries, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(const QString& number);

private:
    QTableWidget* table_;
};

}  // namespace lacuna::ui
