#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/compute/opencl.h"

namespace lacuna {

/// One OpenCL device as found, and what was learnt of it.
struct DeviceInfo {
    int index = 0;  ///< as listed, from 0
    std::string platform, name, vendor, driver, opencl_version;
    bool is_cpu = false, is_gpu = false;
    int compute_units = 0;
    std::size_t memory_bytes = 0, max_allocation_bytes = 0;
    bool usable = false;  ///< compiled and passed the self-test
    std::string fault;    ///< why not, when not usable
    double rank_ms = 0;   ///< time of the ranking kernel, smaller is faster; 0 when not measured
};

/// One context and one in-order queue on one device. Shared by everything that computes there; the queue is
/// thread-safe as OpenCL's are, kernels objects are not: see Program::kernel.
class ComputeDevice {
public:
    ComputeDevice(cl::Device device, DeviceInfo info);
    const DeviceInfo& info() const { return info_; }
    cl::Context& context() { return context_; }
    cl::CommandQueue& queue() { return queue_; }
    const cl::Device& device() const { return device_; }
    /// Host memory and device memory are one: buffers may use host pointers without a copy.
    bool unified_memory() const { return unified_memory_; }

private:
    cl::Device device_;
    DeviceInfo info_;
    cl::Context context_;
    cl::CommandQueue queue_;
    bool unified_memory_ = false;
};

/// Lists every device of every platform. Without `measure` nothing runs there: `usable` stays false. With `measure`,
/// each is self-tested (a ramp sampled, a sum) and timed with a short kernel; a device that fails is listed with its
/// fault, never trusted. What was learnt of a device is kept for the life of the process. Empty when there is no
/// platform. @throws Error(cancelled)
std::vector<DeviceInfo> list_devices(bool measure, const JobContext& job = {});

/// Forgets what was learnt of the devices: the next listing or opening tests and times them anew.
void forget_measurements();

/// Opens a device: "" takes the fastest usable by the measured ranking, "N" the index listed, else the first whose
/// name contains the text (case-insensitive). nullptr when the choice is "" and no usable device exists (said once in
/// the log).
/// @throws Error(bad_usage) for an unknown N or NAME, listing the devices; Error(device) when the chosen one fails its
/// self-test
std::shared_ptr<ComputeDevice> open_device(const std::string& choice = "", const JobContext& job = {});

}  // namespace lacuna
