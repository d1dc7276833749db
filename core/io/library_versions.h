#pragma once

#include <string>
#include <vector>

namespace lacuna {

struct LibraryVersion {
    std::string name, version;
};

/// The libraries that read and write files, as linked: DCMTK, GDCM, ITK.
std::vector<LibraryVersion> io_library_versions();

}  // namespace lacuna
