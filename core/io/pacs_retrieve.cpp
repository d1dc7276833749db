#include <fmt/format.h>

#include <atomic>
#include <optional>

#include "core/base/atomic_folder.h"
#include "core/base/error.h"
#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"
#include "core/io/pacs.h"
#include "core/io/pacs_connection.h"
#include "core/io/pacs_kinds.h"
#include "core/io/pacs_receiver.h"

// C-GET and C-MOVE: two ways for the same objects into the same folder.
namespace lacuna {

namespace fs = std::filesystem;
using dicom::ask;
using dicom::PacsConnection;

namespace {

/// What a person asked for.
struct Wanted {
    std::string study, series;  ///< UIDs; no series: the whole study

    DcmDataset keys() const {
        DcmDataset keys;
        ask(keys, DCM_QueryRetrieveLevel, series.empty() ? "STUDY" : "SERIES");
        ask(keys, DCM_StudyInstanceUID, study);
        if (!series.empty()) ask(keys, DCM_SeriesInstanceUID, series);
        return keys;
    }
    bool holds(const fs::path& file) const {
        DcmFileFormat format;
        if (format
                .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect,
                                  DcmTagKey(0x7FE0, 0))
                .bad())
            return false;
        DcmDataset& set = *format.getDataset();
        return dicom::text_of(set, DCM_StudyInstanceUID) == study &&
               (series.empty() || dicom::text_of(set, DCM_SeriesInstanceUID) == series);
    }
};

/// The folder being filled. Files are named by number: names the server gives are not used.
class Arrivals {
public:
    explicit Arrivals(const fs::path& folder) : folder_(folder), output_(folder) {}

