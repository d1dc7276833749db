#include "core/io/dicom_tags.h"

#include <charconv>

namespace lacuna::dicom {

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(std::string(" \t\r\n\0", 5));
    if (first == std::string::npos) return {};
    const auto last = text.find_last_not_of(std::string(" \t\r\n\0", 5));
    return text.substr(first, last - first + 1);
}

double parse_number(const std::string& text, const DcmTagKey& tag) {
    const std::string body = !text.empty() && text.front() == '+' ? text.substr(1) : text;
    double value = 0;
    // from_chars knows no locale: a German desktop must not turn 0.7 into 0.
    const auto result = std::from_chars(body.data(), body.data() + body.size(), value);
    if (result.ec != std::errc() || result.ptr != body.data() + body.size() || !std::isfinite(value))
        throw std::runtime_error(tag_text(tag) + " is not a number");
    return value;
}

}  // namespace

std::string tag_text(const DcmTagKey& key) {
    char number[16];
    std::snprintf(number, sizeof number, "(%04X,%04X)", unsigned(key.getGroup()), unsigned(key.getElement()));
    DcmTag tag(key);
    const char* name = tag.getTagName();
    return std::string(name ? name : "tag") + " " + number;
}

std::string text_of(DcmItem& item, const DcmTagKey& tag, unsigned long index) {
    OFString value;
    if (item.findAndGetOFString(tag, value, index).bad()) return {};
    return trimmed(std::string(value.c_str(), value.size()));
}

std::vector<double> numbers_of(DcmItem& item, const DcmTagKey& tag) {
    std::vector<double> found;
    DcmElement* element = nullptr;
    if (item.findAndGetElement(tag, element).bad() || !element) return found;
    const unsigned long count = element->getVM();
    for (unsigned long i = 0; i < count; ++i) {
        OFString value;
        if (element->getOFString(value, i).bad()) throw std::runtime_error(tag_text(tag) + " cannot be read");
        const std::string text = trimmed(std::string(value.c_str(), value.size()));
        if (text.empty() && count == 1) break;
        found.push_back(parse_number(text, tag));
    }
    return found;
}

std::optional<double> number_of(DcmItem& item, const DcmTagKey& tag) {
    const auto all = numbers_of(item, tag);
    return all.empty() ? std::nullopt : std::optional<double>(all.front());
}

std::optional<int> integer_of(DcmItem& item, const DcmTagKey& tag) {
    const auto value = number_of(item, tag);
    if (!value) return std::nullopt;
    if (!(std::abs(*value) <= 2147483647.0) || *value != std::floor(*value))
        throw std::runtime_error(tag_text(tag) + " is not a whole number");
    return int(*value);
}

std::optional<double> readable_number_of(DcmItem& item, const DcmTagKey& tag) {
    const std::string first = text_of(item, tag);
    if (first.empty()) return std::nullopt;
    try {
        return parse_number(first, tag);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

std::optional<int> readable_integer_of(DcmItem& item, const DcmTagKey& tag) {
    const auto value = readable_number_of(item, tag);
    if (!value || !(std::abs(*value) <= 2147483647.0) || *value != std::floor(*value)) return std::nullopt;
    return int(*value);
}

DcmItem* item_of(DcmItem& item, const DcmTagKey& sequence, unsigned long index) {
    DcmSequenceOfItems* found = nullptr;
    if (item.findAndGetSequence(sequence, found).bad() || !found || index >= found->card()) return nullptr;
    return found->getItem(index);
}

}  // namespace lacuna::dicom
