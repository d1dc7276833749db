#include <algorithm>
#include <string>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"
#include "core/regions/run_components.h"

namespace lacuna::labelling {

namespace {

/// Per provisional id: its final id 1..n by descending size, ties by the smaller id; 0 for those too small.
std::vector<std::uint32_t> rank_by_size(const std::vector<std::uint64_t>& voxels, std::int64_t min_voxels,
                                        std::uint32_t& count) {
    std::vector<std::uint32_t> order;
    for (std::size_t id = 0; id < voxels.size(); ++id)
        if (voxels[id] > 0 && voxels[id] >= std::uint64_t(min_voxels)) {
            if (order.size() == k_most_regions) refuse_region_count(min_voxels);
            order.push_back(std::uint32_t(id));
        }
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return voxels[a] != voxels[b] ? voxels[a] > voxels[b] : a < b; });
    std::vector<std::uint32_t> final_id(voxels.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) final_id[order[i]] = std::uint32_t(i) + 1;
    count = std::uint32_t(order.size());
    return final_id;
}

}  // namespace

std::shared_ptr<std::vector<std::uint32_t>> label_components(const Volume& volume, const RegionOptions& options,
                                                             const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    const runs::MarkRow in_range = runs::mark_in_range(volume, *options.threshold);
    const runs::MarkRow eligible = mark_eligible(volume, options);
    const runs::MarkRow both = [&](int y, int z, std::uint8_t* marks) {
        std::vector<std::uint8_t> also(std::size_t(size.x));
        in_range(y, z, marks);
        eligible(y, z, also.data());
        for (int x = 0; x < size.x; ++x) marks[x] &= also[std::size_t(x)];
    };
    const runs::RunList list = runs::find_runs(size, options.gradient_limit ? both : in_range, job.part(0, 0.4));
    const runs::Components components = runs::join(list, options.connectivity, job.part(0.4, 0.6));
    std::uint32_t count = 0;
    const std::vector<std::uint32_t> final_id = rank_by_size(components.voxels, options.min_voxels, count);

    auto labels = std::make_shared<std::vector<std::uint32_t>>(std::size_t(volume.geometry().voxel_count()));
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {
            runs::for_runs(list, int(z), [&](int y, int slice, const runs::Run& run, std::size_t k) {
                const std::uint32_t id = final_id[components.of_run[k]];
                if (id == 0) return;
                std::uint32_t* row = labels->data() + volume.geometry().linear_index(0, y, slice);
                std::fill(row + run.first, row + run.last + 1, id);
            });
        },
        job.part(0.6, 1));
    return labels;
}

void refuse_region_count(std::int64_t min_voxels) {
    throw Error(Errc::bad_usage, "The volume falls into more than " + std::to_string(k_most_regions) +
                                     " regions of at least " + std::to_string(min_voxels) +
                                     " voxels; ask for larger regions (--min-voxels) or a wider range.");
}

std::uint32_t number_by_size(ProvisionalLabels& provisional, std::int64_t min_voxels, const JobContext& job) {
    std::uint32_t count = 0;
    const std::vector<std::uint32_t> final_id = rank_by_size(provisional.voxels, min_voxels, count);
    std::vector<std::uint64_t>().swap(provisional.voxels);
    std::vector<double> mean(provisional.mean.empty() ? 0 : std::size_t(count) + 1, 0.0);
    for (std::size_t id = 1; id < provisional.mean.size(); ++id)
        if (final_id[id] != 0) mean[final_id[id]] = provisional.mean[id];
    provisional.mean = std::move(mean);

    std::vector<std::uint32_t>& labels = *provisional.labels;
    parallel_bands(
        0, std::int64_t(labels.size()), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) {
                const std::uint32_t id = labels[std::size_t(i)];
                if (id != 0) labels[std::size_t(i)] = id == k_never ? 0 : final_id[id];
            }
        },
        job);
    return count;
}

}  // namespace lacuna::labelling
