#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/volume/grid_geometry.h"
#include "core/volume/voxel_source.h"
#include "core/volume/voxel_type.h"

namespace lacuna {

/// Closed range of values in the volume's unit.
struct ValueRange {
    double lo = 0, hi = 0;
    double width() const { return hi - lo; }
    bool contains(double v) const { return v >= lo && v <= hi; }  // false for NaN
    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// One thing that was repaired or is doubtful about an input, with the largest geometric error it leaves.
struct Warning {
    std::string text;               ///< one sentence, no patient data
    double max_error_mm = 0;        ///< largest position error of any voxel, mm; 0 when exact or not geometric
};

/// Facts about a DICOM series that carry no patient's identity.
struct DicomFacts {
    std::string modality, description, transfer_syntax, photometric_interpretation;
    std::string series_uid;
    int slices_found = 0, slices_used = 0;
    std::vector<int> slices_missing;         ///< grid indices along z that were interpolated
    std::vector<std::string> duplicates;     ///< file names set aside
    double slice_spacing_min_mm = 0, slice_spacing_max_mm = 0;  ///< between neighbouring slices as found
    double gantry_tilt_deg = 0;              ///< signed; 0 when the slices stack along their normal
    std::optional<double> window_center, window_width;          ///< the first stored window, if any
    std::vector<std::pair<std::string, std::string>> component; ///< DICONDE component fields (name, id, ...), if any
};

/// Voxel memory: aligned to 2 MiB where it is large, huge pages asked for, at least 64 readable zero bytes behind the
/// last voxel (kernels load neighbours in pairs). First touch is by whoever fills it.
class VoxelBuffer {
public:
    VoxelBuffer() = default;
    /// @throws Error(out_of_memory) naming the size
    explicit VoxelBuffer(std::size_t bytes);
    std::byte* data() const { return data_.get(); }
    std::size_t size() const { return size_; }

private:
    std::shared_ptr<std::byte> data_;
    std::size_t size_ = 0;
};

/// Read-only typed window on a volume's voxels, x fastest.
template <class T> struct VolumeView {
    const T* data = nullptr;
    glm::ivec3 size{0};

    const T& operator()(int x, int y, int z) const {
        return data[(std::int64_t(z) * size.y + y) * size.x + x];
    }
    const T* row(int y, int z) const { return data + (std::int64_t(z) * size.y + y) * size.x; }
    std::span<const T> voxels() const { return {data, std::size_t(std::int64_t(size.x) * size.y * size.z)}; }
};

/// A scalar volume with its geometry. Copies share the voxels, which nobody changes once the volume is made. They lie in
/// memory, or, of a volume larger than that, in a VoxelSource, from which boxes are read (read_box()); only what says so
/// takes the latter.
/// Values are in the input's real unit (HU for CT DICOM): a voxel's value is its number, no further scale applies.
class Volume {
public:
    Volume() = default;
    /// Takes voxels already filled, x fastest. @throws Error(bad_input) if the geometry is unsound or the size differs
    Volume(GridGeometry geometry, VoxelType type, VoxelBuffer voxels);
    /// A volume whose voxels stay where they are. @throws Error(bad_input) if the geometry is unsound
    Volume(GridGeometry geometry, VoxelType type, std::shared_ptr<const VoxelSource> source);

    bool empty() const { return voxels_.size() == 0 && !source_; }
    /// Its voxels can be read at data(); else only box by box.
    bool in_memory() const { return voxels_.size() != 0; }
    /// Of all its voxels, wherever they lie.
    std::uint64_t total_bytes() const { return std::uint64_t(geometry_.voxel_count()) * size_of(type_); }
    /// Equal for volumes that share their voxels, and for no others alive at the same time.
    const void* identity() const { return source_ ? static_cast<const void*>(source_.get()) : voxels_.data(); }
    const std::shared_ptr<const VoxelSource>& source() const { return source_; }
    const GridGeometry& geometry() const { return geometry_; }
    VoxelType type() const { return type_; }
    std::size_t bytes() const { return voxels_.size(); }
    const std::byte* data() const { return voxels_.data(); }
    const VoxelBuffer& buffer() const { return voxels_; }
    /// @pre T is the volume's type
    template <class T> VolumeView<T> view() const {
        return {reinterpret_cast<const T*>(voxels_.data()), geometry_.size};
    }
    /// One value, any type; slow, for read-outs. @pre inside the grid
    double value(int x, int y, int z) const;

    std::string name;                 ///< short, for titles: folder or file name, never a patient's name
    std::string unit;                 ///< "HU", or empty when the input names none
    std::vector<Warning> warnings;
    std::optional<DicomFacts> dicom;

private:
    GridGeometry geometry_;
    VoxelType type_ = VoxelType::u8;
    VoxelBuffer voxels_;
    std::shared_ptr<const VoxelSource> source_;
};

/// Copies a box of a volume's voxels, from memory or its source, as VoxelSource::read does.
/// @pre the box lies inside the grid. @throws Error(io), Error(cancelled)
void read_box(const Volume& volume, const VoxelBox& box, std::byte* out, const JobContext& job = {});

/// A box of a volume as a volume of its own, in memory, at the same place in space.
Volume extract_box(const Volume& volume, const VoxelBox& box, const JobContext& job = {});

/// Makes a volume of T by allocating and calling fill(std::span<T>).
template <class T, class Fill> Volume make_volume(const GridGeometry& geometry, Fill&& fill) {
    VoxelBuffer buffer(std::size_t(geometry.voxel_count()) * sizeof(T));
    fill(std::span<T>(reinterpret_cast<T*>(buffer.data()), std::size_t(geometry.voxel_count())));
    return Volume(geometry, voxel_type_of<T>(), std::move(buffer));
}

}  // namespace lacuna
