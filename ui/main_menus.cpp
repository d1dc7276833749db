// The window's menus: every command with its key.
#include <QActionGroup>
#include <QBuffer>

#include "core/base/atomic_file.h"
#include "core/volume/samples.h"
#include "ui/axis_words.h"
#include "ui/file_choice.h"
#include "ui/main_window.h"
#include "ui/tool_bar.h"

namespace lacuna::ui {

using Menu = Workbench::Menu;

void MainWindow::buildMenus() {
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildGoMenu();
    buildToolsMenu();
}

/// What closes the menus, behind what the features added.
void MainWindow::finishMenus() {
    QMenu* file = bench_->menu(Menu::file);
    QAction* exports = bench_->submenu(Menu::file, tr("&Export"))->menuAction();
    file->removeAction(exports);
    file->addSeparator();
    file->addAction(exports);
    file->addSeparator();
    bench_->addAlways(file, tr("&Quit"), QKeySequence(QStringLiteral("Ctrl+Q")), this, &QWidget::close);
    help_ = new HelpFeature(*bench_);
    layout_ = new LayoutFeature(*bench_);
}

void MainWindow::buildFileMenu() {
    QMenu* file = bench_->menu(Menu::file);
    offer_tool(bench_->addAlways(file, tr("Open &folder…"), QKeySequence(QStringLiteral("Ctrl+Shift+O")), this,
                                 &MainWindow::openFolder),
               ToolGroup::document, Icon::folder, tr("Folder"));
    offer_tool(bench_->addAlways(file, tr("&Open file…"), QKeySequence::Open, this, &MainWindow::openFile),
               ToolGroup::document, Icon::file, tr("File"));
    QMenu* samples = file->addMenu(tr("Open &sample"));
    int number = 0;
    for (const std::string_view name : sample_names()) {
        const QString text = QString::fromUtf8(name.data(), qsizetype(name.size()));
        ++number;
        bench_->addAlways(samples, QStringLiteral("&%1  %2").arg(number).arg(text),
                          QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(number)), this,
                          [this, text] { openInput(QStringLiteral("sample:") + text); });
    }
    (void)bench_->submenu(Menu::file, tr("Open &recent"));  // its place; RecentFeature fills it
    file->addSeparator();
}

void MainWindow::buildEditMenu() {
    QMenu* edit = bench_->menu(Menu::edit);
    QAction* undo = bench_->addAlways(edit, tr("&Undo"), QKeySequence(QStringLiteral("Ctrl+Z")), documents_,
                                      &DocumentController::undo);
    QAction* redo = bench_->addAlways(edit, tr("&Redo"), QKeySequence(QStringLiteral("Ctrl+Shift+Z")), documents_,
                                      &DocumentController::redo);
    const auto show = [this, undo, redo] {
        const EditHistory& history = documents_->history();
        undo->setEnabled(history.can_undo());
        redo->setEnabled(history.can_redo());
        undo->setText(history.can_undo() ? tr("&Undo: %1").arg(QString::fromStdString(history.undo_name()))
                                         : tr("&Undo"));
        redo->setText(history.can_redo() ? tr("&Redo: %1").arg(QString::fromStdString(history.redo_name()))
                                         : tr("&Redo"));
        // setText() would put the long text under the icon.
        offer_tool(undo, ToolGroup::history, Icon::undo, tr("Undo"));
        offer_tool(redo, ToolGroup::history, Icon::redo, tr("Redo"));
    };
    connect(documents_, &DocumentController::historyChanged, this, show);
    show();
}

void MainWindow::buildViewMenu() {
    QMenu* view = bench_->menu(Menu::view);
    QMenu* modes = view->addMenu(tr("View &mode"));
    modes_ = new QActionGroup(this);
    for (std::size_t i = 0; i < mode_names().size(); ++i) {
        QAction* action =
            bench_->add(modes, mode_names()[i].name, QKeySequence(QString::number(i + 1)), this, [this, i] {
                ViewSettings next = documents_->document().settings;
                switch_mode(next, mode_names()[i].mode);
                documents_->edit(tr("View mode"), next);
            });
        action->setCheckable(true);
        modes_->addAction(action);
    }
    QMenu* sides = view->addMenu(tr("&Look from"));
    for (const char side : {'A', 'P', 'L', 'R', 'H', 'F'}) {
        QAction* action =
            bench_->add(sides, standard_view_name(AxisNames::patient, side), QKeySequence(QString(QLatin1Char(side))),
                        this, [this, side] { views_->volumeView()->lookFrom(side); });
        connect(documents_, &DocumentController::opened, action, [this, action, side] {
            action->setText(standard_view_name(documents_->document().volume.geometry().axis_names, side));
        });
    }
    offer_tool(bench_->add(view, tr("&Reset the 3D view"), QKeySequence(QStringLiteral("0")), views_->volumeView(),
                           &VolumeView::resetCamera),
               ToolGroup::layout, Icon::reset_view, tr("Reset"));
    bench_->add(view, tr("Reset the &slices"), QKeySequence(QStringLiteral("Shift+0")), this, [this] {
        for (SliceView* slice : views_->slices()) slice->resetView();
    });
    QAction* perspective =
        bench_->add(view, tr("&Perspective"), QKeySequence(QStringLiteral("Ctrl+P")), this, [this](bool on) {
            Camera camera = documents_->document().camera;
            camera.fov_deg = on ? std::optional<double>(30) : std::nullopt;
            documents_->setCamera(camera);
        });
    perspective->setCheckable(true);
    for (const auto signal : {&DocumentController::opened, &DocumentController::cameraChanged})
        connect(documents_, signal, perspective,
                [this, perspective] { perspective->setChecked(documents_->document().camera.fov_deg.has_value()); });
    view->addSeparator();
    bench_->add(view, tr("Ma&ximise the view, or show all"), QKeySequence(QStringLiteral("M")), views_,
                &FourUp::toggleFocused);
    QAction* full = bench_->addAlways(view, tr("&Full screen"), QKeySequence(QStringLiteral("F11")), this,
                                      [this](bool on) { on ? showFullScreen() : showNormal(); });
    full->setCheckable(true);
}

