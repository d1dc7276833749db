#pragma once

#include <memory>
#include <string>

class DcmItem;
class DcmTagKey;

namespace lacuna::dicom {

/// Texts of a data set as they may be shown: in UTF-8, without control characters (which a terminal would obey) and
/// padding. What its character set does not explain stays as it is. Cost: the conversion's only where one is needed.
class Utf8Texts {
public:
    explicit Utf8Texts(DcmItem& data);
    ~Utf8Texts();

    /// The first value of an element; empty without one.
    /// @param delimiters  characters behind which the first character set holds again (PS3.5 6.1.2.5.3)
    std::string operator()(const DcmTagKey& tag, const char* delimiters = "\\");
    /// A text of the data set, or of an item in it.
    std::string readable(std::string text, const char* delimiters = "\\");

private:
    struct Converter;
    DcmItem& data_;
    std::unique_ptr<Converter> converter_;
};

}  // namespace lacuna::dicom
