#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/io/raw_reader.h"

namespace lacuna {

/// What a file name says of the voxels inside; each part may be missing.
struct RawNameHints {
    std::vector<int> size;          ///< two or three numbers joined by x; else empty
    std::optional<VoxelType> type;  ///< "uint16", "short", "float" ...
    std::optional<int> bits;        ///< "16bit": a width without a sign
    std::optional<bool> big_endian;
    std::optional<glm::dvec3> spacing_mm;  ///< three decimal fractions joined by x
};

RawNameHints raw_name_hints(std::string_view file_name);

/// One way to read a headerless file of voxels.
struct RawGuess {
    RawLayout layout;
    double confidence = 0;             ///< 0..1; those of all guesses together are at most 1
    std::vector<std::string> reasons;  ///< what speaks for it, one sentence part each, strongest first
};

/// Proposes how a file without header or sidecar is to be read, best first, at most eight ways; none for an empty file.
/// Word size, sign and byte order are those under which neighbouring words differ least, counted as
/// log2(1+|difference|) bits for each byte (the length of a simple delta code: Elias 1975); rows and slices are as long
/// as the distances at which the voxels repeat themselves best; sizes must fill the file, behind no header, one of a
/// usual length, or one that the size in the file's name or first bytes leaves over. Confidence is a softmax of the
/// code lengths, against "none of these". Cost: reads at most 64 MiB from the middle of the file; about a second.
/// @throws Error(io), Error(cancelled)
std::vector<RawGuess> guess_raw_layouts(const std::filesystem::path& file, const JobContext& job = {});

/// The layout as the words of --raw.
std::string raw_text(const RawLayout& layout);

}  // namespace lacuna
