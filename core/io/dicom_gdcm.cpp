#include "core/io/dicom_gdcm.h"

#include <gdcmImageReader.h>
#include <gdcmTrace.h>

#include <mutex>
#include <vector>

namespace lacuna::dicom {

void decode_by_gdcm(const File& file, int count, const FrameSink& sink, const JobContext& job) {
    static std::once_flag once;
    std::call_once(once, [] {
        gdcm::Trace::DebugOff();
        gdcm::Trace::WarningOff();
        gdcm::Trace::ErrorOff();
    });
    const auto damaged = [&](const char* what) {
        return Error(
            Errc::bad_input,
            "Cannot read the pixels of " + file.path.string() + ": " + what + "; copy or export the file again.",
            file.path.string());
    };
    std::vector<std::byte> all;
    PixelFormat format = file.pixels;
    try {
        gdcm::ImageReader reader;
        reader.SetFileName(file.path.c_str());
        if (!reader.Read()) throw damaged("they are cut short or damaged");
        job.check();
        const gdcm::Image& image = reader.GetImage();
        format.bits_allocated = image.GetPixelFormat().GetBitsAllocated();
        format.bits_stored = image.GetPixelFormat().GetBitsStored();
        format.high_bit = image.GetPixelFormat().GetHighBit();
        all.resize(image.GetBufferLength());
        if (!image.GetBuffer(reinterpret_cast<char*>(all.data()))) throw damaged("they are cut short or damaged");
    } catch (const Error&) {
        throw;
    } catch (const std::exception&) {
        throw damaged("the decoder failed");
    }
    const auto each = std::size_t(format.frame_bytes());
    if (format.bits_stored < 1 || format.high_bit >= format.bits_allocated ||
        format.high_bit < format.bits_stored - 1 || all.size() < each * std::size_t(count))
        throw damaged("they are cut short");
    for (int f = 0; f < count; ++f) {
        job.check();
        sink(f, std::span<const std::byte>(all).subspan(each * std::size_t(f), each), format);
    }
}

}  // namespace lacuna::dicom
