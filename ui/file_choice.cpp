#include "ui/file_choice.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMap>
#include <QSettings>
#include <QStandardPaths>

#include "ui/preferences.h"

namespace lacuna::ui::file_choice {

namespace {

constexpr const char* k_names[] = {"volume", "dicom",   "session", "preset", "criteria", "parts",    "certificate",
                                   "report", "picture", "mesh",    "table",  "copy",     "retrieved"};

QString name_of(FileKind kind) { return QString::fromLatin1(k_names[int(kind)]); }

/// Any kind that is read, or written.
QString name_of_any(bool to_write) { return to_write ? QStringLiteral("any-written") : QStringLiteral("any-read"); }

QString kept_file() {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    folder.mkpath(QStringLiteral("."));
    return folder.filePath(QStringLiteral("folders.ini"));
}

/// Of this run, and of the runs before where they were kept.
QMap<QString, QString>& last_folders() {
    static QMap<QString, QString> folders = [] {
        QMap<QString, QString> kept;
        const QSettings file(kept_file(), QSettings::IniFormat);
        for (const QString& key : file.allKeys()) kept[key] = file.value(key).toString();
        return kept;
    }();
    return folders;
}

QString folder_of(const QString& path) { return path.isEmpty() ? QString() : QFileInfo(path).absolutePath(); }

bool is_folder(const QString& path) { return !path.isEmpty() && QFileInfo(path).isDir(); }

void keep() {
    const QString name = kept_file();
    if (preferences::hide_patient()) {
        QFile::remove(name);
        return;
    }
    {
        QFile file(name);  // nobody else's eyes, from the first byte on
        if (!file.exists() && !file.open(QIODevice::WriteOnly)) return;
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    }
    QSettings file(name, QSettings::IniFormat);
    file.clear();
    for (auto at = last_folders().cbegin(); at != last_folders().cend(); ++at) file.setValue(at.key(), at.value());
}

}  // namespace

QString start_folder(FileKind kind, bool to_write) {
    const QString chosen = to_write ? preferences::save_folder() : preferences::open_folder();
    if (is_folder(chosen)) return chosen;
    if (const QString own = last_folders().value(name_of(kind)); is_folder(own)) return own;
    if (const QString alike = last_folders().value(name_of_any(to_write)); is_folder(alike)) return alike;
    return QDir::homePath();
}

void remember(FileKind kind, bool to_write, const QString& folder) {
    if (folder.isEmpty()) return;
    QMap<QString, QString>& folders = last_folders();
    const QString alike = name_of_any(to_write);
    if (folders.value(name_of(kind)) == folder && folders.value(alike) == folder) return;
    folders[name_of(kind)] = folders[alike] = folder;
    keep();
}

void forget() {
    last_folders().clear();
    QFile::remove(kept_file());
}

QString open_file(QWidget* parent, const QString& title, FileKind kind, const QString& filter) {
    const QString file = QFileDialog::getOpenFileName(parent, title, start_folder(kind, false), filter);
    remember(kind, false, folder_of(file));
    return file;
}

QStringList open_files(QWidget* parent, const QString& title, FileKind kind, const QString& filter) {
    const QStringList files = QFileDialog::getOpenFileNames(parent, title, start_folder(kind, false), filter);
    if (!files.isEmpty()) remember(kind, false, folder_of(files.front()));
    return files;
}

QString open_folder(QWidget* parent, const QString& title, FileKind kind, bool to_write) {
    const QString folder = QFileDialog::getExistingDirectory(parent, title, start_folder(kind, to_write));
    // What is written goes into the same folder again; what is read lies beside what was read before.
    remember(kind, to_write, to_write ? folder : folder_of(folder));
    return folder;
}

QString save_file(QWidget* parent, const QString& title, FileKind kind, const QString& name, const QString& filter) {
    const QString file =
        QFileDialog::getSaveFileName(parent, title, QDir(start_folder(kind, true)).filePath(name), filter);
    remember(kind, true, folder_of(file));
    return file;
}

}  // namespace lacuna::ui::file_choice
