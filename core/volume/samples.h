#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// One known object inside an analytic sample: an ellipsoid (a ball where the radii agree).
struct SampleObject {
    std::string kind;          ///< "void", "inclusion" or "ball"
    glm::dvec3 centre_mm{0};
    glm::dvec3 radii_mm{0};    ///< semi-axes
    double volume_mm3 = 0;     ///< exact
};

/// A volume made from a formula, with what is exactly true of it.
struct AnalyticSample {
    Volume volume;
    /// The exact continuous signal before blur, noise and quantisation, at a position in mm.
    std::function<double(const glm::dvec3& mm)> value;
    std::vector<SampleObject> objects;   ///< casting: every pore; spheres: every ball
    double background = 0, material = 0; ///< the two main levels; 0, 0 where the sample has none
};

/// Options of a sample; the defaults give what `sample:NAME` means on the command line.
struct SampleOptions {
    int size = 0;              ///< voxels along every axis; 0: the sample's default
    double noise = -1;         ///< standard deviation in the volume's unit; negative: the sample's default
    double blur_voxels = -1;   ///< Gaussian sigma of the point-spread function; negative: the sample's default
    unsigned seed = 1;         ///< of noise and of the random objects; same seed, same bytes, any number of threads
    glm::ivec3 dims{0};        ///< voxels along each axis, over the same box of space; 0: as `size` says
};

/// Names of the built-in samples: casting, head, vessels, spheres, marschner-lobb.
std::vector<std::string_view> sample_names();

/// Makes a built-in sample. @throws Error(bad_usage) for an unknown name (the message lists the known), an axis outside
/// 8..131072 or more than 2^36 voxels in all; Error(cancelled), Error(out_of_memory)
AnalyticSample make_sample(std::string_view name, const SampleOptions& options = {}, const JobContext& job = {});

/// The same volume, voxel for voxel, without its voxels: each box is painted when it is read (VoxelSource). Throws as
/// make_sample. Cost: none; reading costs 10 to 100 ns a voxel and thread.
Volume sample_in_parts(std::string_view name, const SampleOptions& options = {});

}  // namespace lacuna
