#include "core/accel/voxel_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr int k_entries = 65536;
constexpr double k_most_angle_cells = 1e9;  // along an edge of the cube: six faces of them have 64 bit numbers

/// The step of the threshold that opacity and colour fall into; invisible values have one of their own.
std::array<int, 4> steps_of(const ColorOpacity& at, double threshold) {
    if (!(at.opacity > 0)) return {-1, 0, 0, 0};
    const auto step = [&](double v) { return int(std::floor(std::min(v / threshold, 1e9))); };
    return {step(at.opacity), step(at.color.r), step(at.color.g), step(at.color.b)};
}

/// Regions of the cells of one volume.
template <class T>
class Labeller {
public:
    Labeller(const Volume& volume, const VoxelRules& rules)
        : view_(volume.view<T>()), spacing_(volume.geometry().spacing), rules_(rules) {}

    void label_slice(int z, std::uint8_t* out) const {
        const glm::ivec3 n = view_.size;
        std::vector<T> least(std::size_t(n.x) + 1), most(least.size());
        std::vector<std::uint8_t> bad(least.size());
        for (int y = 0; y < n.y; ++y, out += n.x) {
            reduce_rows(y, z, least.data(), most.data(), bad.data());
            const double nothing = std::numeric_limits<double>::quiet_NaN();
            double lo = nothing, hi = nothing;
            std::uint8_t label = 0;
            bool was_bad = false;
            for (int x = 0; x < n.x; ++x) {
                const auto at = std::size_t(x);
                const double a = double(std::min(least[at], least[at + 1]));
                const double b = double(std::max(most[at], most[at + 1]));
                const bool holds_bad = bad[at] || bad[at + 1];
                if (!(a == lo && b == hi && holds_bad == was_bad)) {
                    lo = a, hi = b, was_bad = holds_bad;
                    label = label_of(lo, hi, holds_bad);
                }
                const bool checked = label == 2 && rules_.second == VoxelRules::Second::homogeneous && rules_.gradients;
                out[x] = checked && !alike_gradients({x, y, z}) ? std::uint8_t(0) : label;
            }
        }
    }

private:
    /// Extremes over the two rows and slices of the cells of row (y, z), for each voxel of the row and one behind it.
    void reduce_rows(int y, int z, T* least, T* most, std::uint8_t* bad) const {
        const glm::ivec3 n = view_.size;
        const int y1 = std::min(y + 1, n.y - 1), z1 = std::min(z + 1, n.z - 1);
        const T* rows[4] = {view_.row(y, z), view_.row(y1, z), view_.row(y, z1), view_.row(y1, z1)};
        for (int x = 0; x < n.x; ++x) {
            if constexpr (std::is_floating_point_v<T>) {
                T lo = std::numeric_limits<T>::infinity(), hi = -lo;
                bad[x] = 0;
                for (const T* row : rows) {
                    const bool finite = std::isfinite(row[x]);
                    bad[x] = std::uint8_t(bad[x] | !finite);
                    lo = finite ? std::min(lo, row[x]) : lo;
                    hi = finite ? std::max(hi, row[x]) : hi;
                }
                least[x] = lo, most[x] = hi;
            } else {
                least[x] = std::min(std::min(rows[0][x], rows[1][x]), std::min(rows[2][x], rows[3][x]));
                most[x] = std::max(std::max(rows[0][x], rows[1][x]), std::max(rows[2][x], rows[3][x]));
            }
        }
        least[n.x] = least[n.x - 1], most[n.x] = most[n.x - 1], bad[n.x] = bad[n.x - 1];
    }

    std::uint8_t label_of(double lo, double hi, bool bad) const {
        using Answer = VisibilityTable::Answer;
        using Second = VoxelRules::Second;
        if (lo > hi) return 1;  // nothing but NaN
        const Answer answer = rules_.visible.query({lo - rules_.slack, hi + rules_.slack});
        if (answer == Answer::none) return 1;
        if (rules_.second == Second::busy) return 2;
        if (bad) return 0;
        if (rules_.second == Second::all_visible) return answer == Answer::all ? 2 : 0;
        return rules_.alike->alike(lo, hi) ? 2 : 0;
    }

