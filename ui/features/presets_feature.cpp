#include "ui/features/presets_feature.h"

#include <QInputDialog>
#include <QMessageBox>
#include <QStandardPaths>

#include "core/session/preset_settings.h"

#include "ui/file_choice.h"
#include "ui/preset_title.h"

namespace lacuna::ui {

PresetsFeature::PresetsFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      gallery_(new PresetGallery(bench.window())),
      dock_(bench.addDock(QStringLiteral("presets"), tr("Presets"), gallery_, Qt::RightDockWidgetArea)),
      thumbnails_(new PresetThumbnails(bench.scheduler(), this)),
      listing_(this),
      keeps_(this, bench.tasks()),
      changes_(this, bench.tasks()),
      exports_(bench) {
    connect(&exports_, &FileWrites::written, this, &PresetsFeature::exported);
    bench.needDocument(gallery_);
    if (auto* scene = bench.window()->findChild<QDockWidget*>(QStringLiteral("scene"))) {
        bench.window()->tabifyDockWidget(scene, dock_);
        scene->raise();
    }
    connectGallery();
    connectDocument();
    addActions();
}

std::filesystem::path PresetsFeature::folder() {
    return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString()) /
           "presets";
}

void PresetsFeature::connectGallery() {
    connect(gallery_, &PresetGallery::shown, this, &PresetsFeature::drawVisible);
    connect(gallery_, &PresetGallery::applyRequested, this, &PresetsFeature::apply);
    connect(gallery_, &PresetGallery::saveRequested, this,
            [this] { askName(tr("Save as a preset"), QString(), [this](const QString& name) { saveAs(name); }); });
    connect(gallery_, &PresetGallery::renameRequested, this, [this](const PresetEntry& entry) {
        askName(tr("Rename the preset"), QString::fromStdString(entry.name),
                [this, entry](const QString& name) { rename(entry, name); });
    });
    connect(gallery_, &PresetGallery::removeRequested, this, [this](const PresetEntry& entry) {
        auto* question =
            new QMessageBox(QMessageBox::Question, tr("Delete the preset"),
                            tr("Delete the preset “%1”? Its file is removed.").arg(QString::fromStdString(entry.name)),
                            QMessageBox::Yes | QMessageBox::Cancel, bench_.window());
        question->setAttribute(Qt::WA_DeleteOnClose);
        connect(question, &QMessageBox::accepted, this, [this, entry] { remove(entry); });
        question->open();
    });
    connect(gallery_, &PresetGallery::importRequested, this, [this] {
        const QString file = file_choice::open_file(bench_.window(), tr("Import a preset"), FileKind::preset,
                                                    tr("Presets (*.json);;All files (*)"));
        if (!file.isEmpty()) importFile(file);
    });
    connect(gallery_, &PresetGallery::exportRequested, this, [this](const PresetEntry& entry) {
        const QString name = QString::fromStdString(entry.name) + QStringLiteral(".json");
        const QString file = file_choice::save_file(bench_.window(), tr("Export the preset"), FileKind::preset, name,
                                                    tr("Presets (*.json)"));
        if (!file.isEmpty()) exportFile(entry, file);
    });
    connect(thumbnails_, &PresetThumbnails::drawn, gallery_, &PresetGallery::setPicture);
}

void PresetsFeature::connectDocument() {
    DocumentController* documents = bench_.documents();
    connect(documents, &DocumentController::opened, this, [this, documents] {
        thumbnails_->setDocument(documents->document());
        list();
    });
    connect(&bench_, &Workbench::engineReady, this, [this] { thumbnails_->setEngine(bench_.engine()); });
    connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) { visible ? list() : drawVisible(); });
}

void PresetsFeature::addActions() {
    QMenu* menu = bench_.submenu(Workbench::Menu::tools, tr("&Colours"));
    bench_.add(menu, tr("&Presets"), QKeySequence(QStringLiteral("Ctrl+Alt+P")), this, &PresetsFeature::showGallery);
    bench_.add(menu, tr("Sa&ve as a preset…"), {}, gallery_, &PresetGallery::saveRequested);
    bench_.add(menu, tr("&Import a preset…"), {}, gallery_, &PresetGallery::importRequested);
}

void PresetsFeature::showGallery() {
    dock_->show();
    dock_->raise();
    gallery_->list()->setFocus();
}

void PresetsFeature::list(const QString& choose) {
    if (!choose.isEmpty()) choose_ = choose;
    listing_.start([folder = folder()](const JobContext&) { return list_presets(folder); },
                   [this](Outcome<std::vector<PresetEntry>> outcome) {
                       if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
                       const std::vector<PresetEntry>& kept = std::get<0>(outcome);
                       // A file that was written again looks otherwise, whoever wrote it.
                       for (const PresetEntry& entry : kept)
                           if (!gallery_->holds(entry)) thumbnails_->forget(PresetGallery::keyOf(entry));
                       gallery_->setEntries(kept);
                       gallery_->choose(std::exchange(choose_, QString()));
                       Q_EMIT listed();
                   });
    drawVisible();
}

