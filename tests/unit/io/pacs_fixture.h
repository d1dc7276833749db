#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <arpa/inet.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/scp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "../../support/dicom_zoo.h"
#include "core/base/error.h"
#include "core/io/dicom_header.h"
#include "core/io/pacs.h"
#include "volume_fixture.h"

// Peers for tests of what goes over a network: broken ones, a small server in this process, Orthanc.
namespace lacuna::test {

/// A listening socket on a free port of the loopback.
class Listener {
public:
    Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(socket_, 8) != 0 ||
            ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
            throw std::runtime_error("no free port");
        port_ = ntohs(address.sin_port);
    }
    ~Listener() { close(); }
    int port() const { return port_; }
    int accept() const { return ::accept(socket_, nullptr, nullptr); }
    void close() {
        if (socket_ < 0) return;
        ::shutdown(socket_, SHUT_RDWR);
        ::close(socket_);
        socket_ = -1;
    }

private:
    int socket_, port_ = 0;
};

inline int free_port() { return Listener().port(); }

inline PacsServer server_at(int port, const char* title = "PEER") {
    PacsServer server;
    server.host = "127.0.0.1";
    server.port = port;
    server.called_aet = title;
    server.timeout_s = 20;
    return server;
}

/// Takes every connection and does with it as told.
class Peer {
public:
    explicit Peer(std::function<void(int)> serve) {
        thread_ = std::thread([this, serve = std::move(serve)] {
            for (int connection; (connection = listener_.accept()) >= 0;) {
                serve(connection);
                open_.push_back(connection);
            }
        });
    }
    ~Peer() {
        listener_.close();
        thread_.join();
        for (const int connection : open_) ::close(connection);
    }
    int port() const { return listener_.port(); }

private:
    Listener listener_;
    std::vector<int> open_;
    std::thread thread_;
};

