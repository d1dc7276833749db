#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/base/job.h"
#include "core/io/dicom_header.h"

namespace lacuna::dicom {

/// The stored samples of one frame, in the machine's byte order; `format` says how wide they came out (lossy codecs
/// may hand out 8 bits where the header says 16).
using FrameSink = std::function<void(int frame, std::span<const std::byte> samples, const PixelFormat& format)>;

/// Decodes the frames [0, count) of a file whose pixels do not lie in it as they are: RLE, JPEG, JPEG-LS and deflated
/// by DCMTK, JPEG 2000 by GDCM (OpenJPEG). Calls the sink once a frame, in order. Thread-safe for different files.
/// @throws Error(bad_input) naming a file that is cut short or damaged; Error(unsupported) naming the transfer syntax;
/// Error(cancelled)
/// Memory: one frame beyond the compressed bytes; the whole file's frames for JPEG 2000 and deflated.
void decode_frames(const File& file, int count, const FrameSink& sink, const JobContext& job);

}  // namespace lacuna::dicom