void PresetsFeature::drawVisible() {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    std::vector<std::pair<QString, ViewSettings>> wanted;
    for (const PresetEntry& entry : gallery_->visibleEntries()) {
        const QString key = PresetGallery::keyOf(entry);
        if (const QImage known = thumbnails_->picture(key); !known.isNull()) {
            gallery_->setPicture(key, known);
            continue;
        }
        ViewSettings plain;  // nothing cut away, no effects: what tells presets apart
        plain.iso = document.settings.iso;
        plain.lmip_threshold = document.settings.lmip_threshold;
        plain.window = document.settings.window;
        plain.projection_window = document.settings.projection_window;
        try {
            wanted.emplace_back(key, with_preset(plain, preset_for(entry, document.volume, *document.statistics)));
        } catch (const Error&) {
            continue;  // its tool tip says why
        }
    }
    thumbnails_->want(std::move(wanted));
}

void PresetsFeature::apply(const PresetEntry& entry) {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    try {
        PresetFile preset = preset_for(entry, document.volume, *document.statistics);
        if (!gallery_->withTechnique()) preset.technique.reset();
        const ViewSettings next = with_preset(document.settings, preset);
        bench_.documents()->endGesture();
        bench_.documents()->edit(tr("Preset %1").arg(preset_title(entry)), next);
        bench_.documents()->endGesture();
    } catch (const Error& error) {
        bench_.report(error);
    }
}

void PresetsFeature::askName(const QString& title, const QString& proposed, std::function<void(const QString&)> then) {
    auto* dialog = new QInputDialog(bench_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(tr("Name of the preset"));
    dialog->setTextValue(proposed);
    connect(dialog, &QInputDialog::textValueSelected, this, [then](const QString& name) { then(name.trimmed()); });
    dialog->open();
}

void PresetsFeature::saveAs(const QString& name) {
    if (!bench_.documents()->hasDocument()) return;
    keep(preset_of(bench_.documents()->document().settings, name.toStdString()), false);
}

void PresetsFeature::keep(const PresetFile& preset, bool replace) {
    using Kept = std::optional<std::filesystem::path>;
    keeps_.start(
        tr("Saving the preset"),
        [folder = folder(), preset, replace](const JobContext&) -> Kept {
            if (!replace && owns_preset(folder, preset.tf.name)) return std::nullopt;
            return store_preset(folder, preset, replace);
        },
        [this, preset](Outcome<Kept> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            const Kept& file = std::get<0>(outcome);
            if (!file) return askToReplace(preset);
            const QString name = QString::fromStdString(preset.tf.name);
            // What was said before, such as that it lacked a name, is over.
            bench_.messages()->showNotice(tr("The preset “%1” is saved.").arg(name));
            list(name);
        });
}

void PresetsFeature::askToReplace(const PresetFile& preset) {
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Save as a preset"),
                        tr("There is a preset “%1” already. Replace it?").arg(QString::fromStdString(preset.tf.name)),
                        QMessageBox::Yes | QMessageBox::Cancel, bench_.window());
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::accepted, this, [this, preset] { keep(preset, true); });
    question->open();
}

void PresetsFeature::change(const QString& name, Task<QString>::Work work, std::function<void(const QString&)> done) {
    changes_.start(name, std::move(work), [this, done = std::move(done)](Outcome<QString> outcome) {
        if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
        list(std::get<0>(outcome));
        if (done) done(std::get<0>(outcome));
    });
}

void PresetsFeature::rename(const PresetEntry& entry, const QString& name) {
    change(tr("Renaming the preset"), [file = entry.file, name](const JobContext&) {
        rename_preset(file, name.toStdString());
        return name;
    });
}

void PresetsFeature::remove(const PresetEntry& entry) {
    change(tr("Deleting the preset"), [file = entry.file](const JobContext&) {
        remove_preset(file);
        return QString();
    });
}

void PresetsFeature::importFile(const QString& file) {
    change(
        tr("Importing a preset"),
        [path = std::filesystem::path(file.toStdString()), folder = folder()](const JobContext&) {
            PresetFile preset = load_preset(path);
            if (preset.tf.name.empty()) preset.tf.name = path.stem().string();
            store_preset(folder, preset, false);
            return QString::fromStdString(preset.tf.name);
        },
        [this](const QString& name) {
            showGallery();
            Q_EMIT imported(name);
        });
}

void PresetsFeature::exportFile(const PresetEntry& entry, const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    exports_.start(tr("Exporting the preset"), file,
                   [entry, file, volume = document.volume, statistics = document.statistics](const JobContext&) {
                       save_preset(preset_for(entry, volume, *statistics), file.toStdString());
                   });
}

}  // namespace lacuna::ui
