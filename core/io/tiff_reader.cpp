#include "core/io/tiff_reader.h"

#include <tiffio.h>

#include <algorithm>
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"
#include "core/io/voxel_convert.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

/// An open TIFF file whose messages are kept instead of printed.
class TiffFile {
public:
    explicit TiffFile(const fs::path& file) : file_(file) {
        const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &TiffFile::keep_error, this);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &TiffFile::drop_warning, this);
        tiff_ = TIFFOpenExt(file.c_str(), "rm", options.get());
        if (!tiff_) refuse("it is no TIFF file or is damaged");
    }
    ~TiffFile() {
        if (tiff_) TIFFClose(tiff_);
    }
    TiffFile(const TiffFile&) = delete;
    TiffFile& operator=(const TiffFile&) = delete;

    TIFF* get() const { return tiff_; }
    /// What the library found wrong so far, if anything.
    const std::string& message() const { return message_; }
    template <class T>
    T tag(std::uint32_t id, T otherwise = {}) const {
        T value = otherwise;
        return TIFFGetFieldDefaulted(tiff_, id, &value) ? value : otherwise;
    }
    [[noreturn]] void refuse(const std::string& fault, Errc code = Errc::bad_input) const {
        throw Error(code, "Cannot read " + file_.string() + ": " + fault +
                              (message_.empty() ? "" : " (" + message_ + ")") + ".");
    }

private:
    static int keep_error(TIFF*, void* self, const char*, const char* format, va_list arguments) {
        char text[256];
        std::vsnprintf(text, sizeof text, format, arguments);
        auto& message = static_cast<TiffFile*>(self)->message_;
        if (message.empty()) message = text;
        while (!message.empty() && message.back() == '.') message.pop_back();
        return 1;
    }
    static int drop_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

    fs::path file_;
    TIFF* tiff_ = nullptr;
    std::string message_;
};

/// What all pages of a volume must share.
struct PageLayout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 0, format = SAMPLEFORMAT_UINT, photometric = 0;
    bool packed = false;                      ///< pixels of one bit, eight a byte; read as bytes of 0 and 1
    std::vector<std::uint8_t> grey_of_index;  ///< of a palette; empty: none

    /// Bytes in the file of so many pixels of a row.
    std::size_t stored(std::uint32_t pixels) const {
        return packed ? (std::size_t(pixels) + 7) / 8 : std::size_t(pixels) * (bits / 8);
    }
    std::size_t bytes() const { return std::size_t(width) * height * (bits / 8); }
    bool operator==(const PageLayout&) const = default;
};

std::vector<std::uint8_t> grey_palette(const TiffFile& file, std::uint16_t bits) {
    std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (bits != 8 || !TIFFGetField(file.get(), TIFFTAG_COLORMAP, &red, &green, &blue))
        file.refuse("its palette is not of 8 bits; convert it to grey values", Errc::unsupported);
    const bool wide = *std::max_element(red, red + 256) > 255;  // old writers stored 8 bit entries
    std::vector<std::uint8_t> grey(256);
    for (int i = 0; i < 256; ++i) {
        if (red[i] != green[i] || red[i] != blue[i])
            file.refuse("it has a colour palette; convert it to grey values", Errc::unsupported);
        grey[std::size_t(i)] = std::uint8_t(wide ? red[i] >> 8 : red[i]);
    }
    return grey;
}

PageLayout layout_of(const TiffFile& file) {
    PageLayout page;
    page.width = file.tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
    page.height = file.tag<std::uint32_t>(TIFFTAG_IMAGELENGTH);
    page.bits = file.tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
    page.format = file.tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    page.photometric = file.tag<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    if (page.format == SAMPLEFORMAT_VOID) page.format = SAMPLEFORMAT_UINT;
    if (file.tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1) != 1)
        file.refuse("it has several samples a pixel (colours); convert it to grey values", Errc::unsupported);
    if (page.photometric == PHOTOMETRIC_PALETTE)
        page.grey_of_index = grey_palette(file, page.bits);
    else if (page.photometric != PHOTOMETRIC_MINISBLACK && page.photometric != PHOTOMETRIC_MINISWHITE)
        file.refuse("it holds no grey values; convert it", Errc::unsupported);
    const bool whole = page.format == SAMPLEFORMAT_UINT || page.format == SAMPLEFORMAT_INT;
    const bool real = page.format == SAMPLEFORMAT_IEEEFP;
    page.packed = page.bits == 1 && page.format == SAMPLEFORMAT_UINT;
    if (page.packed) page.bits = 8;
    const bool known = (whole && (page.bits == 8 || page.bits == 16 || page.bits == 32)) ||
                       (real && (page.bits == 32 || page.bits == 64));
    if (!known)
        file.refuse("its pixels of " + std::to_string(page.bits) +
                        " bits are not supported; convert it to 8 or 16 bit integers or 32 bit floats",
                    Errc::unsupported);
    if (page.width < 1 || page.height < 1) file.refuse("it has no pixels");
    return page;
}

