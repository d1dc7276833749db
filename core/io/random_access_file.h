#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace lacuna {

/// A file opened for positioned reads: no shared file pointer, no buffer in between, so that any number of threads may
/// read from one.
class RandomAccessFile {
public:
    /// @throws Error(io) naming the file and the reason
    explicit RandomAccessFile(const std::filesystem::path& path);
    ~RandomAccessFile();
    RandomAccessFile(const RandomAccessFile&) = delete;
    RandomAccessFile& operator=(const RandomAccessFile&) = delete;

    /// Its size when it was opened.
    std::uint64_t bytes() const { return bytes_; }

    /// Reads as many bytes as there are from `offset` on, at most target.size(); returns how many.
    /// @throws Error(io)
    std::size_t read(std::uint64_t offset, std::span<std::byte> target) const;

    /// Fills the whole target. @throws Error(io), also where the file ends before
    void read_all(std::uint64_t offset, std::span<std::byte> target) const;

private:
    [[noreturn]] void fail(int code) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

}  // namespace lacuna
