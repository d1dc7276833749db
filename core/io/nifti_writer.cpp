#include "core/io/nifti_writer.h"

#include <nifti1.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>

#include "core/base/error.h"
#include "core/io/output_file.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace {

short datatype_of(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
            return DT_UINT8;
        case VoxelType::i8:
            return DT_INT8;
        case VoxelType::u16:
            return DT_UINT16;
        case VoxelType::i16:
            return DT_INT16;
        case VoxelType::f32:
            break;
    }
    return DT_FLOAT32;
}

/// The rotation as a quaternion (nifti1.h, "QUATERNION REPRESENTATION"); a left-handed grid is told by pixdim[0] = -1.
void set_qform(nifti_1_header& h, glm::dmat3 ras_axes, const glm::dvec3& ras_origin) {
    h.qform_code = NIFTI_XFORM_SCANNER_ANAT;
    h.pixdim[0] = 1;
    if (glm::determinant(ras_axes) < 0) {
        h.pixdim[0] = -1;
        ras_axes[2] = -ras_axes[2];
    }
    glm::dquat q = glm::normalize(glm::quat_cast(ras_axes));
    if (q.w < 0) q = -q;
    h.quatern_b = float(q.x);
    h.quatern_c = float(q.y);
    h.quatern_d = float(q.z);
    h.qoffset_x = float(ras_origin.x);
    h.qoffset_y = float(ras_origin.y);
    h.qoffset_z = float(ras_origin.z);
}

nifti_1_header header_of(const Volume& volume) {
    const GridGeometry& g = volume.geometry();
    nifti_1_header h{};
    h.sizeof_hdr = 348;
    h.regular = 'r';
    h.dim[0] = 3;
    for (int a = 0; a < 3; ++a) {
        h.dim[a + 1] = short(g.size[a]);
        h.pixdim[a + 1] = float(g.spacing[a]);
    }
    for (int a = 4; a < 8; ++a) h.dim[a] = 1, h.pixdim[a] = 1;
    h.datatype = datatype_of(volume.type());
    h.bitpix = short(8 * size_of(volume.type()));
    h.vox_offset = 352;
    h.scl_slope = 1;
    h.xyzt_units = NIFTI_UNITS_MM;
    glm::dmat3 axes = g.direction;  // LPS to RAS: x and y change sign
    for (int c = 0; c < 3; ++c) axes[c].x = -axes[c].x, axes[c].y = -axes[c].y;
    const glm::dvec3 origin(-g.origin.x, -g.origin.y, g.origin.z);
    set_qform(h, axes, origin);
    h.sform_code = NIFTI_XFORM_SCANNER_ANAT;
    float* const rows[3] = {h.srow_x, h.srow_y, h.srow_z};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) rows[r][c] = float(axes[c][r] * g.spacing[c]);
        rows[r][3] = float(origin[r]);
    }
    std::memcpy(h.magic, "n+1", 4);
    return h;
}

}  // namespace

void write_nifti(const Volume& volume, const std::filesystem::path& target, const JobContext& job) {
    for (int a = 0; a < 3; ++a)
        if (volume.geometry().size[a] > 32767)
            throw Error(Errc::unsupported, "Cannot write " + target.string() +
                                               ": NIfTI holds at most 32767 voxels an axis; " + "write .nrrd instead.");
    std::byte head[352] = {};  // header and four bytes that say "no extensions"
    const nifti_1_header header = header_of(volume);
    static_assert(sizeof header == 348);
    std::memcpy(head, &header, sizeof header);
    OutputFile file(target);
    const std::span<const std::byte> voxels(volume.data(), volume.bytes());
    if (lower_case(target.extension().string()) == ".gz") {
        write_gzip(file, head, voxels, job);
    } else {
        file.write(head);
        write_plain(file, voxels, job);
    }
    file.commit();
}

}  // namespace lacuna
