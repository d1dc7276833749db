#include <QApplication>
#include <QCommandLineParser>

#include "core/compute/device.h"
#include "ui/main_window.h"
#include "ui/preferences.h"
#include "ui/theme_control.h"

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Lacuna"));
    lacuna::ui::name_application(QStringLiteral(LACUNA_VERSION));
    QCommandLineParser words;
    words.setApplicationDescription(QStringLiteral(
        "The Lacuna workstation: opens a CT volume, shows it in 3D and in slices, and measures its regions.\n"
        "Not a medical device; not for diagnosis.\n\nExample: lacuna-workstation sample:casting"));
    words.addHelpOption();
    words.addVersionOption();
    words.addPositionalArgument(QStringLiteral("INPUT"),
                                QStringLiteral("DICOM folder or file, mhd mha nrrd nhdr nii nii.gz, TIFF, raw, or "
                                               "sample:NAME[@SIZE]"),
                                QStringLiteral("[INPUT]"));
    const QCommandLineOption device(QStringLiteral("device"),
                                    QStringLiteral("OpenCL device: its number or a part of its name; none: no device"),
                                    QStringLiteral("N|NAME"));
    words.addOption(device);
    words.process(application);
    lacuna::ui::ThemeControl::instance();

    const std::string choice = words.value(device).toStdString();
    lacuna::ui::MainWindow window([choice](const lacuna::JobContext& job) {
        return std::make_shared<lacuna::Engine>(choice == "none" ? nullptr : lacuna::open_device(choice, job));
    });
    window.show();
    if (!words.positionalArguments().isEmpty()) window.openInput(words.positionalArguments().front());
    return QApplication::exec();
}
