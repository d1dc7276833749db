#include "core/io/pacs_connection.h"

#include <dcmtk/dcmnet/dcmtrans.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "core/base/error.h"
#include "core/io/dicom_header.h"

namespace lacuna::dicom {

namespace {

constexpr int k_longest_connect_s = 10, k_poll_ms = 50;
constexpr unsigned k_largest_pdu = 131072;

bool is_title(const std::string& title) {
    return !title.empty() && title.size() <= 16 &&
           std::all_of(title.begin(), title.end(), [](char c) { return c > 32 && c < 127 && c != '\\'; });
}

void check_server(const PacsServer& server) {
    const auto refuse = [](const std::string& fault) { throw Error(Errc::bad_usage, fault); };
    if (server.host.empty()) refuse("The server has no address; enter its host name or IP address.");
    if (server.port < 1 || server.port > 65535)
        refuse("The port " + std::to_string(server.port) +
               " is none; ports are 1 to 65535, for DICOM often 104 or 11112.");
    for (const std::string& title : {server.called_aet, server.calling_aet})
        if (!is_title(title))
            refuse("The AE title '" + title + "' is none: 1 to 16 characters without spaces and backslashes.");
    if (server.timeout_s < 1) refuse("The time to wait for the server must be a second at least.");
    if (!server.receiver.on) return;
    if (server.receiver.address.empty()) refuse("The receiver has no address of this computer; 127.0.0.1 is only it.");
    if (server.receiver.port < 1 || server.receiver.port > 65535)
        refuse("The receiver's port " + std::to_string(server.receiver.port) + " is none; ports are 1 to 65535.");
}

}  // namespace

std::string place_of(const PacsServer& server) { return server.host + " port " + std::to_string(server.port); }

void check_uid(const std::string& uid) {
    const bool sound = !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string::npos;
    if (!sound) throw Error(Errc::bad_usage, "'" + uid + "' is no unique identifier of a study or series.");
}

OFList<OFString> plain_syntaxes() {
    OFList<OFString> syntaxes;
    syntaxes.push_back(UID_LittleEndianExplicitTransferSyntax);
    syntaxes.push_back(UID_LittleEndianImplicitTransferSyntax);
    return syntaxes;
}

OFList<OFString> one_syntax(const char* uid) {
    OFList<OFString> syntaxes;
    syntaxes.push_back(uid);
    return syntaxes;
}

void ask(DcmDataset& keys, const DcmTagKey& tag, const std::string& value) {
    keys.putAndInsertString(tag, value.c_str());
}

PacsConnection::PacsConnection(const PacsServer& server, const JobContext& job)
    : server_(server), job_(job), watch_(std::make_shared<SocketWatch>()) {
    prepare_dcmtk();
    check_server(server);
    setPeerHostName(server.host.c_str());
    setPeerPort(Uint16(server.port));
    setPeerAETitle(server.called_aet.c_str());
    setAETitle(server.calling_aet.c_str());
    setMaxReceivePDULength(k_largest_pdu);
    setDIMSEBlockingMode(DIMSE_NONBLOCKING);
    setDIMSETimeout(Uint32(server.timeout_s));
    setACSETimeout(Uint32(server.timeout_s));
    setConnectionTimeout(std::min(server.timeout_s, k_longest_connect_s));
    dcmSocketSendTimeout.set(server.timeout_s);
    dcmSocketReceiveTimeout.set(server.timeout_s);
    setDatasetConversionMode(OFTrue);
    setStorageMode(DCMSCU_STORAGE_BIT_PRESERVING);
    on_stop_ = std::make_unique<std::stop_callback<std::function<void()>>>(
        job.stop, std::function<void()>([watch = watch_] { watch->shut_down(); }));
}

PacsConnection::~PacsConnection() {
    if (isConnected()) abortAssociation();
}

void PacsConnection::propose(const OFString& sop_class, const OFList<OFString>& syntaxes, bool as_receiver) {
    addPresentationContext(sop_class, syntaxes, as_receiver ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
}

/// Connects once by itself, which names the fault as the operating system knows it and can be stopped.
void PacsConnection::probe() const {
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_family = AF_INET;  // what DCMTK connects by
    wanted.ai_socktype = SOCK_STREAM;
    if (::getaddrinfo(server_.host.c_str(), std::to_string(server_.port).c_str(), &wanted, &found) != 0 || !found)
        throw Error(Errc::io, "There is no host named " + server_.host + "; check the server's address.");
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> address(found, &::freeaddrinfo);
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket < 0)
        throw Error(Errc::io, std::string("No network connection can be made: ") + std::strerror(errno) + ".");
    const std::unique_ptr<const int, void (*)(const int*)> closer(&socket, [](const int* s) { ::close(*s); });
    int fault = ::connect(socket, address->ai_addr, address->ai_addrlen) == 0 ? 0 : errno;
    const auto until =
        std::chrono::steady_clock::now() + std::chrono::seconds(std::min(server_.timeout_s, k_longest_connect_s));
    while (fault == EINPROGRESS && std::chrono::steady_clock::now() < until) {
        job_.check();
        pollfd waiting{socket, POLLOUT, 0};
        if (::poll(&waiting, 1, k_poll_ms) <= 0) continue;
        socklen_t size = sizeof fault;
        if (::getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size) != 0) fault = errno;
    }
    if (fault == 0) return;
    if (fault == ECONNREFUSED)
        throw Error(Errc::io, place_of(server_) +
                                  " refuses the connection; check that the server runs and that the port is right.");
    if (fault == EINPROGRESS || fault == ETIMEDOUT)
        throw Error(Errc::io, place_of(server_) + " does not answer; check address, port and firewall.");
    throw Error(Errc::io, place_of(server_) + " cannot be reached: " + std::strerror(fault) + ".");
}

