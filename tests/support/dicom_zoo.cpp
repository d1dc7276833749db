#include "tests/support/dicom_zoo.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <dcmtk/oflog/oflog.h>
#include <unistd.h>

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

namespace lacuna::test {

namespace {

void check(const OFCondition& result, const char* what) {
    if (result.bad()) throw std::runtime_error(std::string(what) + ": " + result.text());
}

void prepare_encoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs();
        DJLSEncoderRegistration::registerCodecs();
    });
}

E_TransferSyntax syntax_of(ZooSyntax syntax) {
    switch (syntax) {
        case ZooSyntax::implicit_le:
            return EXS_LittleEndianImplicit;
        case ZooSyntax::explicit_le:
            return EXS_LittleEndianExplicit;
        case ZooSyntax::explicit_be:
            return EXS_BigEndianExplicit;
        case ZooSyntax::deflated:
            return EXS_DeflatedLittleEndianExplicit;
        case ZooSyntax::rle:
            return EXS_RLELossless;
        case ZooSyntax::jpeg_lossless:
            return EXS_JPEGProcess14SV1;
        case ZooSyntax::jpeg_ls:
            return EXS_JPEGLSLossless;
    }
    return EXS_LittleEndianExplicit;
}

std::string triple(const glm::dvec3& v) { return fmt::format("{:.10g}\\{:.10g}\\{:.10g}", v.x, v.y, v.z); }

void put(DcmItem& item, const DcmTag& tag, const std::string& value) {
    check(item.putAndInsertString(tag, value.c_str()), "put text");
}

void put_word(DcmItem& item, const DcmTag& tag, int value) {
    check(item.putAndInsertUint16(tag, Uint16(value)), "put word");
}

/// US or SS, as the pixels are.
void put_pixel_value(DcmItem& item, const DcmTagKey& key, int value, bool is_signed) {
    if (is_signed)
        check(item.putAndInsertSint16(DcmTag(key, EVR_SS), Sint16(value)), "put pixel value");
    else
        check(item.putAndInsertUint16(DcmTag(key, EVR_US), Uint16(value)), "put pixel value");
}

void put_modality_lut(DcmDataset& data, const ZooSlice& s) {
    if (s.modality_lut.empty()) return;
    DcmItem* item = nullptr;
    check(data.findOrCreateSequenceItem(DCM_ModalityLUTSequence, item), "put table");
    const std::size_t claims = s.modality_lut_claims < 0 ? s.modality_lut.size() : std::size_t(s.modality_lut_claims);
    const Uint16 described[] = {Uint16(claims), Uint16(s.modality_lut_first), 16};
    const std::vector<Uint16> words(s.modality_lut.begin(), s.modality_lut.end());
    check(item->putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), described, 3), "put descriptor");
    check(item->putAndInsertUint16Array(DcmTag(DCM_LUTData, EVR_US), words.data(), words.size()), "put table");
    put(*item, DCM_ModalityLUTType, "OD");
}

void put_voi_tables(DcmDataset& data, const ZooSlice& s) {
    for (std::size_t i = 0; i < s.voi_tables.size(); ++i) {
        const ZooTable& table = s.voi_tables[i];
        DcmItem* item = nullptr;
        check(data.findOrCreateSequenceItem(DCM_VOILUTSequence, item, long(i)), "put table");
        if (table.first_as_ss) {
            const Sint16 described[] = {Sint16(table.entries.size()), Sint16(table.first), Sint16(table.bits)};
            check(item->putAndInsertSint16Array(DcmTag(DCM_LUTDescriptor, EVR_SS), described, 3), "put descriptor");
        } else {
            const Uint16 described[] = {Uint16(table.entries.size()), Uint16(table.first), Uint16(table.bits)};
            check(item->putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), described, 3), "put descriptor");
        }
        std::vector<Uint16> words(table.entries.begin(), table.entries.end());
        if (table.packed) {
            words.assign((table.entries.size() + 1) / 2, 0);
            for (std::size_t k = 0; k < table.entries.size(); ++k)
                words[k / 2] = Uint16(words[k / 2] | table.entries[k] << (k % 2 * 8));
        }
        check(item->putAndInsertUint16Array(DcmTag(DCM_LUTData, EVR_OW), words.data(), words.size()), "put table");
        if (!table.explanation.empty()) put(*item, DCM_LUTExplanation, table.explanation);
    }
}

void put_header(DcmDataset& data, const ZooSlice& s) {
    static std::atomic<int> serial{0};
    put(data, DCM_SOPClassUID, UID_CTImageStorage);
    put(data, DCM_SOPInstanceUID, "1.2.826.0.1.3680043.2.1143.9." + std::to_string(++serial));
    put(data, DCM_ImageType, s.image_type);
    put(data, DCM_Modality, s.modality);
    put(data, DCM_SeriesDescription, s.description);
    put(data, DCM_PatientName, "Zoo^Animal");
    put(data, DCM_PatientID, "zoo-id");
    put(data, DCM_SeriesInstanceUID, s.series_uid);
    put(data, DCM_SeriesNumber, std::to_string(s.series_number));
    put(data, DCM_InstanceNumber, std::to_string(s.instance));
    if (s.acquisition) put(data, DCM_AcquisitionNumber, std::to_string(*s.acquisition));
    put_word(data, DCM_SamplesPerPixel, 1);
    put(data, DCM_PhotometricInterpretation, s.photometric);
    put_word(data, DCM_Rows, s.size.y);
    put_word(data, DCM_Columns, s.size.x);
    put_word(data, DCM_BitsAllocated, s.bits_allocated);
    put_word(data, DCM_BitsStored, s.bits_stored);
    put_word(data, DCM_HighBit, s.high_bit < 0 ? s.bits_stored - 1 : s.high_bit);
    put_word(data, DCM_PixelRepresentation, s.is_signed);
    if (s.padding) put_pixel_value(data, DCM_PixelPaddingValue, *s.padding, s.is_signed);
    if (s.padding_limit) put_pixel_value(data, DCM_PixelPaddingRangeLimit, *s.padding_limit, s.is_signed);
    put_modality_lut(data, s);
    put_voi_tables(data, s);
    for (const auto& [tag, value] : s.extra) put(data, DcmTag(Uint16(tag.first), Uint16(tag.second)), value);
}

