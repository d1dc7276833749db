#pragma once

#include <vector>

#include "ui/file_writes.h"
#include "ui/panels/inspection_panel.h"
#include "ui/task.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// An inspector's work in the window: finds and measures defects, shows them in every view, writes the report.
class InspectionFeature final : public QObject {
    Q_OBJECT
public:
    explicit InspectionFeature(Workbench& bench);

    InspectionPanel* panel() const { return panel_; }
    QDockWidget* dock() const { return dock_; }
    void inspect(const DetectionOptions& options) { inspectAgain(options, {}); }
    /// As an inspection with these options was decided on by hand before. The decisions name its defects by number, so
    /// they are for this inspection alone: a newer one drops them.
    void inspectAgain(const DetectionOptions& options, std::vector<HandDecision> by_hand);
    void cancel();
    /// Writes the report of the open part, with the panel's criteria and decisions, to a new folder.
    void writeReport(const QString& folder);
    /// Reads criteria for the panel, or writes the panel's; off the window's thread.
    void readCriteria(const QString& file);
    void writeCriteria(const QString& file);

Q_SIGNALS:
    void finished();
    void criteriaRead();
    void written(const QString& path);  ///< a report's folder or a criteria file
    void gathered();                    ///< the defects' voxels are marked

private:
    void colorDefects();
    void choose(std::uint32_t id);
    void loadCriteria();
    void saveCriteria();
    void exportReport();

    using Analysis = std::shared_ptr<const PartAnalysis>;
    using Highlights = std::shared_ptr<const std::vector<Highlight>>;

    Workbench& bench_;
    InspectionPanel* panel_;
    QDockWidget* dock_;
    Task<Analysis> analyse_;
    LatestJob<Highlights> gather_;
    FileWrites writes_;
    LatestJob<Criteria> read_;
};

}  // namespace lacuna::ui
