#include "core/base/atomic_folder.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

/// "a/b/" and "a/b" are the same folder.
fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

fs::path parent_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

std::string suffix_of(const fs::path& target) { return ".part." + target.filename().string(); }

/// Swaps two folders in one step. @return false where the file system cannot
bool exchange(const fs::path& a, const fs::path& b) {
    constexpr unsigned k_exchange = 2;  // RENAME_EXCHANGE
    return ::syscall(SYS_renameat2, AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), k_exchange) == 0;
}

/// Temporary folders this process is filling: a second job with the same target would clear the first one's.
struct BeingFilled {
    std::mutex mutex;
    std::set<fs::path> folders;
};

BeingFilled& being_filled() {
    static BeingFilled all;
    return all;
}

void no_longer_filled(const fs::path& folder) {
    const std::lock_guard lock(being_filled().mutex);
    being_filled().folders.erase(folder);
}

}  // namespace

AtomicFolder::AtomicFolder(const fs::path& target, const std::vector<std::string>& own)
    : target_(without_slash(target)), own_(own) {
    check(target_, own_);
    temporary_ = parent_of(target_) / ("." + std::to_string(::getpid()) + suffix_of(target_));
    const std::lock_guard lock(being_filled().mutex);
    if (being_filled().folders.contains(temporary_))
        throw Error(Errc::io, "Cannot write " + target_.string() +
                                  ": it is being written already; wait for that, or name another folder.");
    std::error_code ec;
    fs::remove_all(temporary_, ec);  // of a process of the same number that was killed
    if (!fs::create_directory(temporary_, ec)) throw_cannot_write(target_, ec ? ec.value() : EEXIST);
    being_filled().folders.insert(temporary_);
}

AtomicFolder::~AtomicFolder() {
    std::error_code ec;
    if (!committed_) fs::remove_all(temporary_, ec);
    if (!committed_) no_longer_filled(temporary_);
}

void AtomicFolder::check(const fs::path& wanted, const std::vector<std::string>& own) {
    const fs::path target = without_slash(wanted);
    std::error_code ec;
    if (!fs::is_directory(parent_of(target), ec))
        throw Error(Errc::io, "Cannot write " + target.string() + ": the folder " + parent_of(target).string() +
                                  " does not exist; create it first.");
    if (::access(parent_of(target).c_str(), W_OK | X_OK) != 0) throw_cannot_write(target, errno);
    if (!fs::exists(target, ec)) return;
    if (!fs::is_directory(target, ec))
        throw Error(Errc::io, "Cannot write " + target.string() + ": it is no folder; name another one.");
    if (fs::is_empty(target, ec)) return;
    if (own.empty() || !fs::exists(target / own.front(), ec))
        throw Error(Errc::io, "Cannot write " + target.string() +
                                  (own.empty() ? ": the folder is not empty"
                                               : ": the folder is not empty and holds no " + own.front()) +
                                  "; name a new one, so that nothing is mixed.");
    for (fs::directory_iterator at(target, ec), end; !ec && at != end; at.increment(ec)) {
        const std::string name = at->path().filename().string();
        if (std::find(own.begin(), own.end(), name) == own.end())
            throw Error(Errc::io, "Cannot write " + target.string() + ": the folder that stands there also holds " +
                                      name + ", which would be lost; move that, or name another folder.");
    }
    if (ec) throw_cannot_write(target, ec.value());
}

void AtomicFolder::commit() {
    check(target_, own_);  // somebody may have put a file there meanwhile
    std::error_code ec;
    const bool replaces = fs::exists(target_, ec) && !fs::is_empty(target_, ec);
    if (replaces && exchange(temporary_, target_)) {
        committed_ = true;
        fs::remove_all(temporary_, ec);
        no_longer_filled(temporary_);
        return;
    }
    const fs::path old = temporary_.string() + ".old";
    if (replaces) {
        fs::rename(target_, old, ec);
        if (ec) throw_cannot_write(target_, ec.value());
    }
    fs::rename(temporary_, target_, ec);
    if (ec) {
        std::error_code ignored;
        if (replaces) fs::rename(old, target_, ignored);
        throw_cannot_write(target_, ec.value());
    }
    committed_ = true;
    no_longer_filled(temporary_);
    if (replaces) fs::remove_all(old, ec);
}

void AtomicFolder::remove_leftovers(const fs::path& wanted) {
    const fs::path target = without_slash(wanted);
    const std::string suffix = suffix_of(target);
    std::error_code ec;
    for (fs::directory_iterator at(parent_of(target), ec), end; !ec && at != end; at.increment(ec)) {
        const std::string name = at->path().filename().string();
        if (name.size() <= suffix.size() + 1 || name[0] != '.') continue;
        const bool ours = name.ends_with(suffix) || name.ends_with(suffix + ".old");
        const std::size_t dot = name.find('.', 1);
        const bool number = dot != std::string::npos && dot > 1 &&
                            std::all_of(name.begin() + 1, name.begin() + std::ptrdiff_t(dot),
                                        [](unsigned char c) { return std::isdigit(c) != 0; });
        std::error_code ignored;
        if (ours && number) fs::remove_all(at->path(), ignored);
    }
}

}  // namespace lacuna
