#include "ui/hidden_names.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace lacuna::ui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_most_files = 20000;
constexpr const char* k_hidden = "...";

bool is_part_of_word(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z') ||
           byte == '_' || byte >= 0x80;
}

/// Nobody's name, but words and numbers of any sentence.
bool is_common(const std::string& name) {
    return name.size() < 3 || (name.size() < 5 && name.find_first_not_of("0123456789") == std::string::npos);
}

/// Replaces a name where it stands for itself, not inside a word.
void hide_word(std::string& sentence, const std::string& name) {
    if (is_common(name)) return;
    for (std::size_t at = 0; (at = sentence.find(name, at)) != std::string::npos;) {
        const std::size_t end = at + name.size();
        const bool word = (at == 0 || !is_part_of_word(name.front()) || !is_part_of_word(sentence[at - 1])) &&
                          (end == sentence.size() || !is_part_of_word(name.back()) || !is_part_of_word(sentence[end]));
        if (word) sentence.replace(at, name.size(), k_hidden);
        at += word ? std::char_traits<char>::length(k_hidden) : 1;
    }
}

/// Paths that are left, up to the next blank.
void hide_paths(std::string& sentence) {
    for (std::size_t at = 0; (at = sentence.find('/', at)) != std::string::npos;) {
        const bool starts = at == 0 || sentence[at - 1] == ' ' || sentence[at - 1] == '\'' || sentence[at - 1] == '(';
        const bool goes_on = at > 0 && sentence[at - 1] == '.';  // behind a name that is hidden already
        const std::size_t end = std::min(sentence.find_first_of(" :;,')", at), sentence.size());
        if ((!starts && !goes_on) || end == at + 1) {
            ++at;
            continue;
        }
        sentence.replace(at, end - at, goes_on ? "" : k_hidden);
    }
}

/// Names of the files under a folder; false: there are too many.
template <class Walk>
bool add_names(const fs::path& folder, std::vector<std::string>& names) {
    std::error_code ec;
    std::size_t count = 0;
    for (Walk at(folder, fs::directory_options::skip_permission_denied, ec), end; !ec && at != end; at.increment(ec)) {
        if (++count > k_most_files) return false;
        names.push_back(at->path().filename().string());
    }
    return true;
}

}  // namespace

std::string without_names(const std::string& sentence, const std::string& input) {
    if (input.empty() || input.starts_with("sample:")) return sentence;
    std::error_code ec;
    const fs::path path(input), whole = fs::absolute(path, ec).lexically_normal();
    std::vector<std::string> names = {input,
                                      whole.string(),
                                      path.filename().string(),
                                      path.stem().string(),
                                      whole.filename().string(),
                                      whole.parent_path().filename().string()};
    const bool all = fs::is_directory(path, ec) ? add_names<fs::recursive_directory_iterator>(path, names)
                                                : add_names<fs::directory_iterator>(whole.parent_path(), names);
    if (!all) return "This cannot be opened; what is wrong is not shown while patients' names are hidden.";
    std::sort(names.begin(), names.end(),
              [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
    std::string hidden = sentence;
    for (const std::string& name : names) hide_word(hidden, name);
    hide_paths(hidden);
    return hidden;
}

void hide_names(Volume& volume, const std::string& input) {
    for (Warning& warning : volume.warnings) warning.text = without_names(warning.text, input);
    if (volume.dicom) std::fill(volume.dicom->duplicates.begin(), volume.dicom->duplicates.end(), k_hidden);
}

}  // namespace lacuna::ui
