#pragma once

#include <QPointer>

#include "ui/dicom_browser.h"
#include "ui/raw_import_dialog.h"
#include "ui/tasks.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Ways into and out of the window that need a question first: raw files of which nothing says how they are to be read,
/// the DICOM browser, anonymised DICOM.
class ImportFeature final : public QObject {
    Q_OBJECT
public:
    explicit ImportFeature(Workbench& bench);

    /// Asks how to read a raw file and opens it so.
    RawImportDialog* importRaw(const QString& file);
    /// Shows the DICOM browser; there is one.
    DicomBrowser* browse();
    /// Writes the open DICOM series, without the patient's data, into a new folder.
    void anonymise(const QString& folder);

public Q_SLOTS:
    void chooseRaw();
    void chooseAnonymised();

Q_SIGNALS:
    void anonymised();  ///< the export has ended

private:
    Workbench& bench_;
    QPointer<DicomBrowser> browser_;
    Tasks<QString> exports_;
};

}  // namespace lacuna::ui
