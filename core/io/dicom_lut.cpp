#include "core/io/dicom_lut.h"

#include <algorithm>

#include "core/io/dicom_tags.h"

namespace lacuna::dicom {

namespace {

constexpr unsigned long k_most_tables = 16;

/// The item that holds a frame's rescale: its own group, else that of all frames, else the data set.
DcmItem& rescale_item(DcmItem& data, int frame) {
    const auto in_groups = [](DcmItem* groups) {
        return groups ? item_of(*groups, DCM_PixelValueTransformationSequence) : nullptr;
    };
    if (frame > 0)
        if (DcmItem* own = in_groups(item_of(data, DCM_PerFrameFunctionalGroupsSequence, (unsigned long)(frame - 1))))
            return *own;
    DcmItem* shared = in_groups(item_of(data, DCM_SharedFunctionalGroupsSequence));
    return shared ? *shared : data;
}

/// Whether the values that a VOI LUT maps may be negative.
bool may_be_negative(DcmItem& data, int frame) {
    if (item_of(data, DCM_ModalityLUTSequence)) return false;  // its entries are unsigned
    const bool is_signed = integer_of(data, DCM_PixelRepresentation).value_or(0) == 1;
    DcmItem& rescale = rescale_item(data, frame);
    const auto slope = number_of(rescale, DCM_RescaleSlope), intercept = number_of(rescale, DCM_RescaleIntercept);
    if (!slope && !intercept) return is_signed;
    const int bits = std::clamp(integer_of(data, DCM_BitsStored).value_or(16), 1, 32);
    const double count = double(std::int64_t(1) << bits), least = is_signed ? -count / 2 : 0;
    const auto real = [&](double stored) { return stored * slope.value_or(1) + intercept.value_or(0); };
    return std::min(real(least), real(least + count - 1)) < 0;
}

}  // namespace

LutItem read_lut(DcmItem& item, bool is_signed) {
    const auto described = numbers_of(item, DCM_LUTDescriptor);
    if (described.size() != 3) throw std::runtime_error(tag_text(DCM_LUTDescriptor) + " has not three values");
    const std::size_t entries = described[0] == 0 ? 65536 : std::size_t(Uint16(std::int64_t(described[0])));
    LutItem lut;
    // Files name a negative first value as US, too; where it reads as negative, it was written as SS.
    lut.first = is_signed ? std::int64_t(Sint16(std::int64_t(described[1]))) : std::int64_t(described[1]);
    lut.bits = int(described[2]);
    const Uint16* words = nullptr;
    unsigned long count = 0;
    if (item.findAndGetUint16Array(DCM_LUTData, words, &count).bad() || !words)
        throw std::runtime_error(tag_text(DCM_LUTData) + " is missing");
    if (count >= entries) {
        lut.entries.assign(words, words + entries);
    } else if (lut.bits == 8 && count * 2 >= entries) {  // two entries a word
        for (std::size_t i = 0; i < entries; ++i) lut.entries.push_back(words[i / 2] >> (i % 2 * 8) & 0xFF);
    } else {
        throw std::runtime_error(tag_text(DCM_LUTData) + " holds " + std::to_string(count) + " of " +
                                 std::to_string(entries) + " values");
    }
    return lut;
}

std::vector<VoiTable> voi_tables(DcmItem& data, int frame) {
    std::vector<VoiTable> tables;
    for (unsigned long i = 0; i < k_most_tables; ++i) {
        DcmItem* item = item_of(data, DCM_VOILUTSequence, i);
        if (!item) break;
        try {
            LutItem lut = read_lut(*item, may_be_negative(data, frame));
            if (lut.bits < 8 || lut.bits > 16) continue;
            tables.push_back({text_of(*item, DCM_LUTExplanation), double(lut.first), std::move(lut.entries), lut.bits});
        } catch (const std::exception&) {
            continue;  // it is only one way to show the image
        }
    }
    return tables;
}

}  // namespace lacuna::dicom
