#pragma once

#include <cstdint>
#include <vector>

#include "core/volume/voi_window.h"

class DcmItem;

// The look-up tables of a data set: an LUT Descriptor (entries, first value mapped, bits) and its data.
namespace lacuna::dicom {

struct LutItem {
    std::int64_t first = 0;  ///< the value of the first entry
    int bits = 16;
    std::vector<std::uint16_t> entries;  ///< at least one
};

/// One item of a Modality or VOI LUT Sequence. @param is_signed  how the first value mapped is meant, whatever the file
/// writes it as. @throws std::runtime_error for one that cannot be
LutItem read_lut(DcmItem& item, bool is_signed);

/// The tables of the VOI LUT Sequence, at most 16; what cannot be read is left out. The first value mapped is signed
/// where the values a table is for may be negative (PS3.3 C.11.2.1.1): as the pixels are where nothing rescales them.
/// @param frame  from 1, of an image with functional groups; 0: it has none
std::vector<VoiTable> voi_tables(DcmItem& data, int frame);

}  // namespace lacuna::dicom
