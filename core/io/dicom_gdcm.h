#pragma once

#include "core/io/dicom_codecs.h"

namespace lacuna::dicom {

/// As decode_frames, by GDCM, for what DCMTK 3.6 cannot decode: JPEG 2000, and JPEG-LS of odd precisions.
void decode_by_gdcm(const File& file, int count, const FrameSink& sink, const JobContext& job);

}  // namespace lacuna::dicom
