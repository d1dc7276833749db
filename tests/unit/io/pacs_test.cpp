#include "core/io/pacs.h"

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
#include <thread>

#include "../../support/dicom_zoo.h"
#include "core/io/dicom_header.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

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

int free_port() { return Listener().port(); }

PacsServer server_at(int port, const char* title = "PEER") {
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
        for (const char* uid :
             {UID_VerificationSOPClass, UID_FINDStudyRootQueryRetrieveInformationModel, UID_CTImageStorage})
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

    int port_ = 0;
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace

TEST(Pacs, EchoesSearchesAndStores) {
    SmallServer peer;
    peer.start();
    const PacsServer server = server_at(peer.port());
    pacs_echo(server);
    EXPECT_EQ(peer.echoes, 1);
    PacsQuery query;
    query.patient_name = "M*\\Other";
    query.date_from = "20260101";
    const auto found = find_pacs_studies(server, query);
    EXPECT_EQ(peer.asked_name, "M*Other");  // a backslash would ask for two names
    ASSERT_EQ(found.rows.size(), 3u);
    EXPECT_FALSE(found.more);
    EXPECT_EQ(found.rows[0].patient_name, "M\xC3\xBCller^Eva");
    EXPECT_EQ(found.rows[0].modalities, "CT, SEG");
    EXPECT_EQ(found.rows[0].images, 0);
    EXPECT_EQ(found.rows[1].images, 12);
    TemporaryFolder folder;
    write_zoo_slice(folder / "a.dcm", {});
    ZooSlice other;
    other.instance = 2;
    other.syntax = ZooSyntax::implicit_le;
    write_zoo_slice(folder / "b.dcm", other);
    const PacsTransfer sent = send_to_pacs(server, {folder / "a.dcm", folder / "b.dcm"});
    EXPECT_EQ(sent.done, 2);
    EXPECT_EQ(sent.failed, 0);
    EXPECT_EQ(peer.stored, 2);
}

TEST(Pacs, ALongAnswerIsCutAndSaysSo) {
    SmallServer peer;
    peer.studies = int(k_most_pacs_rows) + 50;
    peer.start();
    const auto found = find_pacs_studies(server_at(peer.port()), {});
    EXPECT_EQ(found.rows.size(), k_most_pacs_rows);
    EXPECT_TRUE(found.more);
}

TEST(Pacs, WhatTheServerRefusesIsNamed) {
    SmallServer peer;
    peer.find_status = 0xA700;
    peer.store_status = 0xA700;
    peer.start();
    const PacsServer server = server_at(peer.port());
    expect_error(Errc::io, {"search", "out of resources", "A700"}, [&] { find_pacs_studies(server, {}); });
    TemporaryFolder folder;
    write_zoo_slice(folder / "a.dcm", {});
    expect_error(Errc::io, {"storing", "A700"}, [&] { send_to_pacs(server, {folder / "a.dcm"}); });
    // It knows CT images only, has no C-GET, and goes by PEER.
    put_file(folder / "not_dicom.txt", "text");
    expect_error(Errc::bad_input, {"not_dicom.txt"}, [&] { send_to_pacs(server, {folder / "not_dicom.txt"}); });
    expect_error(Errc::io, {"does not offer", "C-GET"},
                 [&] { retrieve_from_pacs(server, "1.2.3", "", folder / "out"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    expect_error(Errc::io, {"refuses the association", "WRONG", "LACUNA"},
                 [&] { pacs_echo(server_at(peer.port(), "WRONG")); });
}

TEST(Pacs, WordsThatCannotBeAreRefusedBeforeAnyConnection) {
    PacsServer server = server_at(104);
    server.called_aet = "";
    expect_error(Errc::bad_usage, {"AE title"}, [&] { pacs_echo(server); });
    server.called_aet = "SEVENTEEN_LETTERS";
    expect_error(Errc::bad_usage, {"AE title"}, [&] { pacs_echo(server); });
    server = server_at(0);
    expect_error(Errc::bad_usage, {"port"}, [&] { pacs_echo(server); });
    server = server_at(104);
    server.host = "";
    expect_error(Errc::bad_usage, {"address"}, [&] { pacs_echo(server); });
    PacsQuery query;
    query.date_from = "yesterday";
    expect_error(Errc::bad_usage, {"yesterday"}, [&] { find_pacs_studies(server_at(104), query); });
    expect_error(Errc::bad_usage, {"identifier"}, [&] { find_pacs_series(server_at(104), "1.2.x"); });
    TemporaryFolder folder;
    expect_error(Errc::bad_usage, {"identifier"},
                 [&] { retrieve_from_pacs(server_at(104), "1.2", "../../x", folder / "out"); });
}

TEST(Pacs, NobodyThereIsNamed) {
    expect_error(Errc::io, {"refuses the connection", "127.0.0.1"}, [&] { pacs_echo(server_at(free_port())); });
    PacsServer server = server_at(104);
    server.host = "no-such-host.invalid";
    expect_error(Errc::io, {"no host named", "no-such-host.invalid"}, [&] { pacs_echo(server); });
}

TEST(Pacs, ASilentPeerIsGivenUpAfterItsTime) {
    Peer silent([](int) {});
    PacsServer server = server_at(silent.port());
    server.timeout_s = 1;
    expect_error(Errc::io, {"silent"}, [&] { pacs_echo(server); });
}

TEST(Pacs, ACancelEndsASilentPeerAtOnce) {
    Peer silent([](int) {});
    const PacsServer server = server_at(silent.port());
    std::stop_source stop;
    const auto from = std::chrono::steady_clock::now();
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop.request_stop();
    });
    expect_error(Errc::cancelled, {}, [&] { pacs_echo(server, {stop.get_token(), nullptr}); });
    EXPECT_LT(std::chrono::steady_clock::now() - from, std::chrono::seconds(10));  // it would wait 20 s
}

TEST(Pacs, RubbishIsRefusedWithoutHarm) {
    const std::string replies[] = {"HTTP/1.1 400 Bad Request\r\n\r\n",
                                   std::string("\x02\x00\xFF\xFF\xFF\xF0", 6) + std::string(64, '\x41'),
                                   std::string("\x02\x00\x00\x00\x00\x04", 6) + "\x01\x02\x03\x04",
                                   std::string("\x04\x00\x00\x00\x00\x08", 6) + std::string(8, '\xFF'),
                                   std::string(4096, '\xFF'),
                                   std::string(4096, '\0'),
                                   ""};
    for (const std::string& reply : replies) {
        Peer rubbish([&reply](int connection) {
            (void)!::send(connection, reply.data(), reply.size(), MSG_NOSIGNAL);
            ::shutdown(connection, SHUT_WR);
        });
        PacsServer server = server_at(rubbish.port());
        server.timeout_s = 2;
        expect_error(Errc::io, {"127.0.0.1"}, [&] { pacs_echo(server); });
    }
}

TEST(Pacs, APlainServerIsNoSecureOne) {
    SmallServer peer;
    peer.start();
    PacsServer server = server_at(peer.port());
    server.timeout_s = 2;
    server.tls.on = true;
    expect_error(Errc::bad_usage, {"certificates to trust"}, [&] { pacs_echo(server); });
    TemporaryFolder folder;
    put_file(folder / "ca.pem", "no certificate");
    server.tls.trusted = folder / "ca.pem";
    expect_error(Errc::bad_usage, {"ca.pem"}, [&] { pacs_echo(server); });
}

namespace {

/// Debian's Orthanc on the loopback with a folder of its own; stopped at the end of the scope.
class Orthanc {
public:
    explicit Orthanc(const std::filesystem::path& folder, const std::string& tls = "") : port_(free_port()) {
        const int http = free_port();
        put_file(folder / "orthanc.json",
                 "{\"Name\":\"test\",\"StorageDirectory\":\"" + (folder / "db").string() + "\",\"IndexDirectory\":\"" +
                     (folder / "db").string() + "\",\"DicomAet\":\"ORTHANC\",\"DicomPort\":" + std::to_string(port_) +
                     ",\"HttpPort\":" + std::to_string(http) +
                     ",\"HttpServerEnabled\":false,\"RemoteAccessAllowed\":false,\"DicomAlwaysAllowEcho\":true,"
                     "\"DicomAlwaysAllowStore\":true,\"DicomAlwaysAllowFind\":true,\"DicomAlwaysAllowGet\":true,"
                     "\"DicomCheckCalledAet\":true,\"Plugins\":[]" +
                     tls + "}");
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
        ::kill(process_, SIGTERM);
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

bool orthanc_is_there() { return std::system("command -v Orthanc >/dev/null 2>&1 || test -x /usr/sbin/Orthanc") == 0; }

}  // namespace

TEST(PacsOrthanc, WhatIsSentIsFoundAndComesBackTheSame) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    Orthanc orthanc(folder.path());
    const PacsServer server = server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    std::filesystem::create_directory(folder / "in");
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < 6; ++i) {
        ZooSlice slice;
        slice.instance = i + 1;
        slice.position = {0, 0, double(i)};
        slice.syntax = i % 2 ? ZooSyntax::jpeg_lossless : ZooSyntax::explicit_le;  // both codings must come back
        slice.stored = [i](int x, int y) { return 100 * i + 10 * y + x; };
        slice.extra = {{{0x0010, 0x0010}, "Roundtrip^Test"},
                       {{0x0010, 0x0020}, "R1"},
                       {{0x0020, 0x000D}, "1.2.826.0.1.3680043.2.1143.99"}};
        files.push_back(folder / ("in/" + std::to_string(i) + ".dcm"));
        write_zoo_slice(files.back(), slice);
    }
    EXPECT_EQ(send_to_pacs(server, files).done, 6);

    PacsQuery query;
    query.patient_name = "Roundtrip*";
    const auto studies = find_pacs_studies(server, query);
    ASSERT_EQ(studies.rows.size(), 1u);
    EXPECT_EQ(studies.rows[0].patient_id, "R1");
    query.patient_name = "Nobody";
    EXPECT_TRUE(find_pacs_studies(server, query).rows.empty());
    const auto series = find_pacs_series(server, studies.rows[0].uid);
    ASSERT_EQ(series.rows.size(), 1u);
    EXPECT_EQ(series.rows[0].modality, "CT");

    double last = 0;
    const JobContext job{{}, [&](double share) { last = share; }};
    const PacsTransfer got = retrieve_from_pacs(server, studies.rows[0].uid, series.rows[0].uid, folder / "out", job);
    EXPECT_EQ(got.done, 6);
    EXPECT_EQ(got.failed, 0);
    EXPECT_GT(last, 0.5);
    const Volume before = open_volume((folder / "in").string()), after = open_volume((folder / "out").string());
    expect_same_voxels(before, after);
    expect_same_geometry(before.geometry(), after.geometry(), 1e-9);

    PacsServer wrong = server;
    wrong.called_aet = "NOT_IT";
    expect_error(Errc::io, {"refuses the association", "NOT_IT"}, [&] { pacs_echo(wrong); });
    expect_error(Errc::io, {}, [&] { retrieve_from_pacs(server, "1.2.3.4.5", "", folder / "none"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(PacsOrthanc, SpeaksTls) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    const std::string base = folder.path().string();
    const std::string make = "cd " + base +
                             " && openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out cert.pem -days 2 "
                             "-subj /CN=localhost >/dev/null 2>&1 && openssl req -x509 -newkey rsa:2048 -nodes "
                             "-keyout other_key.pem -out other.pem -days 2 -subj /CN=other >/dev/null 2>&1";
    if (std::system(make.c_str()) != 0) GTEST_SKIP() << "skipped: the openssl program is not installed";
    Orthanc orthanc(folder.path(), ",\"DicomTlsEnabled\":true,\"DicomTlsCertificate\":\"" + base +
                                       "/cert.pem\",\"DicomTlsPrivateKey\":\"" + base +
                                       "/key.pem\",\"DicomTlsTrustedCertificates\":\"" + base + "/cert.pem\"");
    PacsServer server = server_at(orthanc.port(), "ORTHANC");
    server.tls = {true, folder / "cert.pem", folder / "cert.pem", folder / "key.pem"};
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    EXPECT_TRUE(find_pacs_studies(server, {}).rows.empty());
    SmallServer plain;
    plain.start();
    PacsServer in_the_clear = server;
    in_the_clear.port = plain.port();
    in_the_clear.called_aet = "PEER";
    in_the_clear.timeout_s = 2;
    expect_error(Errc::io, {"127.0.0.1"}, [&] { pacs_echo(in_the_clear); });
    // Not by a certificate nobody signed, nor without one, nor in the clear.
    server.tls.trusted = folder / "other.pem";
    expect_error(Errc::io, {"secure connection"}, [&] { pacs_echo(server); });
    server.tls.trusted = folder / "cert.pem";
    server.tls.key = folder / "other_key.pem";
    expect_error(Errc::bad_usage, {"other_key.pem"}, [&] { pacs_echo(server); });
    server.tls = {};
    expect_error(Errc::io, {"127.0.0.1"}, [&] { pacs_echo(server); });
}
