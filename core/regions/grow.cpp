#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"
#include "core/regions/neighbourhood.h"

namespace lacuna::labelling {

namespace {

/// A label a voxel, all 0. Huge pages, and all threads take them from the system: first touch by one is otherwise a
/// good part of a second at 512^3.
std::shared_ptr<std::vector<std::uint32_t>> fresh_labels(std::size_t voxels) {
    auto labels = std::make_shared<std::vector<std::uint32_t>>();
    labels->reserve(voxels);
    constexpr std::size_t k_huge_page = std::size_t(2) << 20;
    const std::size_t begin = (reinterpret_cast<std::size_t>(labels->data()) + k_huge_page - 1) / k_huge_page;
    const std::size_t end = (reinterpret_cast<std::size_t>(labels->data()) + voxels * 4) / k_huge_page;
    if (end > begin) {
        ::madvise(reinterpret_cast<void*>(begin * k_huge_page), (end - begin) * k_huge_page, MADV_HUGEPAGE);
        constexpr std::size_t k_page = 4096;  // what a touch takes where there are no huge ones
        parallel_bands(std::int64_t(begin), std::int64_t(end), 8 * thread_count(),
                       [&](std::int64_t first, std::int64_t last) {
                           auto* const memory = reinterpret_cast<volatile char*>(first * std::int64_t(k_huge_page));
                           for (std::size_t at = 0; at < std::size_t(last - first) * k_huge_page; at += k_page)
                               memory[at] = 0;
                       });
    }
    labels->resize(voxels, 0);
    return labels;
}

/// First x in [x, last] without a label, or one behind. Most voxels looked at are long labelled: sixteen at a time.
int next_free(const std::uint32_t* labels, int x, int last) {
    for (; x + 16 <= last + 1; x += 16) {
        int taken = 0;
        for (int i = 0; i < 16; ++i) taken += labels[x + i] != 0;
        if (taken < 16) break;
    }
    while (x <= last && labels[x] != 0) ++x;
    return x;
}

/// A stretch of one row, both ends included.
struct Segment {
    std::int32_t y, z, first, last;
};

/// First in, first out, in one block that is used over and over.
class SegmentQueue {
public:
    void clear() { items_.clear(), head_ = 0; }
    bool empty() const { return head_ == items_.size(); }
    Segment pop() { return items_[head_++]; }
    void push(const Segment& segment) {
        // Reuses the consumed front before growing: memory follows the front of the fill, not its history.
        if (items_.size() == items_.capacity() && head_ > items_.size() / 2) {
            items_.erase(items_.begin(), items_.begin() + std::ptrdiff_t(head_));
            head_ = 0;
        }
        items_.push_back(segment);
    }

private:
    std::vector<Segment> items_;
    std::size_t head_ = 0;
};

template <class T>
class Grower {
public:
    using Wide = std::conditional_t<std::is_integral_v<T>, std::int32_t, double>;
    using Sum = std::conditional_t<std::is_integral_v<T>, std::int64_t, double>;

    Grower(const Volume& volume, std::vector<std::uint32_t>& labels, double width, Connectivity connectivity,
           std::int64_t min_voxels, const JobContext& job)
        : values_(volume.view<T>().data),
          labels_(labels.data()),
          size_(volume.geometry().size),
          width_(whole_width(width)),
          min_voxels_(min_voxels),
          job_(job) {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const int reach = neighbourhood::reach_along_x(connectivity, dy, dz);
                if ((dy != 0 || dz != 0) && reach >= 0) neighbours_.push_back({dy, dz, reach});
            }
    }

    void grow_all(std::vector<std::uint64_t>& voxels, std::vector<double>& mean) {
        voxels.assign(1, 0);
        mean.assign(1, 0);
        for (int z = 0; z < size_.z; ++z) {
            job_.check();
            for (int y = 0; y < size_.y; ++y) {
                const std::uint32_t* row = labels_ + row_start(y, z);
                for (int x = 0; x < size_.x; ++x) {
                    if (row[x] != 0) continue;
                    id_ = std::uint32_t(voxels.size());
                    grow_from(x, y, z);
                    if (count_ < min_voxels_) {
                        give_back();
                        continue;
                    }
                    if (voxels.size() > k_most_regions) refuse_region_count(min_voxels_);
                    voxels.push_back(std::uint64_t(count_));
                    mean.push_back(double(sum_) / double(count_));
                }
            }
        }
    }

private:
    struct RowNeighbour {
        int dy, dz, reach;
    };

    static Wide whole_width(double width) {
        if constexpr (std::is_integral_v<T>) return Wide(std::floor(width + 1e-6));  // 0.29 * 100 means 29
        return Wide(width);
    }

