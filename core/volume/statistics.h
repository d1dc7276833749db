#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Value statistics of a whole volume, made in one parallel pass (two for f32).
struct VolumeStatistics {
    ValueRange range;                    ///< smallest and largest finite value; {0,0} if there is none
    std::int64_t nan_count = 0;          ///< voxels that are NaN or infinite
    double mean = 0, stddev = 0;         ///< of the finite voxels
    std::vector<std::uint64_t> histogram;///< finite voxels only; bin b covers [lo + b*w, lo + (b+1)*w), the last closed
    ValueRange histogram_range;          ///< lo of the first bin, hi of the last

    double bin_width() const { return histogram.empty() ? 0 : histogram_range.width() / double(histogram.size()); }
    double bin_centre(std::size_t bin) const { return histogram_range.lo + (double(bin) + 0.5) * bin_width(); }
    /// Value below which the given share (0..1) of the finite voxels lies, to a bin's precision.
    double percentile(double share) const;
};

/// Integer types: one bin a value where the range allows (u8/i8 always; u16/i16 up to 65536), so that
/// histogram_range is [lo - 0.5, hi + 0.5]. f32: 4096 bins over the range. Volumes that do not lie in memory are read
/// once (f32: twice), a piece at a time.
VolumeStatistics compute_statistics(const Volume& volume, const JobContext& job = {});

struct VolumePiece;

/// The same, gathered piece by piece (for_each_piece) from a volume that need not lie in memory.
class StatisticsGatherer {
public:
    explicit StatisticsGatherer(VoxelType type);
    ~StatisticsGatherer();
    /// Adds the voxels that belong to this piece alone.
    void add(const VolumePiece& piece);
    /// f32: the range is known only after all pieces; for the histogram they must come a second time.
    bool needs_second_pass() const;
    void begin_second_pass();
    /// @pre all pieces were added, twice where needed
    VolumeStatistics finish() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Otsu's threshold (Otsu 1979: maximises the between-class variance of the histogram): the midpoint between the two
/// class-separating bins; `range.lo` for a constant volume. Ties (empty bins between two peaks) take the middle.
double otsu_threshold(const VolumeStatistics& statistics);

}  // namespace lacuna
