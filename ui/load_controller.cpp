#include "ui/load_controller.h"

#include "core/io/dicom_identity.h"
#include "core/io/dicom_source.h"
#include "core/io/open_limit.h"
#include "core/io/plain_file.h"
#include "ui/core_sentences.h"
#include "ui/hidden_names.h"
#include "ui/memory_limit.h"
#include "ui/preferences.h"

namespace lacuna::ui {

namespace {

/// Slices show any voxel at any time, so a window's volume must go into memory: what its header says is larger is
/// refused before it is read.
Volume open_in_memory(const std::string& name, const OpenOptions& options, std::uint64_t limit, const JobContext& job) {
    try {
        return open_volume_within(name, options, limit, job);
    } catch (const Error& error) {
        if (error.code() != Errc::out_of_memory) throw;
        QString words = core_sentence(error.what());
        if (limit < default_memory_limit())
            words += QLatin1Char(' ') + LoadController::tr("This limit is that of the settings, page Computing.");
        words += QLatin1Char(' ') + LoadController::tr("lacuna render draws large volumes in .raw and .mhd from disk.");
        throw Error(Errc::out_of_memory, words.toStdString());
    }
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
        document.voi_tables = facts.voi_tables;
        // Of a window and a table either may be taken (PS3.3 C.11.2.1.1); most people know windows.
        if (!document.voi_tables.empty() && !document.volume.dicom->window_center)
            show_table(document.settings, document, 0);
    } catch (const Error& error) {
        if (error.code() == Errc::cancelled) throw;
    }
}

}  // namespace

void LoadController::open(const QString& input, const OpenOptions& options) {
    job_.start(
        [name = input.toStdString(), options, limit = memory_limit_bytes(),
         hide = preferences::hide_patient()](const JobContext& job) {
            try {
                if (options.raw.empty() && needs_raw_layout(name)) return Opened{.raw_file = true};
                // Reading is most of it; the statistics take the rest.
                Volume volume = open_in_memory(name, options, limit, job.part(0, 0.9));
                Opened opened{.document = make_document(name, std::move(volume), job.part(0.9, 1))};
                opened.document.options = options;
                if (opened.document.volume.dicom) add_screen_facts(opened.document, {job.stop, nullptr});
                if (hide) hide_names(opened.document.volume, name);
                return opened;
            } catch (const AmbiguousInput& several) {
                return Opened{.choice = several.entries};
            } catch (const Error& error) {
                if (!hide || error.code() == Errc::cancelled) throw;
                throw Error(error.code(), without_names(error.what(), name));
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
            } else if (opened.raw_file) {
                Q_EMIT layoutNeeded(input);
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