/// Pixels of a row as they lie in the file to where they belong.
void put_row(const PageLayout& page, const std::byte* from, std::uint32_t pixels, std::byte* to) {
    if (!page.packed) {
        std::memcpy(to, from, page.stored(pixels));
        return;
    }
    for (std::uint32_t x = 0; x < pixels; ++x) to[x] = from[x / 8] >> (7 - x % 8) & std::byte{1};
}

void read_strips(const TiffFile& file, const PageLayout& page, std::byte* to) {
    const std::size_t row = std::size_t(page.width) * (page.bits / 8), stored = page.stored(page.width);
    if (std::size_t(TIFFScanlineSize64(file.get())) != stored)
        file.refuse("its rows are not as long as its width says");
    const std::uint32_t rows =
        std::max(1u, std::min(page.height, file.tag<std::uint32_t>(TIFFTAG_ROWSPERSTRIP, page.height)));
    std::vector<std::byte> packed(page.packed ? stored * rows : 0);
    for (std::uint32_t y = 0; y < page.height; y += rows) {
        const std::uint32_t here = std::min(rows, page.height - y);
        const auto want = tmsize_t(stored * here);
        std::byte* into = page.packed ? packed.data() : to + y * row;
        if (TIFFReadEncodedStrip(file.get(), TIFFComputeStrip(file.get(), y, 0), into, want) != want)
            file.refuse("its pixels are damaged or cut short");
        for (std::uint32_t r = 0; page.packed && r < here; ++r)
            put_row(page, packed.data() + r * stored, page.width, to + (y + r) * row);
    }
}

void read_tiles(const TiffFile& file, const PageLayout& page, std::byte* to) {
    const std::size_t word = page.bits / 8, row = std::size_t(page.width) * word;
    const auto w = file.tag<std::uint32_t>(TIFFTAG_TILEWIDTH), h = file.tag<std::uint32_t>(TIFFTAG_TILELENGTH);
    const auto bytes = std::size_t(TIFFTileSize64(file.get()));
    if (w < 1 || h < 1 || bytes != std::size_t(h) * page.stored(w)) file.refuse("its tiles have an odd size");
    std::vector<std::byte> tile(bytes);
    for (std::uint32_t y = 0; y < page.height; y += h)
        for (std::uint32_t x = 0; x < page.width; x += w) {
            if (TIFFReadTile(file.get(), tile.data(), x, y, 0, 0) < 0)
                file.refuse("its pixels are damaged or cut short");
            const std::uint32_t rows = std::min(h, page.height - y);
            for (std::uint32_t r = 0; r < rows; ++r)
                put_row(page, tile.data() + r * page.stored(w), std::min(w, page.width - x),
                        to + (y + r) * row + x * word);
        }
}

void read_page(const TiffFile& file, const PageLayout& first, std::byte* to) {
    const PageLayout page = layout_of(file);
    if (page != first)
        file.refuse("page " + std::to_string(TIFFCurrentDirectory(file.get()) + 1) + " has " +
                    std::to_string(page.width) + "x" + std::to_string(page.height) + " pixels of " +
                    std::to_string(page.bits) + " bits, or another palette or type, unlike the first page with " +
                    std::to_string(first.width) + "x" + std::to_string(first.height) + " of " +
                    std::to_string(first.bits));
    if (TIFFIsTiled(file.get()))
        read_tiles(file, page, to);
    else
        read_strips(file, page, to);
    if (!page.grey_of_index.empty())
        for (std::size_t i = 0; i < page.bytes(); ++i)
            to[i] = std::byte(page.grey_of_index[std::size_t(std::to_integer<int>(to[i]))]);
}

/// ImageJ writes volumes over 4 GiB as one page followed by all others, uncompressed; the count stands in its text.
std::int64_t imagej_number(const TiffFile& file, std::string_view key, std::string* text = nullptr) {
    const char* description = nullptr;
    if (!TIFFGetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, &description) || !description) return 0;
    if (!std::string_view(description).starts_with("ImageJ=")) return 0;
    for (const auto line : split(std::string_view(description), "\n"))
        if (line.starts_with(key)) {
            const auto value = line.substr(key.size());
            if (text) *text = std::string(value);
            return number_in<std::int64_t>(value).value_or(0);
        }
    return 0;
}

