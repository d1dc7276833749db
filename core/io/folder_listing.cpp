#include "core/io/folder_listing.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include "core/base/error.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

bool may_be_listed(const fs::path& folder) {
    return ::faccessat(AT_FDCWD, folder.c_str(), R_OK | X_OK, AT_EACCESS) == 0;
}

}  // namespace

FolderListing files_under(const fs::path& input, const JobContext& job) {
    std::error_code error;
    if (fs::is_regular_file(input, error)) return {{input}};
    if (!fs::is_directory(input, error))
        throw Error(Errc::bad_input, "There is no file or folder " + input.string() + "; check the name.",
                    input.string());
    if (!may_be_listed(input))
        throw Error(Errc::io,
                    "Cannot list the folder " + input.string() + ": permission denied; ask for the right to read it.",
                    input.string());
    FolderListing found;
    // Links to folders are not followed: they could lead back.
    fs::recursive_directory_iterator at(input, fs::directory_options::skip_permission_denied, error), end;
    for (; !error && at != end; at.increment(error)) {
        job.check();
        std::error_code ignored;
        if (at->is_regular_file(ignored)) {
            if (at->file_size(ignored) > 0)
                found.files.push_back(at->path());
            else
                ++found.empty;
        }
        if (at->is_directory(ignored) && !at->is_symlink(ignored) && !may_be_listed(at->path()))
            found.locked.push_back(at->path().filename().string());
    }
    if (error)
        throw Error(Errc::io, "Cannot list the folder " + input.string() + ": " + error.message() + ".",
                    input.string());
    std::sort(found.files.begin(), found.files.end());
    std::sort(found.locked.begin(), found.locked.end());
    return found;
}

}  // namespace lacuna
