#include "ui/load_controller.h"

namespace lacuna::ui {

void LoadController::open(const QString& input, const QString& series) {
    job_.start(
        [name = input.toStdString(), series = series.toStdString()](const JobContext& job) {
            OpenOptions options;
            options.series = series;
            try {
                // Reading is most of it; the statistics take the rest.
                Volume volume = open_volume(name, options, job.part(0, 0.9));
                return Opened{make_document(name, std::move(volume), job.part(0.9, 1)), {}};
            } catch (const AmbiguousInput& several) {
                return Opened{{}, several.entries};
            }
        },
        [this, input](Outcome<Opened> outcome) {
            if (const Error* error = std::get_if<Error>(&outcome)) {
                if (error->code() == Errc::cancelled)
                    Q_EMIT cancelled();
                else
                    Q_EMIT failed(QString::fromStdString(error->what()));
            } else if (Opened& opened = std::get<Opened>(outcome); !opened.choice.empty()) {
                Q_EMIT choiceNeeded(input, opened.choice);
            } else {
                Q_EMIT loaded(opened.document);
            }
            Q_EMIT finished();
        },
        [this](double share) { Q_EMIT progressed(share); });
    Q_EMIT started(input);
}

void LoadController::cancel() {
    if (!job_.running()) return;
    job_.cancel();
    Q_EMIT cancelled();
    Q_EMIT finished();
}

}  // namespace lacuna::ui
