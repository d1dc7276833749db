#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/inspect/batch.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

/// Endings of files that are a volume by themselves, longest first; a later one yields to an earlier of the same stem
/// (engine.mhd and engine.dat describe the same engine.raw).
constexpr std::string_view k_endings[] = {".nii.gz", ".mhd", ".mha", ".nrrd", ".nhdr", ".nii", ".vgi", ".dat"};

std::string_view volume_ending(std::string_view name) {
    for (const std::string_view ending : k_endings)
        if (name.size() > ending.size() && name.ends_with(ending)) return ending;
    return {};
}

/// A name fit for a folder: letters, digits, dot, dash, underscore; never hidden.
std::string folder_name(const std::string& input) {
    std::string name = input;
    if (!input.starts_with("sample:")) {
        fs::path path(input);
        if (!path.has_filename()) path = path.parent_path();
        name = path.filename().string();
        name.resize(name.size() - volume_ending(name).size());
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
        std::map<std::string, std::string_view> stems;  // of volume files, and the ending kept
        for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec)) {
            const std::string name = at->path().filename().string();
            std::error_code ignored;
            if (name.starts_with(".") || (!leave_out.empty() && fs::equivalent(at->path(), leave_out, ignored)))
                continue;
            if (at->is_directory(ignored)) {
                found.push_back(at->path());
                continue;
            }
            const std::string_view ending = volume_ending(name);
            if (ending.empty() || !at->is_regular_file(ignored)) continue;
            std::string_view& kept = stems[name.substr(0, name.size() - ending.size())];
            const auto place = [](std::string_view e) {
                return std::find(std::begin(k_endings), std::end(k_endings), e);
            };
            // Of two volume files of one stem both are parts, unless one is only a side-car of raw data.
            if (kept.empty() || place(ending) < place(kept)) kept = *place(ending);
        }
        if (ec) throw Error(Errc::io, "Cannot list the folder " + folder.string() + ": " + ec.message() + ".");
        for (const auto& [stem, ending] : stems) found.push_back(folder / (stem + std::string(ending)));
        std::sort(found.begin(), found.end());
        for (const fs::path& path : found) add(path.string());
    }

    void add_list(const fs::path& file) {
        constexpr std::uintmax_t k_longest = 64 << 20;
        std::istringstream lines(read_file(file, k_longest));
        for (std::string line; std::getline(lines, line);) {
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
