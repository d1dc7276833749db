#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/volume/samples.h"
#include "core/volume/volume.h"

namespace lacuna {

namespace dicom {
struct SeriesScan;
}

/// One volume found under an input: a DICOM series (split by UID, orientation, size, acquisition) or a file.
struct SeriesEntry {
    int number = 0;  ///< 1, 2, ... in the order listed
    std::string description, uid, modality;
    glm::ivec3 size{0};
    int slices = 0;
    std::vector<std::filesystem::path> files;
    std::shared_ptr<const dicom::SeriesScan> scan{};  ///< headers the scan parsed, so that reading need not again
};

/// How to open an input, beyond its name.
struct OpenOptions {
    std::string raw;                         ///< the contract's --raw text; empty: none
    std::string series;                      ///< --series N|UID; empty: none
    bool keep_gaps = false;                  ///< refuse a series with missing slices instead of interpolating them
    std::optional<glm::dvec3> spacing_mm{};  ///< replaces the input's own spacing; of DICOM with a warning
};

/// More than one volume lies under the input and none was chosen. Exit status 2; the message lists them.
class AmbiguousInput : public Error {
public:
    AmbiguousInput(const std::string& sentence, std::vector<SeriesEntry> found)
        : Error(Errc::bad_usage, sentence), entries(std::move(found)) {}
    std::vector<SeriesEntry> entries;
};

/// Lists the volumes an input holds without reading pixels (`sample:` inputs: one entry).
std::vector<SeriesEntry> list_series(const std::string& input, const JobContext& job = {});

/// The list AmbiguousInput and an unknown --series show: number, description, size, slices, UID, one a line.
std::string format_series(const std::vector<SeriesEntry>& entries);

/// Opens any INPUT of the contract: DICOM folder or file, mhd mha nrrd nhdr nii nii.gz hdr, TIFF stack or multi-page,
/// raw with `raw` or a sidecar or its own name, `sample:NAME[@SIZE]` with SIZE one number of voxels or WxHxD.
/// @throws Error(bad_input) and Error(unsupported) naming file, fault and what to do; AmbiguousInput; Error(cancelled)
Volume open_volume(const std::string& input, const OpenOptions& options = {}, const JobContext& job = {});

/// The same volume without its voxels, which are read box by box as they are asked for (VoxelSource): raw volumes,
/// .mhd .mha .nrrd .nhdr whose voxels are not packed, and built-in samples, painted as they are read. Nothing for all
/// other inputs. Cost: the header's. Whether voxels are NaN is not looked at. @throws as open_volume
std::optional<Volume> open_volume_in_parts(const std::string& input, const OpenOptions& options = {});

/// A built-in sample with its exact truth; nullopt for every other input.
/// @throws Error(bad_usage) for an unknown sample or a size that is none
std::optional<AnalyticSample> open_sample(const std::string& input, const JobContext& job = {});

/// SHA-256 of the voxels, little-endian in the stored type, x fastest, as hex.
std::string voxel_sha256(const Volume& volume, const JobContext& job = {});

}  // namespace lacuna
