#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// How the connection to a server is secured: TLS 1.2 or newer with the ciphers of BCP 195, not downgraded (PS3.15
/// B.10). The server's certificate is checked against the trusted ones; DCMTK does not compare host names.
struct PacsTls {
    bool on = false;
    std::filesystem::path trusted;           ///< PEM file of the authorities whose certificates are believed
    std::filesystem::path certificate, key;  ///< PEM files of this program's own; empty: it shows none
    friend bool operator==(const PacsTls&, const PacsTls&) = default;
};

/// Where C-MOVE has the server send to: a port of this computer that is open during the retrieval alone, takes images
/// from the server's AE title alone, and keeps those that were asked for.
struct PacsReceiver {
    bool on = false;                    ///< retrieve by C-MOVE; else by C-GET, which opens no port
    std::string address = "127.0.0.1";  ///< of this computer, name or IPv4 address; the port is bound to it alone
    int port = 11112;                   ///< the server has to know this program's title, address and port
    friend bool operator==(const PacsReceiver&, const PacsReceiver&) = default;
};

/// A DICOM server (PACS) as a person configures it.
struct PacsServer {
    std::string name;  ///< for people
    std::string host;  ///< name or IPv4 address
    int port = 104;
    std::string called_aet;              ///< the server's application entity title
    std::string calling_aet = "LACUNA";  ///< this program's, which the server may have to know
    int timeout_s = 30;                  ///< how long to wait for an answer; at most 10 s for the connection itself
    PacsTls tls;
    PacsReceiver receiver;
    friend bool operator==(const PacsServer&, const PacsServer&) = default;
};

/// What to look for; empty parts match everything, * and ? stand for any text and any character.
struct PacsQuery {
    std::string patient_name, patient_id, accession, description;
    std::string date_from, date_to;  ///< YYYYMMDD
    std::string modality;            ///< "CT"
};

struct PacsStudy {
    std::string uid, patient_name, patient_id, birth_date, date, description, accession, modalities;  ///< UTF-8
    int series = 0, images = 0;                                                                       ///< 0: not said
};

struct PacsSeries {
    std::string uid, modality, description;
    int number = 0, images = 0;
};

template <class Row>
struct PacsAnswer {
    std::vector<Row> rows;
    bool more = false;  ///< the server has more than k_most_pacs_rows; narrow the search
};
inline constexpr std::size_t k_most_pacs_rows = 1000;

struct PacsTransfer {
    int done = 0, failed = 0;
    std::string fault;  ///< why it ended before its end, one sentence; empty: it did not
};

// Every call opens an association of its own and ends it. All throw Error(bad_usage) for a server that cannot be (AE
// title, port); Error(io) with what went wrong and what to check when the server is not there, refuses, falls silent or
// says what DICOM does not know; Error(cancelled), at once at any moment. No patient's data in any message or log.

/// C-ECHO: the server is there and takes this program's associations.
void pacs_echo(const PacsServer& server, const JobContext& job = {});

/// C-FIND by the study root. @throws also Error(bad_usage) for dates that are none
PacsAnswer<PacsStudy> find_pacs_studies(const PacsServer& server, const PacsQuery& query, const JobContext& job = {});
PacsAnswer<PacsSeries> find_pacs_series(const PacsServer& server, const std::string& study_uid,
                                        const JobContext& job = {});

/// Retrieves a series, or a whole study where `series_uid` is empty, by C-GET, or by C-MOVE where the server is set to,
/// into a folder that must not exist yet or be empty. It appears whole, or, where the server could not send everything,
/// fell silent or broke off, with what came; not at all where the job is cancelled. Images come in the coding they are
/// stored in, where it is one this program reads. @throws Error(io) also where nothing came, or the receiver's port
/// cannot be opened
PacsTransfer retrieve_from_pacs(const PacsServer& server, const std::string& study_uid, const std::string& series_uid,
                                const std::filesystem::path& folder, const JobContext& job = {});

/// C-STORE of DICOM files, as they are. @throws Error(io) where none was taken; Error(bad_input) for no DICOM file
PacsTransfer send_to_pacs(const PacsServer& server, const std::vector<std::filesystem::path>& files,
                          const JobContext& job = {});

}  // namespace lacuna
