#include "core/compute/device.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>

#include "core/base/log.h"
#include "core/compute/device_error.h"
#include "core/compute/device_list.h"
#include "core/compute/self_test.h"

namespace lacuna {

namespace {

struct FoundDevice {
    cl::Device device;
    DeviceInfo info;
};

/// Text as drivers give it: closed by a null byte or blanks at times.
std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    return text;
}

DeviceInfo describe(const cl::Platform& platform, const cl::Device& device, int index) {
    DeviceInfo info;
    info.index = index;
    info.platform = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.opencl_version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
    info.is_cpu = (type & CL_DEVICE_TYPE_CPU) != 0;
    info.is_gpu = (type & CL_DEVICE_TYPE_GPU) != 0;
    info.compute_units = int(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
    info.memory_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.max_allocation_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) info.fault = "its driver says it is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) info.fault = "its driver has no compiler";
    return info;
}

/// PoCL lists no device at all where it cannot make its cache folder, as for a service without a home. There it gets
/// one among the temporary files.
void give_pocl_a_cache() {
    namespace fs = std::filesystem;
    if (std::getenv("POCL_CACHE_DIR")) return;
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    std::error_code ec;
    if (cache || home) {
        const fs::path wanted = (cache ? fs::path(cache) : fs::path(home) / ".cache") / "pocl" / "kcache";
        fs::create_directories(wanted, ec);
        if (::access(wanted.c_str(), W_OK | X_OK) == 0) return;
    }
    const fs::path own = fs::temp_directory_path(ec) / ("lacuna-pocl-" + std::to_string(::geteuid()));
    ::mkdir(own.c_str(), 0700);
    struct stat status {};
    // A folder somebody else put there must not hand us binaries.
    if (::lstat(own.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != ::geteuid()) return;
    ::setenv("POCL_CACHE_DIR", own.c_str(), 0);
}

/// Every device of every platform. A loader without any platform says so by an error, some by an empty list.
std::vector<FoundDevice> find_devices() {
    static std::once_flag prepared;
    std::call_once(prepared, give_pocl_a_cache);
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error& failure) {
        log(LogLevel::debug, "OpenCL lists no platform: " + status_name(failure.err()));
        return {};
    }
    std::vector<FoundDevice> found;
    for (const cl::Platform& platform : platforms) {
        try {
            std::vector<cl::Device> devices;
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const cl::Device& device : devices)
                found.push_back({device, describe(platform, device, int(found.size()))});
        } catch (const cl::Error& failure) {  // a platform without devices, or a broken driver beside a whole one
            log(LogLevel::debug, "An OpenCL platform lists no device: " + status_name(failure.err()));
        }
    }
    return found;
}

/// What was learnt of a device in this process; a driver's answers do not change while it runs.
struct Learnt {
    bool usable = false;
    std::string fault;
    double rank_ms = 0;
};

std::mutex g_learnt_mutex;
std::map<cl_device_id, Learnt> g_learnt;

/// Self-tests, and times when asked to, what was not tested or timed before.
void learn(FoundDevice& found, bool timed, const JobContext& job) {
    std::lock_guard lock(g_learnt_mutex);
    auto at = g_learnt.find(found.device());
    const bool known = at != g_learnt.end();
    if (!known || (timed && at->second.usable && at->second.rank_ms == 0)) {
        Learnt learnt{false, found.info.fault, 0};
        try {
            if (learnt.fault.empty()) {
                const auto device = std::make_shared<ComputeDevice>(found.device, found.info);
                ProgramLibrary library(device);
                if (!known) learnt.fault = self_test_fault(*device, library, job);
                if (learnt.fault.empty() && timed) learnt.rank_ms = measure_rank_ms(*device, library, job);
            }
        } catch (const Error& failure) {
            if (failure.code() == Errc::cancelled) throw;
            learnt.fault = failure.what();
        }
        learnt.usable = learnt.fault.empty();
        at = g_learnt.insert_or_assign(found.device(), learnt).first;
    }
    found.info.usable = at->second.usable;
    found.info.fault = at->second.fault;
    found.info.rank_ms = at->second.rank_ms;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

std::string names_of(const std::vector<FoundDevice>& found) {
    if (found.empty()) return "there is none here";
    std::string names = "known are";
    for (const FoundDevice& one : found)
        names += (one.info.index ? ", " : " ") + std::to_string(one.info.index) + " (" + one.info.name + ")";
    return names;
}

/// The device an explicit choice means. @throws Error(bad_usage)
FoundDevice& chosen_device(std::vector<FoundDevice>& found, const std::string& choice) {
    const bool number = choice.find_first_not_of("0123456789") == std::string::npos;
    if (number && choice.size() <= 6 && std::stoul(choice) < found.size()) return found[std::stoul(choice)];
    if (!number)
        for (FoundDevice& one : found)
            if (lower(one.info.name).find(lower(choice)) != std::string::npos) return one;
    throw Error(Errc::bad_usage, "There is no OpenCL device \"" + choice + "\"; " + names_of(found) + ".", choice);
}

/// The fastest usable device; nullptr when none is. With one candidate there is nothing to rank.
FoundDevice* fastest_device(std::vector<FoundDevice>& found, const JobContext& job) {
    std::vector<DeviceInfo> infos;
    for (FoundDevice& one : found) {
        learn(one, found.size() > 1, job);
        infos.push_back(one.info);
    }
    const int best = fastest_index(infos);
    return best < 0 ? nullptr : &found[std::size_t(best)];
}

void say_once_that_none_is_usable(const std::vector<FoundDevice>& found) {
    static std::once_flag said;
    std::call_once(said, [&] {
        std::string line = "No OpenCL device can be used";
        for (const FoundDevice& one : found) line += "; " + one.info.name + ": " + one.info.fault;
        if (found.empty()) line += ": no platform is installed or none could start";
        log(LogLevel::warning, line + ". Pictures come from the slower built-in renderer.");
    });
}

}  // namespace

ComputeDevice::ComputeDevice(cl::Device device, DeviceInfo info) : device_(std::move(device)), info_(std::move(info)) {
    with_device_errors("opening " + info_.name, [&] {
        context_ = cl::Context(device_);
        queue_ = cl::CommandQueue(context_, device_);
        unified_memory_ = info_.is_cpu || device_.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>();
    });
}

std::vector<DeviceInfo> list_devices(bool measure, const JobContext& job) {
    std::vector<FoundDevice> found = find_devices();
    std::vector<DeviceInfo> infos;
    for (FoundDevice& one : found) {
        job.checkpoint(infos.size(), found.size());
        if (measure) learn(one, true, job);
        infos.push_back(one.info);
    }
    return infos;
}

void forget_measurements() {
    std::lock_guard lock(g_learnt_mutex);
    g_learnt.clear();
}

std::shared_ptr<ComputeDevice> open_device(const std::string& choice, const JobContext& job) {
    std::vector<FoundDevice> found = find_devices();
    if (choice.empty()) {
        const FoundDevice* best = fastest_device(found, job);
        if (best) return std::make_shared<ComputeDevice>(best->device, best->info);
        say_once_that_none_is_usable(found);
        return nullptr;
    }
    FoundDevice& one = chosen_device(found, choice);
    learn(one, false, job);
    if (!one.info.usable)
        throw Error(Errc::device,
                    "OpenCL device " + one.info.name + " cannot be used: " + one.info.fault + "; choose another one.",
                    one.info.fault);
    return std::make_shared<ComputeDevice>(one.device, one.info);
}

}  // namespace lacuna