    /// A file for what comes next, from any thread.
    fs::path next() { return output_.path() / fmt::format("incoming{}", ++incoming_); }
    /// Keeps a file of so many bytes at least, if any. Of a disk that ran full its writer may not have been told.
    bool keep(const fs::path& file, std::optional<std::uint64_t> bytes) {
        std::error_code ec;
        bool kept = bytes && fs::file_size(file, ec) >= *bytes && !ec;
        if (kept) fs::rename(file, output_.path() / fmt::format("IM{:05d}.dcm", kept_ + 1), ec);
        kept = kept && !ec;
        if (kept) ++kept_;
        full_ = full_ || !kept;
        if (!kept) drop(file);
        return kept;
    }
    bool drop(const fs::path& file) {
        std::error_code ec;
        fs::remove(file, ec);
        return false;
    }
    int kept() const { return kept_; }
    void commit() { output_.commit(); }
    void refuse_full_disk() const {
        if (full_)
            throw Error(Errc::io, "Cannot write what the server sends to " + folder_.string() +
                                      ": the disk is full or the file size is limited; nothing was kept.");
    }

private:
    const fs::path folder_;
    AtomicFolder output_;
    std::atomic<int> incoming_{0};
    int kept_ = 0;
    bool full_ = false;
};

/// What the server said at the end of a retrieval.
struct Ending {
    OFCondition condition;
    unsigned status = 0;
    int done = 0, failed = 0;
};

Ending ending_of(const OFCondition& condition, const OFList<RetrieveResponse*>& responses) {
    Ending ending{condition, 0, 0, 0};
    std::vector<std::unique_ptr<RetrieveResponse>> held;
    for (RetrieveResponse* response : responses) held.emplace_back(response);
    if (held.empty()) return ending;
    ending.status = held.back()->m_status;
    ending.done = held.back()->m_numberOfCompletedSubops + held.back()->m_numberOfWarningSubops;
    ending.failed = held.back()->m_numberOfFailedSubops;
    return ending;
}

/// @throws what ended a retrieval before its end
void require_end(PacsConnection& connection, const Ending& ending, const std::string& service) {
    connection.require(ending.condition);
    const bool some_failed = ending.status == 0xB000;
    if (!some_failed) connection.require_status(ending.status, service);
}

/// Keeps what came, whatever ended it; `explain` says why nothing did.
template <class Explain>
PacsTransfer conclude(PacsConnection& connection, Arrivals& arrivals, const Ending& ending, const std::string& service,
                      Explain&& explain) {
    arrivals.refuse_full_disk();
    PacsTransfer transfer{arrivals.kept(), ending.failed, {}};
    try {
        require_end(connection, ending, service);
        if (transfer.done == 0) connection.require_status(ending.status, service);
        connection.close();
    } catch (const Error& error) {
        if (error.code() != Errc::io) throw;
        if (transfer.done == 0) throw Error(Errc::io, explain(error.what()));
        transfer.fault = error.what();
    }
    if (transfer.done == 0) throw Error(Errc::io, explain({}));
    arrivals.commit();
    return transfer;
}

/// Progress as a server counts it.
void report(const JobContext& job, int remaining, int done, int failed) {
    const int all = remaining + done + failed;
    if (job.progress && all > 0) job.progress(double(done + failed) / all);
}

constexpr const char* k_nothing = "The server sent nothing for this; it may have been removed there.";

PacsTransfer get(const PacsServer& server, const Wanted& wanted, Arrivals& arrivals, const JobContext& job) {
    const char* sop_class = UID_GETStudyRootQueryRetrieveInformationModel;
    PacsConnection connection(server, job);
    connection.propose(sop_class, dicom::plain_syntaxes());
    // A context for each coding: of one with all, the server would take a single coding and have to convert the rest.
    for (const char* image : dicom::k_images) {
        connection.propose(image, dicom::plain_syntaxes(), true);
        for (const char* packed : dicom::k_packed) connection.propose(image, dicom::one_syntax(packed), true);
    }
    for (const char* other : dicom::k_others) connection.propose(other, dicom::plain_syntaxes(), true);
    connection.connect();
    const auto context = connection.accepted(sop_class, "retrieving (C-GET by the study root)");
    connection.new_file = [&] { return arrivals.next(); };
    connection.on_object = [&](const fs::path& file, std::optional<std::uint64_t> bytes) {
        return arrivals.keep(file, bytes);
    };
    connection.on_progress = [&](int remaining, int done, int failed) { report(job, remaining, done, failed); };
    DcmDataset keys = wanted.keys();
    OFList<RetrieveResponse*> responses;
    const OFCondition condition = connection.sendCGETRequest(context, &keys, &responses);
    return conclude(connection, arrivals, ending_of(condition, responses), "retrieval (C-GET)",
                    [](const std::string& fault) { return fault.empty() ? k_nothing : fault; });
}

/// Why a C-MOVE brought nothing: most often the two do not know each other.
std::string why_nothing(const PacsServer& server, const Ending& ending, const std::string& refused,
                        const std::string& fault) {
    const std::string here = fmt::format("{} at {} port {}{}", server.calling_aet, server.receiver.address,
                                         server.receiver.port, server.tls.on ? " with TLS" : "");
    if (!refused.empty())
        return fmt::format("Images were sent by {}, and refused: from {} to {} is taken; correct the AE titles.",
                           refused, server.called_aet, server.calling_aet);
    if (!fault.empty()) return fault + " For C-MOVE the server has to know this program as " + here + ".";
    if (ending.done > 0)
        return fmt::format("The server says that it sent {} files, but none came to {}; correct what it knows of it.",
                           ending.done, here);
    return k_nothing;
}

PacsTransfer move(const PacsServer& server, const Wanted& wanted, Arrivals& arrivals, const JobContext& job) {
    const char* sop_class = UID_MOVEStudyRootQueryRetrieveInformationModel;
    PacsConnection connection(server, job);
    connection.propose(sop_class, dicom::plain_syntaxes());
    connection.connect();
    const auto context = connection.accepted(sop_class, "retrieving (C-MOVE by the study root)");
    const auto take = [&](const fs::path& file, std::optional<std::uint64_t> bytes) {
        return bytes && (job.stopped() || !wanted.holds(file)) ? arrivals.drop(file) : arrivals.keep(file, bytes);
    };
    auto receiving = std::make_unique<dicom::PacsReceiving>(
        server, dicom::PacsReceiving::Callbacks{[&] { return arrivals.next(); }, take, [&] { connection.give_up(); }});
    connection.be_patient();  // images come over another connection; silence on both is what counts
    connection.on_progress = [&](int remaining, int done, int failed) {
        receiving->alive();
        report(job, remaining, done, failed);
    };
    DcmDataset keys = wanted.keys();
    OFList<RetrieveResponse*> responses;
    const OFCondition condition = connection.sendMOVERequest(context, server.calling_aet.c_str(), &keys, &responses);
    const std::string refused = receiving->refused();
    receiving.reset();  // no more comes after this
    const Ending ending = ending_of(condition, responses);
    return conclude(connection, arrivals, ending, "retrieval (C-MOVE)",
                    [&](const std::string& fault) { return why_nothing(server, ending, refused, fault); });
}

}  // namespace

PacsTransfer retrieve_from_pacs(const PacsServer& server, const std::string& study_uid, const std::string& series_uid,
                                const fs::path& folder, const JobContext& job) {
    dicom::check_uid(study_uid);
    if (!series_uid.empty()) dicom::check_uid(series_uid);
    Arrivals arrivals(folder);
    const Wanted wanted{study_uid, series_uid};
    return server.receiver.on ? move(server, wanted, arrivals, job) : get(server, wanted, arrivals, job);
}

}  // namespace lacuna
