#include "core/io/header_check.h"

#include <nifti1.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/io/axis_rule.h"
#include "core/io/header_text.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;
using namespace headers;

namespace {

template <class T>
T swapped(T value) {
    auto* bytes = reinterpret_cast<unsigned char*>(&value);
    std::reverse(bytes, bytes + sizeof(T));
    return value;
}

/// The voxels lie in a file of their own, `.img` beside `.hdr`.
bool is_pair(const nifti_1_header& h) { return std::memcmp(h.magic, "ni1", 4) == 0; }

/// The header in the machine's byte order; true: it was stored the other way round.
std::pair<nifti_1_header, bool> nifti_header(const fs::path& file) {
    nifti_1_header h{};
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
    if (!in) throw Error(Errc::io, "Cannot read " + file.string() + ": " + std::strerror(errno) + ".");
    if (gzread(in.get(), &h, sizeof h) != int(sizeof h))
        refuse(file, "it is cut short, or no NIfTI file: its header needs 348 bytes");
    if (h.sizeof_hdr == 540 || swapped(h.sizeof_hdr) == 540)
        throw Error(Errc::unsupported, "Cannot read " + file.string() +
                                           ": it is NIfTI-2, which is not read; save it as NIfTI-1, .nrrd or .mhd.");
    if (std::memcmp(h.magic, "n+1", 4) != 0 && !is_pair(h))
        refuse(file, "it is no NIfTI file (its magic word is missing)");
    const bool other_order = h.dim[0] < 1 || h.dim[0] > 7;
    if (other_order) {
        for (short& d : h.dim) d = swapped(d);
        for (float& p : h.pixdim) p = swapped(p);
        for (float* f : {&h.vox_offset, &h.scl_slope, &h.scl_inter}) *f = swapped(*f);
        for (float* f : {&h.quatern_b, &h.quatern_c, &h.quatern_d, &h.qoffset_x, &h.qoffset_y, &h.qoffset_z})
            *f = swapped(*f);
        for (float(*row)[4] : {&h.srow_x, &h.srow_y, &h.srow_z})
            for (float& f : *row) f = swapped(f);
        for (short* s : {&h.datatype, &h.bitpix, &h.qform_code, &h.sform_code}) *s = swapped(*s);
    }
    if (h.dim[0] < 1 || h.dim[0] > 7) refuse(file, "its number of dimensions is not within 1 to 7");
    return {h, other_order};
}

StoredType nifti_type(const fs::path& file, const nifti_1_header& h) {
    static const std::pair<int, StoredType> k_types[] = {{DT_UINT8, StoredType::u8},    {DT_INT8, StoredType::i8},
                                                         {DT_UINT16, StoredType::u16},  {DT_INT16, StoredType::i16},
                                                         {DT_UINT32, StoredType::u32},  {DT_INT32, StoredType::i32},
                                                         {DT_UINT64, StoredType::u64},  {DT_INT64, StoredType::i64},
                                                         {DT_FLOAT32, StoredType::f32}, {DT_FLOAT64, StoredType::f64}};
    for (const auto& [code, type] : k_types) {
        if (code != h.datatype) continue;
        if (std::size_t(h.bitpix) != 8 * size_of(type))
            refuse(file, "its bitpix " + std::to_string(h.bitpix) + " does not fit its datatype " +
                             std::to_string(h.datatype));
        return type;
    }
    throw Error(Errc::unsupported, "Cannot read " + file.string() + ": its voxels are of datatype " +
                                       std::to_string(h.datatype) +
                                       " (colours, complex or single bits); only scalar volumes can be opened.");
}

std::uint64_t nifti_offset(const fs::path& file, const nifti_1_header& h) {
    const int least = is_pair(h) ? 0 : 352;
    if (h.vox_offset == 0 || std::isnan(h.vox_offset)) return std::uint64_t(least);
    if (!(h.vox_offset >= float(least) && h.vox_offset < 1e15f))
        refuse(file, "its vox_offset is " + std::to_string(h.vox_offset) + ", but must be " + std::to_string(least) +
                         " at least");
    return std::uint64_t(h.vox_offset);
}

/// The library's matrices end the program where a number is none.
void check_orientation(const fs::path& file, const nifti_1_header& h) {
    const auto finite = [](std::initializer_list<float> numbers) {
        return std::all_of(numbers.begin(), numbers.end(), [](float f) { return std::isfinite(f); });
    };
    const auto row = [&](const float(&r)[4]) { return finite({r[0], r[1], r[2], r[3]}); };
    const bool by_quaternion =
        h.qform_code <= 0 || finite({h.quatern_b, h.quatern_c, h.quatern_d, h.qoffset_x, h.qoffset_y, h.qoffset_z});
    const bool by_matrix = h.sform_code <= 0 || (row(h.srow_x) && row(h.srow_y) && row(h.srow_z));
    if (!by_quaternion || !by_matrix)
        refuse(file, std::string("the orientation its ") + (by_matrix ? "qform" : "sform") +
                         " states holds what is no finite number");
}

/// Where the voxels of a pair lie; `.img` where there is none, for size_or_refuse() to say so.
fs::path image_beside(const fs::path& header) {
    std::error_code ec;
    for (const char* ending : {".img", ".IMG", ".img.gz"})
        if (const fs::path image = fs::path(header).replace_extension(ending); fs::is_regular_file(image, ec))
            return image;
    return fs::path(header).replace_extension(".img");
}

}  // namespace

