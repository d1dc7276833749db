#include "ui/preferences.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>
#include <utility>

namespace lacuna::ui {

namespace preferences {

namespace {

template <class Value>
Value read(const char* key, const Value& fallback) {
    const QVariant kept = QSettings().value(QLatin1String(key));
    return kept.canConvert<Value>() ? kept.value<Value>() : fallback;
}

template <class Value>
void keep(const char* key, const Value& value) {
    QSettings().setValue(QLatin1String(key), value);
}

int within(int value, int lo, int hi, int fallback) { return value >= lo && value <= hi ? value : fallback; }

constexpr int k_autosave_default = 2, k_autosave_most = 60;

}  // namespace

ThemeChoice theme() {
    const QString kept = read("look/theme", QString());
    return kept == QLatin1String("dark")    ? ThemeChoice::dark
           : kept == QLatin1String("light") ? ThemeChoice::light
                                            : ThemeChoice::system;
}
void set_theme(ThemeChoice choice) {
    keep("look/theme", choice == ThemeChoice::dark    ? QStringLiteral("dark")
                       : choice == ThemeChoice::light ? QStringLiteral("light")
                                                      : QStringLiteral("system"));
}

QString language() {
    const QString kept = read("look/language", QString());
    return kept == QLatin1String("en") || kept == QLatin1String("de") ? kept : QString();
}
void set_language(const QString& code) { keep("look/language", code); }

QString device() { return read("compute/device", QString()); }
void set_device(const QString& choice) { keep("compute/device", choice); }

int memory_limit_mib() { return std::max(0, read("compute/memory_limit_mib", 0)); }
void set_memory_limit_mib(int mib) { keep("compute/memory_limit_mib", mib); }

bool hide_patient() { return read("privacy/hide_patient", false); }
void set_hide_patient(bool hide) { keep("privacy/hide_patient", hide); }

int autosave_minutes() {
    return within(read("session/autosave_minutes", k_autosave_default), 0, k_autosave_most, k_autosave_default);
}
void set_autosave_minutes(int minutes) { keep("session/autosave_minutes", minutes); }

QString open_folder() { return read("folders/open", QString()); }
void set_open_folder(const QString& folder) { keep("folders/open", folder); }
QString save_folder() { return read("folders/save", QString()); }
void set_save_folder(const QString& folder) { keep("folders/save", folder); }

QByteArray window_geometry() { return read("window/geometry", QByteArray()); }
QByteArray window_state() { return read("window/state", QByteArray()); }
void set_window(const QByteArray& geometry, const QByteArray& state) {
    keep("window/geometry", geometry);
    keep("window/state", state);
}
void forget_window() { QSettings().remove(QStringLiteral("window")); }

QByteArray views_state() { return read("window/views", QByteArray()); }
void set_views_state(const QByteArray& state) { keep("window/views", state); }

bool free_rotation() { return read("view/free_rotation", false); }
void set_free_rotation(bool free) { keep("view/free_rotation", free); }

}  // namespace preferences

void name_application(const QString& version) {
    QCoreApplication::setOrganizationName(QStringLiteral("lacuna"));
    QCoreApplication::setApplicationName(QStringLiteral("lacuna-workstation"));
    QCoreApplication::setApplicationVersion(version);
}

}  // namespace lacuna::ui
