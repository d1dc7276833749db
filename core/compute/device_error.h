#pragma once

#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/compute/opencl.h"

namespace lacuna {

/// The name of an OpenCL status, e.g. "CL_OUT_OF_RESOURCES" for -5; the number where it has none here.
std::string status_name(cl_int status);

/// The one translation of OpenCL failures. @param doing_what completes "The device failed while ...", e.g. "copying
/// the volume to the device"
/// @throws Error(out_of_memory) where memory did not suffice, else Error(device); about() holds call and status
[[noreturn]] void rethrow_as_error(const cl::Error& failure, const std::string& doing_what);

/// Calls `work` and translates what OpenCL throws. Returns what `work` returns.
template <typename Work>
auto with_device_errors(const std::string& doing_what, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const cl::Error& failure) {
        rethrow_as_error(failure, doing_what);
    }
}

}  // namespace lacuna