/// Brings a panel to the front, also one that was closed, and gives one of its widgets the keys.
void MainWindow::focusPanel(QDockWidget* dock, QWidget* widget) {
    dock->show();
    dock->raise();
    widget->setFocus(Qt::TabFocusReason);
}

void MainWindow::focusTab(int tab, QWidget* widget) {
    tabs_->setCurrentIndex(tab);
    focusPanel(scene_dock_, widget);
}

void MainWindow::buildGoMenu() {
    QMenu* go = bench_->menu(Menu::go);
    const auto key = [](int digit) { return QKeySequence(QStringLiteral("Ctrl+%1").arg(digit)); };
    const auto view = [this](QWidget* widget) { return [this, widget] { views_->focusView(widget); }; };
    bench_->add(go, tr("&3D view"), key(1), this, view(views_->volumeView()));
    const std::pair<QString, QString> slices[] = {{tr("&Axial slice"), tr("&XY slice")},
                                                  {tr("&Coronal slice"), tr("X&Z slice")},
                                                  {tr("&Sagittal slice"), tr("&YZ slice")}};
    for (const SliceKind kind : k_slice_kinds) {
        const auto& [of_patient, of_part] = slices[std::size_t(kind)];
        QAction* action = bench_->add(go, of_patient, key(2 + int(kind)), this, view(views_->slice(kind)));
        connect(documents_, &DocumentController::opened, action, [this, action, a = of_patient, b = of_part] {
            const AxisNames names = documents_->document().volume.geometry().axis_names;
            action->setText(names == AxisNames::patient ? a : b);
        });
    }
    bench_->add(go, tr("View &mode"), key(5), this, [this] { focusPanel(scene_dock_, render_panel_->modeBox()); });
    bench_->add(go, tr("C&olours"), key(6), this, [this] {
        transfer_panel_->showPage(TransferPanel::k_values);
        focusTab(0, transfer_panel_->plot());
    });
    bench_->add(go, tr("&Ranges"), key(7), this, [this] { focusTab(1, ranges_panel_->addButton()); });
    bench_->add(go, tr("C&uts"), key(8), this, [this] { focusTab(2, cuts_panel_->addButton()); });
    bench_->add(go, tr("&Grey levels"), key(9), this, [this] { focusTab(3, slices_panel_->presetBox()); });
    bench_->add(go, tr("Region &table"), key(0), this,
                [this] { focusPanel(regions_->dock(), regions_->panel()->table()); });
}

void MainWindow::buildToolsMenu() {
    QMenu* tools = bench_->menu(Menu::tools);
    QAction* range =
        bench_->add(tools, tr("Add a segmentation &range"), QKeySequence(QStringLiteral("Ctrl+Alt+R")), this, [this] {
            tabs_->setCurrentWidget(ranges_panel_);
            ranges_panel_->addRange();
        });
    offer_tool(range, ToolGroup::tools, Icon::range, tr("Range"));
}

void MainWindow::openFolder() {
    const QString folder =
        file_choice::open_folder(this, tr("Open a folder of DICOM files or TIFF slices"), FileKind::volume);
    if (!folder.isEmpty()) openInput(folder);
}

void MainWindow::openFile() {
    const QString file = file_choice::open_file(this, tr("Open a volume"), FileKind::volume,
                                                tr("Volumes and sessions (*.dcm *.mhd *.mha *.nrrd *.nhdr *.nii "
                                                   "*.nii.gz *.hdr *.raw *.img *.vol *.dat *.vgi *.tif "
                                                   "*.tiff *.lacuna);;"
                                                   "All files (*)"));
    if (!file.isEmpty()) openInput(file);
}

}  // namespace lacuna::ui
