#include "core/compute/program.h"

#include "core/base/log.h"
#include "core/compute/device_error.h"
#include "core/compute/program_cache.h"

namespace lacuna {

namespace {

/// The log's first line that speaks of an error, else its first line that says anything.
std::string first_error_line(const std::string& build_log) {
    std::string first;
    for (std::size_t begin = 0; begin < build_log.size();) {
        const std::size_t end = std::min(build_log.find('\n', begin), build_log.size());
        std::string line = build_log.substr(begin, end - begin);
        begin = end + 1;
        if (line.find("error") != std::string::npos) return line;
        if (first.empty() && line.find_first_not_of(" \t\r") != std::string::npos) first = line;
    }
    return first.empty() ? "the compiler gave no reason" : first;
}

std::string build_log_of(const cl::Program& program, const cl::Device& device) {
    try {
        return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
    } catch (const cl::Error&) {
        return {};
    }
}

/// A program out of a stored binary; an empty one when the driver will not have it.
cl::Program program_of_binary(ComputeDevice& device, const std::string& binary, const std::string& options) {
    try {
        const std::vector<unsigned char> bytes(binary.begin(), binary.end());
        cl::Program program(device.context(), {device.device()}, cl::Program::Binaries{bytes});
        program.build({device.device()}, options.c_str());
        return program;
    } catch (const cl::Error&) {
        return {};
    }
}

std::string binary_of(const cl::Program& program) {
    try {
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        return binaries.empty() ? std::string() : std::string(binaries.front().begin(), binaries.front().end());
    } catch (const cl::Error&) {
        return {};
    }
}

/// Whether asking for a binary costs nothing. PoCL compiles every kernel for any work-group size first.
bool binaries_are_at_hand(const DeviceInfo& info) {
    return info.platform.find("Portable Computing Language") == std::string::npos;
}

}  // namespace

ProgramKey program_key(const ComputeDevice& device, std::string source, const std::string& options) {
    const DeviceInfo& info = device.info();
    const bool has_standard = options.find("-cl-std=") != std::string::npos;
    return {std::move(source), has_standard ? options : ("-cl-std=CL1.2 " + options), info.name, info.driver,
            info.platform + " " + info.opencl_version};
}

cl::Program build_program(ComputeDevice& device, const ProgramKey& key, const std::string& label) {
    cl::Program program;
    try {
        program = cl::Program(device.context(), key.source, false);
        program.build({device.device()}, key.options.c_str());
        return program;
    } catch (const cl::Error& failure) {
        if (failure.err() == CL_OUT_OF_HOST_MEMORY) rethrow_as_error(failure, "compiling " + label);
        std::string build_log = program() ? build_log_of(program, device.device()) : std::string();
        if (build_log.empty()) build_log = std::string(failure.what()) + ": " + status_name(failure.err());
        throw Error(
            Errc::kernel_build,
            "Kernel " + label + " does not compile on " + device.info().name + ": " + first_error_line(build_log),
            build_log);
    }
}

ProgramLibrary::ProgramLibrary(std::shared_ptr<ComputeDevice> device)
    : device_(std::move(device)), cache_(std::make_unique<ProgramCache>(ProgramCache::default_folder())) {}

ProgramLibrary::~ProgramLibrary() = default;

cl::Kernel ProgramLibrary::kernel(const std::string& source_name, const std::string& kernel_name,
                                  const std::string& options) {
    std::string source;
    {
        std::lock_guard lock(mutex_);
        auto at = sources_.find(source_name);
        if (at == sources_.end()) at = sources_.emplace(source_name, expand_kernel_source(source_name)).first;
        source = at->second;
    }
    return kernel_of_text(source_name, source, kernel_name, options);
}

cl::Kernel ProgramLibrary::kernel_of_text(const std::string& label, const std::string& source,
                                          const std::string& kernel_name, const std::string& options) {
    const cl::Program built = program(label, program_key(*device_, source, options));
    try {
        return cl::Kernel(built, kernel_name.c_str());
    } catch (const cl::Error& failure) {
        if (failure.err() != CL_INVALID_KERNEL_NAME)
            rethrow_as_error(failure, "making kernel " + kernel_name + " of " + label);
        throw Error(Errc::kernel_build, "Kernel source " + label + " has no kernel \"" + kernel_name + "\".", label);
    }
}

cl::Program ProgramLibrary::program(const std::string& label, const ProgramKey& key) {
    std::promise<cl::Program> mine;
    Pending pending;
    {
        std::lock_guard lock(mutex_);
        if (const auto at = programs_.find(key); at != programs_.end()) {
            pending = at->second;
        } else {
            programs_.emplace(key, mine.get_future().share());
        }
    }
    if (pending.valid()) return pending.get();
    try {
        cl::Program built = load_or_build(label, key);
        mine.set_value(built);
        return built;
    } catch (...) {
        {
            std::lock_guard lock(mutex_);
            programs_.erase(key);  // a failure is told to who waits, and tried again by who asks later
        }
        mine.set_exception(std::current_exception());
        throw;
    }
}

cl::Program ProgramLibrary::load_or_build(const std::string& label, const ProgramKey& key) {
    if (const auto binary = cache_->load(key)) {
        if (cl::Program loaded = program_of_binary(*device_, *binary, key.options); loaded()) {
            ++loaded_;
            return loaded;
        }
        cache_->remove(key);
    }
    cl::Program built = build_program(*device_, key, label);
    ++compiled_;
    {
        std::lock_guard lock(mutex_);
        not_kept_.emplace_back(key, built);
    }
    if (binaries_are_at_hand(device_->info())) keep_binaries();
    return built;
}

int ProgramLibrary::keep_binaries(const JobContext& job) {
    for (int written = 0;;) {
        std::pair<ProgramKey, cl::Program> next;
        {
            std::lock_guard lock(mutex_);
            if (not_kept_.empty()) return written;
            job.check();
            next = std::move(not_kept_.back());
            not_kept_.pop_back();
        }
        if (cache_->enabled()) written += cache_->store(next.first, binary_of(next.second));
    }
}

}  // namespace lacuna
