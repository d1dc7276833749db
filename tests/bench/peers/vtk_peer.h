#pragma once

#include <memory>

#include "core/render/frame.h"
#include "core/render/scene.h"

namespace lacuna::peers {

/// VTK drawing one scene: emission-absorption and MIP by vtkFixedPointVolumeRayCastMapper, isosurfaces as triangles of
/// vtkFlyingEdges3D. Same camera, transfer function, unit distance, sample distance and picture as Lacuna's.
class VtkPeer {
public:
    /// Holds its own reference to the voxels. @param step in units of the smallest voxel spacing
    VtkPeer(const Scene& scene, double step, int threads);
    ~VtkPeer();

    /// One frame from the call to the pixels on the host, ms. Triangles are made anew where the isovalue is another.
    double draw(const Scene& scene);
    /// Of the frame drawn last: the ray caster alone, without showing its picture; 0 for triangles.
    double caster_ms() const;
    /// The frame drawn last, over black.
    Frame picture() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace lacuna::peers
