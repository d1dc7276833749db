#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "core/volume/volume.h"

namespace lacuna::reference {

/// Reconstruction of a volume between its voxel centres, as scene.h defines it, in double precision. Positions are in
/// voxel coordinates. A value is NaN where any voxel it is made from is not finite.
template <class T>
class Field {
public:
    explicit Field(const Volume& volume)
        : voxels_(volume.view<T>()),
          last_(glm::dvec3(voxels_.size - 1)),
          last_base_(glm::max(voxels_.size - 2, glm::ivec3(0))),
          next_(voxels_.size.x > 1 ? 1 : 0, voxels_.size.y > 1 ? voxels_.size.x : 0,
                voxels_.size.z > 1 ? std::int64_t(voxels_.size.x) * voxels_.size.y : 0),
          spacing_(volume.geometry().spacing) {}

    double linear(glm::dvec3 p) const {
        p = glm::clamp(p, glm::dvec3(0), last_);
        const glm::ivec3 i = glm::min(glm::ivec3(p), last_base_);  // p >= 0: the conversion is a floor
        const glm::dvec3 f = p - glm::dvec3(i);
        const T* v = &voxels_(i.x, i.y, i.z);
        const double near_plane = mix(edge(v, f.x), edge(v + next_.y, f.x), f.y);
        v += next_.z;
        const double far_plane = mix(edge(v, f.x), edge(v + next_.y, f.x), f.y);
        return finite_or_nan(mix(near_plane, far_plane, f.z));
    }

    double nearest(glm::dvec3 p) const {
        const glm::ivec3 i(glm::clamp(p, glm::dvec3(0), last_) + 0.5);
        return finite_or_nan(double(voxels_(i.x, i.y, i.z)));
    }

    /// The gradient at the voxels around, interpolated, per mm along the grid's own axes. At a voxel central
    /// differences over one voxel each way; with `smooth` weighted (1 2 1)/4 along both other axes (Sobel).
    glm::dvec3 gradient(glm::dvec3 p, bool smooth = false) const {
        p = glm::clamp(p, glm::dvec3(0), last_);
        glm::dvec3 g(0);
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = smooth ? -1 : 0; i <= (smooth ? 1 : 0); ++i) {
                for (int j = smooth ? -1 : 0; j <= (smooth ? 1 : 0); ++j) {
                    glm::dvec3 to_side(0), ahead(0);
                    ahead[axis] = 1;
                    to_side[(axis + 1) % 3] = i;
                    to_side[(axis + 2) % 3] = j;
                    const double weight = smooth ? (i == 0 ? 0.5 : 0.25) * (j == 0 ? 0.5 : 0.25) : 1;
                    g[axis] += weight * (linear(p + to_side + ahead) - linear(p + to_side - ahead));
                }
            }
            g[axis] *= 0.5 / spacing_[axis];
        }
        return g;
    }

private:
    // This form (not (1-f)*a + f*b) turns every non-finite corner into a non-finite result, weight 0 included.
    static double mix(double a, double b, double f) { return a + f * (b - a); }
    double edge(const T* v, double f) const { return mix(double(v[0]), double(v[next_.x]), f); }
    static double finite_or_nan(double value) {
        if constexpr (std::is_floating_point_v<T>)
            return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
        return value;
    }

    VolumeView<T> voxels_;
    glm::dvec3 last_;
    glm::ivec3 last_base_;
    glm::i64vec3 next_;
    glm::dvec3 spacing_;
};

}  // namespace lacuna::reference
