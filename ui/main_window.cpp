#include "ui/main_window.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "ui/axis_words.h"
#include "ui/core_sentences.h"
#include "ui/dialogs/close_dialog.h"
#include "ui/dropped_files.h"
#include "ui/features/colours_feature.h"
#include "ui/features/import_feature.h"
#include "ui/features/pacs_feature.h"
#include "ui/features/presets_feature.h"
#include "ui/features/recent_feature.h"
#include "ui/features/view_history_feature.h"
#include "ui/number_text.h"
#include "ui/preferences.h"
#include "ui/series_dialog.h"

namespace lacuna::ui {

MainWindow::MainWindow(EngineFactory make_engine, QWidget* parent)
    : QMainWindow(parent),
      stack_(new QStackedWidget(this)),
      welcome_(new WelcomePage(this)),
      views_(new FourUp(this)),
      messages_(new MessageBar(this)),
      bench_(new Workbench(this, views_, messages_)),
      documents_(bench_->documents()),
      loader_(bench_->loader()),
      scheduler_(bench_->scheduler()),
      status_(new StatusLine(bench_->tasks(), this)),
      tabs_(new QTabWidget(this)),
      render_panel_(new RenderPanel(this)),
      transfer_panel_(new TransferPanel(this)),
      ranges_panel_(new RangesPanel(this)),
      cuts_panel_(new CutsPanel(this)),
      slices_panel_(new SlicesPanel(this)),
      effects_panel_(new EffectsPanel(this)),
      side_(new QWidget(this)),
      close_guard_(new CloseGuard(bench_->tasks(), this)),
      engine_job_(this) {
    setWindowTitle(QStringLiteral("[*]Lacuna"));
    setAcceptDrops(true);
    setStatusBar(status_);
    buildCentre();
    buildDocks();
    buildMenus();
    connectLoading();
    connectViews();
    connectPanels();
    connectRendering();
    buildFeatures();
    finishMenus();
    startEngine(std::move(make_engine));
}

MainWindow::~MainWindow() = default;

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(messages_);
    column->addWidget(stack_, 1);
    stack_->addWidget(welcome_);
    stack_->addWidget(views_);
    setCentralWidget(centre);
}

