#pragma once

#include <cstddef>
#include <span>

namespace lacuna {

/// One file of kernels/ as it was at build time.
struct EmbeddedKernelFile {
    const char* name;            ///< relative to kernels/, e.g. "render/raycast.cl"
    const unsigned char* bytes;  ///< the text, not changed in any way
    std::size_t size;            ///< bytes of text
};

/// Every .cl, .clh and .h file of kernels/, ordered by name.
std::span<const EmbeddedKernelFile> embedded_kernel_files();

}  // namespace lacuna
