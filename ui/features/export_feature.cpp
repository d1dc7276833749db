#include "ui/features/export_feature.h"

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QImageWriter>
#include <QInputDialog>

#include "core/base/atomic_file.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "core/regions/iso_mesh.h"
#include "ui/file_choice.h"
#include "ui/tool_bar.h"
#include "ui/turntable.h"

namespace lacuna::ui {

namespace {

QByteArray encoded(const QImage& image, const QString& file) {
    const bool tiff = file.endsWith(QStringLiteral(".tif"), Qt::CaseInsensitive) ||
                      file.endsWith(QStringLiteral(".tiff"), Qt::CaseInsensitive);
    if (!tiff && !file.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive))
        throw Error(Errc::bad_usage, ExportFeature::tr("A picture's name ends in .png, .tif or .tiff.").toStdString());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, tiff ? "tiff" : "png");
    if (!writer.write(image))
        throw Error(Errc::unsupported,
                    ExportFeature::tr("The picture could not be packed: %1.").arg(writer.errorString()).toStdString());
    return bytes;
}

}  // namespace

ExportFeature::ExportFeature(Workbench& bench) : QObject(&bench), bench_(bench), writes_(bench) {
    connect(&writes_, &FileWrites::written, this, &ExportFeature::written);
    buildMenu();
}

void ExportFeature::buildMenu() {
    QMenu* menu = bench_.submenu(Workbench::Menu::file, tr("&Export"));
    offer_tool(bench_.add(menu, tr("&Picture of the view…"), QKeySequence(QStringLiteral("Ctrl+Shift+P")), this,
                          [this] { askPicture(true); }),
               ToolGroup::document, Icon::picture, tr("Picture"));
    bench_.add(menu, tr("Picture &without words and marks…"), QKeySequence(QStringLiteral("Ctrl+Alt+Shift+P")), this,
               [this] { askPicture(false); });
    bench_.add(menu, tr("&Turntable…"), QKeySequence(QStringLiteral("Ctrl+Alt+T")), this, [this] {
        const QString file = file_choice::save_file(
            bench_.window(), tr("Save a turntable"), FileKind::picture, QStringLiteral("turntable.png"),
            film_encoder().isEmpty() ? tr("Pictures (*.png)") : tr("Pictures (*.png);;Films (*.mp4 *.webm)"));
        if (file.isEmpty()) return;
        bool chosen = false;
        const int frames =
            QInputDialog::getInt(bench_.window(), tr("Turntable"), tr("Pictures a turn"), 72, 2, 3600, 1, &chosen);
        if (chosen) saveTurntable(file, frames);
    });
    bench_.add(menu, tr("&Surface of the isovalue…"), QKeySequence(QStringLiteral("Ctrl+Alt+S")), this, [this] {
        const QString file =
            file_choice::save_file(bench_.window(), tr("Save the surface"), FileKind::mesh,
                                   QStringLiteral("surface.stl"), tr("Meshes (*.stl *.ply *.obj *.vtp)"));
        if (!file.isEmpty()) saveMesh(file);
    });
    bench_.add(menu, tr("&Volume…"), QKeySequence(QStringLiteral("Ctrl+Alt+V")), this, [this] {
        const QString file =
            file_choice::save_file(bench_.window(), tr("Save the volume"), FileKind::copy,
                                   QStringLiteral("volume.nrrd"), tr("Volumes (*.nrrd *.mhd *.nii.gz *.nii *.raw)"));
        if (!file.isEmpty()) saveVolume(file);
    });
    bench_.add(bench_.menu(Workbench::Menu::edit), tr("&Copy the view"), QKeySequence::Copy, this,
               &ExportFeature::copyPicture);
}

QImage ExportFeature::picture(bool annotated) const {
    for (SliceView* slice : bench_.views()->slices()) {
        if (!slice->hasFocus()) continue;
        slice->setNotesShown(annotated);
        const QImage image = slice->grab().toImage();
        slice->setNotesShown(true);
        return image;
    }
    VolumeView* view = bench_.views()->volumeView();
    return annotated ? view->grab().toImage() : view->image();
}

void ExportFeature::askPicture(bool annotated) {
    const QImage image = picture(annotated);  // the dialog takes the focus
    const QString filter =
        QImageWriter::supportedImageFormats().contains("tiff") ? tr("Pictures (*.png *.tif)") : tr("Pictures (*.png)");
    const QString file = file_choice::save_file(bench_.window(), tr("Save the picture"), FileKind::picture,
                                                QStringLiteral("lacuna.png"), filter);
    if (!file.isEmpty()) writePicture(image, file);
}

void ExportFeature::savePicture(const QString& file, bool annotated) { writePicture(picture(annotated), file); }

void ExportFeature::writePicture(const QImage& image, const QString& file) {
    writes_.start(tr("Saving the picture"), file, [image, file](const JobContext&) {
        const QByteArray bytes = encoded(image, file);
        write_file(file.toStdString(), {bytes.constData(), std::size_t(bytes.size())});
    });
}

void ExportFeature::copyPicture() {
    if (bench_.documents()->hasDocument()) QGuiApplication::clipboard()->setImage(picture(true));
}

void ExportFeature::saveTurntable(const QString& file, int frames) {
    if (!bench_.documents()->hasDocument() || !bench_.engine()) return;
    Turntable table;
    table.scene = scene_of(bench_.documents()->document());
    const QSize size = bench_.views()->volumeView()->pixelSize();
    table.scene.size = {size.width() & ~1, size.height() & ~1};  // films take even sizes only
    table.plan = plan_of(bench_.documents()->document(), table.scene);
    const Quality& quality = bench_.documents()->document().settings.quality;
    if (quality.has_budget() && table.scene.mode != ViewMode::shear_warp)
        table.budget = Budget{quality.error_budget, quality.time_budget_ms, quality.step};
    table.frames = frames;
    table.file = file;
    writes_.start(tr("Drawing a turntable"), file,
                  [table, engine = bench_.engine()](const JobContext& job) { write_turntable(table, *engine, job); });
}

void ExportFeature::saveMesh(const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    writes_.start(tr("Saving the surface"), file,
                  [volume = document.volume, iso = document.settings.iso, file](const JobContext& job) {
                      write_mesh(iso_mesh(volume, iso, job), file.toStdString());
                  });
}

void ExportFeature::saveVolume(const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    writes_.start(tr("Saving the volume"), file,
                  [volume = bench_.documents()->document().volume, file](const JobContext& job) {
                      write_volume(volume, file.toStdString(), job);
                  });
}

}  // namespace lacuna::ui
