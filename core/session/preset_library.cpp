#include "core/session/preset_library.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace lacuna {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::error_code& error) {
    throw Error(Errc::io, what + " " + path.string() + ": " + error.message() + ".", path.string());
}

/// A file name that any file system takes; bytes beyond ASCII stay, so that names in any language do.
std::string file_name_of(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        out += u >= 0x80 || std::isalnum(u) || c == '-' || c == '_' ? c : '_';
    }
    return out.substr(0, 80) + ".json";
}

PresetEntry read_entry(const fs::path& file) {
    PresetEntry entry{file.stem().string(), file};
    try {
        entry.preset = load_preset(file);
        if (entry.preset->tf.name.empty()) entry.preset->tf.name = entry.name;
        entry.name = entry.preset->tf.name;
    } catch (const Error& fault) {
        entry.fault = fault.what();
    }
    return entry;
}

std::vector<PresetEntry> own_presets(const fs::path& folder) {
    std::vector<PresetEntry> own;
    std::error_code error;
    if (!fs::exists(folder, error)) return own;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".json") own.push_back(read_entry(at->path()));
    if (error) fail("The presets cannot be read from", folder, error);
    std::sort(own.begin(), own.end(), [](const PresetEntry& a, const PresetEntry& b) { return a.name < b.name; });
    return own;
}

void refuse_taken(const std::string& name) {
    throw Error(Errc::bad_usage, "There is a preset named \"" + name + "\" already; choose another name.");
}

}  // namespace

std::vector<PresetEntry> list_presets(const fs::path& folder) {
    std::vector<PresetEntry> all;
    for (const std::string& name : preset_names()) all.push_back({name});
    for (PresetEntry& entry : own_presets(folder)) all.push_back(std::move(entry));
    return all;
}

bool owns_preset(const fs::path& folder, const std::string& name) {
    const std::vector<PresetEntry> own = own_presets(folder);
    return std::any_of(own.begin(), own.end(), [&](const PresetEntry& entry) { return entry.name == name; });
}

PresetFile preset_for(const PresetEntry& entry, const Volume& volume, const VolumeStatistics& statistics) {
    if (entry.built_in()) return {make_preset(entry.name, volume, statistics), technique_of_preset(entry.name)};
    if (!entry.preset) throw Error(Errc::bad_input, entry.fault, entry.file.string());
    return *entry.preset;
}

fs::path store_preset(const fs::path& folder, const PresetFile& preset, bool replace) {
    const std::string& name = preset.tf.name;
    if (std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isspace(c); }))
        throw Error(Errc::bad_usage, "A preset needs a name.");
    fs::path file = folder / file_name_of(name);
    for (const PresetEntry& entry : list_presets(folder)) {
        if (entry.name != name) continue;
        if (!replace || entry.built_in()) refuse_taken(name);
        file = entry.file;
    }
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail("The folder for presets cannot be made:", folder, error);
    // Another preset, of a name that reads alike as a file name, keeps its file.
    for (int n = 2; fs::exists(file, error) && read_entry(file).name != name; ++n)
        file = folder / (fs::path(file_name_of(name)).stem().string() + "-" + std::to_string(n) + ".json");
    save_preset(preset, file);
    return file;
}

fs::path rename_preset(const fs::path& file, const std::string& name) {
    PresetFile preset = load_preset(file);
    if (preset.tf.name == name) return file;
    preset.tf.name = name;
    fs::path renamed = store_preset(file.parent_path(), preset, false);
    if (renamed != file) remove_preset(file);
    return renamed;
}

void remove_preset(const fs::path& file) {
    std::error_code error;
    if (!fs::remove(file, error) && error) fail("The preset cannot be removed:", file, error);
}

}  // namespace lacuna
