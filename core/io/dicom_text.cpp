#include "core/io/dicom_text.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dcspchrs.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "core/io/dicom_tags.h"

namespace lacuna::dicom {

struct Utf8Texts::Converter {
    DcmSpecificCharacterSet set;
    bool works = false;

    explicit Converter(DcmItem& data) {
        OFString charset;
        if (data.findAndGetOFStringArray(DCM_SpecificCharacterSet, charset).bad() || charset.empty()) return;
        if (charset == "ISO_IR 6" || charset == "ISO_IR 192") return;  // UTF-8 already
        works = DcmSpecificCharacterSet::isConversionAvailable() && set.selectCharacterSet(charset).good();
    }
};

Utf8Texts::Utf8Texts(DcmItem& data) : data_(data) {}
Utf8Texts::~Utf8Texts() = default;

std::string Utf8Texts::operator()(const DcmTagKey& tag, const char* delimiters) {
    return readable(text_of(data_, tag), delimiters);
}

std::string Utf8Texts::readable(std::string text, const char* delimiters) {
    const auto is_plain = [](char c) { return c >= ' ' && c < 0x7F; };
    if (std::all_of(text.begin(), text.end(), is_plain)) return text;
    if (!converter_) converter_ = std::make_unique<Converter>(data_);
    OFString converted;
    if (converter_->works && converter_->set.convertString(text.c_str(), text.size(), converted, delimiters).good())
        text.assign(converted.c_str(), converted.size());
    std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
    const auto last = text.find_last_not_of(' ');
    return text.substr(0, last == std::string::npos ? 0 : last + 1);
}

}  // namespace lacuna::dicom
