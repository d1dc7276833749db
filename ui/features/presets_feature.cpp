#include "ui/features/presets_feature.h"

#include <QInputDialog>
#include <QMessageBox>
#include <QStandardPaths>

#include "core/session/preset_settings.h"

#include "ui/file_choice.h"

namespace lacuna::ui {

PresetsFeature::PresetsFeature(Workbench& bench)
    : QObject(&bench),
      bench_(bench),
      gallery_(new PresetGallery(bench.window())),
      dock_(bench.addDock(QStringLiteral("presets"), tr("Presets"), gallery_, Qt::RightDockWidgetArea)),
      thumbnails_(new PresetThumbnails(bench.scheduler(), this)),
      files_(this, bench.tasks()) {
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

template <class Work>
bool PresetsFeature::attempt(Work&& work) {
    try {
        work();
        return true;
    } catch (const Error& error) {
        bench_.report(error);
        return false;
    }
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

void PresetsFeature::list() {
    attempt([&] { gallery_->setEntries(list_presets(folder())); });
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
    attempt([&] {
        PresetFile preset = preset_for(entry, document.volume, *document.statistics);
        if (!gallery_->withTechnique()) preset.technique.reset();
        const ViewSettings next = with_preset(document.settings, preset);
        bench_.documents()->endGesture();
        bench_.documents()->edit(tr("Preset %1").arg(QString::fromStdString(entry.name)), next);
        bench_.documents()->endGesture();
    });
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
    const PresetFile preset = preset_of(bench_.documents()->document().settings, name.toStdString());
    const auto keep = [this, preset, name](bool replace) {
        std::filesystem::path file;
        if (!attempt([&] { file = store_preset(folder(), preset, replace); })) return;
        thumbnails_->forget(QString::fromStdString(file.string()));
        list();
        gallery_->choose(name);
    };
    bool own = false;
    attempt([&] {
        for (const PresetEntry& entry : list_presets(folder()))
            own = own || (!entry.built_in() && entry.name == preset.tf.name);
    });
    if (!own) return keep(false);
    auto* question = new QMessageBox(QMessageBox::Question, tr("Save as a preset"),
                                     tr("There is a preset “%1” already. Replace it?").arg(name),
                                     QMessageBox::Yes | QMessageBox::Cancel, bench_.window());
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::accepted, this, [keep] { keep(true); });
    question->open();
}

void PresetsFeature::rename(const PresetEntry& entry, const QString& name) {
    if (!attempt([&] { rename_preset(entry.file, name.toStdString()); })) return;
    list();
    gallery_->choose(name);
}

void PresetsFeature::remove(const PresetEntry& entry) {
    if (attempt([&] { remove_preset(entry.file); })) list();
}

void PresetsFeature::importFile(const QString& file) {
    files_.start(
        tr("Importing a preset"),
        [path = std::filesystem::path(file.toStdString()), folder = folder()](const JobContext&) {
            PresetFile preset = load_preset(path);
            if (preset.tf.name.empty()) preset.tf.name = path.stem().string();
            store_preset(folder, preset, false);
            return QString::fromStdString(preset.tf.name);
        },
        [this](Outcome<QString> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            list();
            gallery_->choose(std::get<0>(outcome));
            showGallery();
            Q_EMIT imported(std::get<0>(outcome));
        });
}

void PresetsFeature::exportFile(const PresetEntry& entry, const QString& file) {
    if (!bench_.documents()->hasDocument()) return;
    const Document& document = bench_.documents()->document();
    files_.start(
        tr("Exporting the preset"),
        [entry, file, volume = document.volume, statistics = document.statistics](const JobContext&) {
            save_preset(preset_for(entry, volume, *statistics), file.toStdString());
            return file;
        },
        [this](Outcome<QString> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) return bench_.report(*error);
            bench_.messages()->showNotice(tr("Written to %1.").arg(std::get<0>(outcome)));
            Q_EMIT exported(std::get<0>(outcome));
        });
}

}  // namespace lacuna::ui
