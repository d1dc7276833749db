#include "ui/kept_places.h"

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>

#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

QDir data_folder() { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)); }

/// What was opened lately, which earlier versions kept among the preferences, readable by all.
QVariantMap taken_from_preferences() {
    QSettings settings;
    settings.beginGroup(QStringLiteral("recent"));
    QVariantMap recent;
    for (const QString& key : settings.allKeys()) recent[key] = settings.value(key);
    if (!recent.isEmpty()) settings.remove(QString());
    return recent;
}

}  // namespace

KeptPlaces& KeptPlaces::instance() {
    static KeptPlaces places;
    return places;
}

KeptPlaces::KeptPlaces() {
    const QVariantMap recent = taken_from_preferences();
    QFile::remove(data_folder().filePath(QStringLiteral("folders.ini")));  // of earlier versions, folders alone
    if (preferences::hide_patient()) {
        QFile::remove(file());
        return;
    }
    const QSettings kept(file(), QSettings::IniFormat);
    for (const QString& key : kept.allKeys())
        groups_[key.section(QLatin1Char('/'), 0, 0)][key.section(QLatin1Char('/'), 1)] = kept.value(key);
    const QString name = QStringLiteral("recent");
    if (!recent.isEmpty() && !groups_.contains(name)) setGroup(name, recent);
}

void KeptPlaces::setGroup(const QString& name, const QVariantMap& values) {
    groups_[name] = values;
    write({name});
}

QString KeptPlaces::file() { return data_folder().filePath(QStringLiteral("places.ini")); }

void KeptPlaces::write(const QStringList& groups) const {
    const QString name = file();
    if (preferences::hide_patient()) {
        QFile::remove(name);
        return;
    }
    data_folder().mkpath(QStringLiteral("."));
    {
        QFile own(name);  // nobody else's eyes, from the first byte on
        if (!own.exists() && !own.open(QIODevice::WriteOnly)) return;
        own.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    }
    QSettings kept(name, QSettings::IniFormat);
    for (const QString& group : groups) {
        kept.remove(group);
        const QVariantMap values = groups_.value(group);
        for (auto at = values.cbegin(); at != values.cend(); ++at)
            kept.setValue(group + QLatin1Char('/') + at.key(), at.value());
    }
}

}  // namespace lacuna::ui
