#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/chart/svg_text.h"
#include "core/inspect/batch.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

/// Endings of files that are a volume by themselves, longest first.
constexpr std::string_view k_whole[] = {".nii.gz", ".mha", ".nrrd", ".nii"};
/// Endings of headers; a later one yields to an earlier of the same stem (engine.mhd and engine.dat describe the same
/// engine.raw).
constexpr std::string_view k_headers[] = {".mhd", ".nhdr", ".vgi", ".dat"};

/// The one of the endings that a file's name has; empty if none.
template <std::size_t N>
std::string_view ending_of(std::string_view name, const std::string_view (&endings)[N]) {
    for (const std::string_view ending : endings)
        if (name.size() > ending.size() && name.ends_with(ending)) return ending;
    return {};
}

std::string_view volume_ending(std::string_view name) {
    const std::string_view whole = ending_of(name, k_whole);
    return whole.empty() ? ending_of(name, k_headers) : whole;
}

/// Where this folder is, or leads to, the reports' one and to nothing but series inspected: what a series must not take
/// for a part of itself, the same before the reports' folder was made and after.
bool leads_to_reports(const fs::path& folder, const fs::path& reports) {
    std::error_code ec;
    if (reports.empty()) return false;
    if (fs::equivalent(folder, reports, ec)) return true;
    fs::path inner = fs::weakly_canonical(reports, ec);
    while (!ec && inner.has_relative_path()) {
        const fs::path outer = inner.parent_path();
        for (fs::directory_iterator at(outer, ec), end; !ec && at != end; at.increment(ec)) {
            std::error_code ignored;
            if (at->path() != inner && !fs::exists(at->path() / "series.json", ignored)) return false;
        }
        if (ec) return false;
        if (fs::equivalent(folder, outer, ec)) return true;
        inner = outer;
    }
    return false;
}

/// A name fit for a folder: letters, digits, dot, dash, underscore, all of it UTF-8; never hidden, and short enough for
/// what is written beside it.
std::string folder_name(const std::string& input) {
    constexpr std::size_t k_longest = 160;
    std::string name = input;
    if (!input.starts_with("sample:")) {
        fs::path path(input);
        if (!path.has_filename()) path = path.parent_path();
        name = path.filename().string();
        name.resize(name.size() - volume_ending(name).size());
    }
    name = valid_utf8(name);
    if (name.size() > k_longest) {
        std::size_t end = k_longest;
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;  // between two characters
        name.resize(end);
    }
    for (char& c : name) {
        const bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                          c == '-' || c == '_' || static_cast<unsigned char>(c) >= 0x80;
        if (!fine) c = '_';
    }
    if (name.empty() || name[0] == '.') name.insert(0, "part");
    return name;
}

class PartList {
public:
    void add(const std::string& input) {
        static const std::set<std::string> k_taken{"journal", "reference", "summary.csv", "summary.html",
                                                   "series.json"};
        const std::string name = folder_name(input);
        std::string unique = name;
        for (int n = 2; k_taken.contains(unique) || !names_.insert(unique).second; ++n)
            unique = name + "-" + std::to_string(n);
        parts_.push_back({unique, input});
    }

    void add_folder(const fs::path& folder, const fs::path& leave_out) {
        std::error_code ec;
        std::vector<fs::path> found;
        std::map<std::string, std::string_view> stems;  // of headers, and the ending kept
        for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec)) {
            const std::string name = at->path().filename().string();
            std::error_code ignored;
            if (name.starts_with(".")) continue;
            if (at->is_directory(ignored)) {
                if (!leads_to_reports(at->path(), leave_out)) found.push_back(at->path());
                continue;
            }
            if (!at->is_regular_file(ignored)) continue;
            if (!ending_of(name, k_whole).empty()) {
                found.push_back(at->path());
                continue;
            }
            const std::string_view ending = ending_of(name, k_headers);
            if (ending.empty()) continue;
            std::string_view& kept = stems[name.substr(0, name.size() - ending.size())];
            const auto place = [](std::string_view e) {
                return std::find(std::begin(k_headers), std::end(k_headers), e);
            };
            if (kept.empty() || place(ending) < place(kept)) kept = *place(ending);
        }
        if (ec) throw Error(Errc::io, "Cannot list the folder " + folder.string() + ": " + ec.message() + ".");
        for (const auto& [stem, ending] : stems) found.push_back(folder / (stem + std::string(ending)));
        std::sort(found.begin(), found.end());
        for (const fs::path& path : found) add(path.string());
    }

    void add_list(const fs::path& file) {
        constexpr std::uintmax_t k_longest = 64 << 20;
        const std::string text = read_file(file, k_longest);
        if (text.find('\0') != std::string::npos)
            throw Error(Errc::bad_input,
                        "The file " + file.string() +
                            " is no list of inputs, one a line; name the folder it lies in, or a list that names it.",
                        file.string());
        std::istringstream lines(text);
        constexpr std::string_view k_mark = "\xef\xbb\xbf";  // of UTF-8, which some editors begin a file with
        bool first = true;
        for (std::string line; std::getline(lines, line); first = false) {
            if (first && line.starts_with(k_mark)) line.erase(0, k_mark.size());
            while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.pop_back();
            line.erase(0, line.find_first_not_of(" \t"));
            if (line.empty() || line[0] == '#') continue;
            add(line.starts_with("sample:") ? line : (file.parent_path() / line).string());
        }
    }

    std::vector<BatchPart> take() { return std::move(parts_); }

private:
    std::vector<BatchPart> parts_;
    std::set<std::string> names_;
};

}  // namespace

std::vector<BatchPart> find_parts(const std::vector<std::string>& inputs, const fs::path& leave_out) {
    PartList list;
    for (const std::string& input : inputs) {
        std::error_code ec;
        if (input.starts_with("sample:") || !volume_ending(input).empty())
            list.add(input);
        else if (fs::is_directory(input, ec))
            list.add_folder(input, leave_out);
        else if (fs::is_regular_file(input, ec))
            list.add_list(input);
        else
            throw Error(Errc::bad_input, "There is no folder or list " + input + "; check the name.", input);
    }
    std::vector<BatchPart> parts = list.take();
    if (parts.empty())
        throw Error(Errc::bad_input,
                    "The series has no part: name a folder of sub-folders or volume files, or a list of inputs.");
    return parts;
}

}  // namespace lacuna
