#include "core/io/dicom_pixels.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/byte_order.h"
#include "core/io/dicom_codecs.h"
#include "core/io/dicom_samples.h"
#include "core/io/random_access_file.h"

namespace lacuna::dicom {

namespace {

constexpr std::int64_t k_band_slices = 16;        // converted between two releases of memory no longer needed
constexpr double k_f32_whole_limit = 16777216.0;  // 2^24: f32 holds every whole number up to here

static_assert(std::endian::native == std::endian::little, "the DICOM reader assumes a little-endian machine");

[[noreturn]] void throw_cut_short(const File& file) {
    throw Error(Errc::bad_input,
                "Cannot read " + file.path.string() + ": it is cut short; copy or export the file again.",
                file.path.string());
}

/// Fills `target` with the bytes from `first` on of the pixels, in the order of their values: words that hold several
/// pixels hold the first in their lower half (PS3.5 8.1.1), which a big-endian file stores second.
void read_bytes(const RandomAccessFile& bytes, const File& file, std::uint64_t first, std::span<std::byte> target) {
    const bool halves = file.big_endian && file.words && file.pixels.bits_allocated <= 8;
    if (!halves) {
        if (bytes.read(file.pixel_offset + first, target) != target.size()) throw_cut_short(file);
        return;
    }
    const std::uint64_t from = first / 2 * 2, end = (first + target.size() + 1) / 2 * 2;
    std::vector<std::byte> words(std::size_t(end - from));
    if (bytes.read(file.pixel_offset + from, words) != words.size()) throw_cut_short(file);
    swap_words(words, 2);
    std::memcpy(target.data(), words.data() + (first - from), target.size());
}

/// Reads one uncompressed frame's bytes as they lie in the file, in the machine's byte order.
void read_direct(const RandomAccessFile& bytes, const File& file, int frame, std::span<std::byte> target) {
    const auto each = std::size_t(file.pixels.frame_bytes());
    read_bytes(bytes, file, std::uint64_t(each) * std::uint64_t(frame), target.first(each));
    if (file.big_endian && file.pixels.bits_allocated > 8)
        swap_words(target.first(each), std::size_t(file.pixels.bits_allocated / 8));
}

/// 1-bit frames follow each other without gaps, lowest bit first (PS3.5 8.1.1).
void read_bits(const RandomAccessFile& bytes, const File& file, int frame, std::span<std::byte> target) {
    const std::uint64_t count = std::uint64_t(file.pixels.pixels()), first = count * std::uint64_t(frame);
    std::vector<std::byte> packed(std::size_t((first % 8 + count + 7) / 8));
    read_bytes(bytes, file, first / 8, packed);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t bit = first % 8 + i;
        target[i] = (packed[bit / 8] >> int(bit % 8)) & std::byte(1);
    }
}

/// What is to be read from one file: all its slices for a decoder, one slice where pixels are read directly.
struct Task {
    const File* file = nullptr;
    std::vector<std::size_t> slices;  // positions in `order`
};

class Loader {
public:
    Loader(const SeriesScan& scan, std::span<const std::size_t> order, std::span<const int> planes, int plane_count)
        : scan_(scan), order_(order), planes_(planes), plane_count_(plane_count), states_(order.size()) {
        const PixelFormat& format = scan.file_of(scan.slices[order.front()]).pixels;
        pixels_ = format.pixels();
        for (const std::size_t s : order) {
            const PixelFormat& each = scan.file_of(scan.slices[s]).pixels;
            wide_ = wide_ || each.kind != PixelKind::integer || each.bits_allocated > 16 ||
                    scan.file_of(scan.slices[s]).lut;
            word_bytes_ = std::max(word_bytes_, each.bits_allocated > 8 ? 2 : 1);
        }
        if (wide_) word_bytes_ = 4;
    }

