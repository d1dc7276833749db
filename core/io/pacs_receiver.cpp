#include "core/io/pacs_receiver.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmnet/scp.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <list>
#include <mutex>
#include <system_error>
#include <thread>

#include "core/base/error.h"
#include "core/io/pacs_kinds.h"
#include "core/io/pacs_socket.h"

namespace lacuna::dicom {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int k_poll_ms = 50;
constexpr std::size_t k_most_connections = 8;  // a server sends over one, some over a few
constexpr int k_any_port = 11112;              // DCMTK asks for one, and does not listen on it
constexpr unsigned k_largest_pdu = 131072;

/// DCMTK would listen on every address of the computer. It is handed connections accepted here instead, by a variable
/// of the whole process, one at a time.
std::mutex& handing_over() {
    static std::mutex mutex;
    return mutex;
}

/// What the connections of one receiver share.
struct Shared {
    Shared(const PacsServer& from, PacsReceiving::Callbacks called) : server(from), callbacks(std::move(called)) {}

    const PacsServer& server;
    PacsReceiving::Callbacks callbacks;
    std::mutex keeping, naming;
    std::string refused;
    std::atomic<Clock::rep> last{Clock::now().time_since_epoch().count()};

    void alive() { last = Clock::now().time_since_epoch().count(); }
};

/// One association.
class StoreScp final : public DcmSCP {
public:
    StoreScp(Shared& shared, std::shared_ptr<SocketWatch> watch) : shared_(shared) {
        const PacsServer& server = shared.server;
        setAETitle(server.calling_aet.c_str());
        setMaxReceivePDULength(k_largest_pdu);
        setConnectionBlockingMode(DUL_NOBLOCK);
        setConnectionTimeout(Uint32(server.timeout_s));
        setACSETimeout(Uint32(server.timeout_s));
        setDIMSEBlockingMode(DIMSE_NONBLOCKING);
        setDIMSETimeout(Uint32(server.timeout_s));
        setHostLookupEnabled(OFFalse);
        OFList<OFString> codings;
        for (const char* plain : {UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax})
            codings.push_back(plain);
        addPresentationContext(UID_VerificationSOPClass, codings);
        for (const char* other : k_others) addPresentationContext(other, codings);
        for (const char* packed : k_packed) codings.push_back(packed);
        for (const char* image : k_images) addPresentationContext(image, codings);
        layer_ = make_transport(server.tls, true, std::move(watch), [this] {
            dcmExternalSocketHandle.set(-1);
            if (handing_.owns_lock()) handing_.unlock();
        });
        getConfig().setTransportLayer(layer_.get());
    }

    /// Serves a connection to its end, and closes it. Not by listen(): that takes every address, and changes the user,
    /// whose signal interrupts whatever other threads wait for.
    void serve(int socket) {
        handing_ = std::unique_lock(handing_over());
        dcmExternalSocketHandle.set(socket);
        T_ASC_Network* network = nullptr;
        if (ASC_initializeNetwork(NET_ACCEPTOR, k_any_port, shared_.server.timeout_s, &network).good() &&
            ASC_setTransportLayer(network, layer_.get(), 0).good())
            (void)waitForAssociationRQ(network);
        if (network) ASC_dropNetwork(&network);
        if (!handing_.owns_lock()) return;
        dcmExternalSocketHandle.set(-1);
        handing_.unlock();
        ::close(socket);
    }

protected:
    void notifyAssociationRequest(const T_ASC_Parameters& parameters, DcmSCPActionType&) override {
        calling_ = one_line(parameters.DULparams.callingAPTitle);
    }
    OFBool checkCalledAETitleAccepted(const OFString& title) override {
        return known(title, shared_.server.calling_aet, title);
    }
    OFBool checkCallingAETitleAccepted(const OFString& title) override {
        return known(title, shared_.server.called_aet, shared_.server.calling_aet.c_str());
    }
    void notifyRECEIVEProgress(const unsigned long bytes) override {
        received_ = bytes;
        shared_.alive();
    }

    OFCondition handleIncomingCommand(T_DIMSE_Message* message, const DcmPresentationContextInfo& context) override {
        shared_.alive();
        if (message->CommandField != DIMSE_C_STORE_RQ) return DcmSCP::handleIncomingCommand(message, context);
        T_DIMSE_C_StoreRQ& request = message->msg.CStoreRQ;
        const std::filesystem::path file = shared_.callbacks.new_file();
        received_ = 0;
        const OFCondition got = receiveSTORERequest(request, context.presentationContextID, OFString(file.c_str()));
        const bool full = got == DIMSE_OUTOFRESOURCES;
        if (got.bad() && !full) {
            std::error_code ec;
            std::filesystem::remove(file, ec);
            return got;
        }
        bool kept = false;
        {
            const std::lock_guard one_at_a_time(shared_.keeping);
            kept = shared_.callbacks.on_object(file, full ? std::nullopt : std::optional(received_));
        }
        if (got.bad()) return got;
        shared_.alive();
        return sendSTOREResponse(context.presentationContextID, request,
                                 Uint16(kept ? STATUS_Success : STATUS_STORE_Refused_OutOfResources));
    }

private:
    OFBool known(const OFString& title, const std::string& wanted, const OFString& called) {
        if (wanted == title.c_str()) return OFTrue;
        const std::lock_guard lock(shared_.naming);
        shared_.refused = calling_ + " to " + one_line(called.c_str());
        return OFFalse;
    }

