#pragma once

#include <nifti1.h>

#include <cstring>
#include <string>

#include "volume_fixture.h"

namespace lacuna::test {

/// Voxels of 2 mm, without an orientation.
inline nifti_1_header nifti_header(short datatype, short bits, short x, short y, short z) {
    nifti_1_header h{};
    h.sizeof_hdr = 348;
    h.dim[0] = 3;
    h.dim[1] = x, h.dim[2] = y, h.dim[3] = z;
    for (int a = 4; a < 8; ++a) h.dim[a] = 1;
    h.pixdim[0] = 1;
    h.pixdim[1] = h.pixdim[2] = h.pixdim[3] = 2;
    h.datatype = datatype;
    h.bitpix = bits;
    h.vox_offset = 352;
    h.xyzt_units = NIFTI_UNITS_MM;
    std::memcpy(h.magic, "n+1", 4);
    return h;
}

inline std::string nifti_file(const nifti_1_header& h, const std::string& data) {
    return std::string(reinterpret_cast<const char*>(&h), sizeof h) + std::string(4, '\0') + data;
}

/// Writes a file and opens it.
inline Volume open_text(const ScratchFolder& folder, const std::string& name, const std::string& bytes) {
    put_file(folder / name, bytes);
    return open_volume((folder / name).string());
}

}  // namespace lacuna::test
