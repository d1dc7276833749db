#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

class DcmItem;

namespace lacuna::dicom {

enum class PixelKind { none, integer, float32, float64 };

/// A table from stored to real values where no line does (Modality LUT, PS3.3 C.11.1); constant beyond its ends.
struct ModalityLut {
    std::int64_t first = 0;             ///< stored value of the first entry
    std::vector<std::uint16_t> values;  ///< at least one

    double operator()(double stored) const {
        const double at = std::clamp(stored - double(first), 0.0, double(values.size() - 1));
        return values[std::size_t(at)];
    }
};

/// How the samples of an image are stored (PS3.3 C.7.6.3).
struct PixelFormat {
    PixelKind kind = PixelKind::none;
    int columns = 0, rows = 0;
    int bits_allocated = 0, bits_stored = 0, high_bit = 0;
    int samples = 1;  ///< more than 1: colour
    bool is_signed = false;
    std::string photometric{};

    std::int64_t pixels() const { return std::int64_t(columns) * rows; }
    /// Bytes of one uncompressed frame; frames of 1-bit data are packed, so theirs is a count of bits / 8, rounded up.
    std::int64_t frame_bytes() const { return (pixels() * bits_allocated + 7) / 8; }
};

/// Stored values from lo to hi stand for "no measurement here" (PixelPaddingValue, PixelPaddingRangeLimit).
struct Padding {
    std::int64_t lo = 0, hi = 0;
};

/// What is known of one slice: a frame of a file.
struct Frame {
    int file = 0;                              ///< index into the scan's files
    int number = 0;                            ///< frame within the file, from 0
    std::optional<glm::dvec3> position;        ///< ImagePositionPatient, mm, LPS
    glm::dvec3 row{1, 0, 0}, column{0, 1, 0};  ///< unit vectors along a row (x) and down a column (y)
    bool has_orientation = false;
    std::optional<glm::dvec2> spacing;     ///< mm; x between columns, y between rows
    double thickness_mm = 0, step_mm = 0;  ///< SliceThickness, SpacingBetweenSlices; 0: absent
    double slope = 1, intercept = 0;
    bool has_rescale = false;
    std::string rescale_type;
    std::string acquisition;  ///< what tells apart two passes over the same positions
    std::optional<int> instance;
    bool localizer = false;
    std::optional<double> window_center, window_width;

    glm::dvec3 normal() const { return glm::cross(row, column); }
};

/// The header of one file with pixels. Never holds what identifies a patient (except a DICONDE part's fields).
struct File {
    std::filesystem::path path;
    std::string series_uid, modality, description, syntax_uid, syntax_name;
    std::string study_uid, frame_of_reference_uid, sop_class_uid, sop_instance_uid;
    int series_number = 0;
    PixelFormat pixels;
    std::optional<Padding> padding;
    std::optional<double> float_padding;     ///< the same of floating-point pixels (FloatPixelPaddingValue)
    std::shared_ptr<const ModalityLut> lut;  ///< replaces the frames' rescale
    bool direct = false;                     ///< pixels lie uncompressed in the file, from pixel_offset on
    bool big_endian = false;
    bool words = false;  ///< pixels are stored as words of 16 bits (VR OW), whatever their own width
    std::uint64_t pixel_offset = 0, pixel_bytes = 0, file_bytes = 0;
    std::vector<std::pair<std::string, std::string>> component;
    std::string fault;          ///< why the file cannot be read, one sentence part; empty: sound
    bool unsupported = false;   ///< the fault is one of this program, not of the file
    std::vector<Frame> frames;  ///< Frame::file is 0 until the scan numbers them

    /// For messages: the file's name without its folders.
    std::string name() const { return path.filename().string(); }
};

/// What a file turned out to be.
enum class FileClass { not_dicom, no_image, image, unreadable, locked };

struct HeaderResult {
    FileClass what = FileClass::not_dicom;
    File file;  ///< filled for `image`; path and fault for `unreadable`
};

/// True if the first bytes are those of a DICOM file, or could start a data set written without preamble and meta
/// group. `bytes`: the file's first 132 bytes or more (fewer: a shorter file).
bool starts_like_dicom(std::string_view bytes);

/// Reads a file's header, never its pixels. Cost: one open and some 16 KiB read for common headers.
/// Does not throw for what the file holds: a fault is recorded. @throws Error(io) if it cannot be opened
HeaderResult read_header(const std::filesystem::path& file);

/// Turns DCMTK's log off (it could print patient data) and registers its decoders, once a process; thread-safe.
void prepare_dcmtk();

/// Fills `file` (pixel format, frames with geometry and rescale) from a parsed data set. @throws std::runtime_error
/// with the fault as what() for values that cannot be
void fill_file(DcmItem& dataset, File& file);

/// Fills file.frames: plain images, enhanced multi-frame functional groups, RT dose grids.
void fill_frames(DcmItem& dataset, File& file, int frame_count);

}  // namespace lacuna::dicom
