// C-MOVE and its receiver; and what is kept of a retrieval that breaks off.
#include <gtest/gtest.h>
#include <poll.h>

#include <set>
#include <thread>

#include "../../support/dicom_zoo.h"
#include "core/io/dicom_capture_writer.h"
#include "core/io/dicom_derived.h"
#include "core/io/dicom_seg_writer.h"
#include "core/io/dicom_source.h"
#include "core/io/dicom_sr_writer.h"
#include "core/io/dicom_tags.h"
#include "core/io/pacs.h"
#include "pacs_fixture.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

constexpr const char* k_wanted = "1.2.826.0.1.3680043.2.1143.55";

/// A connection to an address of the loopback; -1: nobody listens there.
int dial(const char* address, int port) {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(std::uint16_t(port));
    ::inet_pton(AF_INET, address, &to.sin_addr);
    if (::connect(socket, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0) return socket;
    ::close(socket);
    return -1;
}

bool listens(const char* address, int port) {
    const int socket = dial(address, port);
    if (socket >= 0) ::close(socket);
    return socket >= 0;
}

std::size_t files_in(const std::filesystem::path& folder) {
    return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// A server of this process whose C-MOVEs do what a test says, and what a client of it is configured with.
class PacsMove : public testing::Test {
protected:
    void SetUp() override {
        peer.start();
        server = server_at(peer.port());
        server.receiver = {true, "127.0.0.1", free_port()};
        for (int i = 0; i < 3; ++i) {
            ZooSlice slice;
            slice.instance = i + 1;
            slice.position = {0, 0, double(i)};
            slice.extra = {{{0x0020, 0x000D}, i < 2 ? k_wanted : "1.2.3.4.5"}};
            files.push_back(folder / (std::to_string(i) + ".dcm"));
            write_zoo_slice(files.back(), slice);
        }
        // The server as a sender of images to this program.
        sender = server_at(server.receiver.port, "LACUNA");
        sender.calling_aet = "PEER";
        sender.timeout_s = 5;
    }
    PacsTransfer retrieve(const JobContext& job = {}) {
        return retrieve_from_pacs(server, k_wanted, "", folder / "out", job);
    }
    PacsTransfer send(std::size_t from, std::size_t to) const {
        return send_to_pacs(sender, {files.begin() + std::ptrdiff_t(from), files.begin() + std::ptrdiff_t(to)});
    }

    TemporaryFolder folder;
    // What the server's thread may still look at when a test's own frame is gone.
    std::stop_source stop;
    std::atomic<bool> over{false};
    std::vector<std::filesystem::path> files;  ///< two of the study wanted, one of another
    SmallServer peer;
    PacsServer server, sender;
};

}  // namespace

TEST_F(PacsMove, BringsWhatWasAskedForAndClosesItsPort) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        const PacsTransfer sent = send(0, 3);
        EXPECT_EQ(sent.done, 2);  // the third is of a study nobody asked for
        EXPECT_EQ(sent.failed, 1);
        pacs_echo(sender);
        peer.moved = 2;
        return Uint16(STATUS_Success);
    };
    EXPECT_FALSE(listens("127.0.0.1", server.receiver.port));
    const PacsTransfer got = retrieve();
    EXPECT_EQ(peer.move_destination, "LACUNA");
    EXPECT_EQ(got.done, 2);
    EXPECT_EQ(got.fault, "");
    EXPECT_EQ(files_in(folder / "out"), 2u);
    EXPECT_EQ(open_volume((folder / "out").string()).geometry().size.z, 2);
    EXPECT_FALSE(listens("127.0.0.1", server.receiver.port));
}

TEST_F(PacsMove, ListensAtTheConfiguredAddressAlone) {
    server.receiver.address = "127.0.0.2";
    sender.host = "127.0.0.2";
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        EXPECT_TRUE(listens("127.0.0.2", server.receiver.port));
        EXPECT_FALSE(listens("127.0.0.1", server.receiver.port));
        EXPECT_FALSE(listens("127.0.0.3", server.receiver.port));
        EXPECT_EQ(send(0, 2).done, 2);
        return Uint16(STATUS_Success);
    };
    EXPECT_EQ(retrieve().done, 2);
}

