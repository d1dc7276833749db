#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

std::string reason(int code) { return std::generic_category().message(code); }

/// What a user can do about a failed write.
const char* advice(int code) {
    switch (code) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or write elsewhere";
        case EFBIG:
            return "the file system or a limit (ulimit -f) allows no file so large; write elsewhere";
        case EACCES:
        case EPERM:
        case EROFS:
            return "name a folder that takes new files";
        case ENAMETOOLONG:
            return "choose a shorter name";
        default:
            return "check the disk or write elsewhere";
    }
}

/// Of no other process, be it of the same number in another container or on another machine that sees the folder.
std::string tag_of_its_own() {
    static std::atomic<unsigned> counter{0};
    std::uint32_t drawn = 0;
    (void)!::getrandom(&drawn, sizeof drawn, 0);
    return "." + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-" + std::to_string(drawn) + ".part";
}

}  // namespace

void throw_cannot_write(const fs::path& target, int code) {
    throw Error(Errc::io, "Cannot write " + target.string() + ": " + reason(code) + "; nothing was written; " +
                              advice(code) + ".");
}

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)) {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    std::error_code ec;
    if (!fs::is_directory(folder, ec))
        throw Error(Errc::io, "Cannot write " + target_.string() + ": the folder " + folder.string() +
                                  " does not exist; create it first.");
    // "name.part.ext" would split "volume.nii.gz" wrongly: the tag goes in front instead.
    temporary_ = folder / (tag_of_its_own() + "." + target_.filename().string());
}

AtomicFile::~AtomicFile() {
    std::error_code ec;
    if (!committed_) fs::remove(temporary_, ec);
}

void AtomicFile::commit() {
    const int fd = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0 || ::fsync(fd) != 0) {
        const int code = errno;
        if (fd >= 0) ::close(fd);
        throw_cannot_write(target_, code);
    }
    ::close(fd);
    std::error_code ec;
    fs::rename(temporary_, target_, ec);
    if (ec) throw_cannot_write(target_, ec.value());
    committed_ = true;
}

void write_file(const fs::path& target, std::string_view bytes) {
    AtomicFile file(target);
    const int fd = ::open(file.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) throw_cannot_write(target, errno);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = ::write(fd, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            const int code = n == 0 ? EIO : errno;
            ::close(fd);
            throw_cannot_write(target, code);
        }
        done += std::size_t(n);
    }
    if (::close(fd) != 0) throw_cannot_write(target, errno);
    file.commit();
}

std::string read_file(const fs::path& file, std::uintmax_t limit) {
    std::error_code ec;
    const std::uintmax_t size = fs::file_size(file, ec);
    if (ec) throw Error(Errc::io, "Cannot read " + file.string() + ": " + ec.message() + ".");
    if (size > limit)
        throw Error(Errc::bad_input, "Cannot read " + file.string() + ": it has " + std::to_string(size) +
                                         " bytes, more than the " + std::to_string(limit) + " expected at most.");
    std::ifstream in(file, std::ios::binary);
    std::string bytes(std::size_t(size), '\0');
    if (!in.read(bytes.data(), std::streamsize(size)) && size > 0)
        throw Error(Errc::io, "Cannot read " + file.string() + ": it is cut short; copy or export the file again.");
    return bytes;
}

}  // namespace lacuna
