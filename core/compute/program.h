#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/compute/device.h"

namespace lacuna {

class ProgramCache;

/// Everything that can change a compiled program. Two equal keys give the same binary.
struct ProgramKey {
    std::string source;   ///< every #include expanded, #line kept
    std::string options;  ///< "-cl-std=CL1.2 -DLACUNA_MODE=1 ..."
    std::string device, driver, platform;
    auto operator<=>(const ProgramKey&) const = default;
};

/// The key of a source on a device. Options without "-cl-std" get "-cl-std=CL1.2" in front.
ProgramKey program_key(const ComputeDevice& device, std::string source, const std::string& options);

/// The text of an embedded kernel source with its #includes expanded (each file once, #line directives kept so that
/// build logs point at the file). Names are relative to kernels/, or to the including file.
/// @param name e.g. "render/raycast.cl"
/// @throws Error(kernel_build) for an unknown name or include
std::string expand_kernel_source(const std::string& name);

/// The text of a source file by name; nothing for a file there is not.
using SourceText = std::function<std::optional<std::string_view>(std::string_view name)>;
/// expand_kernel_source over other files than the embedded ones. @throws Error(kernel_build)
std::string expand_source(const std::string& name, const SourceText& files);

/// Compiles and links for one device. @param label names the source in messages
/// @throws Error(kernel_build): the sentence has the log's first error, about() the whole log
cl::Program build_program(ComputeDevice& device, const ProgramKey& key, const std::string& label);

/// Where a library's programs came from so far.
struct ProgramCounts {
    int compiled = 0, loaded_from_disk = 0;
};

/// Compiles embedded kernels for one device; keeps programs in memory and binaries on disk
/// ($XDG_CACHE_HOME or ~/.cache, lacuna/kernels; LACUNA_CACHE overrides). A cache entry that cannot be read, does not
/// match or does not load means "compile again"; an unwritable cache is tolerated; a failed build is never cached.
/// Usable from any thread: a program is built once, who needs it meanwhile waits, who needs another does not.
class ProgramLibrary {
public:
    explicit ProgramLibrary(std::shared_ptr<ComputeDevice> device);
    ~ProgramLibrary();
    /// A fresh kernel object (kernel objects carry their arguments: one thread each). Cost: microseconds once built,
    /// 20 ms to 1 s before.
    /// @throws Error(kernel_build) with the build log in about()
    cl::Kernel kernel(const std::string& source_name, const std::string& kernel_name, const std::string& options);
    /// The same for a source that is not embedded. @param label names it in messages
    cl::Kernel kernel_of_text(const std::string& label, const std::string& source, const std::string& kernel_name,
                              const std::string& options);
    /// Writes to disk what was compiled here and not yet written. Most drivers give binaries at once, and the library
    /// calls this itself; PoCL compiles every kernel again for them (0.5 s a program, while it runs nothing else), and
    /// has a cache of its own that makes a program in 45 ms where a binary takes 5: there it is for idle times.
    /// @return programs written. @throws Error(cancelled) between programs
    int keep_binaries(const JobContext& job = {});
    ProgramCounts counts() const { return {compiled_, loaded_}; }

private:
    using Pending = std::shared_future<cl::Program>;
    cl::Program program(const std::string& label, const ProgramKey& key);
    cl::Program load_or_build(const std::string& label, const ProgramKey& key);

    std::shared_ptr<ComputeDevice> device_;
    std::unique_ptr<ProgramCache> cache_;
    std::mutex mutex_;
    std::map<ProgramKey, Pending> programs_;
    std::vector<std::pair<ProgramKey, cl::Program>> not_kept_;  ///< compiled here, not on disk
    std::map<std::string, std::string> sources_;                ///< embedded sources, expanded
    std::atomic<int> compiled_ = 0, loaded_ = 0;
};

}  // namespace lacuna
