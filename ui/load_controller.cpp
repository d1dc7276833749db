#include "ui/load_controller.h"

#include "core/io/dicom_identity.h"
#include "core/io/dicom_source.h"
#include "core/io/volume_reader.h"
#include "core/render/brick_plan.h"

namespace lacuna::ui {

namespace {

/// Slices show any voxel at any time, so a window's volume must go into memory. Told by the header where it can be.
void require_memory(const std::string& name, const OpenOptions& options) {
    if (!options.series.empty()) return;
    const std::optional<Volume> parts = open_volume_in_parts(name, options);
    const std::uint64_t limit = default_memory_limit();
    if (!parts || parts->total_bytes() <= limit) return;
    throw Error(Errc::out_of_memory, "The volume holds " + std::to_string(parts->total_bytes() >> 20) +
                                         " MB and the window may take " + std::to_string(limit >> 20) +
                                         " MB (75 % of the machine's memory); lacuna render draws it from disk.");
}

/// What only the screen shows of a DICOM series. An input that cannot be told a second time is shown without.
void add_screen_facts(Document& document, const JobContext& job) {
    try {
        const auto source = find_dicom_source(document.input, document.options, job);
        if (!source || source->images.empty()) return;
        const DicomScreenFacts facts = read_screen_facts(source->images.front().file, source->images.front().frame);
        // In a DICONDE file the patient is a part, and its fields are known already.
        if (document.volume.dicom->component.empty()) document.patient = facts.patient;
        if (facts.voi_function) document.settings.slices.function = *facts.voi_function;
    } catch (const Error& error) {
        if (error.code() == Errc::cancelled) throw;
    }
}

}  // namespace

void LoadController::open(const QString& input, const OpenOptions& options) {
    job_.start(
        [name = input.toStdString(), options](const JobContext& job) {
            try {
                require_memory(name, options);
                // Reading is most of it; the statistics take the rest.
                Volume volume = open_volume(name, options, job.part(0, 0.9));
                Opened opened{make_document(name, std::move(volume), job.part(0.9, 1)), {}};
                opened.document.options = options;
                if (opened.document.volume.dicom) add_screen_facts(opened.document, {job.stop, nullptr});
                return opened;
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
