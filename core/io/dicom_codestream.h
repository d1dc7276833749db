#pragma once

#include "core/io/dicom_header.h"

namespace lacuna::dicom {

/// Compares what the compressed pixels say of their own size with the header's Rows and Columns: JPEG's and JPEG-LS's
/// frame header (ITU-T T.81 B.2.2, T.87 C.2.2), JPEG 2000's SIZ marker (T.800 A.5.1), the lengths that RLE unpacks to
/// (PS3.5 G.3). The decoders do not: they skew the picture, leave a part of it black, or write beyond their memory.
/// Cost: a few bytes of each frame; of RLE all of them, without unpacking.
/// @throws Error(bad_input) naming the file and both sizes; Error(io)
void check_codestreams(const File& file);

}  // namespace lacuna::dicom
