#include "core/io/dicom_header.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "core/io/dicom_lut.h"
#include "core/io/dicom_tags.h"
#include "core/io/dicom_text.h"
#include "core/io/random_access_file.h"

namespace lacuna::dicom {

namespace {

constexpr Uint16 k_pixel_group = 0x7FE0;
constexpr std::uint32_t k_undefined_length = 0xFFFFFFFF;
constexpr std::size_t k_first_read = 16 << 10, k_largest_header = 256 << 20;

struct ParsedHeader {
    std::unique_ptr<DcmFileFormat> format;
    std::uint64_t stopped_at = 0;  ///< offset of the first element of the pixel group, or of the end
    bool good = false;
};

/// Parses the file's elements up to the pixel group from memory, reading more of the file only where the header is
/// longer: most headers are a few KiB, the pixels behind them half a MiB.
ParsedHeader parse_until_pixels(const RandomAccessFile& file) {
    std::vector<std::byte> bytes;
    for (std::size_t wanted = k_first_read;; wanted *= 16) {
        const std::size_t held = bytes.size(), total = std::size_t(std::min<std::uint64_t>(wanted, file.bytes()));
        bytes.resize(total);
        bytes.resize(held + file.read(held, std::span(bytes).subspan(held)));

        ParsedHeader header{std::make_unique<DcmFileFormat>(), 0, false};
        DcmInputBufferStream stream;
        stream.setBuffer(bytes.data(), offile_off_t(bytes.size()));
        const bool whole = bytes.size() >= file.bytes() || bytes.size() < total;
        if (whole) stream.setEos();
        header.format->transferInit();
        const OFCondition result = header.format->readUntilTag(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                                               DcmTagKey(k_pixel_group, 0));
        header.format->transferEnd();
        header.stopped_at = std::uint64_t(stream.tell());
        header.good = result.good();
        if (header.good || whole || wanted >= k_largest_header) return header;
    }
}

std::uint32_t number_at(const std::byte* at, int bytes, bool big_endian) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint32_t(at[big_endian ? bytes - 1 - i : i]) << (8 * i);
    return value;
}

/// One element of the pixel group: its number, where its value starts, how long that is.
struct ElementHead {
    std::uint32_t element = 0, length = 0, bytes = 0;
    bool words = true;  ///< its VR is OW, as it is without a VR
};

/// The head of the pixel group's element at `offset`; none if something else is there.
std::optional<ElementHead> element_head(const RandomAccessFile& file, std::uint64_t offset, const DcmXfer& syntax) {
    const bool big = syntax.getByteOrder() == EBO_BigEndian;
    std::array<std::byte, 12> head{};
    const std::size_t got = file.read(offset, head);
    if (got < 8 || number_at(head.data(), 2, big) != k_pixel_group) return std::nullopt;
    ElementHead found{number_at(head.data() + 2, 2, big), 0, 8};
    const std::string vr = {char(head[4]), char(head[5])};
    if (!syntax.isExplicitVR()) {
        found.length = number_at(head.data() + 4, 4, big);
    } else if (vr[0] == 'O' || vr == "UN" || vr == "SQ" || vr == "UT") {
        if (got < 12) return std::nullopt;
        found.length = number_at(head.data() + 8, 4, big);
        found.bytes = 12;
        found.words = vr == "OW";
    } else {
        found.length = number_at(head.data() + 6, 2, big);
    }
    return found;
}

/// Walks the elements of the pixel group to the pixels themselves; `stopped_at` is where DCMTK stopped, which is just
/// behind the head of the group's first element. False: there are no pixels.
bool locate_pixels(const RandomAccessFile& bytes, std::uint64_t stopped_at, const DcmXfer& syntax, File& file) {
    std::optional<ElementHead> head;
    for (const std::uint64_t back : {12u, 8u}) {
        if (stopped_at < back) continue;
        head = element_head(bytes, stopped_at - back, syntax);
        if (head && head->bytes == back) break;
        head.reset();
    }
    std::uint64_t value_at = stopped_at;
    for (int guard = 0; head && guard < 16; ++guard) {
        if (head->element == 0x0008 || head->element == 0x0009 || head->element == 0x0010) {
            file.pixels.kind = head->element == 0x0010   ? PixelKind::integer
                               : head->element == 0x0008 ? PixelKind::float32
                                                         : PixelKind::float64;
            file.pixel_offset = value_at;
            file.pixel_bytes = head->length;
            file.direct = !syntax.isEncapsulated() && head->length != k_undefined_length;
            file.big_endian = syntax.getByteOrder() == EBO_BigEndian;
            file.words = head->words;
            return true;
        }
        const std::uint64_t next = value_at + head->length;
        head = element_head(bytes, next, syntax);
        if (head) value_at = next + head->bytes;
    }
    return false;
}

/// Finds the pixels or what stands in for them; false when the data set has none.
bool find_pixels(const RandomAccessFile& bytes, const ParsedHeader& header, File& file) {
    const E_TransferSyntax syntax = header.format->getDataset()->getOriginalXfer();
    const DcmXfer xfer(syntax);
    file.syntax_uid = xfer.getXferID() ? xfer.getXferID() : "";
    file.syntax_name = xfer.getXferName() ? xfer.getXferName() : "unknown";
    file.file_bytes = bytes.bytes();
    if (syntax == EXS_DeflatedLittleEndianExplicit) {
        // The offset counts compressed bytes; what the pixels are comes out when they are inflated.
        file.pixels.kind = PixelKind::integer;
        return header.stopped_at > 0;
    }
    return locate_pixels(bytes, header.stopped_at, xfer, file);
}

void check_pixel_extent(File& file, int frames) {
    // Beyond any file's length: the product below would leave 64 bits and seem small.
    if (double(file.pixels.pixels()) * file.pixels.bits_allocated * frames > 8e18)
        throw std::runtime_error("it claims more pixels than any file could hold");
    const auto needed = std::uint64_t((file.pixels.pixels() * file.pixels.bits_allocated * frames + 7) / 8);
    if (!file.direct) {
        if (std::uint64_t(frames) * 8 > file.file_bytes)
            throw std::runtime_error("it claims more frames than its bytes could hold");
        return;
    }
    const std::uint64_t present =
        std::min(file.pixel_bytes, file.file_bytes - std::min(file.file_bytes, file.pixel_offset));
    if (present < needed)
        throw std::runtime_error("it is cut short: " + std::to_string(present) + " of " + std::to_string(needed) +
                                 " bytes of pixels are there");
}

void fill_pixel_format(DcmItem& data, PixelFormat& pixels) {
    const auto need = [&](const DcmTagKey& tag, int lowest, int highest) {
        const auto value = integer_of(data, tag);
        if (!value) throw std::runtime_error(tag_text(tag) + " is missing");
        if (*value < lowest || *value > highest)
            throw std::runtime_error(tag_text(tag) + " is " + std::to_string(*value) + ", which cannot be");
        return *value;
    };
    pixels.rows = need(DCM_Rows, 1, 65535);
    pixels.columns = need(DCM_Columns, 1, 65535);
    pixels.samples = integer_of(data, DCM_SamplesPerPixel).value_or(1);
    pixels.photometric = text_of(data, DCM_PhotometricInterpretation);
    pixels.bits_allocated = need(DCM_BitsAllocated, 1, 64);
    pixels.bits_stored = integer_of(data, DCM_BitsStored).value_or(pixels.bits_allocated);
    pixels.high_bit = integer_of(data, DCM_HighBit).value_or(pixels.bits_stored - 1);
    pixels.is_signed = integer_of(data, DCM_PixelRepresentation).value_or(0) == 1;
    const int bits = pixels.bits_allocated;
    if (pixels.kind != PixelKind::integer) {
        const int width = pixels.kind == PixelKind::float32 ? 32 : 64;
        if (bits != width)
            throw std::runtime_error(tag_text(DCM_BitsAllocated) + " is " + std::to_string(bits) +
                                     ", but its pixels are floating-point numbers of " + std::to_string(width));
        return;
    }
    if (bits != 1 && bits != 8 && bits != 16 && bits != 32)
        throw std::runtime_error(tag_text(DCM_BitsAllocated) + " is " + std::to_string(bits) +
                                 "; 1, 8, 16 and 32 can be read");
    if (pixels.bits_stored < 1 || pixels.bits_stored > bits)
        throw std::runtime_error(tag_text(DCM_BitsStored) + " does not fit " + tag_text(DCM_BitsAllocated));
    if (pixels.high_bit >= bits || pixels.high_bit < pixels.bits_stored - 1)
        throw std::runtime_error(tag_text(DCM_HighBit) + " does not fit " + tag_text(DCM_BitsStored));
}

/// US or SS, whatever the file says it is: the value as a pixel of this format.
std::optional<std::int64_t> pixel_value_of(DcmItem& data, const DcmTagKey& tag, const PixelFormat& pixels) {
    Uint16 word = 0;
    Sint16 signed_word = 0;
    if (data.findAndGetUint16(tag, word).bad()) {
        if (data.findAndGetSint16(tag, signed_word).bad()) return std::nullopt;
        word = Uint16(signed_word);
    }
    return pixels.is_signed ? std::int64_t(Sint16(word)) : std::int64_t(word);
}

/// The Modality LUT of a data set; null when it has none. @throws std::runtime_error for one that cannot be
std::shared_ptr<const ModalityLut> modality_lut(DcmItem& data, const PixelFormat& pixels) {
    DcmItem* item = item_of(data, DCM_ModalityLUTSequence);
    if (!item || pixels.kind != PixelKind::integer) return nullptr;
    LutItem read = read_lut(*item, pixels.is_signed);
    return std::make_shared<ModalityLut>(ModalityLut{read.first, std::move(read.entries)});
}

void fill_component(DcmItem& data, File& file) {
    bool is_part = false;
    Utf8Texts text(data);
    for (DcmObject* at = data.nextInContainer(nullptr); at; at = data.nextInContainer(at)) {
        if (at->getGTag() < 0x0014) continue;
        if (at->getGTag() > 0x0014) break;
        is_part = true;
        OFString value;
        DcmElement* element = dynamic_cast<DcmElement*>(at);
        DcmTag tag = at->getTag();
        if (element && element->isaString() && element->getOFStringArray(value).good() && !value.empty() &&
            value.size() <= 256)
            file.component.emplace_back(tag.getTagName(), text.readable(value.c_str()));
    }
    if (!is_part) return;
    // ASTM E2339 (DICONDE): the patient module holds the component's name and id.
    file.component.insert(file.component.begin(), {"id", text(DCM_PatientID)});
    file.component.insert(file.component.begin(), {"name", text(DCM_PatientName, "\\^=")});
}

}  // namespace