    Shared& shared_;
    std::unique_ptr<DcmTransportLayer> layer_;
    std::unique_lock<std::mutex> handing_;
    std::string calling_;
    std::uint64_t received_ = 0;  ///< bytes of the object that comes
};

/// A socket that listens on one address. @throws Error(io)
int listening(const PacsReceiver& receiver) {
    const std::string port = std::to_string(receiver.port);
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_family = AF_INET;
    wanted.ai_socktype = SOCK_STREAM;
    if (::getaddrinfo(receiver.address.c_str(), port.c_str(), &wanted, &found) != 0 || !found)
        throw Error(Errc::io, "There is no address " + receiver.address + " to receive at; check the receiver's.");
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> address(found, &::freeaddrinfo);
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;  // a port that was open a moment ago
    if (socket >= 0 && ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
        ::bind(socket, address->ai_addr, address->ai_addrlen) == 0 && ::listen(socket, int(k_most_connections)) == 0)
        return socket;
    const int fault = errno;
    if (socket >= 0) ::close(socket);
    const char* what_to_do = fault == EADDRINUSE      ? "choose another port"
                             : fault == EADDRNOTAVAIL ? "name one of this computer's addresses"
                             : fault == EACCES        ? "choose a port from 1024 on"
                                                      : "check the receiver's address and port";
    throw Error(Errc::io, fmt::format("Cannot receive at {} port {}: {}; {}.", receiver.address, receiver.port,
                                      std::strerror(fault), what_to_do));
}

}  // namespace

/// The open port and the connections taken from it.
struct PacsReceiving::State {
    struct Connection {
        std::shared_ptr<SocketWatch> watch = std::make_shared<SocketWatch>();
        std::atomic<bool> ended{false};
        std::thread thread;
    };
    const PacsServer server;
    Shared shared;
    int socket = -1;
    std::atomic<bool> stopping{false};
    std::list<Connection> connections;  // of the accepting thread alone
    std::thread thread;

    State(const PacsServer& from, Callbacks callbacks) : server(from), shared(server, std::move(callbacks)) {
        // What would make every connection fail is said at once.
        (void)make_transport(server.tls, true, std::make_shared<SocketWatch>());
        socket = listening(server.receiver);
        thread = std::thread([this] { accept_until_stopped(); });
    }
    ~State() {
        stopping = true;
        thread.join();
    }

    void accept_until_stopped() {
        bool told = false;
        while (!stopping) {
            pollfd waiting{socket, POLLIN, 0};
            const int ready = ::poll(&waiting, 1, k_poll_ms);
            drop_ended();
            if (ready > 0) take(::accept4(socket, nullptr, nullptr, SOCK_CLOEXEC));
            const Clock::time_point last{Clock::duration(shared.last.load())};
            if (told || Clock::now() - last < std::chrono::seconds(server.timeout_s)) continue;
            told = true;
            shared.callbacks.on_silence();
        }
        ::close(socket);
        for (Connection& connection : connections) {
            connection.watch->shut_down();
            connection.thread.join();
        }
    }

    void take(int accepted) {
        if (accepted < 0) return;
        if (connections.size() >= k_most_connections) {
            ::close(accepted);
            return;
        }
        Connection& connection = connections.emplace_back();
        connection.watch->watch(accepted);
        try {
            connection.thread = std::thread([this, &connection, accepted] {
                serve(connection.watch, accepted);
                connection.ended = true;
            });
        } catch (const std::system_error&) {  // no more threads: the sender is turned away as one too many
            connections.pop_back();
            ::close(accepted);
        }
    }

    void serve(const std::shared_ptr<SocketWatch>& watch, int accepted) {
        std::unique_ptr<StoreScp> scp;
        try {
            scp = std::make_unique<StoreScp>(shared, watch);
        } catch (const std::exception&) {  // a certificate that has gone since
            ::close(accepted);
            return;
        }
        scp->serve(accepted);
    }

    void drop_ended() {
        connections.remove_if([](Connection& connection) {
            if (!connection.ended) return false;
            connection.thread.join();
            return true;
        });
    }
};

PacsReceiving::PacsReceiving(const PacsServer& server, Callbacks callbacks)
    : state_(std::make_unique<State>(server, std::move(callbacks))) {}
PacsReceiving::~PacsReceiving() = default;

void PacsReceiving::alive() { state_->shared.alive(); }

std::string PacsReceiving::refused() const {
    const std::lock_guard lock(state_->shared.naming);
    return state_->shared.refused;
}

}  // namespace lacuna::dicom