    /// Central differences at a voxel, per mm; indices clamped to the grid as the kernels do.
    glm::dvec3 gradient(glm::ivec3 p) const {
        glm::dvec3 g;
        for (int a = 0; a < 3; ++a) {
            glm::ivec3 before = p, behind = p;
            before[a] = std::max(p[a] - 1, 0);
            behind[a] = std::min(p[a] + 1, view_.size[a] - 1);
            g[a] = (double(view_(behind.x, behind.y, behind.z)) - double(view_(before.x, before.y, before.z))) /
                   spacing_[a];
        }
        return g;
    }

    /// A number that gradients of about one direction share: a cell on the faces of a cube, at most angle_deg wide.
    /// 0: no gradient. -1: none that others share.
    std::int64_t direction(const glm::dvec3& g) const {
        const glm::dvec3 size = glm::abs(g);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        if (size[axis] == 0) return 0;
        if (!(size[axis] > 0) || !(rules_.angle_deg > 0)) return -1;
        const double cells = std::ceil(90 * std::numbers::sqrt2 / rules_.angle_deg);
        if (!(cells <= k_most_angle_cells)) return -1;
        const auto cell = [&](int other) {
            const double angle = std::atan(g[other] / size[axis]) / (std::numbers::pi / 2) + 0.5;
            return std::int64_t(std::clamp(std::floor(angle * cells), 0.0, cells - 1));
        };
        const int face = 2 * axis + (g[axis] < 0);
        return 1 + face + 6 * (cell((axis + 1) % 3) + std::int64_t(cells) * cell((axis + 2) % 3));
    }

    bool alike_gradients(glm::ivec3 c) const {
        if (rules_.angle_deg >= 180) return true;
        std::int64_t first = -1;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 p = glm::min(c + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), view_.size - 1);
            const std::int64_t towards = direction(gradient(p));
            if (towards < 0 || (corner > 0 && towards != first)) return false;
            first = towards;
        }
        return true;
    }

    VolumeView<T> view_;
    glm::dvec3 spacing_;
    const VoxelRules& rules_;
};

}  // namespace

HomogeneityTable::HomogeneityTable(const Classification& classification, ValueRange values, double threshold)
    : values_(values) {
    if (!(threshold > 0)) return;
    entries_per_unit_ = values.width() > 0 ? (k_entries - 1) / values.width() : 0;
    changes_.resize(k_entries);
    std::array<int, 4> before{};
    for (int i = 0; i < k_entries; ++i) {
        const double value = entries_per_unit_ > 0 ? values.lo + i / entries_per_unit_ : values.lo;
        const std::array<int, 4> now = steps_of(classification.at(value), threshold);
        // What shapes show also depends on the gradient: no two values they show are alike.
        const bool shaped = now[0] >= 0 && classification.function_of(value).is_2d();
        changes_[std::size_t(i)] = i == 0 ? 0 : changes_[std::size_t(i) - 1] + (shaped || now != before);
        before = now;
    }
}

bool HomogeneityTable::alike(double lo, double hi) const {
    if (lo == hi) return true;
    if (changes_.empty()) return false;
    const auto entry = [&](double v) { return std::size_t(std::clamp(v, 0.0, double(k_entries - 1))); };
    return changes_[entry(std::floor((lo - values_.lo) * entries_per_unit_))] ==
           changes_[entry(std::ceil((hi - values_.lo) * entries_per_unit_))];
}

RegionGrid voxel_regions(const Volume& volume, const VoxelRules& rules, const JobContext& job) {
    const glm::ivec3 n = volume.geometry().size;
    const std::size_t slice = std::size_t(n.x) * std::size_t(n.y);
    RegionGrid grid{n, std::vector<std::uint8_t>(slice * std::size_t(n.z))};
    visit_type(volume.type(), [&](auto tag) {
        const Labeller<decltype(tag)> labeller(volume, rules);
        parallel_for(
            0, n.z, [&](std::int64_t z) { labeller.label_slice(int(z), grid.region.data() + std::size_t(z) * slice); },
            job);
    });
    return grid;
}

}  // namespace lacuna
