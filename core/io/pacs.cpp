#include "core/io/pacs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"
#include "core/io/pacs_connection.h"

namespace lacuna {

namespace fs = std::filesystem;
using dicom::ask;
using dicom::PacsConnection;
using dicom::text_of;

namespace {

/// A query's value: a backslash would part it into several.
std::string plain(std::string text) {
    std::erase_if(text, [](char c) { return c == '\\' || (c >= 0 && c < ' '); });
    return text;
}

std::string date_range(const PacsQuery& query) {
    for (const std::string& date : {query.date_from, query.date_to})
        if (!date.empty() && (date.size() != 8 || date.find_first_not_of("0123456789") != std::string::npos))
            throw Error(Errc::bad_usage, "The date '" + date + "' is none; write YYYYMMDD.");
    if (query.date_from.empty() && query.date_to.empty()) return {};
    return query.date_from == query.date_to ? query.date_from : query.date_from + "-" + query.date_to;
}

int number(DcmDataset& set, const DcmTagKey& tag) {
    try {
        return dicom::integer_of(set, tag).value_or(0);
    } catch (const std::exception&) {
        return 0;  // a server's slip in what is only shown
    }
}

/// All values of a tag, joined by commas.
std::string values(DcmDataset& set, const DcmTagKey& tag) {
    std::string joined;
    for (unsigned long i = 0; i < 16; ++i) {
        const std::string value = text_of(set, tag, i);
        if (value.empty()) break;
        joined += (i ? ", " : "") + value;
    }
    return joined;
}

template <class Row, class Read>
PacsAnswer<Row> find(const PacsServer& server, DcmDataset& keys, Read&& read, const JobContext& job) {
    PacsConnection connection(server, job);
    const OFString sop_class = UID_FINDStudyRootQueryRetrieveInformationModel;
    connection.propose(sop_class, dicom::plain_syntaxes());
    connection.connect();
    const auto context = connection.accepted(sop_class, "searching (C-FIND by the study root)");
    OFList<QRResponse*> responses;
    const OFCondition done = connection.sendFINDRequest(context, &keys, &responses);
    std::vector<std::unique_ptr<QRResponse>> held;
    for (QRResponse* response : responses) held.emplace_back(response);
    connection.require(done);
    PacsAnswer<Row> answer;
    answer.more = connection.had_more;
    for (const auto& response : held) {
        const bool pending = response->m_status == 0xFF00 || response->m_status == 0xFF01;
        if (!pending) {
            connection.require_status(response->m_status, "search (C-FIND)");
            continue;
        }
        if (!response->m_dataset || answer.rows.size() >= k_most_pacs_rows) continue;
        (void)response->m_dataset->convertToUTF8();
        answer.rows.push_back(read(*response->m_dataset));
    }
    if (!connection.had_more) connection.close();  // else its further answers would come in between
    job.checkpoint(1, 1);
    return answer;
}

/// What a file is and how it is coded, from its header.
struct Outgoing {
    fs::path file;
    std::string sop_class, syntax;
};

Outgoing outgoing(const fs::path& file) {
    DcmFileFormat format;
    const OFCondition read = format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                                     ERM_autoDetect, DCM_PixelData);
    DcmDataset& set = *format.getDataset();
    Outgoing found{file, read.good() ? text_of(set, DCM_SOPClassUID) : "",
                   read.good() ? DcmXfer(set.getOriginalXfer()).getXferID() : ""};
    if (found.sop_class.empty())
        throw Error(Errc::bad_input, "Cannot send " + file.filename().string() + ": it is no DICOM object.");
    return found;
}

}  // namespace

void pacs_echo(const PacsServer& server, const JobContext& job) {
    PacsConnection connection(server, job);
    connection.propose(UID_VerificationSOPClass, dicom::plain_syntaxes());
    connection.connect();
    connection.require(connection.sendECHORequest(connection.accepted(UID_VerificationSOPClass, "C-ECHO")));
    connection.close();
}