void PacsConnection::connect() {
    job_.check();
    probe();
    {
        const ReadingAsBefore before;
        require(initNetwork());
    }
    layer_ = make_transport(server_.tls, false, watch_);
    require(useSecureConnection(layer_.get()));
    require(negotiateAssociation());
}

void PacsConnection::close() {
    if (isConnected()) releaseAssociation();
}

void PacsConnection::be_patient() {
    constexpr Uint32 k_a_day = 86400;
    setDIMSETimeout(k_a_day);
}

void PacsConnection::give_up() {
    silent_ = true;
    watch_->shut_down();
}

T_ASC_PresentationContextID PacsConnection::accepted(const OFString& sop_class, const std::string& service) {
    const T_ASC_PresentationContextID id = findAnyPresentationContextID(sop_class, "");
    if (id != 0) return id;
    throw Error(Errc::io, "The server " + place_of(server_) + " does not offer " + service + ".");
}

void PacsConnection::require(const OFCondition& condition) {
    if (condition.good()) {
        job_.check();
        return;
    }
    fail(condition);
}

void PacsConnection::fail(const OFCondition& condition) const {
    job_.check();  // what fails after a stop fails because of it
    const std::string place = place_of(server_);
    if (condition == DUL_ASSOCIATIONREJECTED)
        throw Error(Errc::io,
                    fmt::format("The server {} refuses the association; check that its AE title is {} and that it "
                                "knows this program as {}.",
                                place, server_.called_aet, server_.calling_aet));
    if (condition == NET_EC_NoAcceptablePresentationContexts || condition == NET_EC_NoPresentationContextsDefined)
        throw Error(Errc::io, "The server " + place + " offers none of the DICOM services asked for.");
    if (silent_ || condition == DIMSE_NODATAAVAILABLE || condition == DUL_READTIMEOUT)
        throw Error(Errc::io, fmt::format("The server {} fell silent for {} s; try again, or allow it more time.",
                                          place, server_.timeout_s));
    const std::string text = one_line(condition.text());
    if (text.find("TLS") != std::string::npos || text.find("SSL") != std::string::npos ||
        text.find("certificate") != std::string::npos)
        throw Error(Errc::io, "The secure connection to " + place + " failed (" + text +
                                  "); check that it speaks TLS there and that its certificate is trusted.");
    if (condition == DUL_NETWORKCLOSED || condition == DUL_PEERABORTEDASSOCIATION ||
        condition == DUL_PEERREQUESTEDRELEASE)
        throw Error(Errc::io, "The server " + place +
                                  " ended the connection; check that it is a DICOM server and takes "
                                  "connections of this program.");
    throw Error(Errc::io, "What answers at " + place + " is no DICOM server, or does not speak as one (" + text + ").");
}

void PacsConnection::require_status(unsigned status, const std::string& service) const {
    if (status == 0) return;
    const char* meaning = "it failed there";
    if (status == 0xA700 || status == 0xA701 || status == 0xA702) meaning = "it is out of resources";
    if (status == 0xA801) meaning = "it does not know the destination";
    if (status == 0xA900 || status == 0x0122) meaning = "it does not do this for such data";
    if (status == 0x0124) meaning = "this program is not allowed to";
    if (status == 0xFE00) meaning = "it was cancelled there";
    throw Error(Errc::io, fmt::format("The server {} did not do the {}: {} (status {:04X}).", place_of(server_),
                                      service, meaning, status));
}

OFCondition PacsConnection::handleFINDResponse(const T_ASC_PresentationContextID id, QRResponse* response,
                                               OFBool& wait_for_next) {
    const OFCondition handled = DcmSCU::handleFINDResponse(id, response, wait_for_next);
    if (wait_for_next && ++responses_ > most_responses) {
        had_more = true;
        wait_for_next = OFFalse;
    }
    if (job_.stopped()) wait_for_next = OFFalse;
    return handled;
}

/// The name is the one the server gives its object, with folders if it likes: it is not used.
OFCondition PacsConnection::handleSTORERequestFile(T_ASC_PresentationContextID* id, const OFString&,
                                                   T_DIMSE_C_StoreRQ* request) {
    const std::filesystem::path file = new_file();
    received_ = 0;
    const OFCondition got = DcmSCU::handleSTORERequestFile(id, file.c_str(), request);
    const bool full = got == DIMSE_OUTOFRESOURCES;
    if (got.bad() && !full) {
        std::error_code ec;
        std::filesystem::remove(file, ec);
        return got;
    }
    const bool kept = on_object(file, full ? std::nullopt : std::optional(received_));
    return kept ? got : OFCondition(DIMSE_OUTOFRESOURCES);
}

void PacsConnection::report(const RetrieveResponse* response) const {
    if (response && on_progress)
        on_progress(response->m_numberOfRemainingSubops,
                    response->m_numberOfCompletedSubops + response->m_numberOfWarningSubops,
                    response->m_numberOfFailedSubops);
}

OFCondition PacsConnection::handleCGETResponse(const T_ASC_PresentationContextID id, RetrieveResponse* response,
                                               OFBool& go_on) {
    report(response);
    return DcmSCU::handleCGETResponse(id, response, go_on);
}

OFCondition PacsConnection::handleMOVEResponse(const T_ASC_PresentationContextID id, RetrieveResponse* response,
                                               OFBool& go_on) {
    report(response);
    return DcmSCU::handleMOVEResponse(id, response, go_on);
}

}  // namespace lacuna::dicom