TEST_F(PacsMove, TakesNothingFromOtherTitles) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        PacsServer wrong = sender;
        wrong.called_aet = "ELSE";
        expect_error(Errc::io, {"refuses the association"}, [&] { pacs_echo(wrong); });
        wrong = sender;
        wrong.calling_aet = "STRANGER";
        expect_error(Errc::io, {"refuses the association"}, [&] { send_to_pacs(wrong, {files[0]}); });
        return Uint16(STATUS_Success);
    };
    expect_error(Errc::io, {"STRANGER to LACUNA", "from PEER to LACUNA"}, [&] { retrieve(); });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(PacsMove, SaysWhatTheServerHasToKnow) {
    const std::string port = std::to_string(server.receiver.port);
    expect_error(Errc::io, {"destination", "A801", "LACUNA", "127.0.0.1", port.c_str()}, [&] { retrieve(); });
    peer.on_move = [&](const std::string&) { return Uint16(STATUS_Success); };
    expect_error(Errc::io, {"sent nothing"}, [&] { retrieve(); });
    peer.moved = 4;  // to somebody else of this name
    expect_error(Errc::io, {"sent 4 files", "none came", port.c_str()}, [&] { retrieve(); });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    server.receiver.port = 0;
    expect_error(Errc::bad_usage, {"receiver's port"}, [&] { retrieve(); });
    server.receiver = {true, "", 11112};
    expect_error(Errc::bad_usage, {"no address"}, [&] { retrieve(); });
}

TEST_F(PacsMove, APortThatCannotBeOpenedIsNamed) {
    const Listener taken;
    server.receiver.port = taken.port();
    expect_error(Errc::io, {"Cannot receive", "choose another port"}, [&] { retrieve(); });
    server.receiver = {true, "192.0.2.1", free_port()};  // an address for documentation, nobody's own
    expect_error(Errc::io, {"192.0.2.1", "this computer's addresses"}, [&] { retrieve(); });
}

TEST_F(PacsMove, KeepsWhatCameOfAServerThatBreaksOff) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        EXPECT_EQ(send(0, 1).done, 1);
        return std::nullopt;
    };
    const PacsTransfer got = retrieve();
    EXPECT_EQ(got.done, 1);
    EXPECT_NE(got.fault.find("ended the connection"), std::string::npos) << got.fault;
    EXPECT_EQ(files_in(folder / "out"), 1u);
}

TEST_F(PacsMove, KeepsWhatCameOfAServerThatFailsOrFallsSilent) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        EXPECT_EQ(send(0, 2).done, 2);
        return Uint16(0xA702);
    };
    PacsTransfer got = retrieve();
    EXPECT_EQ(got.done, 2);
    EXPECT_NE(got.fault.find("A702"), std::string::npos) << got.fault;
    std::filesystem::remove_all(folder / "out");

    server.timeout_s = 3;
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        EXPECT_EQ(send(0, 2).done, 2);
        while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return std::nullopt;
    };
    got = retrieve();
    over = true;
    EXPECT_EQ(got.done, 2);
    EXPECT_NE(got.fault.find("silent"), std::string::npos) << got.fault;
    EXPECT_EQ(files_in(folder / "out"), 2u);
}

TEST_F(PacsMove, ACancelEndsItAtOnceAndKeepsNothing) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        EXPECT_EQ(send(0, 1).done, 1);
        stop.request_stop();
        while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return std::nullopt;
    };
    expect_error(Errc::cancelled, {}, [&] { retrieve({stop.get_token(), nullptr}); });
    over = true;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    EXPECT_FALSE(listens("127.0.0.1", server.receiver.port));
}

TEST_F(PacsMove, RubbishAndSilenceAtThePortHinderNobody) {
    peer.on_move = [&](const std::string&) -> std::optional<Uint16> {
        std::vector<int> rude;
        for (const std::string& words :
             {std::string(), std::string("GET / HTTP/1.1\r\n\r\n"), std::string(4096, '\xFF'),
              std::string("\x01\x00\xFF\xFF\xFF\xF0", 6) + std::string(64, 'A')}) {
            rude.push_back(dial("127.0.0.1", server.receiver.port));
            (void)!::send(rude.back(), words.data(), words.size(), MSG_NOSIGNAL);
        }
        EXPECT_EQ(send(0, 2).done, 2);  // while they hang on the line
        for (const int socket : rude) ::close(socket);
        return Uint16(STATUS_Success);
    };
    EXPECT_EQ(retrieve().done, 2);
}