int page_count(const TiffFile& file) {
    const int pages = int(TIFFNumberOfDirectories(file.get()));
    if (!file.message().empty())  // the library counts as far as it comes
        file.refuse("its list of pages is damaged or cut short after page " + std::to_string(pages));
    TIFFSetDirectory(file.get(), 0);
    const std::int64_t frames = imagej_number(file, "frames=");  // as many as pages: a stack named so
    if (imagej_number(file, "channels=") > 1 || (frames > 1 && frames < imagej_number(file, "images=")))
        file.refuse("ImageJ stored several channels or points of time in its pages; save one of them alone",
                    Errc::unsupported);
    if (pages == 1 && imagej_number(file, "images=") > 1)
        file.refuse("ImageJ stored its " + std::to_string(imagej_number(file, "images=")) +
                        " slices behind one page; save it as raw or as an image sequence",
                    Errc::unsupported);
    return pages;
}

/// The spacing ImageJ's description states, where its unit is one of a part's length (never inch: printers' default).
std::optional<glm::dvec3> imagej_spacing(const TiffFile& file) {
    std::string unit, step;
    imagej_number(file, "unit=", &unit);
    imagej_number(file, "spacing=", &step);
    static const std::pair<std::string_view, double> k_units[] = {
        {"mm", 1.0},        {"um", 1e-3},    {"micron", 1e-3}, {"microns", 1e-3},
        {"\\u00B5m", 1e-3}, {"\xb5m", 1e-3}, {"nm", 1e-6},     {"cm", 10.0}};
    double mm = 0;
    for (const auto& [word, value] : k_units)
        if (unit == word) mm = value;
    const float x = file.tag<float>(TIFFTAG_XRESOLUTION), y = file.tag<float>(TIFFTAG_YRESOLUTION);
    const double z = number_in<double>(step).value_or(0);
    const auto sound = [](double v) { return std::isfinite(v) && v > 0; };
    if (!sound(mm) || !sound(x) || !sound(y)) return std::nullopt;
    return glm::dvec3(mm / x, mm / y, sound(z) ? z * mm : mm / x);
}

/// Splits a name into texts and numbers, so that slice9 comes before slice10.
bool natural_less(const std::string& a, const std::string& b) {
    std::size_t i = 0, j = 0;
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    while (i < a.size() && j < b.size()) {
        if (digit(a[i]) && digit(b[j])) {
            const std::size_t i0 = std::min(a.find_first_not_of('0', i), a.size());
            const std::size_t j0 = std::min(b.find_first_not_of('0', j), b.size());
            std::size_t ie = i0, je = j0;
            while (ie < a.size() && digit(a[ie])) ++ie;
            while (je < b.size() && digit(b[je])) ++je;
            if (ie - i0 != je - j0) return ie - i0 < je - j0;
            if (const int c = a.compare(i0, ie - i0, b, j0, je - j0)) return c < 0;
            i = ie, j = je;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i, ++j;
        }
    }
    return a.size() - i < b.size() - j || (a.size() - i == b.size() - j && a < b);
}

/// Names the holes in a numbered stack: its slices would lie too close together without anyone noticing.
void warn_of_gaps(const std::vector<fs::path>& files, std::vector<Warning>& warnings) {
    std::vector<std::int64_t> numbers;
    for (const fs::path& file : files) {
        const std::string stem = file.stem().string();
        const auto last = stem.find_last_not_of("0123456789");
        const auto number = number_in<std::int64_t>(stem.substr(last == std::string::npos ? 0 : last + 1));
        if (!number) return;
        numbers.push_back(*number);
    }
    std::int64_t step = numbers.size() > 1 ? numbers[1] - numbers[0] : 1;
    for (std::size_t i = 1; i < numbers.size(); ++i) step = std::min(step, numbers[i] - numbers[i - 1]);
    std::string holes;
    for (std::size_t i = 1; i < numbers.size() && step > 0; ++i)
        if (numbers[i] - numbers[i - 1] != step && holes.size() < 200)
            holes += (holes.empty() ? "" : ", ") + std::to_string(numbers[i - 1]) + " to " + std::to_string(numbers[i]);
    if (!holes.empty()) warnings.push_back({"Slices are missing in the numbered stack: from " + holes + ".", 0});
}

struct StackLayout {
    PageLayout page;
    std::vector<int> first_slice;  ///< of each file, and the total at the end
    std::optional<glm::dvec3> spacing;
    bool turned = false;  ///< the first row is not the top one, or its first pixel not the left one
};

