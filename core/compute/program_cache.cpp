#include "core/compute/program_cache.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/log.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_magic = "lacuna-program-1\n";
constexpr std::uintmax_t k_largest_bytes = std::uintmax_t(256) << 20;

/// FNV-1a (Fowler, Noll, Vo), 64 bits. Two seeds give the 128 bits of a file name; the key inside the file decides.
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash) {
    for (unsigned char c : bytes) hash = (hash ^ c) * 0x100000001b3ull;
    return hash;
}

void append_part(std::string& out, std::string_view part) {
    const std::uint64_t size = part.size();
    for (int byte = 0; byte < 8; ++byte) out += char((size >> (8 * byte)) & 0xff);
    out.append(part);
}

/// Every part with its length before it, so that no two keys give the same bytes.
std::string bytes_of(const ProgramKey& key) {
    std::string out;
    out.reserve(key.source.size() + key.options.size() + 512);
    for (const std::string* part : {&key.source, &key.options, &key.device, &key.driver, &key.platform})
        append_part(out, *part);
    return out;
}

/// Takes the next part off `bytes`; false when its length cannot be.
bool take_part(std::string_view& bytes, std::string_view& part) {
    if (bytes.size() < 8) return false;
    std::uint64_t size = 0;
    for (int byte = 0; byte < 8; ++byte) size |= std::uint64_t(static_cast<unsigned char>(bytes[byte])) << (8 * byte);
    bytes.remove_prefix(8);
    if (size > bytes.size()) return false;
    part = bytes.substr(0, size);
    bytes.remove_prefix(size);
    return true;
}

std::string checksum_of(std::string_view binary) {
    const std::uint64_t hash = fnv1a(binary, 0xcbf29ce484222325ull);
    std::string out(8, '\0');
    for (int byte = 0; byte < 8; ++byte) out[byte] = char((hash >> (8 * byte)) & 0xff);
    return out;
}

}  // namespace

fs::path ProgramCache::default_folder() {
    if (const char* own = std::getenv("LACUNA_CACHE")) return fs::path(own);
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "lacuna/kernels";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/lacuna/kernels";
    return {};
}

fs::path ProgramCache::file_of(const ProgramKey& key) const {
    const std::string bytes = bytes_of(key);
    const std::uint64_t first = fnv1a(bytes, 0xcbf29ce484222325ull);
    const std::uint64_t second = fnv1a(bytes, first ^ 0x9e3779b97f4a7c15ull);
    char name[40];
    std::snprintf(name, sizeof name, "%016llx%016llx.bin", static_cast<unsigned long long>(first),
                  static_cast<unsigned long long>(second));
    return folder_ / name;
}

std::optional<std::string> ProgramCache::load(const ProgramKey& key) const {
    if (folder_.empty()) return std::nullopt;
    const fs::path file = file_of(key);
    std::error_code ec;
    if (!fs::is_regular_file(file, ec)) return std::nullopt;
    try {
        const std::string bytes = read_file(file, k_largest_bytes);
        std::string_view rest = bytes, stored_key, binary, checksum;
        if (!rest.starts_with(k_magic)) return std::nullopt;
        rest.remove_prefix(k_magic.size());
        if (!take_part(rest, stored_key) || !take_part(rest, binary) || !take_part(rest, checksum)) return std::nullopt;
        if (!rest.empty() || stored_key != bytes_of(key) || checksum != checksum_of(binary)) return std::nullopt;
        fs::last_write_time(file, fs::file_time_type::clock::now(), ec);  // used: among the last to go
        return std::string(binary);
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool ProgramCache::store(const ProgramKey& key, const std::string& binary) const {
    if (folder_.empty() || binary.empty() || binary.size() > k_largest_bytes / 2) return false;
    std::error_code ec;
    fs::create_directories(folder_, ec);
    std::string bytes(k_magic);
    append_part(bytes, bytes_of(key));
    append_part(bytes, binary);
    append_part(bytes, checksum_of(binary));
    try {
        write_file(file_of(key), bytes);
        drop_oldest();
        return true;
    } catch (const Error& failure) {
        log(LogLevel::debug, std::string("Compiled kernels are not kept on disk: ") + failure.what());
        return false;
    }
}

void ProgramCache::remove(const ProgramKey& key) const {
    std::error_code ec;
    if (!folder_.empty()) fs::remove(file_of(key), ec);
}

void ProgramCache::drop_oldest() const {
    std::error_code ec;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (fs::directory_iterator at(folder_, ec), end; !ec && at != end; at.increment(ec)) {
        std::error_code entry_ec;
        const auto time = fs::last_write_time(at->path(), entry_ec);
        const std::string name = at->path().filename().string();
        if (!entry_ec && at->path().extension() == ".bin" && name.size() == 36) files.emplace_back(time, at->path());
    }
    if (files.size() <= k_entries_kept) return;
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + k_entries_kept < files.size(); ++i) fs::remove(files[i].second, ec);
}

}  // namespace lacuna
