#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmnet/scu.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/base/job.h"
#include "core/io/pacs_socket.h"

namespace lacuna::dicom {

/// One association with a server: opened by connect(), ended by close() or destruction. A stop of the job shuts the
/// socket down, so that every call returns at once.
class PacsConnection : public DcmSCU {
public:
    PacsConnection(const PacsServer& server, const JobContext& job);
    ~PacsConnection() override;

    /// Asks for these classes; the role is the peer's view of C-GET's sub-operations.
    void propose(const OFString& sop_class, const OFList<OFString>& syntaxes, bool as_receiver = false);
    /// @throws Error(io), Error(cancelled)
    void connect();
    void close();
    /// Waits for an answer as long as it takes: something else watches, and calls give_up().
    void be_patient();
    /// From another thread: ends what waits on the server, as if it had fallen silent.
    void give_up();

    /// The accepted context of a class; @throws Error(io) naming `service` if the server does not offer it
    T_ASC_PresentationContextID accepted(const OFString& sop_class, const std::string& service);
    /// @throws the error that a failed call means
    void require(const OFCondition& condition);
    /// @throws Error(io) for a response status other than success, naming `service`
    void require_status(unsigned status, const std::string& service) const;

    /// A file for the next object that C-GET brings, which is written while it comes.
    std::function<std::filesystem::path()> new_file;
    /// Called for every object that has come, of so many bytes (none: the disk ran full); false: it could not be kept.
    std::function<bool(const std::filesystem::path& file, std::optional<std::uint64_t> bytes)> on_object;
    /// Called with remaining and finished sub-operations of C-GET and C-MOVE.
    std::function<void(int remaining, int done, int failed)> on_progress;
    std::size_t most_responses = k_most_pacs_rows;
    bool had_more = false;

    OFCondition handleFINDResponse(const T_ASC_PresentationContextID id, QRResponse* response,
                                   OFBool& wait_for_next) override;
    OFCondition handleSTORERequestFile(T_ASC_PresentationContextID* id, const OFString& name,
                                       T_DIMSE_C_StoreRQ* request) override;
    void notifyRECEIVEProgress(const unsigned long bytes) override { received_ = bytes; }
    OFCondition handleCGETResponse(const T_ASC_PresentationContextID id, RetrieveResponse* response,
                                   OFBool& go_on) override;
    OFCondition handleMOVEResponse(const T_ASC_PresentationContextID id, RetrieveResponse* response,
                                   OFBool& go_on) override;

private:
    void probe() const;
    void report(const RetrieveResponse* response) const;
    [[noreturn]] void fail(const OFCondition& condition) const;

    const PacsServer server_;
    const JobContext job_;
    std::shared_ptr<SocketWatch> watch_;
    std::unique_ptr<DcmTransportLayer> layer_;
    std::size_t responses_ = 0;
    std::uint64_t received_ = 0;  ///< bytes of the object that comes
    std::atomic<bool> silent_{false};
    std::unique_ptr<std::stop_callback<std::function<void()>>> on_stop_;
};

/// "HOST port PORT", as messages name a server.
std::string place_of(const PacsServer& server);
/// @throws Error(bad_usage) for a text that is no UID
void check_uid(const std::string& uid);
/// The codings without compression, and one alone.
OFList<OFString> plain_syntaxes();
OFList<OFString> one_syntax(const char* uid);
/// A key of a query: to be given back where `value` is empty.
void ask(DcmDataset& keys, const DcmTagKey& tag, const std::string& value = {});

}  // namespace lacuna::dicom
