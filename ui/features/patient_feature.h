#pragma once

#include "ui/workbench.h"

namespace lacuna::ui {

/// Who and what is shown: the words in the slices' corners and the window's title. With patient data hidden, neither
/// says a name, an identifier, a date or the file's name (which is often the patient's); a part's name (DICONDE) stays.
class PatientFeature final : public QObject {
    Q_OBJECT
public:
    explicit PatientFeature(Workbench& bench);
    bool hidden() const { return hidden_; }

public Q_SLOTS:
    void setHidden(bool hide);

private:
    void show();
    QStringList personLines() const;
    QStringList studyLines() const;
    QString titleWords() const;

    Workbench& bench_;
    QAction* shown_;
    bool hidden_;
};

}  // namespace lacuna::ui
