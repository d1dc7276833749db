#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/inspect/batch.h"

namespace lacuna {

/// What a series has done so far, one small file a part in FOLDER/journal, each written atomically; and
/// FOLDER/series.json, which says what the series consists of, so that it is never mixed with another.
class BatchJournal {
public:
    explicit BatchJournal(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Starts a series, or goes on with the one that stands there if it is the same and `resume` says so. Shards of one
    /// series may start at the same time.
    /// @throws Error(io) if the folder cannot be made, or holds something else
    void open(const std::vector<BatchPart>& parts, const BatchOptions& options);
    /// What open() wrote. @throws Error(bad_input) if no series stands there
    void read_series(std::vector<BatchPart>& parts, BatchOptions& options) const;

    /// What a run of one shard holds while it fills the folder.
    std::filesystem::path lock_file(int shard) const {
        return folder_ / "journal" / ("shard-" + std::to_string(shard) + ".lock");
    }

    /// None while the part is not done.
    std::optional<BatchRow> read(const std::string& part) const;
    void write(const BatchRow& row) const;
    void forget(const std::string& part) const;

private:
    std::filesystem::path entry(const std::string& part) const { return folder_ / "journal" / (part + ".json"); }
    std::filesystem::path folder_;
};

}  // namespace lacuna
