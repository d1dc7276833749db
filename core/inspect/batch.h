#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/inspect/report.h"
#include "core/io/volume_reader.h"

namespace lacuna {

class ComputeDevice;

/// One component of a series.
struct BatchPart {
    std::string name;   ///< unique in the series; also the name of its report folder
    std::string input;  ///< as open_volume takes it
};

/// What a series is made of: each sub-folder and each volume file of a folder is a component, each line of a list file
/// (# starts a comment, relative names count from the list's folder), and a volume file or sample by itself. Sorted by
/// name within a folder; hidden entries and `leave_out` are passed over.
/// @throws Error(bad_input) for a name that is not there, or a series without a part
std::vector<BatchPart> find_parts(const std::vector<std::string>& inputs, const std::filesystem::path& leave_out = {});

/// What a series knows of a finished part.
struct BatchRow {
    std::string name, input;
    std::optional<Verdict> verdict;  ///< none: the part is broken
    std::string reason;              ///< of the verdict, or why the part could not be inspected
    std::string sha256;
    std::vector<std::pair<std::string, Measured>> values;  ///< characteristics, by name with unit
    std::vector<std::string> more_reasons = {};            ///< of the verdict, beyond the first
};

/// All of a row's reasons, a sentence each, the first one first.
std::vector<std::string> reasons_of(const BatchRow& row);

/// The characteristics of a part that a series compares.
BatchRow row_of(const BatchPart& part, const InspectionReport& report);

enum class PartState { waiting, running, done, broken };

struct BatchOptions {
    std::filesystem::path folder;  ///< of the series' reports
    Criteria criteria;
    OpenOptions open;                ///< how to open every part
    std::string reference;           ///< input of the reference component; empty: none
    int jobs = 1;                    ///< parts at once, at most
    std::uint64_t memory_bytes = 0;  ///< what all parts at once may use
    bool resume = false;             ///< go on with the series that stands in `folder`
    int shard = 1, shards = 1;       ///< inspects part i where i % shards == shard - 1
    int worst = 10;                  ///< defects that get pictures, a part
    std::string software;
    std::shared_ptr<ComputeDevice> device;
    /// Called from worker threads whenever a part's state or progress (0..1) changes; may block to pause the series.
    std::function<void(std::size_t part, PartState state, double progress)> on_part;
};

struct BatchResult {
    std::vector<BatchRow> rows;  ///< of the parts of this shard, in the series' order
    std::optional<BatchRow> reference;
    bool whole = false;  ///< every part of the series is done, and the summary was written
};

/// Inspects a series: one report folder a part in `folder`, a journal entry written atomically after each, and, when
/// every part is done, summary.csv and summary.html. A part that cannot be read or inspected is a row with its reason.
/// Inputs are looked at before the first part starts. Parts run at once only while their memory, by size, fits.
/// Killed at any moment and resumed, the summary is the same, byte for byte.
/// @throws Error(bad_usage) for options out of range; Error(io) if the folder cannot be written or holds another
/// series; Error(cancelled), after which the series can be resumed
BatchResult run_batch(const std::vector<BatchPart>& parts, const BatchOptions& options, const JobContext& job = {});

/// Makes the summary of a series whose shards are all done. @throws Error(bad_input) naming the parts not done
BatchResult merge_batch(const std::filesystem::path& folder);

/// Bytes inspecting a volume of this many voxels takes, the volume included.
std::uint64_t inspection_bytes(std::uint64_t voxels, int bytes_per_voxel);

/// One characteristic over a series.
struct SeriesStatistics {
    std::string name;
    double median = 0, mad = 0;  ///< median and median absolute deviation of the parts that have it
    std::optional<double> reference;
    std::vector<double> deviation;  ///< of each part from the reference; NaN where either is missing
    std::vector<double> z;          ///< robust z-score (Iglewicz & Hoaglin 1993)
    std::vector<bool> outlier;      ///< |z| > 3.5
};

/// @return one entry a characteristic that any row has, in the rows' order. Cost: rows x characteristics
std::vector<SeriesStatistics> compare_series(const std::vector<BatchRow>& rows,
                                             const std::optional<BatchRow>& reference);

std::string summary_csv(const std::vector<BatchRow>& rows, const std::optional<BatchRow>& reference);
std::string summary_html(const std::vector<BatchRow>& rows, const std::optional<BatchRow>& reference,
                         const Criteria& criteria, const std::string& software);

}  // namespace lacuna
