#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"

namespace lacuna::labelling {

namespace {

/// Squared gradient by central differences, one-sided at the border, per mm; an axis of one voxel has none.
template <class T>
double squared_gradient(const VolumeView<T>& view, const glm::dvec3& spacing, const glm::ivec3& p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (view.size[axis] == 1) continue;
        glm::ivec3 low = p, high = p;
        low[axis] = std::max(0, p[axis] - 1);
        high[axis] = std::min(view.size[axis] - 1, p[axis] + 1);
        const double slope = (double(view(high.x, high.y, high.z)) - double(view(low.x, low.y, low.z))) /
                             (spacing[axis] * (high[axis] - low[axis]));
        sum += slope * slope;
    }
    return sum;
}

/// A face between a sliver and a region.
struct Contact {
    std::uint32_t sliver, region;
    friend bool operator<(const Contact& a, const Contact& b) {
        return a.sliver != b.sliver ? a.sliver < b.sliver : a.region < b.region;
    }
    friend bool operator==(const Contact&, const Contact&) = default;
};

/// Per sliver the region it shares most faces with; 0 if none.
std::vector<std::uint32_t> best_neighbours(std::vector<Contact>& contacts, std::uint32_t slivers) {
    std::sort(contacts.begin(), contacts.end());
    std::vector<std::uint32_t> best(slivers, 0);
    std::vector<std::size_t> most(slivers, 0);
    for (std::size_t i = 0; i < contacts.size();) {
        std::size_t end = i;
        while (end < contacts.size() && contacts[end] == contacts[i]) ++end;
        if (end - i > most[contacts[i].sliver])
            most[contacts[i].sliver] = end - i, best[contacts[i].sliver] = contacts[i].region;
        i = end;
    }
    return best;
}

}  // namespace

runs::MarkRow mark_eligible(const Volume& volume, const RegionOptions& options) {
    const glm::dvec3 spacing = volume.geometry().spacing;
    const std::optional<ValueRange> background = options.range_width ? options.background : std::nullopt;
    const std::optional<double> limit = options.gradient_limit;
    return visit_type(volume.type(), [&](auto tag) -> runs::MarkRow {
        using T = decltype(tag);
        const VolumeView<T> view = volume.view<T>();
        return [=](int y, int z, std::uint8_t* marks) {
            const T* row = view.row(y, z);
            for (int x = 0; x < view.size.x; ++x) {
                const double v = double(row[x]);
                marks[x] = std::isfinite(v) && !(background && background->contains(v)) &&
                           (!limit || squared_gradient(view, spacing, {x, y, z}) <= *limit * *limit);
            }
        };
    });
}

void merge_slivers(const Volume& volume, const RegionOptions& options, std::vector<std::uint32_t>& labels,
                   const JobContext& job) {
    const GridGeometry& g = volume.geometry();
    // What the gradient or the range kept out is a sliver too; background and NaN stay what they are.
    RegionOptions only_background;
    only_background.range_width = options.range_width, only_background.background = options.background;
    const runs::MarkRow eligible = mark_eligible(volume, only_background);
    const runs::RunList left = runs::find_runs(
        g.size,
        [&](int y, int z, std::uint8_t* marks) {
            eligible(y, z, marks);
            const std::uint32_t* row = labels.data() + g.linear_index(0, y, z);
            for (int x = 0; x < g.size.x; ++x) marks[x] &= std::uint8_t(row[x] == 0);
        },
        job.part(0, 0.3));
    const runs::Components pieces = runs::join(left, Connectivity::c6, job.part(0.3, 0.4));
    const auto is_sliver = [&](std::size_t run) {
        return pieces.voxels[pieces.of_run[run]] < std::uint64_t(options.min_voxels);
    };
    std::vector<Contact> contacts;
    const std::int64_t step[3] = {1, g.size.x, std::int64_t(g.size.x) * g.size.y};
    for (int z = 0; z < g.size.z; ++z) {
        runs::for_runs(left, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            if (!is_sliver(k)) return;
            for (int x = run.first; x <= run.last; ++x) {
                const glm::ivec3 p(x, y, at_z);
                const std::int64_t i = g.linear_index(x, y, at_z);
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {-1, 1}) {
                        if (p[axis] + side < 0 || p[axis] + side >= g.size[axis]) continue;
                        if (const std::uint32_t id = labels[std::size_t(i + side * step[axis])])
                            contacts.push_back({pieces.of_run[k], id});
                    }
            }
        });
        job.part(0.4, 0.7).checkpoint(std::size_t(z) + 1, std::size_t(g.size.z));
    }
    const std::vector<std::uint32_t> best = best_neighbours(contacts, pieces.count());
    for (int z = 0; z < g.size.z; ++z)
        runs::for_runs(left, z, [&](int y, int at_z, const runs::Run& run, std::size_t k) {
            std::uint32_t* row = labels.data() + g.linear_index(0, y, at_z);
            if (is_sliver(k)) std::fill(row + run.first, row + run.last + 1, best[pieces.of_run[k]]);
        });

    ProvisionalLabels grown;  // the same labels, ranked once more
    grown.voxels.assign(std::size_t(*std::max_element(labels.begin(), labels.end())) + 1, 0);
    for (const std::uint32_t id : labels)
        if (id != 0) ++grown.voxels[id];
    grown.labels = std::make_shared<std::vector<std::uint32_t>>(std::move(labels));
    number_by_size(grown, 1, job.part(0.7, 1));
    labels = std::move(*grown.labels);
}

}  // namespace lacuna::labelling
