#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>

#include "core/base/error.h"

namespace lacuna::dicom {

/// A file opened for positioned reads: no shared file pointer, no buffer in between.
class RandomAccessFile {
public:
    /// @throws Error(io) naming the file and the reason
    explicit RandomAccessFile(const std::filesystem::path& path) : path_(path) {
        descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        struct stat status {};
        if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
            const std::string reason = std::strerror(errno);
            if (descriptor_ >= 0) ::close(descriptor_);
            throw Error(Errc::io, "Cannot read " + path.string() + ": " + reason + ".", path.string());
        }
        bytes_ = std::uint64_t(status.st_size);
    }
    ~RandomAccessFile() { ::close(descriptor_); }
    RandomAccessFile(const RandomAccessFile&) = delete;
    RandomAccessFile& operator=(const RandomAccessFile&) = delete;

    std::uint64_t bytes() const { return bytes_; }

    /// Reads as many bytes as there are from `offset` on, at most target.size(); returns how many.
    /// @throws Error(io)
    std::size_t read(std::uint64_t offset, std::span<std::byte> target) const {
        std::size_t done = 0;
        while (done < target.size()) {
            const ssize_t got = ::pread(descriptor_, target.data() + done, target.size() - done, off_t(offset + done));
            if (got < 0 && errno == EINTR) continue;
            if (got < 0)
                throw Error(Errc::io, "Cannot read " + path_.string() + ": " + std::strerror(errno) + ".",
                            path_.string());
            if (got == 0) break;
            done += std::size_t(got);
        }
        return done;
    }

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

}  // namespace lacuna::dicom