PacsAnswer<PacsStudy> find_pacs_studies(const PacsServer& server, const PacsQuery& query, const JobContext& job) {
    DcmDataset keys;
    ask(keys, DCM_SpecificCharacterSet, "ISO_IR 192");
    ask(keys, DCM_QueryRetrieveLevel, "STUDY");
    ask(keys, DCM_StudyInstanceUID);
    ask(keys, DCM_StudyDate, date_range(query));
    ask(keys, DCM_PatientName, plain(query.patient_name));
    ask(keys, DCM_PatientID, plain(query.patient_id));
    ask(keys, DCM_AccessionNumber, plain(query.accession));
    ask(keys, DCM_StudyDescription, plain(query.description));
    ask(keys, DCM_ModalitiesInStudy, plain(query.modality));
    for (const DcmTagKey& wanted :
         {DCM_PatientBirthDate, DCM_NumberOfStudyRelatedSeries, DCM_NumberOfStudyRelatedInstances})
        ask(keys, wanted);
    return find<PacsStudy>(
        server, keys,
        [](DcmDataset& set) {
            return PacsStudy{text_of(set, DCM_StudyInstanceUID),
                             text_of(set, DCM_PatientName),
                             text_of(set, DCM_PatientID),
                             text_of(set, DCM_PatientBirthDate),
                             text_of(set, DCM_StudyDate),
                             text_of(set, DCM_StudyDescription),
                             text_of(set, DCM_AccessionNumber),
                             values(set, DCM_ModalitiesInStudy),
                             number(set, DCM_NumberOfStudyRelatedSeries),
                             number(set, DCM_NumberOfStudyRelatedInstances)};
        },
        job);
}

PacsAnswer<PacsSeries> find_pacs_series(const PacsServer& server, const std::string& study_uid, const JobContext& job) {
    dicom::check_uid(study_uid);
    DcmDataset keys;
    ask(keys, DCM_QueryRetrieveLevel, "SERIES");
    ask(keys, DCM_StudyInstanceUID, study_uid);
    for (const DcmTagKey& wanted : {DCM_SeriesInstanceUID, DCM_Modality, DCM_SeriesNumber, DCM_SeriesDescription,
                                    DCM_NumberOfSeriesRelatedInstances})
        ask(keys, wanted);
    return find<PacsSeries>(
        server, keys,
        [](DcmDataset& set) {
            return PacsSeries{text_of(set, DCM_SeriesInstanceUID), text_of(set, DCM_Modality),
                              text_of(set, DCM_SeriesDescription), number(set, DCM_SeriesNumber),
                              number(set, DCM_NumberOfSeriesRelatedInstances)};
        },
        job);
}

PacsTransfer send_to_pacs(const PacsServer& server, const std::vector<fs::path>& files, const JobContext& job) {
    dicom::prepare_dcmtk();
    if (files.empty()) throw Error(Errc::bad_input, "There is nothing to send.");
    std::vector<Outgoing> objects;
    std::set<std::pair<std::string, std::string>> kinds;
    for (const fs::path& file : files) {
        objects.push_back(outgoing(file));
        kinds.insert({objects.back().sop_class, objects.back().syntax});
        job.check();
    }
    PacsConnection connection(server, job);
    for (const auto& [sop_class, syntax] : kinds) {
        connection.propose(sop_class.c_str(), dicom::one_syntax(syntax.c_str()));
        if (!DcmXfer(syntax.c_str()).isEncapsulated()) connection.propose(sop_class.c_str(), dicom::plain_syntaxes());
    }
    connection.connect();
    PacsTransfer transfer;
    unsigned refusal = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        Uint16 status = 0;
        const OFCondition sent = connection.sendSTORERequest(0, objects[i].file.c_str(), nullptr, status);
        if (sent == DIMSE_NOVALIDPRESENTATIONCONTEXTID) {  // the server takes no objects of this kind
            status = 0x0122;
        } else {
            connection.require(sent);
        }
        const bool taken = status == 0 || (status & 0xF000) == 0xB000;  // B...: taken, with a warning
        ++(taken ? transfer.done : transfer.failed);
        if (!taken) refusal = status;
        job.checkpoint(i + 1, objects.size());
    }
    if (transfer.done == 0) connection.require_status(refusal, "storing (C-STORE)");
    connection.close();
    return transfer;
}

}  // namespace lacuna
