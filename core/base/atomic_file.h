#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lacuna {

/// A file written beside its target and renamed over it by commit(), so that no half-written file ever carries the
/// target's name. Destroyed without commit(), it leaves nothing behind.
class AtomicFile {
public:
    /// @throws Error(io) if the target's folder does not exist or cannot be written
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where to write. It keeps the target's extension, because image libraries go by it.
    const std::filesystem::path& path() const { return temporary_; }
    /// Flushes to disk and renames. @throws Error(io), the temporary file removed
    void commit();

private:
    std::filesystem::path target_, temporary_;
    bool committed_ = false;
};

/// @throws always: Error(io) "Cannot write TARGET: reason; nothing was written; what to do."
/// @param code an errno
[[noreturn]] void throw_cannot_write(const std::filesystem::path& target, int code);

/// Writes all bytes or nothing. @throws Error(io) naming the file and the reason (disk full, permission)
void write_file(const std::filesystem::path& target, std::string_view bytes);

/// The whole file as bytes. @throws Error(io) naming the file; Error(bad_input) if longer than `limit` bytes
std::string read_file(const std::filesystem::path& file, std::uintmax_t limit = std::uintmax_t(1) << 30);

}  // namespace lacuna