/// A small DICOM server: takes echoes and stores, answers searches from a list.
class SmallServer final : public DcmSCP {
public:
    SmallServer() {
        dicom::prepare_dcmtk();
        port_ = free_port();
        setPort(Uint16(port_));
        setAETitle("PEER");
        setConnectionBlockingMode(DUL_NOBLOCK);
        setConnectionTimeout(1);
        setRespondWithCalledAETitle(OFTrue);
        OFList<OFString> syntaxes;
        syntaxes.push_back(UID_LittleEndianExplicitTransferSyntax);
        syntaxes.push_back(UID_LittleEndianImplicitTransferSyntax);
        for (const char* uid : {UID_VerificationSOPClass, UID_FINDStudyRootQueryRetrieveInformationModel,
                                UID_MOVEStudyRootQueryRetrieveInformationModel, UID_CTImageStorage})
            addPresentationContext(uid, syntaxes);
    }
    ~SmallServer() override {
        stopping_ = true;
        if (thread_.joinable()) thread_.join();
    }
    void start() {
        thread_ = std::thread([this] { (void)listen(); });
        for (int i = 0; i < 200; ++i) {  // until it listens
            const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
            sockaddr_in address{};
            address.sin_family = AF_INET;
            address.sin_port = htons(std::uint16_t(port_));
            address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
            const bool there = ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
            ::close(socket);
            if (there) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    int port() const { return port_; }

    std::atomic<int> stored{0}, echoes{0};
    std::string stored_name, asked_name;
    Uint16 find_status = STATUS_Success, store_status = STATUS_Success;
    int studies = 3;
    std::function<OFBool()> refuse = [] { return OFFalse; };
    /// What a C-MOVE does here; returns the status of its end, or nothing: it ends without one.
    std::function<std::optional<Uint16>(const std::string& destination)> on_move;
    std::string move_destination;
    Uint16 moved = 0;  ///< how many the end of a C-MOVE says were sent

protected:
    OFBool stopAfterCurrentAssociation() override { return stopping_; }
    OFBool stopAfterConnectionTimeout() override { return stopping_; }
    OFBool checkCalledAETitleAccepted(const OFString& title) override { return title == "PEER"; }
    OFBool checkCallingHostAccepted(const OFString&) override { return !refuse(); }

    OFCondition handleIncomingCommand(T_DIMSE_Message* message, const DcmPresentationContextInfo& context) override {
        if (message->CommandField == DIMSE_C_ECHO_RQ) {
            ++echoes;
            return handleECHORequest(message->msg.CEchoRQ, context.presentationContextID);
        }
        if (message->CommandField == DIMSE_C_STORE_RQ) return take(message->msg.CStoreRQ, context);
        if (message->CommandField == DIMSE_C_FIND_RQ) return search(message->msg.CFindRQ, context);
        if (message->CommandField == DIMSE_C_MOVE_RQ) return move(message->msg.CMoveRQ, context);
        return DIMSE_BADCOMMANDTYPE;
    }

private:
    OFCondition take(T_DIMSE_C_StoreRQ& request, const DcmPresentationContextInfo& context) {
        DcmDataset* set = nullptr;
        const OFCondition got = receiveSTORERequest(request, context.presentationContextID, set);
        const std::unique_ptr<DcmDataset> held(set);
        if (got.bad()) return got;
        OFString name;
        set->findAndGetOFString(DCM_PatientName, name);
        stored_name = name.c_str();
        if (store_status == STATUS_Success) ++stored;
        return sendSTOREResponse(context.presentationContextID, request, store_status);
    }

    OFCondition search(T_DIMSE_C_FindRQ& request, const DcmPresentationContextInfo& context) {
        DcmDataset* keys = nullptr;
        const OFCondition got = receiveFINDRequest(request, context.presentationContextID, keys);
        const std::unique_ptr<DcmDataset> held(keys);
        if (got.bad()) return got;
        OFString name;
        keys->findAndGetOFString(DCM_PatientName, name);
        asked_name = name.c_str();
        for (int i = 0; i < studies && find_status == STATUS_Success; ++i) {
            DcmDataset row;
            row.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
            row.putAndInsertString(DCM_StudyInstanceUID, ("1.2.3." + std::to_string(i)).c_str());
            row.putAndInsertString(DCM_PatientName, "M\xFCller^Eva");
            row.putAndInsertString(DCM_StudyDate, "20260102");
            row.putAndInsertString(DCM_ModalitiesInStudy, "CT\\SEG");
            row.putAndInsertString(DCM_NumberOfStudyRelatedInstances, i == 1 ? "12" : "many");
            const OFCondition sent = sendFINDResponse(context.presentationContextID, request.MessageID,
                                                      request.AffectedSOPClassUID, &row, STATUS_Pending);
            if (sent.bad()) return sent;
        }
        return sendFINDResponse(context.presentationContextID, request.MessageID, request.AffectedSOPClassUID, nullptr,
                                find_status);
    }

    OFCondition move(T_DIMSE_C_MoveRQ& request, const DcmPresentationContextInfo& context) {
        DcmDataset* keys = nullptr;
        OFString destination;
        const OFCondition got = receiveMOVERequest(request, context.presentationContextID, keys, destination);
        const std::unique_ptr<DcmDataset> held(keys);
        if (got.bad()) return got;
        move_destination = destination.c_str();
        const auto status = on_move ? on_move(move_destination) : std::optional<Uint16>(0xA801);
        if (!status) return abortAssociation();
        return sendMOVEResponse(context.presentationContextID, request.MessageID, request.AffectedSOPClassUID, nullptr,
                                *status, nullptr, 0, moved);
    }

    int port_ = 0;
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

/// Debian's Orthanc on the loopback with a folder of its own; stopped at the end of the scope.
class Orthanc {
public:
    /// @param more  of its settings, each with a comma before it
    explicit Orthanc(const std::filesystem::path& folder, const std::string& more = "") : port_(free_port()) {
        const int http = free_port();
        put_file(folder / "orthanc.json",
                 "{\"Name\":\"test\",\"StorageDirectory\":\"" + (folder / "db").string() + "\",\"IndexDirectory\":\"" +
                     (folder / "db").string() + "\",\"DicomAet\":\"ORTHANC\",\"DicomPort\":" + std::to_string(port_) +
                     ",\"HttpPort\":" + std::to_string(http) +
                     ",\"HttpServerEnabled\":false,\"RemoteAccessAllowed\":false,\"DicomAlwaysAllowEcho\":true,"
                     "\"DicomAlwaysAllowStore\":true,\"DicomAlwaysAllowFind\":true,\"DicomAlwaysAllowGet\":true,"
                     "\"DicomAlwaysAllowMove\":true,"
                     "\"DicomCheckCalledAet\":true,\"Plugins\":[]" +
                     more + "}");
        const std::string config = (folder / "orthanc.json").string(), log = (folder / "log.txt").string();
        process_ = ::fork();
        if (process_ == 0) {
            (void)!::freopen(log.c_str(), "w", stdout);
            (void)!::freopen(log.c_str(), "w", stderr);
            ::execlp("Orthanc", "Orthanc", config.c_str(), nullptr);
            ::execl("/usr/sbin/Orthanc", "Orthanc", config.c_str(), nullptr);
            ::_exit(127);
        }
    }
    ~Orthanc() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);  // its folder goes with it
        ::waitpid(process_, nullptr, 0);
    }
    /// False: it does not run here.
    bool wait(const PacsServer& server) {
        for (int i = 0; i < 300; ++i) {
            int status = 0;
            if (::waitpid(process_, &status, WNOHANG) == process_) {
                process_ = 0;
                return false;
            }
            try {
                pacs_echo(server);
                return true;
            } catch (const Error&) {
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
            }
        }
        return false;
    }
    int port() const { return port_; }

private:
    int port_;
    pid_t process_ = -1;
};

inline bool orthanc_is_there() {
    return std::system("command -v Orthanc >/dev/null 2>&1 || test -x /usr/sbin/Orthanc") == 0;
}

/// Makes cert.pem with key.pem, and other.pem with other_key.pem; false: the openssl program is not installed.
inline bool make_certificates(const std::filesystem::path& folder) {
    const auto make = [&](const std::string& key, const std::string& certificate, const std::string& name) {
        const std::string call = "cd " + folder.string() + " && openssl req -x509 -newkey rsa:2048 -nodes -keyout " +
                                 key + " -out " + certificate + " -days 2 -subj /CN=" + name + " >/dev/null 2>&1";
        return std::system(call.c_str()) == 0;
    };
    return make("key.pem", "cert.pem", "localhost") && make("other_key.pem", "other.pem", "other");
}

/// Orthanc's settings for TLS with cert.pem, which it also trusts.
inline std::string orthanc_tls(const std::filesystem::path& folder) {
    const std::string base = folder.string();
    return ",\"DicomTlsEnabled\":true,\"DicomTlsCertificate\":\"" + base + "/cert.pem\",\"DicomTlsPrivateKey\":\"" +
           base + "/key.pem\",\"DicomTlsTrustedCertificates\":\"" + base + "/cert.pem\"";
}

/// Six slices of one series of the study k_round_study, in two codings, in a folder "in".
inline constexpr const char* k_round_study = "1.2.826.0.1.3680043.2.1143.99";
inline std::vector<std::filesystem::path> write_round_trip_series(const std::filesystem::path& folder) {
    std::filesystem::create_directory(folder / "in");
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < 6; ++i) {
        ZooSlice slice;
        slice.instance = i + 1;
        slice.position = {0, 0, double(i)};
        slice.syntax = i % 2 ? ZooSyntax::jpeg_lossless : ZooSyntax::explicit_le;  // both codings must come back
        slice.stored = [i](int x, int y) { return 100 * i + 10 * y + x; };
        slice.extra = {
            {{0x0010, 0x0010}, "Roundtrip^Test"}, {{0x0010, 0x0020}, "R1"}, {{0x0020, 0x000D}, k_round_study}};
        files.push_back(folder / ("in/" + std::to_string(i) + ".dcm"));
        write_zoo_slice(files.back(), slice);
    }
    return files;
}

}  // namespace lacuna::test
