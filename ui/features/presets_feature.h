#pragma once

#include <QObject>
#include <filesystem>

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
    void imported(const QString& name);
    void exported(const QString& file);

private:
    void connectGallery();
    void connectDocument();
    void addActions();
    void list();
    void drawVisible();
    void askName(const QString& title, const QString& proposed, std::function<void(const QString&)> then);
    /// Runs what may fail and reports it.
    template <class Work>
    bool attempt(Work&& work);

    Workbench& bench_;
    PresetGallery* gallery_;
    QDockWidget* dock_;
    PresetThumbnails* thumbnails_;
    Tasks<QString> files_;
};

}  // namespace lacuna::ui
