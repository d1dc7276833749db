#include "ui/file_choice.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include "ui/kept_places.h"
#include "ui/preferences.h"

namespace lacuna::ui::file_choice {

namespace {

constexpr const char* k_names[] = {"volume", "dicom",   "session", "preset", "criteria", "parts",    "certificate",
                                   "report", "picture", "mesh",    "table",  "copy",     "retrieved"};

QString name_of(FileKind kind) { return QString::fromLatin1(k_names[int(kind)]); }

/// Any kind that is read, or written.
QString name_of_any(bool to_write) { return to_write ? QStringLiteral("any-written") : QStringLiteral("any-read"); }

const QString k_group = QStringLiteral("folders");

QString last_folder(const QString& name) { return KeptPlaces::instance().group(k_group).value(name).toString(); }

QString folder_of(const QString& path) { return path.isEmpty() ? QString() : QFileInfo(path).absolutePath(); }

bool is_folder(const QString& path) { return !path.isEmpty() && QFileInfo(path).isDir(); }

}  // namespace

QString start_folder(FileKind kind, bool to_write) {
    const QString chosen = to_write ? preferences::save_folder() : preferences::open_folder();
    if (is_folder(chosen)) return chosen;
    if (const QString own = last_folder(name_of(kind)); is_folder(own)) return own;
    if (const QString alike = last_folder(name_of_any(to_write)); is_folder(alike)) return alike;
    return QDir::homePath();
}

void remember(FileKind kind, bool to_write, const QString& folder) {
    if (folder.isEmpty()) return;
    const QString own = name_of(kind), alike = name_of_any(to_write);
    if (last_folder(own) == folder && last_folder(alike) == folder) return;
    QVariantMap folders = KeptPlaces::instance().group(k_group);
    folders[own] = folders[alike] = folder;
    KeptPlaces::instance().setGroup(k_group, folders);
}

void forget() { KeptPlaces::instance().setGroup(k_group, {}); }

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
    // The dialog itself adds the ending, so that it asks about the file that is then written.
    QFileDialog dialog(parent, title, start_folder(kind, true), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(QFileInfo(name).suffix());
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& chosen) {
        static const QRegularExpression first_ending(QStringLiteral("\\*\\.([\\w.]+)"));
        dialog.setDefaultSuffix(first_ending.match(chosen).captured(1));
    });
    dialog.selectFile(name);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    const QString file = dialog.selectedFiles().front();
    remember(kind, true, folder_of(file));
    return file;
}

}  // namespace lacuna::ui::file_choice