void put_rescale(DcmItem& item, const ZooSlice& s) {
    if (s.slope.empty()) return;
    put(item, DCM_RescaleSlope, s.slope);
    put(item, DCM_RescaleIntercept, s.intercept);
    if (!s.rescale_type.empty()) put(item, DCM_RescaleType, s.rescale_type);
}

template <class Stored>
void put_pixels(DcmDataset& data, const ZooSlice& s, int frames, const Stored& stored) {
    const std::size_t count = std::size_t(s.size.x) * std::size_t(s.size.y) * std::size_t(frames);
    std::vector<Uint16> words;
    std::vector<Uint8> bytes;
    for (int f = 0; f < frames; ++f)
        for (int y = 0; y < s.size.y; ++y)
            for (int x = 0; x < s.size.x; ++x)
                s.bits_allocated == 8 ? bytes.push_back(Uint8(stored(f, x, y)))
                                      : words.push_back(Uint16(stored(f, x, y)));
    if (s.bits_allocated == 8) {
        if (bytes.size() % 2) bytes.push_back(0);
        check(data.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()), "put bytes");
    } else {
        check(data.putAndInsertUint16Array(DCM_PixelData, words.data(), count), "put words");
    }
}

void save(DcmFileFormat& format, const std::filesystem::path& file, const ZooSlice& s) {
    prepare_encoders();
    const E_TransferSyntax syntax = syntax_of(s.syntax);
    DJ_RPLossless lossless;
    DJLSRepresentationParameter lossless_ls(0, OFTrue);
    const DcmRepresentationParameter* parameter = s.syntax == ZooSyntax::jpeg_lossless ? &lossless
                                                  : s.syntax == ZooSyntax::jpeg_ls
                                                      ? static_cast<const DcmRepresentationParameter*>(&lossless_ls)
                                                      : nullptr;
    if (DcmXfer(syntax).isEncapsulated()) check(format.getDataset()->chooseRepresentation(syntax, parameter), "encode");
    const E_FileWriteMode mode = s.with_meta ? EWM_fileformat : EWM_dataset;
    check(format.saveFile(file.c_str(), syntax, EET_UndefinedLength, EGL_recalcGL, EPD_noChange, 0, 0, mode), "save");
}

}  // namespace

void write_zoo_slice(const std::filesystem::path& file, const ZooSlice& s) {
    DcmFileFormat format;
    DcmDataset& data = *format.getDataset();
    put_header(data, s);
    put(data, DCM_ImagePositionPatient, triple(s.position));
    put(data, DCM_ImageOrientationPatient, triple(s.row) + "\\" + triple(s.column));
    if (!s.pixel_spacing.empty()) put(data, DCM_PixelSpacing, s.pixel_spacing);
    if (!s.thickness.empty()) put(data, DCM_SliceThickness, s.thickness);
    put_rescale(data, s);
    put_pixels(data, s, 1, [&](int, int x, int y) { return s.stored(x, y); });
    save(format, file, s);
}

void write_zoo_enhanced(const std::filesystem::path& file, const ZooSlice& s, const std::vector<glm::dvec3>& positions,
                        const std::function<int(int frame, int x, int y)>& stored) {
    DcmFileFormat format;
    DcmDataset& data = *format.getDataset();
    put_header(data, s);
    put(data, DCM_SOPClassUID, UID_EnhancedCTImageStorage);
    put(data, DCM_NumberOfFrames, std::to_string(positions.size()));
    DcmItem* at = nullptr;
    const auto group = [&](const DcmTag& sequence, const DcmTag& part, long index) -> DcmItem& {
        DcmItem* item = nullptr;
        check(data.findOrCreateSequenceItem(sequence, item, index), "functional group");
        check(item->findOrCreateSequenceItem(part, at, 0), "functional group part");
        return *at;
    };
    const DcmTag shared(DCM_SharedFunctionalGroupsSequence), each(DCM_PerFrameFunctionalGroupsSequence);
    put(group(shared, DCM_PlaneOrientationSequence, 0), DCM_ImageOrientationPatient,
        triple(s.row) + "\\" + triple(s.column));
    DcmItem& measures = group(shared, DCM_PixelMeasuresSequence, 0);
    put(measures, DCM_PixelSpacing, s.pixel_spacing);
    put(measures, DCM_SliceThickness, s.thickness);
    put_rescale(group(shared, DCM_PixelValueTransformationSequence, 0), s);
    for (std::size_t f = 0; f < positions.size(); ++f)
        put(group(each, DCM_PlanePositionSequence, long(f)), DCM_ImagePositionPatient, triple(positions[f]));
    put_pixels(data, s, int(positions.size()), stored);
    save(format, file, s);
}

void cut_file(const std::filesystem::path& file, std::uintmax_t bytes) {
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - bytes);
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lacuna-zoo-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace lacuna::test
