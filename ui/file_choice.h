#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace lacuna::ui {

/// What a file dialog is about. Each begins where the last one of its kind ended.
enum class FileKind {
    volume,
    dicom,
    session,
    preset,
    criteria,
    parts,
    certificate,
    report,
    picture,
    mesh,
    table,
    copy,
    retrieved
};

/// The one way to ask for files and folders: a dialog starts in the folder chosen in the settings for reading or
/// writing; where none was chosen, in the last one used for this kind of file, else for another kind that is read or
/// written alike, else at home. What was used last is kept as KeptPlaces says.
namespace file_choice {

/// Each gives an empty answer where nothing was chosen, and remembers where it was otherwise.
QString open_file(QWidget* parent, const QString& title, FileKind kind, const QString& filter);
QStringList open_files(QWidget* parent, const QString& title, FileKind kind, const QString& filter);
/// @param to_write  files are to be written into it
QString open_folder(QWidget* parent, const QString& title, FileKind kind, bool to_write = false);
/// @param name  the file proposed
QString save_file(QWidget* parent, const QString& title, FileKind kind, const QString& name,
                  const QString& filter = {});

/// Where a dialog of this kind starts, to read or to write; a folder that exists.
QString start_folder(FileKind kind, bool to_write);
void remember(FileKind kind, bool to_write, const QString& folder);
void forget();

}  // namespace file_choice

}  // namespace lacuna::ui