    LoadedSlices load(const JobContext& job) {
        raw_ = VoxelBuffer(std::size_t(pixels_) * std::size_t(plane_count_) * std::size_t(word_bytes_));
        const std::vector<Task> tasks = make_tasks();
        const auto reading = job.part(0, 0.9);
        parallel_for(
            0, std::int64_t(tasks.size()), [&](std::int64_t t) { run(tasks[std::size_t(t)], job); }, reading);
        find_range();
        if (wide_)
            finish_wide(job.part(0.9, 1));
        else if (word_bytes_ == 2)
            finish<std::uint16_t>(job.part(0.9, 1));
        else
            finish<std::uint8_t>(job.part(0.9, 1));
        return std::move(result_);
    }

private:
    const Frame& slice(std::size_t i) const { return scan_.slices[order_[i]]; }
    std::int64_t plane_start(std::size_t i) const { return std::int64_t(planes_[i]) * pixels_; }

    std::vector<Task> make_tasks() const {
        std::vector<Task> tasks;
        std::vector<std::ptrdiff_t> of_file(scan_.files.size(), -1);
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const File& file = scan_.file_of(slice(i));
            std::ptrdiff_t& at = of_file[std::size_t(slice(i).file)];
            if (file.direct || at < 0) {
                at = std::ptrdiff_t(tasks.size());
                tasks.push_back({&file, {}});
            }
            tasks[std::size_t(at)].slices.push_back(i);
        }
        return tasks;
    }

    void run(const Task& task, const JobContext& job) {
        const File& file = *task.file;
        if (file.direct) {
            const std::size_t i = task.slices.front();
            const RandomAccessFile bytes(file.path);
            load_direct(bytes, file, i);
            return;
        }
        std::vector<std::size_t> by_frame;
        int count = 0;
        for (const std::size_t i : task.slices) {
            const auto frame = std::size_t(slice(i).number);
            if (by_frame.size() <= frame) by_frame.resize(frame + 1, order_.size());
            by_frame[frame] = i;
            count = std::max(count, slice(i).number + 1);
        }
        const JobContext quiet{job.stop, nullptr};
        decode_frames(
            file, count,
            [&](int frame, std::span<const std::byte> samples, const PixelFormat& format) {
                const std::size_t i = by_frame[std::size_t(frame)];
                if (i < order_.size()) settle_decoded(i, samples, format);
            },
            quiet);
    }

    std::span<std::byte> plane_bytes(std::size_t i) const {
        const auto bytes = std::size_t(pixels_) * std::size_t(word_bytes_);
        return {raw_.data() + std::size_t(planes_[i]) * bytes, bytes};
    }

    void load_direct(const RandomAccessFile& bytes, const File& file, std::size_t i) {
        const PixelFormat& format = file.pixels;
        if (format.bits_allocated == 1) {
            std::vector<std::byte> unpacked(std::size_t(format.pixels()));
            read_bits(bytes, file, slice(i).number, unpacked);
            PixelFormat as_bytes = format;
            as_bytes.bits_allocated = 8;
            settle_decoded(i, unpacked, as_bytes);
        } else if (!wide_ && format.bits_allocated == 8 * word_bytes_) {
            read_direct(bytes, file, slice(i).number, plane_bytes(i));
            settle(i, format);
        } else {
            std::vector<std::byte> samples(std::size_t(format.frame_bytes()));
            read_direct(bytes, file, slice(i).number, samples);
            settle_decoded(i, samples, format);
        }
    }

    /// Samples of any width into the slice's plane.
    void settle_decoded(std::size_t i, std::span<const std::byte> samples, const PixelFormat& format) {
        if (wide_) {
            settle_wide(i, samples, format);
            return;
        }
        const std::span<std::byte> target = plane_bytes(i);
        if (format.bits_allocated == 8 * word_bytes_) {
            std::memcpy(target.data(), samples.data(), target.size());
        } else if (format.bits_allocated == 8 && word_bytes_ == 2) {
            auto* words = reinterpret_cast<std::uint16_t*>(target.data());
            for (std::int64_t p = 0; p < pixels_; ++p) words[p] = std::uint16_t(samples[std::size_t(p)]);
        } else {
            throw Error(Errc::unsupported, "The pixels of " + scan_.file_of(slice(i)).path.string() +
                                               " are wider than its header says; export it uncompressed.");
        }
        settle(i, format);
    }

