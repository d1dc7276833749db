#include "core/compute/bands.h"

#include <algorithm>
#include <deque>

#include "core/base/stopwatch.h"
#include "core/compute/device_error.h"

namespace lacuna {

namespace {

constexpr int k_bands_in_flight = 2;  // one runs, one waits: the device never idles, a stop waits for two at most

struct BandInFlight {
    int end_row = 0, granules = 0;
    cl::Event done;
};

/// Granules of the next band, from how long one of `granules` took: at most twice as many, at least one.
int next_granules(int granules, double took_ms, double band_ms) {
    if (took_ms < 0.5 * band_ms) return granules * 2;
    if (took_ms > band_ms) return std::max(1, int(granules * (band_ms / took_ms)));
    return granules;
}

/// Whatever way the caller leaves, the device no longer writes into its buffers.
class FinishAtExit {
public:
    explicit FinishAtExit(cl::CommandQueue& queue) : queue_(queue) {}
    ~FinishAtExit() {
        try {
            queue_.finish();
        } catch (const cl::Error&) {  // the caller is leaving by the exception that matters
        }
    }

private:
    cl::CommandQueue& queue_;
};

}  // namespace

void run_in_bands(ComputeDevice& device, int rows, int granule,
                  const std::function<void(int first, int count, cl::Event& done)>& enqueue, const JobContext& job,
                  double band_ms, int* height) {
    job.check();
    if (rows <= 0) return;
    granule = std::max(granule, 1);
    const FinishAtExit finish(device.queue());
    std::deque<BandInFlight> flight;
    int next_row = 0, granules = std::max(height ? *height : 1, 1);
    Stopwatch since_last;
    const auto wait_for_oldest = [&] {
        const BandInFlight band = flight.front();
        flight.pop_front();
        band.done.wait();
        // Bands run one after the other, so the time between two ends is the later one's own.
        granules = std::min(next_granules(band.granules, since_last.ms(), band_ms), (rows + granule - 1) / granule);
        since_last.restart();
        job.checkpoint(std::size_t(band.end_row), std::size_t(rows));
    };
    with_device_errors("rendering", [&] {
        while (next_row < rows) {
            const int count = std::min(granules * granule, rows - next_row);
            BandInFlight band{next_row + count, (count + granule - 1) / granule, {}};
            enqueue(next_row, count, band.done);
            device.queue().flush();
            next_row += count;
            flight.push_back(std::move(band));
            if (int(flight.size()) == k_bands_in_flight) wait_for_oldest();
        }
        while (!flight.empty()) wait_for_oldest();
    });
    if (!height) return;
    const bool all_at_once = granules * granule >= rows;  // the call was too small to tell how high a band could be
    *height = all_at_once ? std::max(*height, granules) : granules;
}

}  // namespace lacuna
