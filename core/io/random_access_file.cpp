#include "core/io/random_access_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace lacuna {

RandomAccessFile::RandomAccessFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
        const int code = errno;
        if (descriptor_ >= 0) ::close(descriptor_);
        fail(code);
    }
    bytes_ = std::uint64_t(status.st_size);
}

RandomAccessFile::~RandomAccessFile() { ::close(descriptor_); }

std::size_t RandomAccessFile::read(std::uint64_t offset, std::span<std::byte> target) const {
    std::size_t done = 0;
    while (done < target.size()) {
        const ssize_t got = ::pread(descriptor_, target.data() + done, target.size() - done, off_t(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(errno);
        if (got == 0) break;
        done += std::size_t(got);
    }
    return done;
}

void RandomAccessFile::read_all(std::uint64_t offset, std::span<std::byte> target) const {
    if (read(offset, target) != target.size()) fail(EIO);
}

void RandomAccessFile::fail(int code) const {
    throw Error(Errc::io, "Cannot read " + path_.string() + ": " + std::generic_category().message(code) + ".",
                path_.string());
}

}  // namespace lacuna