    void settle(std::size_t i, const PixelFormat& format) {
        SliceState& state = states_[i];
        state.slope = slice(i).slope;
        state.intercept = slice(i).intercept;
        const auto& padding = scan_.file_of(slice(i)).padding;
        if (word_bytes_ == 2)
            settle_samples<std::uint16_t>(
                {reinterpret_cast<std::uint16_t*>(plane_bytes(i).data()), std::size_t(pixels_)}, format, padding,
                state);
        else
            settle_samples<std::uint8_t>({reinterpret_cast<std::uint8_t*>(plane_bytes(i).data()), std::size_t(pixels_)},
                                         format, padding, state);
    }

    static void add_padding(SliceState& state, std::int64_t pixel) {
        const auto at = std::uint32_t(pixel);
        if (!state.padding.empty() && state.padding.back().first + state.padding.back().count == at)
            ++state.padding.back().count;
        else
            state.padding.push_back({at, 1});
        ++state.padding_voxels;
    }

    template <class In>
    void widen(std::size_t i, std::span<const std::byte> samples, const PixelFormat& format) {
        SliceState& state = states_[i];
        auto* out = reinterpret_cast<float*>(plane_bytes(i).data());
        double lo = std::numeric_limits<double>::infinity(), hi = -lo;
        const int unused = std::is_floating_point_v<In> ? 0 : format.bits_allocated - format.bits_stored;
        const int low = format.high_bit + 1 - format.bits_stored;
        const double slope = slice(i).slope, intercept = slice(i).intercept;
        const File& file = scan_.file_of(slice(i));
        const ModalityLut* const lut = file.lut.get();
        const auto is_padding = [&](In value) {
            if constexpr (std::is_floating_point_v<In>)
                return file.float_padding && double(value) == double(In(*file.float_padding));
            else
                return file.padding && std::int64_t(value) >= file.padding->lo &&
                       std::int64_t(value) <= file.padding->hi;
        };
        for (std::int64_t p = 0; p < pixels_; ++p) {
            In stored;
            std::memcpy(&stored, samples.data() + std::size_t(p) * sizeof(In), sizeof(In));
            bool padding = is_padding(stored);  // outside the stored bits, or within
            if constexpr (std::is_integral_v<In>)
                if (unused > 0) stored = In(In(std::make_unsigned_t<In>(stored) << (unused - low)) >> unused);
            padding = padding || is_padding(stored);
            if (padding) {
                add_padding(state, p);
                continue;
            }
            const double value = lut ? (*lut)(double(stored)) : double(stored) * slope + intercept;
            out[p] = float(value);
            if (!std::isfinite(value)) {
                state.whole = false;
                continue;
            }
            lo = std::min(lo, value);
            hi = std::max(hi, value);
            state.whole = state.whole && value == std::floor(value);
        }
        wide_lo_[i] = lo;
        wide_hi_[i] = hi;
    }

    void settle_wide(std::size_t i, std::span<const std::byte> samples, const PixelFormat& format) {
        if (format.kind == PixelKind::float32)
            widen<float>(i, samples, format);
        else if (format.kind == PixelKind::float64)
            widen<double>(i, samples, format);
        else if (format.bits_allocated == 32)
            format.is_signed ? widen<std::int32_t>(i, samples, format) : widen<std::uint32_t>(i, samples, format);
        else if (format.bits_allocated == 16)
            format.is_signed ? widen<std::int16_t>(i, samples, format) : widen<std::uint16_t>(i, samples, format);
        else
            format.is_signed ? widen<std::int8_t>(i, samples, format) : widen<std::uint8_t>(i, samples, format);
    }

