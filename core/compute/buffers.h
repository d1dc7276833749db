#pragma once

#include <cstddef>
#include <span>

#include "core/compute/device.h"

namespace lacuna {

/// Host addresses with this alignment (a cache line) can serve a CPU device without a copy.
inline constexpr std::size_t k_zero_copy_alignment = 64;

/// A read-only buffer with the bytes at `data`. On unified memory and an aligned address the device reads `data`
/// itself, which must then outlive the buffer and every kernel that uses it, unchanged; else the bytes are copied now.
/// @throws Error(bad_input) for no bytes; Error(out_of_memory), also where `bytes` exceeds what the device allocates at
/// once; Error(device)
cl::Buffer device_buffer(ComputeDevice& device, const void* data, std::size_t bytes);

/// Whether device_buffer would use `data` in place.
bool is_zero_copy(const ComputeDevice& device, const void* data);

/// An uninitialised buffer that kernels may read and write. @throws as device_buffer
cl::Buffer scratch_buffer(ComputeDevice& device, std::size_t bytes);

/// A buffer of its own with a copy of the bytes at `data`, which may go away afterwards. @throws as device_buffer
cl::Buffer uploaded_buffer(ComputeDevice& device, const void* data, std::size_t bytes);

/// Waits for the queue and copies the buffer's first `bytes` to `target`. @throws Error(device)
void read_bytes(ComputeDevice& device, const cl::Buffer& buffer, void* target, std::size_t bytes);

/// The same for values. @throws Error(device)
template <typename T>
void read_values(ComputeDevice& device, const cl::Buffer& buffer, std::span<T> target) {
    read_bytes(device, buffer, target.data(), target.size_bytes());
}

}  // namespace lacuna
