#pragma once

#include <QObject>
#include <filesystem>

#include "ui/file_writes.h"
#include "ui/latest_job.h"
#include "ui/panels/preset_gallery.h"
#include "ui/preset_thumbnails.h"
#include "ui/tasks.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// The gallery of presets: built-in ones and one's own, which are files in the program's data folder.
class PresetsFeature final : public QObject {
    Q_OBJECT
public:
    explicit PresetsFeature(Workbench& bench);

    PresetGallery* gallery() const { return gallery_; }
    QDockWidget* dock() const { return dock_; }
    PresetThumbnails* thumbnails() const { return thumbnails_; }
    /// Where one's own presets are kept.
    static std::filesystem::path folder();

public Q_SLOTS:
    void showGallery();
    void apply(const lacuna::PresetEntry& entry);
    /// Keeps what is shown under a name; asks before it replaces one's own preset of that name.
    void saveAs(const QString& name);
    void rename(const lacuna::PresetEntry& entry, const QString& name);
    void remove(const lacuna::PresetEntry& entry);
    /// Takes a file among one's own presets.
    void importFile(const QString& file);
    void exportFile(const lacuna::PresetEntry& entry, const QString& file);

Q_SIGNALS:
    void listed();  ///< the gallery shows what is kept
    void imported(const QString& name);
    void exported(const QString& file);

private:
    void connectGallery();
    void connectDocument();
    void addActions();
    /// Brings the gallery up to what is kept. @param choose  the preset to be marked then; empty: as it was
    void list(const QString& choose = {});
    void drawVisible();
    void keep(const PresetFile& preset, bool replace);
    void askToReplace(const PresetFile& preset);
    /// Changes one's own presets, then lists them. @param work  says which to mark; empty: as it was
    void change(const QString& name, Task<QString>::Work work, std::function<void(const QString&)> done = nullptr);
    void askName(const QString& title, const QString& proposed, std::function<void(const QString&)> then);
    Workbench& bench_;
    PresetGallery* gallery_;
    QDockWidget* dock_;
    PresetThumbnails* thumbnails_;
    LatestJob<std::vector<PresetEntry>> listing_;
    QString choose_;                                     ///< once they are listed
    Tasks<std::optional<std::filesystem::path>> keeps_;  ///< the file; none where a person must be asked first
    Tasks<QString> changes_;
    FileWrites exports_;
};

}  // namespace lacuna::ui
