#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/inspect/verdict.h"
#include "core/regions/regions.h"
#include "core/session/document.h"

namespace lacuna {

/// How regions are asked for, and what there was of them.
struct SessionRegions {
    RegionOptions options;
    bool computed = false;       ///< there was a table: it is made again from the data
    std::uint32_t selected = 0;  ///< its row that was chosen; 0: none
};

/// What a session file keeps of a window: which data was open and what was done with it, but not the data itself and no
/// result that can be computed again.
struct Session {
    std::string input;  ///< as opened: an absolute path, or sample:NAME[@SIZE]
    OpenOptions options;
    std::string sha256;  ///< of the voxels (voxel_sha256); empty: was not known when it was saved
    glm::ivec3 size{0};
    ViewSettings settings;
    Camera camera;
    glm::dvec3 cursor_mm{0};
    std::string criteria;                 ///< criteria JSON of the inspection; empty: nothing was inspected
    std::vector<HandDecision> decisions;  ///< by hand, on what an inspection by those criteria finds
    std::optional<SessionRegions> regions;
};

/// A document's part of a session. A relative input becomes an absolute one.
Session session_of(const Document& document, const std::string& sha256);

/// Writes the file whole or not at all. A path to the data relative to the file's folder is kept beside the absolute
/// one, so that data and session can move together.
/// @throws Error(io)
void save_session(const Session& session, const std::filesystem::path& file);

/// @throws Error(bad_input) for what is no session file, one of a newer version, or an entry that cannot be, naming
/// file and entry; Error(io)
Session load_session(const std::filesystem::path& file);

/// Shows a document as the session did. @throws Error(bad_input) where the volume's size is another
void apply_session(const Session& session, Document& document);

inline constexpr const char* k_session_suffix = ".lacuna";

}  // namespace lacuna