namespace {

/// Stands between a client and a server, and after so many bytes of the server does what `then` says to the client.
class Proxy {
public:
    Proxy(int server, std::size_t bytes, std::function<void(int client)> then) : bytes_(bytes), then_(std::move(then)) {
        thread_ = std::thread([this, server] {
            for (int client; (client = listener_.accept()) >= 0;) {
                carry(client, dial("127.0.0.1", server));
                ::close(client);
            }
        });
    }
    ~Proxy() {
        over_ = true;
        listener_.stop();
        thread_.join();
    }
    int port() const { return listener_.port(); }
    std::size_t carried() const { return carried_; }  ///< bytes of the server

private:
    void carry(int client, int server) {
        std::size_t left = bytes_;
        char buffer[4096];
        while (!over_) {
            pollfd ends[] = {{client, POLLIN, 0}, {server, POLLIN, 0}};
            if (::poll(ends, 2, 20) <= 0) continue;
            if (ends[0].revents) {
                const ssize_t got = ::recv(client, buffer, sizeof buffer, 0);
                if (got <= 0) break;
                (void)!::send(server, buffer, std::size_t(got), MSG_NOSIGNAL);
            }
            if (!ends[1].revents) continue;
            const ssize_t got = ::recv(server, buffer, std::min(sizeof buffer, left), 0);
            if (got <= 0) break;
            (void)!::send(client, buffer, std::size_t(got), MSG_NOSIGNAL);
            left -= std::size_t(got);
            carried_ += std::size_t(got);
            if (left > 0) continue;
            then_(client);
            break;
        }
        ::close(server);
    }

    Listener listener_;
    const std::size_t bytes_;
    std::function<void(int)> then_;
    std::atomic<bool> over_{false};
    std::atomic<std::size_t> carried_{0};
    std::thread thread_;
};

std::string modality(int port, const std::string& more = "") {
    return ",\"DicomModalities\":{\"lacuna\":{\"AET\":\"LACUNA\",\"Host\":\"127.0.0.1\",\"Port\":" +
           std::to_string(port) + more + "}}";
}

}  // namespace

