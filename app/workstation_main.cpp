#include <QCommandLineParser>

#include "ui/log_store.h"
#include "ui/preferences.h"
#include "ui/theme_control.h"
#include "ui/watchdog.h"
#include "ui/workstation.h"

int main(int argc, char** argv) {
    lacuna::ui::Application application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Lacuna"));
    lacuna::ui::name_application(QStringLiteral(LACUNA_VERSION));
    QCommandLineParser words;
    words.setApplicationDescription(QStringLiteral(
        "The Lacuna workstation: opens a CT volume, shows it in 3D and in slices, and measures its regions.\n"
        "Not a medical device; not for diagnosis.\n\nExample: lacuna-workstation sample:casting"));
    words.addHelpOption();
    words.addVersionOption();
    words.addPositionalArgument(QStringLiteral("INPUT"),
                                QStringLiteral("DICOM folder or file, mhd mha nrrd nhdr nii nii.gz hdr, TIFF, raw, or "
                                               "sample:NAME[@SIZE]"),
                                QStringLiteral("[INPUT]"));
    const QCommandLineOption device(QStringLiteral("device"),
                                    QStringLiteral("OpenCL device: its number or a part of its name; none: no device"),
                                    QStringLiteral("N|NAME"));
    words.addOption(device);
    words.process(application);
    lacuna::ui::ThemeControl::instance();
    lacuna::ui::LogStore::instance();

    const QString choice = words.isSet(device) ? words.value(device) : lacuna::ui::preferences::device();
    const lacuna::ui::Workstation workstation(
        lacuna::ui::engine_on(choice.toStdString(), lacuna::ui::preferences::memory_limit_mib()));
    if (!words.positionalArguments().isEmpty()) workstation.window()->openInput(words.positionalArguments().front());
    return QApplication::exec();
}
