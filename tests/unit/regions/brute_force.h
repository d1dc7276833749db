#pragma once

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "core/regions/regions.h"

namespace lacuna::test {

/// Whether two voxels that differ by d are adjacent.
inline bool adjacent(const glm::ivec3& d, int connectivity) {
    const int sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    const bool near = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) == 1;
    return near && sum <= (connectivity == 6 ? 1 : connectivity == 18 ? 2 : 3);
}

/// Components of the set voxels of a mask of the given size, by plain flood fill; labels 1.. in scan order.
inline std::vector<int> flood(const std::vector<std::uint8_t>& mask, const glm::ivec3& size, int connectivity) {
    std::vector<int> label(mask.size(), 0);
    const auto at = [&](const glm::ivec3& p) { return std::size_t((p.z * size.y + p.y) * size.x + p.x); };
    int count = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                if (!mask[at({x, y, z})] || label[at({x, y, z})]) continue;
                std::vector<glm::ivec3> open{{x, y, z}};
                label[at({x, y, z})] = ++count;
                while (!open.empty()) {
                    const glm::ivec3 p = open.back();
                    open.pop_back();
                    for (int k = 0; k < 27; ++k) {
                        const glm::ivec3 d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), q = p + d;
                        if (!adjacent(d, connectivity) || glm::any(glm::lessThan(q, glm::ivec3(0))) ||
                            glm::any(glm::greaterThanEqual(q, size)) || !mask[at(q)] || label[at(q)])
                            continue;
                        label[at(q)] = count;
                        open.push_back(q);
                    }
                }
            }
    return label;
}

/// One region as a mask with a layer of outside round it.
inline std::vector<std::uint8_t> padded(const LabelVolume& labels, std::uint32_t id, glm::ivec3& size) {
    size = labels.geometry.size + 2;
    std::vector<std::uint8_t> mask(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    for (int z = 0; z < labels.geometry.size.z; ++z)
        for (int y = 0; y < labels.geometry.size.y; ++y)
            for (int x = 0; x < labels.geometry.size.x; ++x)
                mask[std::size_t(((z + 1) * size.y + y + 1) * size.x + x + 1)] = labels(x, y, z) == id;
    return mask;
}

/// Cavities of one region: components of its complement less the outer one.
inline int cavities_of(const LabelVolume& labels, std::uint32_t id, int complement) {
    glm::ivec3 size;
    std::vector<std::uint8_t> mask = padded(labels, id, size);
    for (auto& m : mask) m = !m;
    const std::vector<int> parts = flood(mask, size, complement);
    return *std::max_element(parts.begin(), parts.end()) - 1;
}

/// Euler's number of the union of closed cells: distinct vertices less edges plus faces less cells.
inline int euler_of_cells(const LabelVolume& labels, std::uint32_t id) {
    std::set<std::tuple<int, int, int>> elements;  // doubled coordinates: odd spans, even is a point
    const glm::ivec3 size = labels.geometry.size;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (labels(x, y, z) == id)
                    for (int k = 0; k < 27; ++k) elements.insert({2 * x + k % 3, 2 * y + k / 3 % 3, 2 * z + k / 9});
    int sum = 0;
    for (const auto& [x, y, z] : elements) sum += (x % 2 + y % 2 + z % 2) % 2 ? -1 : 1;
    return sum;
}

/// Euler's number of the graph of face neighbours with its full squares and cubes filled in.
inline int euler_of_face_graph(const LabelVolume& labels, std::uint32_t id) {
    const glm::ivec3 size = labels.geometry.size;
    int sum = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int span = 0; span < 8; ++span) {  // the axes along which the element reaches one voxel further
                    bool whole = true;
                    for (int corner = 0; corner < 8 && whole; ++corner) {
                        const glm::ivec3 p(x + (span & corner & 1), y + ((span & corner) >> 1 & 1),
                                           z + ((span & corner) >> 2 & 1));
                        whole = p.x < size.x && p.y < size.y && p.z < size.z && labels(p.x, p.y, p.z) == id;
                    }
                    if (whole) sum += ((span & 1) + (span >> 1 & 1) + (span >> 2 & 1)) % 2 ? -1 : 1;
                }
    return sum;
}

}  // namespace lacuna::test
