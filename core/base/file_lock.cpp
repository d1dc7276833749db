#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace lacuna {

FileLock::FileLock(const std::filesystem::path& file, const std::string& busy)
    : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw_cannot_write(file, errno);
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(file_);
    throw Error(Errc::io, busy);
}

FileLock::~FileLock() { ::close(file_); }

}  // namespace lacuna