    void find_range() {
        double lo = std::numeric_limits<double>::infinity(), hi = -lo;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const SliceState& s = states_[i];
            result_.padding_voxels += s.padding_voxels;
            whole_ = whole_ && s.whole;
            if (wide_) {
                lo = std::min(lo, wide_lo_[i]);
                hi = std::max(hi, wide_hi_[i]);
            } else if (!s.all_padding()) {
                lo = std::min({lo, s.real(s.lo), s.real(s.hi)});  // a negative slope turns the order
                hi = std::max({hi, s.real(s.lo), s.real(s.hi)});
            }
        }
        if (!(lo <= hi)) lo = hi = wide_ ? 0 : states_.front().padding_value;
        result_.range = {lo, hi};
        result_.type = smallest_type(lo, hi, whole_);
        result_.rounded = whole_ && std::max(std::abs(lo), std::abs(hi)) > k_f32_whole_limit;
    }

    /// Bands of slices to the final type; each band's source memory is given back before the next is touched, so that
    /// both volumes never stand in memory at once.
    template <class Convert>
    void convert_bands(std::size_t out_bytes, const Convert& convert, const JobContext& job) {
        VoxelBuffer target(std::size_t(pixels_) * std::size_t(plane_count_) * out_bytes);
        std::vector<std::size_t> of_plane(std::size_t(plane_count_), states_.size());
        for (std::size_t i = 0; i < states_.size(); ++i) of_plane[std::size_t(planes_[i])] = i;
        const std::size_t plane = std::size_t(pixels_) * std::size_t(word_bytes_), page = 4096;
        std::size_t released = 0;
        for (std::int64_t first = 0; first < plane_count_; first += k_band_slices) {
            const std::int64_t last = std::min<std::int64_t>(plane_count_, first + k_band_slices);
            parallel_for(
                first, last,
                [&](std::int64_t p) {
                    if (const std::size_t i = of_plane[std::size_t(p)]; i < states_.size()) convert(i, target.data());
                },
                JobContext{job.stop, nullptr});
            const std::size_t done = std::size_t(last) * plane / page * page;
            if (done > released) ::madvise(raw_.data() + released, done - released, MADV_DONTNEED);
            released = done;
            job.checkpoint(std::size_t(last), std::size_t(plane_count_));
        }
        result_.voxels = std::move(target);
    }

    template <class T>
    void finish(const JobContext& job) {
        const double air = result_.range.lo;
        const T* in = reinterpret_cast<const T*>(raw_.data());
        visit_type(result_.type, [&](auto tag) {
            using Out = decltype(tag);
            if constexpr (sizeof(Out) == sizeof(T)) {
                auto* out = reinterpret_cast<Out*>(raw_.data());
                parallel_for(
                    0, std::int64_t(states_.size()),
                    [&](std::int64_t s) {
                        const auto i = std::size_t(s);
                        finish_samples<T, Out>(in + plane_start(i), out + plane_start(i), std::size_t(pixels_),
                                               states_[i], air);
                    },
                    job);
                result_.voxels = std::move(raw_);
            } else {
                convert_bands(
                    sizeof(Out),
                    [&](std::size_t i, std::byte* target) {
                        finish_samples<T, Out>(in + plane_start(i), reinterpret_cast<Out*>(target) + plane_start(i),
                                               std::size_t(pixels_), states_[i], air);
                    },
                    job);
            }
        });
    }

    void finish_wide(const JobContext& job) {
        for (std::size_t i = 0; i < states_.size(); ++i) {
            auto* const values = reinterpret_cast<float*>(plane_bytes(i).data());
            for (const PaddingRun& run : states_[i].padding)
                std::fill_n(values + run.first, run.count, float(result_.range.lo));
        }
        if (result_.type == VoxelType::f32) {
            result_.voxels = std::move(raw_);
            return;
        }
        const auto* in = reinterpret_cast<const float*>(raw_.data());
        visit_type(result_.type, [&](auto tag) {
            using Out = decltype(tag);
            convert_bands(
                sizeof(Out),
                [&](std::size_t i, std::byte* target) {
                    const float* from = in + plane_start(i);
                    Out* to = reinterpret_cast<Out*>(target) + plane_start(i);
                    for (std::int64_t p = 0; p < pixels_; ++p) to[p] = Out(from[p]);
                },
                job);
        });
    }

    const SeriesScan& scan_;
    std::span<const std::size_t> order_;
    std::span<const int> planes_;
    int plane_count_ = 0, word_bytes_ = 1;
    bool wide_ = false, whole_ = true;
    std::int64_t pixels_ = 0;
    std::vector<SliceState> states_;
    std::vector<double> wide_lo_ = std::vector<double>(states_.size()), wide_hi_ = wide_lo_;
    VoxelBuffer raw_;
    LoadedSlices result_;
};

}  // namespace

LoadedSlices load_slices(const SeriesScan& scan, std::span<const std::size_t> order, std::span<const int> planes,
                         int plane_count, const JobContext& job) {
    return Loader(scan, order, planes, plane_count).load(job);
}

}  // namespace lacuna::dicom