TEST(PacsOrthanc, CMoveBringsTheSameAsCGet) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    const int port = free_port();
    Orthanc orthanc(folder.path(), modality(port));
    PacsServer server = server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    EXPECT_EQ(send_to_pacs(server, write_round_trip_series(folder.path())).done, 6);
    const auto series = find_pacs_series(server, k_round_study);
    ASSERT_EQ(series.rows.size(), 1u);
    EXPECT_EQ(retrieve_from_pacs(server, k_round_study, series.rows[0].uid, folder / "got").done, 6);
    server.receiver = {true, "127.0.0.1", port};
    double last = 0;
    const JobContext job{{}, [&](double share) { last = share; }};
    const PacsTransfer moved = retrieve_from_pacs(server, k_round_study, "", folder / "moved", job);
    EXPECT_EQ(moved.done, 6);
    EXPECT_EQ(moved.failed, 0);
    EXPECT_EQ(moved.fault, "");
    EXPECT_GT(last, 0.5);
    EXPECT_EQ(retrieve_from_pacs(server, k_round_study, series.rows[0].uid, folder / "again").done, 6);
    const Volume before = open_volume((folder / "in").string());
    for (const char* way : {"got", "moved", "again"}) {
        const Volume after = open_volume((folder / way).string());
        expect_same_voxels(before, after);
        expect_same_geometry(before.geometry(), after.geometry(), 1e-9);
    }
    // Something nobody has, a title it does not know, a port where it finds nobody.
    expect_error(Errc::io, {}, [&] { retrieve_from_pacs(server, "1.2.3.4.5", "", folder / "none"); });
    PacsServer unknown = server;
    unknown.calling_aet = "NOBODY";
    expect_error(Errc::io, {"NOBODY"}, [&] { retrieve_from_pacs(unknown, k_round_study, "", folder / "none"); });
    PacsServer elsewhere = server;
    elsewhere.receiver.port = free_port();
    expect_error(Errc::io, {"LACUNA", std::to_string(elsewhere.receiver.port)},
                 [&] { retrieve_from_pacs(elsewhere, k_round_study, "", folder / "none"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(PacsOrthanc, SegmentationsReportsAndCapturesAreStoredAndComeBack) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    const int port = free_port();
    Orthanc orthanc(folder.path(), modality(port));
    PacsServer server = server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    write_round_trip_series(folder.path());
    const std::string input = (folder / "in").string();
    const auto source = find_dicom_source(input, {});
    ASSERT_NE(source, nullptr);
    const GridGeometry grid = open_volume(input).geometry();
    const auto voxels = std::size_t(grid.voxel_count());
    const MaskVolume part{grid, std::make_shared<std::vector<std::uint8_t>>(voxels, std::uint8_t(1))};
    const LabelVolume labels{grid, std::make_shared<std::vector<std::uint32_t>>(voxels, 0u)};
    (*labels.labels)[7] = 1;
    const DicomProvenance made{"seed", "Lacuna", "0", "part"};
    const std::string tracking = "2.25.77";
    write_dicom_segmentation(part, labels,
                             {{"Part", "part", "", {}, {0, 0, 0}, grid.size - 1, ""},
                              {"Defect 1", "void", "", {1}, {0, 0, 0}, grid.size - 1, tracking}},
                             *source, made, folder / "seg.dcm");
    write_dicom_report({{"Defect 1", tracking, "void", 2, {{DicomQuantity::volume_mm3, 0.25}}, {}}}, {}, "HU", *source,
                       made, folder / "sr.dcm");
    const std::vector<std::uint8_t> grey(3 * 8 * 8, 90);
    write_dicom_capture({8, 8}, grey, *source, made, folder / "capture.dcm");
    const PacsTransfer sent = send_to_pacs(server, {folder / "seg.dcm", folder / "sr.dcm", folder / "capture.dcm"});
    EXPECT_EQ(sent.done, 3);
    EXPECT_EQ(sent.failed, 0);
    EXPECT_EQ(find_pacs_series(server, k_round_study).rows.size(), 3u);
    for (const bool move : {false, true}) {
        server.receiver = {move, "127.0.0.1", port};
        const auto out = folder / (move ? "moved" : "got");
        EXPECT_EQ(retrieve_from_pacs(server, k_round_study, "", out).done, 3);
        std::set<std::string> kinds;
        for (const auto& file : std::filesystem::directory_iterator(out)) {
            DcmFileFormat format;
            ASSERT_TRUE(format.loadFile(file.path().c_str()).good());
            kinds.insert(dicom::text_of(*format.getDataset(), DCM_SOPClassUID));
        }
        EXPECT_EQ(kinds.size(), 3u) << move;
    }
}

TEST(PacsOrthanc, CMoveComesOverTls) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    if (!make_certificates(folder.path())) GTEST_SKIP() << "skipped: the openssl program is not installed";
    const int port = free_port();
    Orthanc orthanc(folder.path(), orthanc_tls(folder.path()) + modality(port, ",\"UseDicomTls\":true"));
    PacsServer server = server_at(orthanc.port(), "ORTHANC");
    server.tls = {true, folder / "cert.pem", folder / "cert.pem", folder / "key.pem"};
    server.receiver = {true, "127.0.0.1", port};
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    EXPECT_EQ(send_to_pacs(server, write_round_trip_series(folder.path())).done, 6);
    EXPECT_EQ(retrieve_from_pacs(server, k_round_study, "", folder / "moved").done, 6);
    expect_same_voxels(open_volume((folder / "in").string()), open_volume((folder / "moved").string()));
}

TEST(PacsOrthanc, WhatCameBeforeABreakIsKept) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    Orthanc orthanc(folder.path());
    PacsServer server = server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    EXPECT_EQ(send_to_pacs(server, write_round_trip_series(folder.path())).done, 6);
    std::size_t all = 0;
    {
        Proxy counting(orthanc.port(), 1u << 30, [](int) {});
        server.port = counting.port();
        EXPECT_EQ(retrieve_from_pacs(server, k_round_study, "", folder / "whole").done, 6);
        all = counting.carried();
    }
    ASSERT_GT(all, 3000u);
    const std::pair<const char*, std::function<void(int)>> ways[] = {
        {"cut", [](int client) { ::shutdown(client, SHUT_RDWR); }},
        {"rubbish",
         [](int client) {
             const std::string words(4096, '\xEE');
             (void)!::send(client, words.data(), words.size(), MSG_NOSIGNAL);
             std::this_thread::sleep_for(std::chrono::milliseconds(300));
         }},
        {"silent", [](int client) {
             pollfd until_it_leaves{client, POLLRDHUP, 0};
             (void)::poll(&until_it_leaves, 1, 5000);
         }}};
    for (const auto& [name, then] : ways) {
        bool some = false;
        // Wherever it breaks off, there are whole images, or one clear fault and no folder.
        for (const double share : {0.05, 0.75}) {
            const auto bytes = std::size_t(share * double(all));
            Proxy proxy(orthanc.port(), bytes, then);
            server.port = proxy.port();
            server.timeout_s = 1;
            const auto out = folder / (name + std::to_string(bytes));
            try {
                const PacsTransfer got = retrieve_from_pacs(server, k_round_study, "", out);
                EXPECT_GT(got.done, 0);
                EXPECT_LE(got.done, 6);
                EXPECT_NE(got.fault.find("127.0.0.1"), std::string::npos) << name << ": " << got.fault;
                EXPECT_EQ(files_in(out), std::size_t(got.done));
                EXPECT_NO_THROW(open_volume((out / "IM00001.dcm").string()));
                some = true;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), Errc::io) << name;
                EXPECT_FALSE(std::filesystem::exists(out));
            }
        }
        EXPECT_TRUE(some) << name;
    }
}
