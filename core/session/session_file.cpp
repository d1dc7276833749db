#include "core/session/session_file.h"

#include <ctime>

#include "core/base/atomic_file.h"
#include "core/session/settings_fields.h"
#include "core/session/settings_json.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr int k_version = 2;  // 2 adds the regions

bool is_file_name(const std::string& input) { return !input.starts_with("sample:"); }

/// The entry "data": where the voxels came from.
struct DataEntry {
    std::string input, relative;
    std::string series, raw;
    bool keep_gaps = false;
    std::optional<glm::dvec3> spacing_mm;
    std::string sha256;
    glm::ivec3 size{0};
};

template <class Archive>
void fields(Archive& archive, DataEntry& data) {
    archive("input", data.input);
    archive("relative", data.relative);
    archive("series", data.series);
    archive("raw", data.raw);
    archive("keep_gaps", data.keep_gaps);
    archive("spacing_mm", data.spacing_mm);
    archive("sha256", data.sha256);
    archive("size", data.size);
}

/// The entry "regions".
struct RegionsEntry {
    std::optional<double> range_width, gradient_limit;
    std::optional<ValueRange> threshold, background;
    int connectivity = 6;
    std::int64_t min_voxels = 1;
    bool merge_slivers = false, computed = false;
    std::uint32_t selected = 0;
};

template <class Archive>
void fields(Archive& archive, RegionsEntry& regions) {
    archive("range_width", regions.range_width);
    archive("threshold", regions.threshold);
    archive("background", regions.background);
    archive("connectivity", regions.connectivity);
    archive("min_voxels", regions.min_voxels);
    archive("gradient_limit", regions.gradient_limit);
    archive("merge_slivers", regions.merge_slivers);
    archive("computed", regions.computed);
    archive("selected", regions.selected);
}

RegionsEntry entry_of(const SessionRegions& regions) {
    const RegionOptions& options = regions.options;
    return {options.range_width,   options.gradient_limit,    options.threshold,
            options.background,    int(options.connectivity), options.min_voxels,
            options.merge_slivers, regions.computed,          regions.selected};
}

/// @throws Error(bad_input) for what find_regions() would not take
SessionRegions regions_of(const RegionsEntry& entry, const std::string& where) {
    const auto refuse = [&](const char* fault) { throw Error(Errc::bad_input, where + ".regions: " + fault); };
    if (entry.range_width.has_value() == entry.threshold.has_value())
        refuse("exactly one of range_width and threshold has to be given.");
    if (entry.range_width && !(*entry.range_width > 0 && *entry.range_width <= 1))
        refuse("range_width has to lie between 0 and 1.");
    if (entry.connectivity != 6 && entry.connectivity != 18 && entry.connectivity != 26)
        refuse("connectivity has to be 6, 18 or 26.");
    if (entry.min_voxels < 1) refuse("min_voxels has to be 1 or more.");
    SessionRegions regions;
    regions.options.range_width = entry.range_width;
    regions.options.threshold = entry.threshold;
    regions.options.background = entry.background;
    regions.options.connectivity = Connectivity(entry.connectivity);
    regions.options.min_voxels = entry.min_voxels;
    regions.options.gradient_limit = entry.gradient_limit;
    regions.options.merge_slivers = entry.merge_slivers;
    regions.computed = entry.computed;
    regions.selected = entry.selected;
    return regions;
}

/// What the file holds besides "lacuna_session" and "criteria".
struct Body {
    std::string saved;
    DataEntry data;
    ViewSettings settings;
    Camera camera;
    glm::dvec3 cursor_mm{0};
    std::vector<HandDecision> decisions;
    std::optional<RegionsEntry> regions;
};

