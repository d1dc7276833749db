#include "core/compute/buffers.h"

#include <cstdint>

#include "core/compute/device_error.h"

namespace lacuna {

namespace {

void check_size(const ComputeDevice& device, std::size_t bytes) {
    if (bytes == 0) throw Error(Errc::bad_input, "A device buffer of no bytes was asked for.");
    const std::size_t limit = device.info().max_allocation_bytes;
    if (limit > 0 && bytes > limit)
        throw Error(Errc::out_of_memory, "A buffer of " + std::to_string(bytes >> 20) + " MB is more than " +
                                             device.info().name + " allocates at once (" + std::to_string(limit >> 20) +
                                             " MB); use a smaller volume or a lower --memory-limit.");
}

}  // namespace

bool is_zero_copy(const ComputeDevice& device, const void* data) {
    return device.unified_memory() && reinterpret_cast<std::uintptr_t>(data) % k_zero_copy_alignment == 0;
}

cl::Buffer device_buffer(ComputeDevice& device, const void* data, std::size_t bytes) {
    check_size(device, bytes);
    const cl_mem_flags source = is_zero_copy(device, data) ? CL_MEM_USE_HOST_PTR : CL_MEM_COPY_HOST_PTR;
    return with_device_errors("copying " + std::to_string(bytes) + " bytes to the device", [&] {
        return cl::Buffer(device.context(), CL_MEM_READ_ONLY | source, bytes, const_cast<void*>(data));
    });
}

cl::Buffer scratch_buffer(ComputeDevice& device, std::size_t bytes) {
    check_size(device, bytes);
    return with_device_errors("allocating " + std::to_string(bytes) + " bytes on the device",
                              [&] { return cl::Buffer(device.context(), CL_MEM_READ_WRITE, bytes); });
}

cl::Buffer uploaded_buffer(ComputeDevice& device, const void* data, std::size_t bytes) {
    cl::Buffer buffer = scratch_buffer(device, bytes);
    with_device_errors("copying " + std::to_string(bytes) + " bytes to the device",
                       [&] { device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, data); });
    return buffer;
}

void read_bytes(ComputeDevice& device, const cl::Buffer& buffer, void* target, std::size_t bytes) {
    if (bytes == 0) return;
    with_device_errors("reading a result from the device",
                       [&] { device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, bytes, target); });
}

}  // namespace lacuna
