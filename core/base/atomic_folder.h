#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// A folder made beside its target and renamed to it by commit(), so that no half-filled folder ever carries the
/// target's name. Destroyed without commit(), it and all in it are removed.
class AtomicFolder {
public:
    /// @param own  names of the files such a folder may hold, the first one always: an existing target that holds that
    ///             one and nothing but these is of this kind and is replaced; empty: only an empty folder, or none, may
    ///             stand there
    /// @throws Error(io) if the target is in the way, or its parent cannot be written
    explicit AtomicFolder(const std::filesystem::path& target, const std::vector<std::string>& own = {});
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// Where to put the files.
    const std::filesystem::path& path() const { return temporary_; }
    /// Renames. A target that stood there is exchanged in one step where the file system can, and removed.
    /// @throws Error(io), the target as it was, also where it holds by now what is not to be lost
    void commit();

    /// @throws as the constructor does for a target that is in the way
    static void check(const std::filesystem::path& target, const std::vector<std::string>& own = {});
    /// Removes what a killed process left beside a target.
    static void remove_leftovers(const std::filesystem::path& target);

private:
    std::filesystem::path target_, temporary_;
    std::vector<std::string> own_;
    bool committed_ = false;
};

}  // namespace lacuna
