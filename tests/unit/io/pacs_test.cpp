#include "core/io/pacs.h"

#include <gtest/gtest.h>

#include <thread>

#include "../../support/dicom_zoo.h"
#include "pacs_fixture.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

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

TEST(PacsOrthanc, WhatIsSentIsFoundAndComesBackTheSame) {
    if (!orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    TemporaryFolder folder;
    Orthanc orthanc(folder.path());
    const PacsServer server = server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server)) << get_file(folder / "log.txt");
    const auto files = write_round_trip_series(folder.path());
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
    if (!make_certificates(folder.path())) GTEST_SKIP() << "skipped: the openssl program is not installed";
    Orthanc orthanc(folder.path(), orthanc_tls(folder.path()));
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
