#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/criteria.h"
#include "core/io/volume_reader.h"

namespace lacuna {

namespace {

[[noreturn]] void refuse(const Zone& zone, const std::string& what) {
    throw Error(Errc::bad_input, fmt::format("Zone {} ({}) {}.", zone.name, zone.is_box ? "box_mm" : "labels", what));
}

bool same_grid(const GridGeometry& a, const GridGeometry& b) {
    if (a.size != b.size) return false;
    // The farthest voxel centre decides: what spacing and direction differ by adds up there.
    const double tolerance = 0.01 * b.smallest_spacing_mm();
    const glm::dvec3 last(a.size - 1);
    const glm::dvec3 ends[] = {{0, 0, 0}, {last.x, 0, 0}, {0, last.y, 0}, {0, 0, last.z}, last};
    return std::all_of(std::begin(ends), std::end(ends), [&](const glm::dvec3& voxel) {
        return glm::length(a.voxel_to_mm(voxel) - b.voxel_to_mm(voxel)) <= tolerance;
    });
}

}  // namespace

ZoneMask::ZoneMask(const Zone& zone, const GridGeometry& geometry, const JobContext& job)
    : geometry_(geometry), is_box_(zone.is_box) {
    if (zone.is_box)
        lay_box(zone);
    else
        read_labels(zone, job);
}

void ZoneMask::lay_box(const Zone& zone) {
    min_ = zone.box_min_mm;
    max_ = zone.box_max_mm;
    // The voxel box around the corners; on an oblique grid it holds voxels outside the zone, which contains() leaves
    // out.
    glm::dvec3 lo(INFINITY), hi(-INFINITY);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 mm(corner & 1 ? max_.x : min_.x, corner & 2 ? max_.y : min_.y, corner & 4 ? max_.z : min_.z);
        const glm::dvec3 voxel = geometry_.mm_to_voxel(mm);
        lo = glm::min(lo, voxel);
        hi = glm::max(hi, voxel);
    }
    const glm::dvec3 end = glm::dvec3(geometry_.size) - 0.5;
    constexpr double k_slack = 1e-6;  // a zone that ends on the volume's face ends inside
    for (int axis = 0; axis < 3; ++axis)
        reaches_out_ = reaches_out_ || lo[axis] < -0.5 - k_slack || hi[axis] > end[axis] + k_slack;
    first_ = glm::ivec3(glm::clamp(glm::ceil(lo - k_slack), glm::dvec3(0), glm::dvec3(geometry_.size)));
    last_ = glm::ivec3(glm::clamp(glm::floor(hi + k_slack), glm::dvec3(-1), glm::dvec3(geometry_.size - 1)));
    bool any = false;
    for (int z = first_.z; z <= last_.z && !any; ++z)
        for (int y = first_.y; y <= last_.y && !any; ++y)
            for (int x = first_.x; x <= last_.x && !any; ++x) any = contains(x, y, z);
    if (any) return;
    const glm::dvec3 a = geometry_.voxel_to_mm(glm::dvec3(-0.5)), b = geometry_.voxel_to_mm(end);
    refuse(zone, fmt::format("lies outside the volume, or between its voxels; the volume reaches from "
                             "({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}) mm",
                             a.x, a.y, a.z, b.x, b.y, b.z));
}

void ZoneMask::read_labels(const Zone& zone, const JobContext& job) {
    const Volume volume = open_volume(zone.labels.string(), {}, job);
    const glm::ivec3 n = geometry_.size, m = volume.geometry().size;
    if (n != m)
        refuse(zone, fmt::format("has {}x{}x{} voxels, the part {}x{}x{}; it must lie on the part's grid", m.x, m.y,
                                 m.z, n.x, n.y, n.z));
    if (!same_grid(volume.geometry(), geometry_))
        refuse(zone, "lies elsewhere than the part (origin, spacing or axes differ); it must lie on the part's grid");
    first_ = n;
    last_ = glm::ivec3(-1);
    std::vector<bool> all(std::size_t(geometry_.voxel_count()));
    visit_type(volume.type(), [&](auto tag) {
        const auto voxels = volume.view<decltype(tag)>().voxels();
        std::size_t i = 0;
        for (int z = 0; z < n.z; ++z)
            for (int y = 0; y < n.y; ++y)
                for (int x = 0; x < n.x; ++x, ++i) {
                    const double value = double(voxels[i]);
                    if (!(zone.label ? value == double(*zone.label) : value != 0 && std::isfinite(value))) continue;
                    all[i] = true;
                    first_ = glm::min(first_, glm::ivec3(x, y, z));
                    last_ = glm::max(last_, glm::ivec3(x, y, z));
                }
    });
    if (last_.x < 0)
        refuse(zone, zone.label ? fmt::format("holds no voxel of label {}", *zone.label) : "holds no voxel above 0");
    const glm::ivec3 size = last_ - first_ + 1;
    inside_.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    std::size_t to = 0;
    for (int z = first_.z; z <= last_.z; ++z)
        for (int y = first_.y; y <= last_.y; ++y)
            for (int x = first_.x; x <= last_.x; ++x) inside_[to++] = all[std::size_t(geometry_.linear_index(x, y, z))];
}

bool ZoneMask::contains(int x, int y, int z) const {
    const glm::ivec3 at(x, y, z);
    if (glm::any(glm::lessThan(at, first_)) || glm::any(glm::greaterThan(at, last_))) return false;
    if (is_box_) {
        const glm::dvec3 mm = geometry_.voxel_to_mm(glm::dvec3(at));
        return glm::all(glm::greaterThanEqual(mm, min_)) && glm::all(glm::lessThanEqual(mm, max_));
    }
    const glm::ivec3 size = last_ - first_ + 1, local = at - first_;
    return inside_[(std::size_t(local.z) * std::size_t(size.y) + std::size_t(local.y)) * std::size_t(size.x) +
                   std::size_t(local.x)];
}

std::vector<ZoneMask> lay_zones(const Criteria& criteria, const GridGeometry& geometry, const JobContext& job) {
    std::vector<ZoneMask> masks;
    for (const Zone& zone : criteria.zones) masks.emplace_back(zone, geometry, job);
    return masks;
}

}  // namespace lacuna
