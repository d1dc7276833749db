#pragma once

#include <QDockWidget>
#include <QTextBrowser>
#include <optional>

#include "core/accuracy/limits.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// Where the way the 3D picture is drawn fails (docs/limits.md): the failures of the plan shown, first those the scene
/// on screen meets, with the facts. The facts are measured off the window's thread, only while the list is to be seen.
class LimitsFeature final : public QObject {
    Q_OBJECT
public:
    explicit LimitsFeature(Workbench& bench);

    QDockWidget* dock() const { return dock_; }
    QTextBrowser* text() const { return text_; }
    /// Failures listed, and those of them the scene meets.
    int listed() const { return listed_; }
    const std::vector<MetLimit>& met() const { return met_; }

public Q_SLOTS:
    void show();

Q_SIGNALS:
    /// The list is that of the picture shown, its facts measured.
    void updated();

private:
    void refresh();
    void fill(const SceneFacts* facts);

    Workbench& bench_;
    QTextBrowser* text_;
    QDockWidget* dock_;
    FrameFacts shown_;  ///< the last full picture
    /// What the facts were measured on; another camera or plan needs no new ones.
    std::shared_ptr<const Scene> measured_;
    std::optional<SceneFacts> facts_;
    std::vector<MetLimit> met_;
    int listed_ = 0;
    LatestJob<SceneFacts> job_;
};

}  // namespace lacuna::ui
