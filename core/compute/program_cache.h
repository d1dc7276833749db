#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/compute/program.h"

namespace lacuna {

/// Compiled programs on disk, one file a key. Nothing here throws: what cannot be read is absent, what cannot be
/// written is not kept. A file holds its whole key, so equal hashes of unequal keys do no harm. Several processes may
/// share a folder: files appear whole or not at all.
class ProgramCache {
public:
    static constexpr std::size_t k_entries_kept = 64;  ///< the newest; older files go as new ones are stored

    /// @param folder made when first needed; empty: nothing is kept
    explicit ProgramCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// LACUNA_CACHE (set but empty: keep nothing), else $XDG_CACHE_HOME/lacuna/kernels, else ~/.cache/lacuna/kernels;
    /// empty when none is known.
    static std::filesystem::path default_folder();

    bool enabled() const { return !folder_.empty(); }
    /// The binary stored for exactly this key; none when absent, damaged, or another key's.
    std::optional<std::string> load(const ProgramKey& key) const;
    /// Keeps a binary. @return whether it was written
    bool store(const ProgramKey& key, const std::string& binary) const;
    /// Forgets a binary, e.g. one the driver would not take.
    void remove(const ProgramKey& key) const;
    /// The file of a key: 32 hexadecimal digits of a hash over every part of it, ".bin".
    std::filesystem::path file_of(const ProgramKey& key) const;

private:
    void drop_oldest() const;
    std::filesystem::path folder_;
};

}  // namespace lacuna
