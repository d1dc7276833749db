#pragma once

#include <QObject>
#include <vector>

#include "core/session/document.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Measures a part's defects, and gathers their voxels for the 3D view, on worker threads.
class InspectionController final : public QObject {
    Q_OBJECT
public:
    using Analysis = std::shared_ptr<const PartAnalysis>;
    using Highlights = std::shared_ptr<const std::vector<Highlight>>;

    explicit InspectionController(QObject* parent = nullptr) : QObject(parent), analyse_(this), gather_(this) {}

    bool running() const { return analyse_.running(); }

public Q_SLOTS:
    void analyse(const lacuna::Volume& volume, const lacuna::DetectionOptions& options);
    /// @param colors  of each defect, by row; as many as the analysis has
    void gather(std::shared_ptr<const lacuna::PartAnalysis> analysis, const std::vector<glm::dvec3>& colors);
    void cancel();

Q_SIGNALS:
    void started();
    void progressed(double share);
    void analysed(std::shared_ptr<const lacuna::PartAnalysis> analysis);
    void gathered(std::shared_ptr<const std::vector<lacuna::Highlight>> highlights);
    void failed(const QString& sentence);
    void finished();

private:
    LatestJob<Analysis> analyse_;
    LatestJob<Highlights> gather_;
};

}  // namespace lacuna::ui
