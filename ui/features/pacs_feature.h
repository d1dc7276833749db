#pragma once

#include <QPointer>

#include "ui/pacs_dialog.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// DICOM servers in the window: a dialog to search, retrieve and send; what was retrieved is opened.
class PacsFeature final : public QObject {
    Q_OBJECT
public:
    explicit PacsFeature(Workbench& bench);

public Q_SLOTS:
    void showDialog();

private:
    Workbench& bench_;
    QPointer<PacsDialog> dialog_;
};

}  // namespace lacuna::ui
