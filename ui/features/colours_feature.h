#pragma once

#include <QObject>
#include <QTabWidget>

#include "ui/panels/ranges_panel.h"
#include "ui/panels/transfer_panel.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Transfer functions and segmentation ranges of the open document: connects their panels to it.
class ColoursFeature final : public QObject {
    Q_OBJECT
public:
    /// @param tabs  where the panels stand as tabs
    ColoursFeature(Workbench& bench, TransferPanel* colours, RangesPanel* ranges, QTabWidget* tabs);

private:
    void addActions();

    Workbench& bench_;
    TransferPanel* colours_;
    RangesPanel* ranges_;
    QTabWidget* tabs_;
};

}  // namespace lacuna::ui
