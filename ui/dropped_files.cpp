#include "ui/dropped_files.h"

#include <QFileInfo>
#include <algorithm>

#include "core/base/error.h"
#include "core/io/dicom_reader.h"
#include "core/session/session_file.h"

namespace lacuna::ui {

namespace {

constexpr int k_looked_at = 4;

bool ends_in(const QString& file, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](const char* ending) { return file.endsWith(QLatin1String(ending), Qt::CaseInsensitive); });
}

bool is_slice(const QString& file) {
    if (ends_in(file, {".tif", ".tiff"})) return true;
    try {
        return looks_like_dicom(file.toStdString());
    } catch (const Error&) {
        return false;  // opening it will say why
    }
}

/// Files that all lie in one folder and are slices, as far as a few of them tell.
bool are_slices(const QStringList& files) {
    const QString folder = QFileInfo(files.front()).path();
    for (const QString& file : files)
        if (!QFileInfo(file).isFile() || QFileInfo(file).path() != folder) return false;
    return std::all_of(files.begin(), files.begin() + std::min<qsizetype>(k_looked_at, files.size()), is_slice);
}

}  // namespace

Dropped dropped_input(const QStringList& files) {
    const int others = int(files.size()) - 1;
    if (others == 0) return {files.front(), 0, false};
    for (const QString& file : files)
        if (file.endsWith(QLatin1String(k_session_suffix))) return {file, others, false};
    for (const QString& file : files)
        if (ends_in(file, {".mhd", ".nhdr", ".hdr", ".vgi", ".dat"})) {
            const auto voxels = std::count_if(files.begin(), files.end(), [](const QString& other) {
                return ends_in(other, {".raw", ".zraw", ".img", ".vol", ".bin", ".gz"});
            });
            return {file, others - int(voxels), false};
        }
    if (are_slices(files)) return {QFileInfo(files.front()).path(), 0, true};
    return {files.front(), others, false};
}

}  // namespace lacuna::ui
