#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// Work that only one may do at a time, in this process or any other that sees the file: held while it lives, and let
/// go by the system however its process ends. Where the file system knows no locks, it keeps nobody out. The file
/// stays.
class FileLock {
public:
    /// @param busy  the sentence for when another holds it
    /// @throws Error(io) with that sentence; Error(io) if the file cannot be made
    FileLock(const std::filesystem::path& file, const std::string& busy);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    int file_;
};

}  // namespace lacuna
