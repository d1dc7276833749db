#include "ui/inspection_controller.h"

namespace lacuna::ui {

void InspectionController::analyse(const Volume& volume, const DetectionOptions& options) {
    gather_.cancel();
    analyse_.start(
        [volume, options](const JobContext& job) {
            return std::make_shared<const PartAnalysis>(analyse_part(volume, options, job));
        },
        [this](Outcome<Analysis> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                if (error->code() != Errc::cancelled) Q_EMIT failed(QString::fromStdString(error->what()));
            } else {
                Q_EMIT analysed(std::get<0>(outcome));
            }
            Q_EMIT finished();
        },
        [this](double share) { Q_EMIT progressed(share); });
    Q_EMIT started();
}

void InspectionController::gather(Analysis analysis, const std::vector<glm::dvec3>& colors) {
    gather_.cancel();
    if (!analysis) return;
    gather_.start(
        [analysis, colors](const JobContext& job) -> Highlights {
            return std::make_shared<const std::vector<Highlight>>(defect_highlights(*analysis, colors, job));
        },
        [this](Outcome<Highlights> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome))
                Q_EMIT failed(QString::fromStdString(error->what()));
            else
                Q_EMIT gathered(std::get<0>(outcome));
        });
}

void InspectionController::cancel() {
    gather_.cancel();
    if (!analyse_.running()) return;
    analyse_.cancel();
    Q_EMIT finished();
}

}  // namespace lacuna::ui