    std::int64_t row_start(int y, int z) const { return (std::int64_t(z) * size_.y + y) * size_.x; }

    // False for NaN. Infinite values fail too: a region starts at a finite value and its width is finite.
    bool fits(std::uint32_t label, T value) const {
        // One branch instead of three: on noise each would be mispredicted on its own.
        return bool(int(label == 0) & int(Wide(value) >= admit_low_) & int(Wide(value) <= admit_high_));
    }

    void admit(Wide value) {
        sum_ += value;
        if (value < low_) low_ = value, admit_high_ = low_ + width_;
        if (value > high_) high_ = value, admit_low_ = high_ - width_;
    }

    void grow_from(int x, int y, int z) {
        low_ = high_ = Wide(values_[row_start(y, z) + x]);
        admit_low_ = high_ - width_;
        admit_high_ = low_ + width_;
        count_ = 0;
        sum_ = 0;
        claimed_.clear();
        queue_.clear();
        claim(y, z, x, x);
        while (!queue_.empty()) {
            const Segment front = queue_.pop();
            for (const RowNeighbour& n : neighbours_) {
                const int row_y = front.y + n.dy, row_z = front.z + n.dz;
                if (row_y < 0 || row_z < 0 || row_y >= size_.y || row_z >= size_.z) continue;
                claim(row_y, row_z, std::max(0, front.first - n.reach), std::min(size_.x - 1, front.last + n.reach));
            }
        }
    }

    /// Claims what fits of a stretch, and what follows from it to either side; each piece joins the queue once.
    void claim(int y, int z, int first, int last) {
        const std::int64_t start = row_start(y, z);
        const T* values = values_ + start;
        std::uint32_t* labels = labels_ + start;
        for (int x = next_free(labels, first, last); x <= last; x = next_free(labels, x + 1, last)) {
            if (!fits(labels[x], values[x])) continue;
            int begin = x;
            for (; x < size_.x && fits(labels[x], values[x]); ++x) {
                labels[x] = id_;
                admit(values[x]);
            }
            if (begin == first)  // further right, the voxel before was refused just now
                for (; begin > 0 && fits(labels[begin - 1], values[begin - 1]); --begin) {
                    labels[begin - 1] = id_;
                    admit(values[begin - 1]);
                }
            note({y, z, begin, x - 1});
        }
    }

    void note(const Segment& claimed) {
        queue_.push(claimed);
        if (count_ < min_voxels_) claimed_.push_back(claimed);
        const int length = claimed.last - claimed.first + 1;
        count_ += length;
        since_check_ += length;
        if (since_check_ <= 1'000'000) return;
        done_ += since_check_;
        since_check_ = 0;
        job_.checkpoint(std::size_t(done_), std::size_t(row_start(0, size_.z)));
    }

    void give_back() {
        for (const Segment& s : claimed_) {
            std::uint32_t* row = labels_ + row_start(s.y, s.z);
            std::fill(row + s.first, row + s.last + 1, k_never);
        }
    }

    const T* values_;
    std::uint32_t* labels_;
    glm::ivec3 size_;
    Wide width_, low_{}, high_{}, admit_low_{}, admit_high_{};
    std::int64_t min_voxels_, count_ = 0, since_check_ = 0, done_ = 0;
    Sum sum_ = 0;
    std::uint32_t id_ = 0;
    std::vector<RowNeighbour> neighbours_;
    SegmentQueue queue_;
    std::vector<Segment> claimed_;  // of the region at hand, until it is large enough to stay
    const JobContext& job_;
};

}  // namespace

ProvisionalLabels grow_regions(const Volume& volume, double width, const RegionOptions& options,
                               const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    ProvisionalLabels result;
    result.labels = fresh_labels(std::size_t(volume.geometry().voxel_count()));
    if (volume.type() == VoxelType::f32 || options.background || options.gradient_limit) {
        const runs::MarkRow eligible = mark_eligible(volume, options);
        parallel_for(
            0, size.z,
            [&](std::int64_t z) {
                std::vector<std::uint8_t> marks(std::size_t(size.x));
                for (int y = 0; y < size.y; ++y) {
                    eligible(y, int(z), marks.data());
                    std::uint32_t* row = result.labels->data() + volume.geometry().linear_index(0, y, int(z));
                    for (int x = 0; x < size.x; ++x)
                        if (!marks[std::size_t(x)]) row[x] = k_never;
                }
            },
            job.part(0, 0.05));
    }
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const JobContext growing = job.part(0.05, 1);
        Grower<T>(volume, *result.labels, width, options.connectivity, options.min_voxels, growing)
            .grow_all(result.voxels, result.mean);
    });
    return result;
}

}  // namespace lacuna::labelling