StackLayout stack_layout(const std::vector<fs::path>& files) {
    const TiffFile file(files.at(0));
    StackLayout stack;
    stack.page = layout_of(file);
    stack.spacing = imagej_spacing(file);
    stack.turned = file.tag<std::uint16_t>(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) != ORIENTATION_TOPLEFT;
    const int pages = page_count(file);
    stack.first_slice.push_back(0);
    if (files.size() == 1) {
        stack.first_slice.push_back(pages);
        return stack;
    }
    if (pages != 1)
        file.refuse("a folder of TIFF files is a stack of slices, but this file has " + std::to_string(pages) +
                    " pages; open one multi-page file by its name");
    for (std::size_t i = 0; i < files.size(); ++i) stack.first_slice.push_back(int(i) + 1);
    return stack;
}

VoxelBuffer read_pages(const std::vector<fs::path>& files, const StackLayout& stack, const JobContext& job) {
    const std::size_t page_bytes = stack.page.bytes();
    const int slices = stack.first_slice.back();
    VoxelBuffer pixels(std::size_t(
        checked_bytes(files[0].string(), stack.page.width, stack.page.height, slices, stack.page.bits / 8)));
    if (files.size() == 1) {
        const TiffFile file(files[0]);
        for (int z = 0; z < slices; ++z) {
            if (z > 0 && !TIFFReadDirectory(file.get()))
                file.refuse("page " + std::to_string(z + 1) + " cannot be read");
            read_page(file, stack.page, pixels.data() + std::size_t(z) * page_bytes);
            job.checkpoint(std::size_t(z) + 1, std::size_t(slices));
        }
        return pixels;
    }
    parallel_for(
        0, slices,
        [&](std::int64_t z) {
            const TiffFile file(files[std::size_t(z)]);
            read_page(file, stack.page, pixels.data() + std::size_t(z) * page_bytes);
        },
        job);
    return pixels;
}

template <class T>
ConvertedVoxels converted(const VoxelBuffer& pixels, bool shrink, const JobContext& job) {
    return to_smallest<T>({reinterpret_cast<const T*>(pixels.data()), pixels.size() / sizeof(T)}, shrink, job);
}

ConvertedVoxels voxels_of(const PageLayout& page, VoxelBuffer pixels, const JobContext& job) {
    const bool sign = page.format == SAMPLEFORMAT_INT;
    if (page.bits == 64) return converted<double>(pixels, false, job);
    if (page.bits == 8) return {sign ? VoxelType::i8 : VoxelType::u8, std::move(pixels), {}};
    if (page.bits == 16) return {sign ? VoxelType::i16 : VoxelType::u16, std::move(pixels), {}};
    if (page.format == SAMPLEFORMAT_IEEEFP) return {VoxelType::f32, std::move(pixels), {}};
    return sign ? converted<std::int32_t>(pixels, true, job) : converted<std::uint32_t>(pixels, true, job);
}

}  // namespace

std::vector<fs::path> tiff_stack(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec)) {
        const std::string ending = lower_case(entry.path().extension().string());
        if ((ending == ".tif" || ending == ".tiff") && entry.is_regular_file(ec)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return natural_less(a.filename().string(), b.filename().string());
    });
    return files;
}

glm::ivec3 tiff_size(const std::vector<fs::path>& files) {
    const StackLayout stack = stack_layout(files);
    checked_bytes(files[0].string(), stack.page.width, stack.page.height, stack.first_slice.back(), 1);
    return {int(stack.page.width), int(stack.page.height), stack.first_slice.back()};
}

Volume read_tiff(const std::vector<fs::path>& files, const JobContext& job) {
    const StackLayout stack = stack_layout(files);
    GridGeometry geometry;
    ConvertedVoxels read = voxels_of(stack.page, read_pages(files, stack, job.part(0, 0.8)), job.part(0.8, 1));
    geometry.size = {int(stack.page.width), int(stack.page.height), stack.first_slice.back()};
    std::vector<Warning> warnings;
    if (stack.spacing)
        geometry.spacing = *stack.spacing;
    else
        warnings.push_back({"The voxel spacing is not stated; 1 x 1 x 1 mm is assumed.", 0});
    if (stack.turned)
        warnings.push_back(
            {"The pages are marked as stored mirrored or turned (TIFF's Orientation); rows and columns "
             "were kept as they are stored.",
             0});
    if (stack.page.photometric == PHOTOMETRIC_MINISWHITE)
        warnings.push_back({"The pages are marked white-is-zero; stored values were kept as they are.", 0});
    if (files.size() > 1) warn_of_gaps(files, warnings);
    if (!read.warning.empty()) warnings.push_back({read.warning, 0});
    Volume volume(geometry, read.type, std::move(read.voxels));
    const fs::path named = files.size() > 1 ? files[0].parent_path() : files[0];
    volume.name = named.filename().string();
    volume.warnings = std::move(warnings);
    return volume;
}

}  // namespace lacuna
