#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// A folder made beside its target and renamed to it by commit(), so that no half-filled folder ever carries the
/// target's name. Destroyed without commit(), it and all in it are removed.
class AtomicFolder {
public:
    /// @param mark  a file whose presence tells that an existing target is of this kind and may be replaced; empty:
    ///              only an empty folder, or none, may stand there
    /// @throws Error(io) if the target is in the way, or its parent cannot be written
    explicit AtomicFolder(const std::filesystem::path& target, const std::string& mark = {});
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// Where to put the files.
    const std::filesystem::path& path() const { return temporary_; }
    /// Renames. A target that stood there is exchanged in one step where the file system can, and removed.
    /// @throws Error(io), the target as it was
    void commit();

    /// @throws as the constructor does for a target that is in the way
    static void check(const std::filesystem::path& target, const std::string& mark = {});
    /// Removes what a killed process left beside a target.
    static void remove_leftovers(const std::filesystem::path& target);

private:
    std::filesystem::path target_, temporary_;
    bool committed_ = false;
};

}  // namespace lacuna
