#include <algorithm>
#include <limits>
#include <string>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"
#include "core/regions/neighbourhood.h"

namespace lacuna::labelling {

namespace {

/// Disjoint sets of ids whose root is always the smallest id.
class IdSets {
public:
    std::uint32_t find(std::uint32_t id) {
        while (root_[id] != id) id = root_[id] = root_[root_[id]];
        return id;
    }
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        if (b < a) std::swap(a, b);
        root_[b] = a;
        return a;
    }
    std::uint32_t add() {
        root_.push_back(std::uint32_t(root_.size()));
        return root_.back();
    }
    std::vector<std::uint32_t> take() { return std::move(root_); }

private:
    std::vector<std::uint32_t> root_;
};

struct EarlierRow {
    int dy, dz, reach;
};

/// Labels the runs of one row of marks (1 inside, 0 outside), given that all earlier rows carry ids.
void label_row(std::uint32_t* row, int y, int z, const glm::ivec3& size, const std::vector<EarlierRow>& earlier,
               IdSets& sets, std::vector<std::uint64_t>& voxels) {
    for (int x = 0; x < size.x; ++x) {
        if (row[x] == 0) continue;
        const int first = x;
        while (x + 1 < size.x && row[x + 1] != 0) ++x;
        std::uint32_t id = 0;
        for (const EarlierRow& e : earlier) {
            if (y + e.dy < 0 || y + e.dy >= size.y || z + e.dz < 0) continue;
            const std::uint32_t* other = row + (std::int64_t(e.dz) * size.y + e.dy) * size.x;
            const int end = std::min(size.x - 1, x + e.reach);
            std::uint32_t seen = 0;
            for (int k = std::max(0, first - e.reach); k <= end; ++k) {
                if (other[k] == 0 || other[k] == seen) continue;
                seen = other[k];
                id = id ? sets.unite(id, seen) : sets.find(seen);
            }
        }
        if (!id) {
            id = sets.add();
            voxels.push_back(0);
        }
        std::fill(row + first, row + x + 1, id);
        voxels[id] += std::uint64_t(x - first + 1);
    }
}

void mark_range(const Volume& volume, const ValueRange& range, std::vector<std::uint32_t>& labels,
                const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    const std::int64_t slice = std::int64_t(size.x) * size.y;
    constexpr double k_finite = std::numeric_limits<double>::max();  // an open range still leaves infinite voxels out
    const double lo = std::max(range.lo, -k_finite), hi = std::min(range.hi, k_finite);
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const T* values = volume.view<T>().data;
        parallel_for(
            0, size.z,
            [&](std::int64_t z) {
                for (std::int64_t i = z * slice; i < (z + 1) * slice; ++i)
                    labels[std::size_t(i)] = double(values[i]) >= lo && double(values[i]) <= hi;
            },
            job);
    });
}

}  // namespace

ProvisionalLabels label_components(const Volume& volume, const ValueRange& range, Connectivity connectivity,
                                   const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    ProvisionalLabels result;
    result.labels = std::make_shared<std::vector<std::uint32_t>>(std::size_t(volume.geometry().voxel_count()));
    result.voxels.push_back(0);
    mark_range(volume, range, *result.labels, job.part(0, 0.3));

    std::vector<EarlierRow> earlier;
    for (const auto& [dy, dz] : {std::pair{-1, -1}, {0, -1}, {1, -1}, {-1, 0}})
        if (const int reach = neighbourhood::reach_along_x(connectivity, dy, dz); reach >= 0)
            earlier.push_back({dy, dz, reach});

    IdSets sets;
    sets.add();  // 0: background
    const JobContext joining = job.part(0.3, 1);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y)
            label_row(result.labels->data() + (std::int64_t(z) * size.y + y) * size.x, y, z, size, earlier, sets,
                      result.voxels);
        joining.checkpoint(std::size_t(z) + 1, std::size_t(size.z));
    }

    result.root = sets.take();
    for (std::size_t id = 1; id < result.root.size(); ++id) {  // a root is smaller than its ids: one pass flattens
        result.root[id] = result.root[result.root[id]];
        if (result.root[id] == id) continue;
        result.voxels[result.root[id]] += result.voxels[id];
        result.voxels[id] = 0;
    }
    return result;
}

void refuse_region_count(std::int64_t min_voxels) {
    throw Error(Errc::bad_usage, "The volume falls into more than " + std::to_string(k_most_regions) +
                                     " regions of at least " + std::to_string(min_voxels) +
                                     " voxels; ask for larger regions (--min-voxels) or a wider range.");
}

std::uint32_t number_by_size(ProvisionalLabels& provisional, std::int64_t min_voxels, const JobContext& job) {
    std::vector<std::uint64_t>& voxels = provisional.voxels;
    std::vector<std::uint32_t> order;
    for (std::size_t id = 1; id < voxels.size(); ++id)
        if (voxels[id] > 0 && voxels[id] >= std::uint64_t(min_voxels)) {
            if (order.size() == k_most_regions) refuse_region_count(min_voxels);
            order.push_back(std::uint32_t(id));
        }
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return voxels[a] != voxels[b] ? voxels[a] > voxels[b] : a < b; });

    std::vector<std::uint32_t> final_id(voxels.size(), 0);
    std::vector<std::uint64_t>().swap(voxels);
    for (std::size_t i = 0; i < order.size(); ++i) final_id[order[i]] = std::uint32_t(i) + 1;
    if (!provisional.root.empty())
        for (std::size_t id = 1; id < final_id.size(); ++id) final_id[id] = final_id[provisional.root[id]];
    std::vector<std::uint32_t>().swap(provisional.root);

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
    return std::uint32_t(order.size());
}

}  // namespace lacuna::labelling
