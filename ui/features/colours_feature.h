#pragma once

#include <QObject>
#include <QTabWidget>

#include "ui/file_writes.h"
#include "ui/latest_job.h"
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

    /// Reads a file, off the window's thread, for the function being edited.
    void loadFunction(const QString& file);
    /// Writes the function being edited.
    void saveFunction(const QString& file);

Q_SIGNALS:
    void loaded();
    void written(const QString& file);

private:
    void addActions();
    void askForLoad();
    void askForSave();

    Workbench& bench_;
    TransferPanel* colours_;
    RangesPanel* ranges_;
    QTabWidget* tabs_;
    LatestJob<TransferFunction> read_;
    FileWrites writes_;
};

}  // namespace lacuna::ui
