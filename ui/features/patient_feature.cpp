#include "ui/features/patient_feature.h"

#include <QSignalBlocker>

#include "core/io/dicom_identity.h"
#include "ui/kept_places.h"
#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text).simplified(); }

/// The texts that are there, on one line.
QString joined(std::initializer_list<QString> parts) {
    QStringList present;
    for (const QString& part : parts)
        if (!part.isEmpty()) present << part;
    return present.join(QStringLiteral(" · "));
}

}  // namespace

PatientFeature::PatientFeature(Workbench& bench)
    : QObject(&bench), bench_(bench), hidden_(preferences::hide_patient()) {
    shown_ = bench.addAlways(bench.menu(Workbench::Menu::view), tr("Patient &data"),
                             QKeySequence(QStringLiteral("Ctrl+Shift+H")), this,
                             [this](bool show_it) { setHidden(!show_it); });
    shown_->setCheckable(true);
    shown_->setChecked(!hidden_);
    shown_->setToolTip(tr("Names, identifiers, dates and file names in the views and the window's title"));
    connect(bench.documents(), &DocumentController::opened, this, &PatientFeature::show);
}

void PatientFeature::setHidden(bool hide) {
    shown_->setChecked(!hide);
    if (hide && !hidden_) bench_.messages()->showNotice({});  // it may name files, and those patients
    hidden_ = hide;
    preferences::set_hide_patient(hide);
    KeptPlaces::instance().keep();
    show();
}

QStringList PatientFeature::personLines() const {
    const Document& document = bench_.documents()->document();
    QStringList lines;
    if (document.volume.dicom)
        for (const auto& [key, value] : document.volume.dicom->component)
            if (key == "name" || key == "id") lines << text_of(value);
    if (hidden() || !document.patient) return lines;
    const PatientIdentity& patient = *document.patient;
    lines << text_of(patient.name) << text_of(patient.id)
          << joined({text_of(patient.birth_date), text_of(patient.sex), text_of(patient.age)});
    lines.removeAll(QString());
    return lines;
}

QStringList PatientFeature::studyLines() const {
    const Document& document = bench_.documents()->document();
    QStringList lines;
    if (!hidden() && document.patient)
        lines << text_of(document.patient->place)
              << joined({text_of(document.patient->study_date), text_of(document.patient->study)});
    if (document.volume.dicom)
        lines << joined({text_of(document.volume.dicom->modality), text_of(document.volume.dicom->description)});
    else if (!hidden())
        lines << text_of(document.volume.name);
    lines.removeAll(QString());
    return lines;
}

QString PatientFeature::titleWords() const {
    const Document& document = bench_.documents()->document();
    const bool sample = document.input.starts_with("sample:");
    const QString name = text_of(document.volume.name.empty() ? document.input : document.volume.name);
    if (!hidden()) return joined({document.patient ? text_of(document.patient->name) : QString(), name});
    if (sample) return name;
    return document.volume.dicom ? text_of(document.volume.dicom->modality) : QString();
}

void PatientFeature::show() {
    if (!bench_.documents()->hasDocument()) return;
    for (SliceView* slice : bench_.views()->slices()) slice->setCornerWords(personLines(), studyLines());
    const QString words = titleWords();
    bench_.window()->setWindowTitle(words.isEmpty() ? tr("[*]Lacuna") : tr("%1[*] — Lacuna").arg(words));
}

}  // namespace lacuna::ui