void prepare_dcmtk() {
    static std::once_flag once;
    std::call_once(once, [] {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        dcmEnableUnknownVRConversion.set(OFTrue);  // known elements written as UN are read as what they are
        DcmRLEDecoderRegistration::registerCodecs();
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
        (void)dcmDataDict.rdlock().isDictionaryLoaded();
        dcmDataDict.rdunlock();
    });
}

bool starts_like_dicom(std::string_view bytes) {
    if (bytes.size() >= 132 && bytes.substr(128, 4) == "DICM") return true;
    if (bytes.size() < 16) return false;
    const auto byte = [&](int i) { return unsigned(static_cast<unsigned char>(bytes[std::size_t(i)])); };
    const bool little = (byte(0) == 0x02 || byte(0) == 0x08) && byte(1) == 0;
    const bool big = byte(0) == 0 && byte(1) == 0x08;
    if (!little && !big) return false;
    const unsigned element = little ? byte(2) | byte(3) << 8 : byte(2) << 8 | byte(3);
    if (element > 0x0100) return false;
    static constexpr std::string_view k_vrs = "AE AS CS DA DT IS LO LT OB PN SH SQ ST TM UI UL UN US UT";
    const std::string_view vr = bytes.substr(4, 2);
    if (vr.find(' ') == std::string_view::npos && k_vrs.find(vr) != std::string_view::npos) return true;
    // Implicit VR: a length, small for the first elements of group 0008.
    return little && byte(5) == 0 && byte(6) == 0 && byte(7) == 0;
}