void MainWindow::buildDocks() {
    auto* column = new QVBoxLayout(side_);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(render_panel_);
    column->addWidget(tabs_, 1);
    tabs_->setDocumentMode(true);
    tabs_->setAccessibleName(tr("Scene settings"));
    tabs_->addTab(transfer_panel_, tr("Colours"));
    tabs_->addTab(ranges_panel_, tr("Ranges"));
    tabs_->addTab(cuts_panel_, tr("Cuts"));
    tabs_->addTab(slices_panel_, tr("Grey levels"));
    tabs_->addTab(effects_panel_, tr("Effects"));
    side_->setMinimumWidth(340);
    bench_->needDocument(side_);
    scene_dock_ = bench_->addDock(QStringLiteral("scene"), tr("Scene"), side_, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    resizeDocks({scene_dock_}, {370}, Qt::Horizontal);
}

/// One line a feature; the order is that of their entries in the menus.
void MainWindow::buildFeatures() {
    auto* view_history = new ViewHistoryFeature(*bench_);
    new ImportFeature(*bench_);
    new PacsFeature(*bench_);
    new ColoursFeature(*bench_, transfer_panel_, ranges_panel_, tabs_);
    new PresetsFeature(*bench_);
    cuts_ = new CutFeature(*bench_, cuts_panel_);
    connect(cuts_, &CutFeature::cutAdded, this, [this] { tabs_->setCurrentWidget(cuts_panel_); });
    hand_ = new HandFeature(*bench_);
    pick_ = new PickFeature(*bench_, cuts_);
    connect(pick_, &PickFeature::readOut, this, &MainWindow::readOut);
    connect(pick_, &PickFeature::readOutEnded, this, &MainWindow::readOutCursor);
    exports_ = new ExportFeature(*bench_);
    regions_ = new RegionsFeature(*bench_);
    inspection_ = new InspectionFeature(*bench_);
    batch_ = new BatchFeature(*bench_);
    session_ = new SessionFeature(*bench_, *inspection_, *regions_);
    connect(session_, &SessionFeature::restored, view_history, &ViewHistoryFeature::reset);
    new RecentFeature(*bench_, *session_);
    accuracy_ = new AccuracyFeature(*bench_);
    render_panel_->append(accuracy_->budget());
    limits_ = new LimitsFeature(*bench_);
    settings_ = new SettingsFeature(*bench_);
    connect(settings_, &SettingsFeature::engineChosen, this,
            [this] { startEngine(engine_on(preferences::device().toStdString(), preferences::memory_limit_mib())); });
    measure_ = new MeasureFeature(*bench_);
    slices_ = new SlicesFeature(*bench_, slices_panel_);
    patient_ = new PatientFeature(*bench_);
    connect(settings_, &SettingsFeature::preferencesChanged, patient_,
            [this] { patient_->setHidden(preferences::hide_patient()); });
    tabifyDockWidget(regions_->dock(), inspection_->dock());
    tabifyDockWidget(inspection_->dock(), accuracy_->dock());
    tabifyDockWidget(accuracy_->dock(), measure_->dock());
    tabifyDockWidget(measure_->dock(), limits_->dock());
    regions_->dock()->raise();
    resizeDocks({regions_->dock()}, {190}, Qt::Vertical);
}

void MainWindow::startEngine(EngineFactory make_engine) {
    status_->showDevice(tr("Looking for a device…"));
    engine_job_.start(std::move(make_engine), [this](Outcome<std::shared_ptr<Engine>> outcome) {
        std::shared_ptr<Engine> engine;
        if (const Error* error = std::get_if<Error>(&outcome)) {
            messages_->showError(QString::fromStdString(error->what()));
            engine = std::make_shared<Engine>(nullptr);
        } else {
            engine = std::get<0>(outcome);
        }
        status_->showDevice(QString::fromStdString(engine->device_name()));
        bench_->setEngine(std::move(engine));
    });
}

void MainWindow::openInput(const QString& input) {
    if (input.endsWith(QLatin1String(k_session_suffix)))
        session_->openFile(input);
    else
        loader_->open(input);
}

void MainWindow::connectLoading() {
    connect(welcome_, &WelcomePage::openFolderRequested, this, &MainWindow::openFolder);
    connect(welcome_, &WelcomePage::openFileRequested, this, &MainWindow::openFile);
    connect(welcome_, &WelcomePage::sampleRequested, this, &MainWindow::openInput);
    connect(loader_, &LoadController::started, this, [this] {
        messages_->dismiss();
        bench_->tasks()->end(load_task_);
        load_task_ = bench_->tasks()->begin(tr("Opening"), [this] { loader_->cancel(); });
    });
    connect(loader_, &LoadController::progressed, this,
            [this](double share) { bench_->tasks()->progress(load_task_, share); });
    connect(loader_, &LoadController::finished, this, [this] { bench_->tasks()->end(load_task_); });
    connect(loader_, &LoadController::failed, messages_, &MessageBar::showError);
    connect(loader_, &LoadController::cancelled, this, [this] { messages_->showNotice(tr("Opening was cancelled.")); });
    connect(loader_, &LoadController::loaded, this, [this](const Document& document) {
        showWarnings(document.volume.warnings);  // once: they may name files, and patients may be hidden later
        documents_->open(document);
    });
    connect(loader_, &LoadController::choiceNeeded, this,
            [this](const QString& input, const std::vector<SeriesEntry>& entries) {
                auto* dialog = new SeriesDialog(entries, this);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                connect(dialog, &SeriesDialog::chosen, loader_, [this, input, entries](const QString& number) {
                    OpenOptions options;
                    options.series = number.toStdString();
                    const auto chosen = std::find_if(entries.begin(), entries.end(), [&](const SeriesEntry& entry) {
                        return QString::number(entry.number) == number;
                    });
                    // A UID still names it when files come or go; but one may be split into several volumes.
                    const auto same_uid = [&](const SeriesEntry& entry) { return entry.uid == chosen->uid; };
                    if (chosen != entries.end() && !chosen->uid.empty() &&
                        std::count_if(entries.begin(), entries.end(), same_uid) == 1)
                        options.series = chosen->uid;
                    loader_->open(input, options);
                });
                dialog->open();
            });
    connect(documents_, &DocumentController::opened, this, &MainWindow::showDocument);
}

void MainWindow::connectViews() {
    VolumeView* volume = views_->volumeView();
    connect(volume, &VolumeView::cameraEdited, documents_, &DocumentController::setCamera);
    connect(volume, &VolumeView::resized, scheduler_, &FrameScheduler::setSize);
    connect(documents_, &DocumentController::cameraChanged, this, [this] {
        views_->volumeView()->setCamera(documents_->document().camera);
        renderScene();
    });
    for (SliceView* slice : views_->slices()) {
        connect(slice, &SliceView::cursorMoved, documents_, &DocumentController::setCursor);
        connect(slice, &SliceView::hovered, this, &MainWindow::readOut);
        connect(slice, &SliceView::left, this, &MainWindow::readOutCursor);
        connect(slice, &SliceView::windowEdited, this, [this](ValueRange window) {
            ViewSettings next = documents_->document().settings;
            next.window = window;
            documents_->edit(tr("Window and level"), next);
        });
    }
    connect(documents_, &DocumentController::cursorChanged, this, [this] {
        for (SliceView* slice : views_->slices()) slice->setCursor3d(documents_->document().cursor_mm);
        readOutCursor();
    });
    connect(documents_, &DocumentController::settingsChanged, this, [this] {
        showSettings();
        if (!same_scene(rendered_, documents_->document().settings)) renderScene();
    });
    connect(documents_, &DocumentController::selectionChanged, this, &MainWindow::showSelection);
    connect(documents_, &DocumentController::plannedChanged, this, &MainWindow::renderScene);
}

void MainWindow::connectPanels() {
    connect(render_panel_, &RenderPanel::edited, documents_, &DocumentController::edit);
    connect(slices_panel_, &SlicesPanel::edited, documents_, &DocumentController::edit);
    const auto change = [this](const QString& name, auto&& apply) {
        ViewSettings next = documents_->document().settings;
        apply(next);
        documents_->edit(name, next);
    };
    connect(cuts_panel_, &CutsPanel::edited, this, [change](const QString& name, const std::vector<CutSetting>& cuts) {
        change(name, [&](ViewSettings& settings) { settings.cuts = cuts; });
    });
    connect(cuts_panel_, &CutsPanel::boxEdited, this, [change](const QString& name, const BoxRoi& box) {
        change(name, [&](ViewSettings& settings) { settings.roi = box; });
    });
    connect(effects_panel_, &EffectsPanel::edited, this,
            [change](const QString& name, const std::vector<Effect>& effects) {
                change(name, [&](ViewSettings& settings) { settings.effects = effects; });
            });
}

void MainWindow::connectRendering() {
    slow_frame_.setSingleShot(true);
    slow_frame_.setInterval(600);
    connect(&slow_frame_, &QTimer::timeout, this,
            [this] { frame_task_ = bench_->tasks()->begin(tr("Rendering"), [this] { scheduler_->cancel(); }); });
    connect(scheduler_, &FrameScheduler::busyChanged, this, [this](bool busy) {
        if (busy) {
            if (!slow_frame_.isActive() && frame_task_ == 0) slow_frame_.start();
            return;
        }
        slow_frame_.stop();
        bench_->tasks()->end(std::exchange(frame_task_, 0));
    });
    connect(scheduler_, &FrameScheduler::progressed, this,
            [this](double share) { bench_->tasks()->progress(frame_task_, share); });
    connect(scheduler_, &FrameScheduler::failed, messages_, &MessageBar::showError);
    connect(scheduler_, &FrameScheduler::frameReady, this, [this](const QImage& image, const FrameFacts& facts) {
        if (!documents_->hasDocument()) return;
        views_->volumeView()->setImage(image);
        status_->showFrame(facts, documents_->document().volume.bytes());
    });
}

void MainWindow::showDocument() {
    const Document& document = documents_->document();
    for (SliceView* slice : views_->slices()) {
        slice->setVolume(document.volume, document.voi_tables);
        slice->setCursor3d(document.cursor_mm);
    }
    views_->volumeView()->setGeometry3d(document.volume.geometry());
    views_->volumeView()->setHome(document.home);
    views_->volumeView()->setCamera(document.camera);
    render_panel_->setVolumeFacts(*document.statistics, QString::fromStdString(document.volume.unit));
    cuts_panel_->setGeometry3d(document.volume.geometry());
    slices_panel_->setDocument(document);
    stack_->setCurrentWidget(views_);
    showSettings();
    readOutCursor();
    scheduler_->setSize(views_->volumeView()->pixelSize());
    renderScene();
    views_->volumeView()->setFocus();
}

void MainWindow::showWarnings(const std::vector<Warning>& warnings) {
    if (warnings.empty()) return;
    QString words = core_sentence(warnings.front().text);
    if (warnings.size() > 1) words += tr(" (and %1 more notes)").arg(warnings.size() - 1);
    QStringList all;
    for (const Warning& warning : warnings) all << core_sentence(warning.text);
    messages_->showNotice(words, all.join(QLatin1Char('\n')));
}

void MainWindow::showSettings() {
    const ViewSettings& settings = documents_->document().settings;
    render_panel_->setSettings(settings);
    render_panel_->setScene(scene_of(documents_->document()));
    cuts_panel_->setCuts(settings.cuts);
    cuts_panel_->setBox(settings.roi);
    slices_panel_->setSettings(settings);
    effects_panel_->setEffects(settings.effects, settings.mode);
    const std::vector<CuttingPlane> cuts = planes_of(settings, documents_->document().volume.geometry());
    for (SliceView* slice : views_->slices()) {
        slice->setSettings(settings.window, settings.slices);
        slice->setCuts(cuts);
    }
    for (std::size_t i = 0; i < mode_names().size(); ++i)
        if (mode_names()[i].mode == settings.mode) {
            views_->volumeView()->setCaption(mode_names()[i].name);
            modes_->actions().at(qsizetype(i))->setChecked(true);
        }
    const bool projection = settings.mode == ViewMode::mip || settings.mode == ViewMode::lmip ||
                            settings.mode == ViewMode::minip || settings.mode == ViewMode::mean;
    views_->volumeView()->setPlainBackground(projection);
    views_->volumeView()->setOrthographic(settings.mode == ViewMode::shear_warp);
}

void MainWindow::showSelection() {
    const Document& document = documents_->document();
    SliceOverlay overlay;
    if (document.defects && document.inspection) {
        overlay.labels = std::shared_ptr<const LabelVolume>(document.inspection, &document.inspection->labels);
        overlay.id = document.selected_defect;
        auto tints = std::make_shared<std::vector<QRgb>>(1, 0);
        for (const QColor& color : inspection_->panel()->model()->colors()) tints->push_back(color.rgb());
        overlay.tints = std::move(tints);
    }
    if (document.regions && document.selected_region != 0) {
        overlay = {};
        overlay.labels = std::shared_ptr<const LabelVolume>(document.regions, &document.regions->labels);
        overlay.id = document.selected_region;
    }
    for (SliceView* slice : views_->slices()) slice->setOverlay(overlay);
    renderScene();
}

void MainWindow::renderScene() {
    if (!documents_->hasDocument()) return;
    try {
        rendered_ = documents_->document().settings;
        const Scene scene = scene_of(documents_->document());
        scheduler_->setScene(scene, plan_of(documents_->document(), scene));
    } catch (const Error& error) {
        messages_->showError(QString::fromStdString(error.what()));
    }
}

void MainWindow::readOut(const glm::ivec3& voxel) {
    if (!documents_->hasDocument()) return;
    const Volume& volume = documents_->document().volume;
    const double value = volume.value(voxel.x, voxel.y, voxel.z);
    const glm::dvec3 mm = volume.geometry().voxel_to_mm(glm::dvec3(voxel));
    const auto place = [&](int axis) { return coordinate_words(volume.geometry().axis_names, axis, mm[axis]); };
    status_->showReadout(tr("%1 at %2  %3  %4 mm · voxel %5, %6, %7")
                             .arg(std::isfinite(value)
                                      ? QStringLiteral("%1 %2")
                                            .arg(number_text(value, 'g', 7), QString::fromStdString(volume.unit))
                                            .trimmed()
                                      : tr("no value"),
                                  place(0), place(1), place(2))
                             .arg(voxel.x)
                             .arg(voxel.y)
                             .arg(voxel.z));
}

void MainWindow::readOutCursor() {
    if (!documents_->hasDocument()) return;
    const Document& document = documents_->document();
    readOut(nearest_voxel(document.volume.geometry(), document.cursor_mm));
}

namespace {

QStringList local_files(const QMimeData* data) {
    QStringList files;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    return files;
}

}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!local_files(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList files = local_files(event->mimeData());
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    const Dropped dropped = dropped_input(files);
    openInput(dropped.input);
    if (dropped.whole_folder)
        messages_->showNotice(tr("These are slices: their whole folder is opened."));
    else if (dropped.left_out > 0)
        messages_->showNotice(tr("One thing is open at a time: %n others are left out.", nullptr, dropped.left_out));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!close_guard_->mayClose()) return event->ignore();
    session_->finish();
    bench_->tasks()->cancelAll();
    scheduler_->cancel();
    event->accept();
}

}  // namespace lacuna::ui
