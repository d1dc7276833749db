#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::test {

/// How the zoo writes a file's pixels.
enum class ZooSyntax { implicit_le, explicit_le, explicit_be, deflated, rle, jpeg_lossless, jpeg_ls };

/// An item of a VOI LUT Sequence.
struct ZooTable {
    std::string explanation;
    std::vector<int> entries;
    int first = 0, bits = 16;
    bool first_as_ss = false;  ///< the descriptor is written as SS, else as US whatever the sign
    bool packed = false;       ///< two entries of 8 bits a word
};

/// One small DICOM image; the defaults make a 6x5 CT slice of 16-bit words with 12 stored bits, in Hounsfield units.
struct ZooSlice {
    glm::ivec2 size{6, 5};
    glm::dvec3 position{0}, row{1, 0, 0}, column{0, 1, 0};
    std::string pixel_spacing = "0.5\\0.5";  ///< as written: rows first
    std::string thickness = "1";
    int bits_allocated = 16, bits_stored = 12, high_bit = -1;  ///< -1: bits_stored - 1
    bool is_signed = false;
    std::string slope = "1", intercept = "-1024", rescale_type;  ///< empty slope: no rescale at all
    std::string modality = "CT", photometric = "MONOCHROME2", image_type = "ORIGINAL\\PRIMARY\\AXIAL";
    std::string series_uid = "1.2.826.0.1.3680043.2.1143.1", description = "zoo";
    int series_number = 1, instance = 1;
    std::optional<int> acquisition, padding, padding_limit;
    std::function<int(int x, int y)> stored = [](int x, int y) { return 100 + 10 * y + x; };
    ZooSyntax syntax = ZooSyntax::explicit_le;
    std::vector<int> modality_lut;  ///< not empty: stored values from modality_lut_first on mean these
    int modality_lut_first = 0, modality_lut_claims = -1;  ///< entries the descriptor names; -1: as many as there are
    std::vector<ZooTable> voi_tables;
    bool with_meta = true;                                                     ///< false: no preamble and no meta group
    std::vector<std::pair<std::pair<unsigned, unsigned>, std::string>> extra;  ///< more text elements, by tag
};

void write_zoo_slice(const std::filesystem::path& file, const ZooSlice& slice);

/// An enhanced CT with one frame a position, in the order given: geometry and rescale in functional groups.
/// `stored(frame, x, y)` is a pixel's stored value.
void write_zoo_enhanced(const std::filesystem::path& file, const ZooSlice& like,
                        const std::vector<glm::dvec3>& positions,
                        const std::function<int(int frame, int x, int y)>& stored);

/// Cuts the last bytes off a file.
void cut_file(const std::filesystem::path& file, std::uintmax_t bytes);

/// An empty folder of its own, removed with everything in it at the end of the scope.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace lacuna::test