void fill_file(DcmItem& data, File& file) {
    file.series_uid = text_of(data, DCM_SeriesInstanceUID);
    file.study_uid = text_of(data, DCM_StudyInstanceUID);
    file.frame_of_reference_uid = text_of(data, DCM_FrameOfReferenceUID);
    file.sop_class_uid = text_of(data, DCM_SOPClassUID);
    file.sop_instance_uid = text_of(data, DCM_SOPInstanceUID);
    Utf8Texts text(data);
    file.modality = text(DCM_Modality);
    file.description = text(DCM_SeriesDescription);
    if (file.description.empty()) file.description = text(DCM_StudyDescription);
    file.series_number = readable_integer_of(data, DCM_SeriesNumber).value_or(0);
    fill_pixel_format(data, file.pixels);
    fill_component(data, file);
    if (file.pixels.samples != 1 || !file.pixels.photometric.starts_with("MONOCHROME")) {
        if (file.pixels.samples != 1 || !file.pixels.photometric.empty()) {
            file.unsupported = true;
            throw std::runtime_error("it is a colour image (" + file.pixels.photometric +
                                     "); only grey values make a volume");
        }
    }
    if (const auto padding = pixel_value_of(data, DCM_PixelPaddingValue, file.pixels)) {
        const std::int64_t limit = pixel_value_of(data, DCM_PixelPaddingRangeLimit, file.pixels).value_or(*padding);
        file.padding = Padding{std::min(*padding, limit), std::max(*padding, limit)};
    }
    if (file.pixels.kind != PixelKind::integer) {
        file.padding.reset();
        file.float_padding = number_of(data, file.pixels.kind == PixelKind::float32 ? DCM_FloatPixelPaddingValue
                                                                                    : DCM_DoubleFloatPixelPaddingValue);
    }
    file.lut = modality_lut(data, file.pixels);
    const int frames = integer_of(data, DCM_NumberOfFrames).value_or(1);
    if (frames < 1) throw std::runtime_error(tag_text(DCM_NumberOfFrames) + " is " + std::to_string(frames));
    check_pixel_extent(file, frames);
    fill_frames(data, file, frames);
    if (!file.lut) return;
    const std::string type = text_of(*item_of(data, DCM_ModalityLUTSequence), DCM_ModalityLUTType);
    for (Frame& frame : file.frames) {
        frame.has_rescale = true;
        frame.rescale_type = type;
    }
}

