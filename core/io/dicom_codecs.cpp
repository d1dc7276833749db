#include "core/io/dicom_codecs.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/io/dicom_codestream.h"
#include "core/io/dicom_gdcm.h"

namespace lacuna::dicom {

namespace {

constexpr std::string_view k_jpeg_ls = "1.2.840.10008.1.2.4.8";  // .80 lossless, .81 near-lossless

[[noreturn]] void throw_damaged(const File& file, const char* what) {
    throw Error(Errc::bad_input,
                "Cannot read the pixels of " + file.path.string() + ": " + what + "; copy or export the file again.",
                file.path.string());
}

const std::set<std::string>& syntaxes_of_dcmtk() {
    static const std::set<std::string> all = {
        UID_LittleEndianImplicitTransferSyntax, UID_LittleEndianExplicitTransferSyntax,
        UID_BigEndianExplicitTransferSyntax,    UID_DeflatedExplicitVRLittleEndianTransferSyntax,
        UID_RLELosslessTransferSyntax,          UID_JPEGProcess1TransferSyntax,
        UID_JPEGProcess2_4TransferSyntax,       UID_JPEGProcess14TransferSyntax,
        UID_JPEGProcess14SV1TransferSyntax,     UID_JPEGLSLosslessTransferSyntax,
        UID_JPEGLSLossyTransferSyntax};
    return all;
}

/// The pixel element's bytes, however DCMTK names their width.
std::span<const std::byte> bytes_of(DcmElement& element) {
    Uint16* words = nullptr;
    Uint8* bytes = nullptr;
    const std::size_t length = element.getLength();
    if (element.getUint16Array(words).good() && words) return {reinterpret_cast<const std::byte*>(words), length};
    if (element.getUint8Array(bytes).good() && bytes) return {reinterpret_cast<const std::byte*>(bytes), length};
    return {};
}

/// One compressed or deflated image: decompressed as a whole, so that the data set tells the width that came out.
void decode_whole(DcmDataset& data, const File& file, int count, const FrameSink& sink, const JobContext& job) {
    if (data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad()) {
        // GDCM could, but its CharLS and DCMTK's have functions of one name and different arguments: never both.
        if (file.syntax_uid.starts_with(k_jpeg_ls) && file.pixels.bits_stored < 8)
            throw Error(Errc::unsupported,
                        "Cannot read the pixels of " + file.path.string() + ": JPEG-LS of " +
                            std::to_string(file.pixels.bits_stored) + " bits is not known; export it uncompressed.",
                        file.path.string());
        throw_damaged(file, "they are cut short, damaged, or of a precision their decoder does not know");
    }
    PixelFormat format = file.pixels;
    Uint16 bits = 0;
    if (data.findAndGetUint16(DCM_BitsAllocated, bits).good() && bits != 0) format.bits_allocated = bits;
    if (data.findAndGetUint16(DCM_BitsStored, bits).good() && bits != 0) format.bits_stored = bits;
    if (data.findAndGetUint16(DCM_HighBit, bits).good()) format.high_bit = bits;
    DcmElement* element = nullptr;
    if (data.findAndGetElement(DCM_PixelData, element).bad() || !element) throw_damaged(file, "there are none");
    const auto all = bytes_of(*element);
    const auto each = std::size_t(format.frame_bytes());
    if (format.bits_allocated == 1 || all.size() < each * std::size_t(count)) throw_damaged(file, "they are cut short");
    for (int f = 0; f < count; ++f) {
        job.check();
        sink(f, all.subspan(each * std::size_t(f), each), format);
    }
}

void decode_each(DcmDataset& data, const File& file, int count, const FrameSink& sink, const JobContext& job) {
    DcmElement* element = nullptr;
    if (data.findAndGetElement(DCM_PixelData, element).bad() || !element) throw_damaged(file, "there are none");
    DcmPixelData* pixels = dynamic_cast<DcmPixelData*>(element);
    Uint32 bytes = 0;
    if (!pixels || pixels->getUncompressedFrameSize(&data, bytes).bad() || bytes < file.pixels.frame_bytes())
        throw_damaged(file, "their size is unknown");
    std::vector<std::byte> frame(bytes + bytes % 2);
    Uint32 fragment = 0;
    OFString colour_model;
    DcmFileCache cache;
    for (int f = 0; f < count; ++f) {
        job.check();
        if (pixels
                ->getUncompressedFrame(&data, Uint32(f), fragment, frame.data(), Uint32(frame.size()), colour_model,
                                       &cache)
                .bad())
            throw_damaged(file, ("frame " + std::to_string(f + 1) + " is cut short or damaged").c_str());
        sink(f, std::span<const std::byte>(frame).first(std::size_t(file.pixels.frame_bytes())), file.pixels);
    }
}

}  // namespace

void decode_frames(const File& file, int count, const FrameSink& sink, const JobContext& job) {
    prepare_dcmtk();
    if (file.syntax_uid == UID_JPEG2000LosslessOnlyTransferSyntax || file.syntax_uid == UID_JPEG2000TransferSyntax) {
        check_codestreams(file);
        decode_by_gdcm(file, count, sink, job);
        return;
    }
    if (!syntaxes_of_dcmtk().contains(file.syntax_uid))
        throw Error(Errc::unsupported,
                    file.path.string() + " is compressed in a way that cannot be read (transfer syntax " +
                        file.syntax_name + ", " + file.syntax_uid + "); export it uncompressed.",
                    file.path.string());
    check_codestreams(file);
    DcmFileFormat format;
    if (format.loadFile(file.path.c_str()).bad()) throw_damaged(file, "the file is cut short or damaged");
    DcmDataset& data = *format.getDataset();
    const bool encapsulated = DcmXfer(data.getOriginalXfer()).isEncapsulated();
    if (encapsulated && count > 1)
        decode_each(data, file, count, sink, job);
    else
        decode_whole(data, file, count, sink, job);
}

}  // namespace lacuna::dicom
