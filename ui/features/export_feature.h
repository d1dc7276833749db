#pragma once

#include "ui/file_writes.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// What leaves the window as a file: pictures of the views, turntables, meshes, volumes, labels.
class ExportFeature final : public QObject {
    Q_OBJECT
public:
    explicit ExportFeature(Workbench& bench);

    /// The view with the focus (the 3D view where none has) as it stands, or without the words and marks on it.
    QImage picture(bool annotated) const;
    /// PNG or TIFF, by the name's ending.
    void savePicture(const QString& file, bool annotated);
    /// @param file  .png: a series NAME-000.png ..; .mp4 or .webm: a film by ffmpeg
    void saveTurntable(const QString& file, int frames);
    /// The surface of the isovalue as .stl, .ply, .obj or .vtp.
    void saveMesh(const QString& file);
    /// The volume as any format `lacuna convert` writes.
    void saveVolume(const QString& file);

public Q_SLOTS:
    void copyPicture();

Q_SIGNALS:
    void written(const QString& file);  ///< of any of the above

private:
    void buildMenu();
    void askPicture(bool annotated);
    void writePicture(const QImage& image, const QString& file);

    Workbench& bench_;
    FileWrites writes_;
};

}  // namespace lacuna::ui
