#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>

#include "ui/language.h"
#include "ui/preferences.h"
#include "ui/theme.h"
#include "ui/watchdog.h"

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    // Nobody's own preferences and sessions are read or changed.
    const QTemporaryDir preferences;
    const QByteArray home = qgetenv("LACUNA_TEST_HOME");  // of a test that starts this program again
    qputenv("XDG_DATA_HOME", home.isEmpty() ? preferences.path().toUtf8() : home);
    lacuna::ui::Application application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, preferences.path());
    lacuna::ui::name_application(QStringLiteral("test"));
    lacuna::ui::preferences::set_language(QStringLiteral("en"));
    lacuna::ui::Language::instance();
    lacuna::ui::apply_theme(application);
    return RUN_ALL_TESTS();
}
