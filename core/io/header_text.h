#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/io/header_check.h"

/// What the checks of the several header formats share.
namespace lacuna::headers {

/// Keys and values as a header states them.
using Fields = std::map<std::string, std::string>;

struct HeaderText {
    Fields fields;
    std::size_t end = 0;  ///< bytes of the header
};

/// @throws Error(bad_input) "Cannot read FILE: FAULT."
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& fault);

/// The first bytes of a file, more than any header has. @throws Error(io)
std::string head_of(const std::filesystem::path& file);

/// Size of the data file a header names as `named`. @throws Error(bad_input) where it is not there
std::uint64_t size_or_refuse(const std::filesystem::path& header, const std::filesystem::path& data,
                             const std::string& named);

/// @param have  bytes in the file from the voxels on
/// @param need  bytes of the voxels, unpacked
/// @throws Error(bad_input) where those cannot be these
void check_length(const std::filesystem::path& header, std::uint64_t have, std::uint64_t need, bool compressed);

/// A field's value; empty where it is not stated.
std::string field(const Fields& fields, const std::string& key);

/// @param text  numbers behind `key`; an empty one passes
/// @throws Error(bad_input) where one is not positive and finite
void check_spacing(const std::filesystem::path& file, const std::string& key, const std::string& text);

/// Whether a name stands for several files: "LIST", or a pattern such as slice%03d.raw; not if there is such a file.
bool is_list(const std::filesystem::path& header, const std::string& named);

/// A pattern may reach a library that takes it for a format of printf: one whole number may stand in it, %d or %03d.
/// @throws Error(bad_input) for any other
void check_pattern(const std::filesystem::path& header, const std::string& named);

/// The names of a pattern with the numbers it goes through: "slice%03d.raw FIRST LAST STEP", the last ones optional.
/// @throws Error(bad_input) where they are not `count` files
std::vector<std::string> names_of_pattern(const std::filesystem::path& header, const std::string& named,
                                          std::int64_t count);

void warn_of_spacing(HeaderFacts& facts);

/// The factor of a unit named in a header; an unknown one is told and taken as mm.
double mm_of(const std::string& unit, HeaderFacts& facts);

}  // namespace lacuna::headers
