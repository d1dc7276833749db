#pragma once

#include <QMainWindow>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <functional>

#include "ui/engine_choice.h"
#include "ui/features/accuracy_feature.h"
#include "ui/features/batch_feature.h"
#include "ui/features/cut_feature.h"
#include "ui/features/export_feature.h"
#include "ui/features/hand_feature.h"
#include "ui/features/help_feature.h"
#include "ui/features/inspection_feature.h"
#include "ui/features/layout_feature.h"
#include "ui/features/limits_feature.h"
#include "ui/features/measure_feature.h"
#include "ui/features/patient_feature.h"
#include "ui/features/pick_feature.h"
#include "ui/features/regions_feature.h"
#include "ui/features/session_feature.h"
#include "ui/features/settings_feature.h"
#include "ui/features/slices_feature.h"
#include "ui/panels/cuts_panel.h"
#include "ui/panels/effects_panel.h"
#include "ui/panels/ranges_panel.h"
#include "ui/panels/render_panel.h"
#include "ui/panels/slices_panel.h"
#include "ui/panels/transfer_panel.h"
#include "ui/status_line.h"
#include "ui/welcome_page.h"
#include "ui/workbench.h"

class QActionGroup;

namespace lacuna::ui {

class CloseGuard;

/// The workstation's window: puts views, panels and features together and carries values between them.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(EngineFactory make_engine, QWidget* parent = nullptr);
    ~MainWindow() override;

    Workbench* bench() const { return bench_; }
    DocumentController* documents() const { return documents_; }
    LoadController* loader() const { return loader_; }
    FrameScheduler* scheduler() const { return scheduler_; }
    RegionsFeature* regions() const { return regions_; }
    InspectionFeature* inspection() const { return inspection_; }
    ExportFeature* exports() const { return exports_; }
    BatchFeature* batch() const { return batch_; }
    SessionFeature* session() const { return session_; }
    AccuracyFeature* accuracy() const { return accuracy_; }
    MeasureFeature* measure() const { return measure_; }
    SlicesFeature* slices() const { return slices_; }
    PatientFeature* patient() const { return patient_; }
    CutFeature* cuts() const { return cuts_; }
    PickFeature* pick() const { return pick_; }
    HandFeature* hand() const { return hand_; }
    LimitsFeature* limitsFeature() const { return limits_; }
    FourUp* views() const { return views_; }
    LayoutFeature* layoutFeature() const { return layout_; }
    CloseGuard* closeGuard() const { return close_guard_; }
    SettingsFeature* settingsFeature() const { return settings_; }
    RenderPanel* renderPanel() const { return render_panel_; }
    TransferPanel* transferPanel() const { return transfer_panel_; }
    RangesPanel* rangesPanel() const { return ranges_panel_; }
    CutsPanel* cutsPanel() const { return cuts_panel_; }
    SlicesPanel* slicesPanel() const { return slices_panel_; }
    EffectsPanel* effectsPanel() const { return effects_panel_; }
    StatusLine* statusLine() const { return status_; }
    MessageBar* messageBar() const { return messages_; }
    QTabWidget* tabs() const { return tabs_; }

public Q_SLOTS:
    /// Opens any INPUT of the command line, a path or `sample:NAME[@SIZE]`, or a session file.
    void openInput(const QString& input);
    void openFolder();
    void openFile();

protected:
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;
    void closeEvent(QCloseEvent*) override;

private:
    void buildCentre();
    void buildDocks();
    void buildFeatures();
    void buildMenus();
    void finishMenus();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildGoMenu();
    void buildToolsMenu();
    void startEngine(EngineFactory make_engine);
    void connectLoading();
    void connectViews();
    void connectPanels();
    void connectRendering();
    void focusPanel(QDockWidget* dock, QWidget* widget);
    void focusTab(int tab, QWidget* widget);

    void showDocument();
    void showWarnings(const std::vector<Warning>& warnings);
    void showSettings();
    void showSelection();
    void renderScene();
    void readOut(const glm::ivec3& voxel);
    void readOutCursor();

    QStackedWidget* stack_;
    WelcomePage* welcome_;
    FourUp* views_;
    MessageBar* messages_;
    Workbench* bench_;
    DocumentController* documents_;
    LoadController* loader_;
    FrameScheduler* scheduler_;
    StatusLine* status_;
    QTabWidget* tabs_;
    RenderPanel* render_panel_;
    TransferPanel* transfer_panel_;
    RangesPanel* ranges_panel_;
    CutsPanel* cuts_panel_;
    SlicesPanel* slices_panel_;
    EffectsPanel* effects_panel_;
    QWidget* side_;
    QDockWidget* scene_dock_ = nullptr;
    RegionsFeature* regions_ = nullptr;
    InspectionFeature* inspection_ = nullptr;
    ExportFeature* exports_ = nullptr;
    BatchFeature* batch_ = nullptr;
    SessionFeature* session_ = nullptr;
    AccuracyFeature* accuracy_ = nullptr;
    LimitsFeature* limits_ = nullptr;
    SettingsFeature* settings_ = nullptr;
    HelpFeature* help_ = nullptr;
    LayoutFeature* layout_ = nullptr;
    MeasureFeature* measure_ = nullptr;
    SlicesFeature* slices_ = nullptr;
    PatientFeature* patient_ = nullptr;
    CutFeature* cuts_ = nullptr;
    PickFeature* pick_ = nullptr;
    HandFeature* hand_ = nullptr;
    CloseGuard* close_guard_;
    QActionGroup* modes_ = nullptr;
    ViewSettings rendered_;  ///< the 3D picture is of these
    QTimer slow_frame_;      ///< a frame is only worth a progress bar when it takes its time
    TaskList::Id load_task_ = 0, frame_task_ = 0;
    LatestJob<std::shared_ptr<Engine>> engine_job_;
};

}  // namespace lacuna::ui
