#pragma once

#include <QMainWindow>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <functional>

#include "core/render/engine.h"
#include "ui/document_controller.h"
#include "ui/four_up.h"
#include "ui/frame_scheduler.h"
#include "ui/inspection_controller.h"
#include "ui/load_controller.h"
#include "ui/panels/cuts_panel.h"
#include "ui/panels/effects_panel.h"
#include "ui/panels/inspection_panel.h"
#include "ui/panels/ranges_panel.h"
#include "ui/panels/regions_panel.h"
#include "ui/panels/render_panel.h"
#include "ui/panels/slices_panel.h"
#include "ui/panels/transfer_panel.h"
#include "ui/region_controller.h"
#include "ui/status_line.h"
#include "ui/welcome_page.h"
#include "ui/widgets/message_bar.h"

class QActionGroup;
class QDockWidget;

namespace lacuna::ui {

/// The workstation's window: puts views, panels and controllers together and carries values between them.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// Makes the engine; called once, on a worker thread, because looking for a device takes its time.
    using EngineFactory = std::function<std::shared_ptr<Engine>(const JobContext&)>;

    explicit MainWindow(EngineFactory make_engine, QWidget* parent = nullptr);
    ~MainWindow() override;

    DocumentController* documents() const { return documents_; }
    LoadController* loader() const { return loader_; }
    RegionController* regions() const { return regions_; }
    InspectionController* inspections() const { return inspections_; }
    FrameScheduler* scheduler() const { return scheduler_; }
    FourUp* views() const { return views_; }
    RenderPanel* renderPanel() const { return render_panel_; }
    TransferPanel* transferPanel() const { return transfer_panel_; }
    RangesPanel* rangesPanel() const { return ranges_panel_; }
    CutsPanel* cutsPanel() const { return cuts_panel_; }
    SlicesPanel* slicesPanel() const { return slices_panel_; }
    EffectsPanel* effectsPanel() const { return effects_panel_; }
    RegionsPanel* regionsPanel() const { return regions_panel_; }
    InspectionPanel* inspectionPanel() const { return inspection_panel_; }
    StatusLine* statusLine() const { return status_; }
    MessageBar* messageBar() const { return messages_; }
    QTabWidget* tabs() const { return tabs_; }

public Q_SLOTS:
    /// Opens any INPUT of the command line: a path or `sample:NAME[@SIZE]`.
    void openInput(const QString& input);
    void openFolder();
    void openFile();
    void savePicture();
    void exportRegions();
    void loadCriteria();
    void saveCriteria();
    void exportReport();
    void showAbout();
    void showControls();

protected:
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;
    void closeEvent(QCloseEvent*) override;

private:
    void buildCentre();
    void buildDocks();
    void buildMenus();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildGoMenu();
    void buildToolsMenu();
    void startEngine(EngineFactory make_engine);
    void connectLoading();
    void connectViews();
    void connectPanels();
    void connectRegions();
    void connectInspection();
    void connectRendering();
    void focusTab(int tab, QWidget* widget);

    void showDocument();
    void showSettings();
    void showSelection();
    void renderScene();
    void readOut(const glm::ivec3& voxel);
    void readOutCursor();
    void updateProgress();
    void cancelShown();
    void chooseRegion(std::uint32_t id);
    void chooseDefect(std::uint32_t id);
    void colorDefects();
    void writeReport(const QString& folder);

    DocumentController* documents_;
    LoadController* loader_;
    RegionController* regions_;
    InspectionController* inspections_;
    FrameScheduler* scheduler_;
    QStackedWidget* stack_;
    WelcomePage* welcome_;
    FourUp* views_;
    MessageBar* messages_;
    StatusLine* status_;
    QTabWidget* tabs_;
    RenderPanel* render_panel_;
    TransferPanel* transfer_panel_;
    RangesPanel* ranges_panel_;
    CutsPanel* cuts_panel_;
    SlicesPanel* slices_panel_;
    EffectsPanel* effects_panel_;
    RegionsPanel* regions_panel_;
    InspectionPanel* inspection_panel_;
    QDockWidget* inspection_dock_ = nullptr;
    QWidget* side_;
    QActionGroup* modes_ = nullptr;
    QList<QAction*> needs_document_;
    QTimer slow_frame_;  ///< a frame is only worth a progress bar when it takes its time
    double load_share_ = -1, regions_share_ = -1, inspection_share_ = -1, report_share_ = -1, frame_share_ = -1;
    std::shared_ptr<Engine> engine_;
    LatestJob<std::shared_ptr<Engine>> engine_job_;
    LatestJob<QString> report_job_;
};

}  // namespace lacuna::ui
