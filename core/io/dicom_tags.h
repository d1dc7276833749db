#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// Small typed look-ups in a DCMTK data set, private to the DICOM reader.
namespace lacuna::dicom {

/// "SliceThickness (0018,0050)": how messages name a tag.
std::string tag_text(const DcmTagKey& tag);

/// A text value without padding; empty when absent.
std::string text_of(DcmItem& item, const DcmTagKey& tag, unsigned long index = 0);

/// All numbers of a tag; empty when absent or empty.
/// @throws std::runtime_error naming the tag when a value is not a finite number
std::vector<double> numbers_of(DcmItem& item, const DcmTagKey& tag);

/// The first number of a tag. @throws as numbers_of
std::optional<double> number_of(DcmItem& item, const DcmTagKey& tag);

/// A whole number. @throws as numbers_of; also when it is not whole or outside 32 bits
std::optional<int> integer_of(DcmItem& item, const DcmTagKey& tag);

/// The first number of a tag that is only shown or sorted by: nothing for what is no number or, of the second, not
/// whole.
std::optional<double> readable_number_of(DcmItem& item, const DcmTagKey& tag);
std::optional<int> readable_integer_of(DcmItem& item, const DcmTagKey& tag);

/// The n-th item of a sequence; nullptr when there is none.
DcmItem* item_of(DcmItem& item, const DcmTagKey& sequence, unsigned long index = 0);

}  // namespace lacuna::dicom
