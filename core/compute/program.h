#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/compute/device.h"

namespace lacuna {

/// Everything that can change a compiled program. Two equal keys give the same binary.
struct ProgramKey {
    std::string source;      ///< every #include expanded, #line kept
    std::string options;     ///< "-cl-std=CL1.2 -DLACUNA_MODE=1 ..."
    std::string device, driver, platform;
    auto operator<=>(const ProgramKey&) const = default;
};

/// The text of an embedded kernel source with its #includes expanded (each file once, #line directives kept so that
/// build logs point at the file). @param name as listed in kernels/CMakeLists.txt, e.g. "render/raycast.cl"
/// @throws Error(kernel_build) for an unknown name or include
std::string expand_kernel_source(const std::string& name);

/// Compiles embedded kernels for one device; keeps programs in memory and binaries on disk
/// ($XDG_CACHE_HOME or ~/.cache, lacuna/kernels; LACUNA_CACHE overrides). A cache entry that cannot be read, does not
/// match or does not load means "compile again"; an unwritable cache is tolerated; a failed build is never cached.
class ProgramLibrary {
public:
    explicit ProgramLibrary(std::shared_ptr<ComputeDevice> device);
    /// A fresh kernel object (kernel objects carry their arguments: one thread each).
    /// @throws Error(kernel_build) with the build log in about()
    cl::Kernel kernel(const std::string& source_name, const std::string& kernel_name, const std::string& options);

private:
    std::shared_ptr<ComputeDevice> device_;
    std::mutex mutex_;
    std::map<ProgramKey, cl::Program> programs_;
};

}  // namespace lacuna
