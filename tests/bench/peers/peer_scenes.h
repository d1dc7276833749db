#pragma once

#include <string>
#include <vector>

#include "core/render/scene.h"

namespace lacuna::peers {

/// One thing to look at, drawable by Lacuna and by its peer alike; its camera is an orbit's first view: perspective 30
/// degrees, elevation 20 degrees.
struct PeerScene {
    std::string name;
    Scene scene;
};

/// Emission-absorption over an opaque casting, a semi-transparent head, vessels, and fog (every voxel visible), all u16
/// with `size` voxels an axis, made from the built-in samples.
std::vector<PeerScene> make_ea_scenes(int size);
/// The same three volumes in another mode (mip or iso): the isovalue lies on the casting's metal, the skull, the
/// vessels.
std::vector<PeerScene> make_plain_scenes(int size, ViewMode mode);

}  // namespace lacuna::peers