template <class Archive>
void fields(Archive& archive, Body& body) {
    archive("saved", body.saved);
    archive("data", body.data);
    archive("settings", body.settings);
    archive("camera", body.camera);
    archive("cursor_mm", body.cursor_mm);
    archive("decisions", body.decisions);
    archive("regions", body.regions);
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/// @throws Error(bad_input) for a camera no picture can be drawn with
void check(const Camera& camera, const std::string& where) {
    try {
        check(camera);
    } catch (const Error& fault) {
        throw Error(Errc::bad_input, where + ".camera: " + fault.what());
    }
}

/// The data beside the session file where it is there, else where it was.
std::string locate(const DataEntry& data, const fs::path& file) {
    if (!is_file_name(data.input) || data.relative.empty()) return data.input;
    std::error_code error;
    const fs::path beside = fs::absolute(file, error).parent_path() / data.relative;
    return fs::exists(beside, error) ? fs::weakly_canonical(beside, error).string() : data.input;
}

}  // namespace

template <class Archive>
void fields(Archive& archive, HandDecision& decision) {
    archive("defect", decision.defect);
    archive("accepted", decision.accepted);
    archive("reason", decision.reason);
}

Session session_of(const Document& document, const std::string& sha256) {
    Session session;
    session.input = document.input;
    if (is_file_name(session.input)) session.input = fs::absolute(session.input).lexically_normal().string();
    session.options = document.options;
    session.sha256 = sha256;
    session.size = document.volume.geometry().size;
    session.settings = document.settings;
    session.camera = document.camera;
    session.cursor_mm = document.cursor_mm;
    return session;
}

void save_session(const Session& session, const fs::path& file) {
    Body body;
    body.saved = utc_now();
    body.data = {session.input,
                 is_file_name(session.input)
                     ? fs::path(session.input).lexically_relative(fs::absolute(file).parent_path()).string()
                     : "",
                 session.options.series,
                 session.options.raw,
                 session.options.keep_gaps,
                 session.options.spacing_mm,
                 session.sha256,
                 session.size};
    body.settings = session.settings;
    body.camera = session.camera;
    body.cursor_mm = session.cursor_mm;
    body.decisions = session.decisions;
    if (session.regions) body.regions = entry_of(*session.regions);
    Json json{{"lacuna_session", k_version}};
    json.update(FieldWriter::write(body));
    if (!session.criteria.empty()) json["criteria"] = parse_json(session.criteria, "The criteria");
    write_file(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Session load_session(const fs::path& file) {
    const std::string where = file.filename().string();
    Json json = parse_json(read_file(file, std::uintmax_t(64) << 20), where);
    const auto version = json.is_object() ? json.find("lacuna_session") : json.end();
    if (version == json.end() || !version->is_number_integer())
        throw Error(Errc::bad_input, where + " is no session of Lacuna.");
    if (*version > k_version)
        throw Error(Errc::bad_input, where + " was saved by a newer Lacuna (session version " + version->dump() +
                                         "; this one reads up to " + std::to_string(k_version) + ").");
    json.erase("lacuna_session");
    Session session;
    if (const auto criteria = json.find("criteria"); criteria != json.end()) {
        session.criteria = criteria->dump();
        json.erase("criteria");
    }
    Body body;
    FieldReader::read(json, body, where);
    check(body.settings, where);
    check(body.camera, where);
    session.input = locate(body.data, file);
    session.options.series = body.data.series;
    session.options.raw = body.data.raw;
    session.options.keep_gaps = body.data.keep_gaps;
    session.options.spacing_mm = body.data.spacing_mm;
    session.sha256 = body.data.sha256;
    session.size = body.data.size;
    session.settings = std::move(body.settings);
    session.camera = body.camera;
    session.cursor_mm = body.cursor_mm;
    session.decisions = std::move(body.decisions);
    if (body.regions) session.regions = regions_of(*body.regions, where);
    return session;
}

void apply_session(const Session& session, Document& document) {
    const glm::ivec3 size = document.volume.geometry().size;
    if (size != session.size)
        throw Error(Errc::bad_input, "The session was saved with a volume of " + std::to_string(session.size.x) + "x" +
                                         std::to_string(session.size.y) + "x" + std::to_string(session.size.z) +
                                         " voxels, the data now has " + std::to_string(size.x) + "x" +
                                         std::to_string(size.y) + "x" + std::to_string(size.z) +
                                         "; it is shown as newly opened.");
    document.settings = session.settings;
    document.camera = session.camera;
    document.cursor_mm = session.cursor_mm;
}

}  // namespace lacuna
