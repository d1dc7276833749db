#pragma once

#include "core/io/dicom_codecs.h"

namespace lacuna::dicom {

/// As decode_frames, by GDCM, for JPEG 2000, which DCMTK 3.6 cannot decode. Nothing else may go this way: GDCM's CharLS
/// and DCMTK's export the same names with different structures, and only DCMTK's is bound.
void decode_by_gdcm(const File& file, int count, const FrameSink& sink, const JobContext& job);

}  // namespace lacuna::dicom