fs::path nifti_pair_header(const fs::path& image) {
    std::error_code ec;
    for (const char* ending : {".hdr", ".HDR"}) {
        const fs::path header = fs::path(image).replace_extension(ending);
        nifti_1_header h{};
        std::ifstream in(header, std::ios::binary);
        if (in.read(reinterpret_cast<char*>(&h), sizeof h) && is_pair(h) &&
            fs::equivalent(image_beside(header), image, ec))
            return header;
    }
    return {};
}

HeaderFacts check_nifti(const fs::path& file) {
    const auto [h, other_order] = nifti_header(file);
    HeaderFacts facts;
    facts.type = nifti_type(file, h);
    std::uint64_t need = size_of(*facts.type);
    for (int a = 1; a <= h.dim[0]; ++a) {
        need = checked_bytes(file.string(), h.dim[a], 1, 1, need);
        if (a > 3 && h.dim[a] > 1)
            throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it holds " + std::to_string(h.dim[a]) +
                                               " volumes (time points or channels); extract one first.");
        if (a <= 3 && !(h.pixdim[a] > 0 && std::isfinite(h.pixdim[a])))
            refuse(file, "its spacing pixdim[" + std::to_string(a) + "] is " + std::to_string(h.pixdim[a]) +
                             ", but spacings must be positive numbers of mm");
    }
    check_orientation(file, h);
    if (std::isfinite(h.scl_slope) && h.scl_slope != 0) {  // zero: no scale at all
        facts.slope = h.scl_slope;
        facts.intercept = std::isfinite(h.scl_inter) ? h.scl_inter : 0;
    }
    const bool oriented = h.qform_code > 0 || h.sform_code > 0;
    facts.axis_names = axis_names_of({FileFormat::nifti, {}, oriented});
    if (!oriented)
        facts.warnings.push_back(
            {"The file states no orientation (neither qform nor sform): left and right cannot be "
             "known from it.",
             0});
    const fs::path data = is_pair(h) ? image_beside(file) : file;
    const std::uint64_t have = size_or_refuse(file, data, data.filename().string());
    const bool packed = lower_case(data.extension().string()) == ".gz";
    const bool swap = other_order == (std::endian::native == std::endian::little);
    const std::uint64_t offset = nifti_offset(file, h);
    // Readers agree to ignore bytes behind the voxels.
    facts.voxels = StoredVoxels{data, packed ? 0 : offset, packed ? offset : 0, need, packed, true, swap};
    if (packed || have < need + offset) check_length(file, have, need + (packed ? 0 : offset), packed);
    return facts;
}

}  // namespace lacuna
