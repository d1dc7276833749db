#include "ui/region_controller.h"

namespace lacuna::ui {

void RegionController::compute(const Volume& volume, const RegionOptions& options) {
    find_.start(
        [volume, options](const JobContext& job) {
            return std::make_shared<const RegionTable>(find_regions(volume, options, job));
        },
        [this](Outcome<std::shared_ptr<const RegionTable>> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                if (error->code() != Errc::cancelled) Q_EMIT failed(QString::fromStdString(error->what()));
            } else {
                Q_EMIT computed(std::get<0>(outcome));
            }
            Q_EMIT finished();
        },
        [this](double share) { Q_EMIT progressed(share); });
    Q_EMIT started();
}

void RegionController::gather(std::shared_ptr<const RegionTable> table, std::uint32_t id) {
    gather_.cancel();
    if (!table || id == 0) return;
    gather_.start(
        [table, id](const JobContext&) -> std::shared_ptr<const Highlight> {
            for (const RegionCharacteristics& row : table->rows)
                if (row.id == id) return std::make_shared<const Highlight>(highlight_of(*table, row));
            return nullptr;
        },
        [this, id](Outcome<std::shared_ptr<const Highlight>> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome))
                Q_EMIT failed(QString::fromStdString(error->what()));
            else
                Q_EMIT gathered(id, std::get<0>(outcome));
        });
}

void RegionController::cancel() {
    gather_.cancel();
    if (!find_.running()) return;
    find_.cancel();
    Q_EMIT finished();
}

}  // namespace lacuna::ui
