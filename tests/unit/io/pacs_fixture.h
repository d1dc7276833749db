#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/scp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "../../support/dicom_zoo.h"
#include "../../support/orthanc.h"
#include "core/base/error.h"
#include "core/io/dicom_header.h"
#include "core/io/pacs.h"
#include "volume_fixture.h"

// Peers for tests of what goes over a network: broken ones and a small server in this process.
namespace lacuna::test {

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
        listener_.stop();
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