HeaderResult read_header(const std::filesystem::path& path) {
    prepare_dcmtk();
    HeaderResult result;
    result.file.path = path;
    const RandomAccessFile bytes(path);
    std::array<std::byte, 256> start{};
    const std::size_t got = bytes.read(0, start);
    const std::string_view text(reinterpret_cast<const char*>(start.data()), got);
    if (!starts_like_dicom(text)) return result;
    const bool marked = got >= 132 && text.substr(128, 4) == "DICM";

    const ParsedHeader header = parse_until_pixels(bytes);
    DcmDataset& data = *header.format->getDataset();
    const bool image = data.tagExists(DCM_Rows) || data.tagExists(DCM_Columns);
    if (!header.good) {
        if (!marked && !image) return result;
        result.what = FileClass::unreadable;
        result.file.fault = "its header cannot be parsed; it may be cut short or damaged";
        return result;
    }
    if (!image) {
        result.what = marked || data.tagExists(DCM_SOPClassUID) ? FileClass::no_image : FileClass::not_dicom;
        return result;
    }
    result.what = FileClass::image;
    File& file = result.file;
    try {
        const bool pixels = find_pixels(bytes, header, file);
        if (!pixels) file.pixels.kind = PixelKind::integer;
        fill_file(data, file);
        if (!pixels) throw std::runtime_error("it has no pixels (7FE0,0010)");
    } catch (const std::exception& fault) {
        file.fault = fault.what();
        if (file.frames.empty()) file.frames.resize(1);
    }
    return result;
}

}  // namespace lacuna::dicom
