#include "core/io/dicom_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/base/atomic_folder.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/dicom_derived.h"

namespace lacuna {

namespace fs = std::filesystem;
using dicom::decimal, dicom::printable;

namespace {

/// How values become 16 bit words: stored = value - intercept.
struct Storage {
    bool sign = false;
    double intercept = 0;
};

constexpr std::int64_t k_undefined_bytes = 0xFFFFFFFF;  // no length of an element, which are even 32 bit numbers

struct SeriesIds {
    std::string study, series, frame;
    std::vector<std::string> instances;
};

std::string fresh_uid(const char* root) {
    char uid[100];
    return dcmGenerateUniqueIdentifier(uid, root);
}

[[noreturn]] void fail(const fs::path& folder, const std::string& reason) {
    throw Error(Errc::io, "Cannot write the DICOM series " + folder.string() + ": " + reason +
                              "; nothing was written; check the space and the permissions there, or write elsewhere.");
}

Storage storage_of_floats(const Volume& volume, const fs::path& folder) {
    double lo = INFINITY, hi = -INFINITY;
    for (const float v : volume.view<float>().voxels()) {
        if (!(std::isfinite(v) && v == std::floor(v)))
            throw Error(Errc::unsupported,
                        "Cannot write the DICOM series " + folder.string() +
                            ": CT images hold whole numbers, but the volume has fractions or NaN; write "
                            ".nrrd or .nii.gz instead.");
        lo = std::min(lo, double(v));
        hi = std::max(hi, double(v));
    }
    if (lo >= -32768 && hi <= 32767) return {true, 0};
    if (hi - lo <= 65535) return {false, lo};
    throw Error(Errc::unsupported, "Cannot write the DICOM series " + folder.string() + ": its values " +
                                       fmt::format("{} to {}", lo, hi) +
                                       " do not fit 16 bits; write .nrrd or .nii.gz instead.");
}

Storage storage_of(const Volume& volume, const fs::path& folder) {
    switch (volume.type()) {
        case VoxelType::u8:
        case VoxelType::u16:
            return {false, 0};
        case VoxelType::i8:
        case VoxelType::i16:
            return {true, 0};
        case VoxelType::f32:
            break;
    }
    return storage_of_floats(volume, folder);
}

std::string decimals(std::initializer_list<double> values) {
    std::string text;
    for (const double v : values) {
        if (!text.empty()) text += '\\';
        text += decimal(v);
    }
    return text;
}

void put(DcmDataset& set, const DcmTagKey& key, const std::string& value) {
    set.putAndInsertString(key, value.c_str());
}

void put_identity(DcmDataset& set, const Volume& volume, const SeriesIds& ids) {
    put(set, DCM_SpecificCharacterSet, "ISO_IR 100");
    put(set, DCM_ImageType, "DERIVED\\SECONDARY\\AXIAL");
    put(set, DCM_SOPClassUID, UID_CTImageStorage);
    put(set, DCM_PatientName, "Anonymous");
    put(set, DCM_PatientID, "Anonymous");
    for (const DcmTagKey& empty : {DCM_StudyDate, DCM_StudyTime, DCM_AccessionNumber, DCM_ReferringPhysicianName,
                                   DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyID, DCM_PositionReferenceIndicator,
                                   DCM_KVP, DCM_AcquisitionNumber, DCM_PatientPosition, DCM_Laterality})
        set.insertEmptyElement(empty);
    put(set, DCM_Modality, "CT");
    put(set, DCM_Manufacturer, "Lacuna");
    put(set, DCM_SeriesDescription, printable(volume.name));
    put(set, DCM_StudyInstanceUID, ids.study);
    put(set, DCM_SeriesInstanceUID, ids.series);
    put(set, DCM_FrameOfReferenceUID, ids.frame);
    put(set, DCM_SeriesNumber, "1");
}

void put_geometry(DcmDataset& set, const GridGeometry& g, int slice) {
    const glm::dvec3 at = g.voxel_to_mm({0, 0, slice}), x = g.direction[0], y = g.direction[1];
    put(set, DCM_ImagePositionPatient, decimals({at.x, at.y, at.z}));
    put(set, DCM_ImageOrientationPatient, decimals({x.x, x.y, x.z, y.x, y.y, y.z}));
    put(set, DCM_PixelSpacing, decimals({g.spacing.y, g.spacing.x}));
    put(set, DCM_SliceThickness, decimal(g.spacing.z));
    put(set, DCM_SpacingBetweenSlices, decimal(g.spacing.z));
}

void put_pixel_format(DcmDataset& set, const Volume& volume, const Storage& storage) {
    const glm::ivec3 n = volume.geometry().size;
    set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    put(set, DCM_PhotometricInterpretation, "MONOCHROME2");
    set.putAndInsertUint16(DCM_Rows, Uint16(n.y));
    set.putAndInsertUint16(DCM_Columns, Uint16(n.x));
    set.putAndInsertUint16(DCM_BitsAllocated, 16);
    set.putAndInsertUint16(DCM_BitsStored, 16);
    set.putAndInsertUint16(DCM_HighBit, 15);
    set.putAndInsertUint16(DCM_PixelRepresentation, storage.sign ? 1 : 0);
    put(set, DCM_RescaleIntercept, decimal(storage.intercept));
    put(set, DCM_RescaleSlope, "1");
    put(set, DCM_RescaleType, volume.unit == "HU" ? "HU" : "US");
}

std::vector<Uint16> slice_words(const Volume& volume, const Storage& storage, int slice) {
    const glm::ivec3 n = volume.geometry().size;
    std::vector<Uint16> words(std::size_t(n.x) * std::size_t(n.y));
    visit_type(volume.type(), [&](auto tag) {
        const auto* from = volume.view<decltype(tag)>().row(0, slice);
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = Uint16(std::int32_t(double(from[i]) - storage.intercept));
    });
    return words;
}

/// The library does not report a disk that ran full when it closes the file; the pixels are its last bytes.
bool ends_with(const fs::path& file, const std::vector<Uint16>& words) {
    const auto bytes = std::streamoff(words.size() * sizeof(Uint16));
    std::ifstream in(file, std::ios::binary);
    std::vector<Uint16> tail(words.size());
    in.seekg(-bytes, std::ios::end);
    in.read(reinterpret_cast<char*>(tail.data()), bytes);
    return in.gcount() == bytes && tail == words;
}

void write_slice(const Volume& volume, const Storage& storage, const SeriesIds& ids, int slice, const fs::path& file,
                 const fs::path& folder) {
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    put_identity(set, volume, ids);
    put(set, DCM_SOPInstanceUID, ids.instances[std::size_t(slice)]);
    put(set, DCM_InstanceNumber, std::to_string(slice + 1));
    put_geometry(set, volume.geometry(), slice);
    put_pixel_format(set, volume, storage);
    const std::vector<Uint16> words = slice_words(volume, storage, slice);
    set.putAndInsertUint16Array(DCM_PixelData, words.data(), static_cast<unsigned long>(words.size()));
    const OFCondition saved = format.saveFile(file.c_str(), EXS_LittleEndianExplicit);
    if (saved.bad() || !ends_with(file, words)) fail(folder, "the disk is full or the file size is limited");
}

}  // namespace

void write_dicom_series(const Volume& volume, const fs::path& folder, const JobContext& job) {
    const glm::ivec3 n = volume.geometry().size;
    if (n.x > 65535 || n.y > 65535)
        throw Error(Errc::unsupported, "Cannot write the DICOM series " + folder.string() +
                                           ": a slice holds at most 65535 rows and columns.");
    if (std::int64_t(n.x) * n.y * std::int64_t(sizeof(Uint16)) >= k_undefined_bytes)
        throw Error(Errc::unsupported, "Cannot write the DICOM series " + folder.string() +
                                           ": a slice holds at most 4294967294 bytes; write .nrrd instead.");
    const Storage storage = storage_of(volume, folder);
    SeriesIds ids{fresh_uid(SITE_STUDY_UID_ROOT), fresh_uid(SITE_SERIES_UID_ROOT), fresh_uid(SITE_SERIES_UID_ROOT), {}};
    for (int z = 0; z < n.z; ++z) ids.instances.push_back(fresh_uid(SITE_INSTANCE_UID_ROOT));
    const fs::path target = folder.has_filename() ? folder : folder.parent_path();
    AtomicFolder output(target);
    parallel_for(
        0, n.z,
        [&](std::int64_t z) {
            write_slice(volume, storage, ids, int(z), output.path() / fmt::format("slice{:05d}.dcm", z + 1), target);
        },
        job);
    output.commit();
}

}  // namespace lacuna
