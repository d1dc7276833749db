#include "core/compute/self_test.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/compute/device_error.h"

namespace lacuna {

namespace {

constexpr const char* k_source = "compute/self_test.cl";
constexpr int k_nx = 7, k_ny = 6, k_nz = 5;  // odd and unequal: exchanged axes show
constexpr int k_samples = 203;               // no multiple of a work-group

/// A function linear in each axis: trilinear interpolation must give it back exactly but for rounding.
double ramp(double x, double y, double z) { return 1.0 + 2.0 * x - 3.0 * y + 5.0 * z; }

std::vector<float> ramp_volume(int nx, int ny, int nz) {
    std::vector<float> voxels;
    voxels.reserve(std::size_t(nx) * ny * nz);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) voxels.push_back(float(ramp(x, y, z)));
    return voxels;
}

/// Positions spread over the volume, corners and last voxels among them.
std::vector<cl_float4> test_positions() {
    std::vector<cl_float4> positions(k_samples);
    for (int i = 0; i < k_samples; ++i) {
        const auto fraction = [i](double ratio) { return i == 0 ? 0.0 : i == 1 ? 1.0 : std::fmod(i * ratio, 1.0); };
        positions[i] = {{cl_float(fraction(0.6180339887) * (k_nx - 1)), cl_float(fraction(0.7548776662) * (k_ny - 1)),
                         cl_float(fraction(0.5698402910) * (k_nz - 1)), 0.0f}};
    }
    return positions;
}

template <typename T>
cl::Buffer copied(ComputeDevice& device, const std::vector<T>& values) {
    return cl::Buffer(device.context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(T),
                      const_cast<T*>(values.data()));
}

std::string sampling_fault(ComputeDevice& device, ProgramLibrary& library, const std::string& source) {
    const std::vector<float> voxels = ramp_volume(k_nx, k_ny, k_nz);
    const std::vector<cl_float4> positions = test_positions();
    const cl::Buffer voxel_buffer = copied(device, voxels), position_buffer = copied(device, positions);
    const cl::Buffer value_buffer(device.context(), CL_MEM_WRITE_ONLY, k_samples * sizeof(float));
    cl::KernelFunctor<cl::Buffer, cl_int4, cl::Buffer, cl::Buffer, cl_int> sample(
        library.kernel_of_text(k_source, source, "sample_positions", ""));
    sample(cl::EnqueueArgs(device.queue(), cl::NDRange(256), cl::NDRange(16)), voxel_buffer,
           cl_int4{{k_nx, k_ny, k_nz, 0}}, position_buffer, value_buffer, k_samples);
    std::vector<float> values(k_samples, -1e30f);
    device.queue().enqueueReadBuffer(value_buffer, CL_TRUE, 0, k_samples * sizeof(float), values.data());
    for (int i = 0; i < k_samples; ++i) {
        const double wanted = ramp(positions[i].s[0], positions[i].s[1], positions[i].s[2]);
        if (!(std::abs(values[i] - wanted) <= 1e-4))
            return "sampling a ramp gave " + std::to_string(values[i]) + " in place of " + std::to_string(wanted);
    }
    return {};
}

std::string summing_fault(ComputeDevice& device, ProgramLibrary& library, const std::string& source) {
    const int count = 1000;
    // 1 is always possible; sizes beyond it are what the reduction is about.
    const std::size_t limit = device.device().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    const int group = limit >= 64 ? 64 : 1, groups = (count + group - 1) / group;
    std::vector<std::uint32_t> numbers(count);
    std::uint64_t wanted = 0;
    for (int i = 0; i < count; ++i) wanted += numbers[i] = std::uint32_t(i) * 7919u % 1021u;
    const cl::Buffer number_buffer = copied(device, numbers);
    const cl::Buffer sum_buffer(device.context(), CL_MEM_WRITE_ONLY, groups * sizeof(std::uint32_t));
    cl::KernelFunctor<cl::Buffer, cl::Buffer, cl::LocalSpaceArg, cl_int> sum(
        library.kernel_of_text(k_source, source, "sum_groups", ""));
    sum(cl::EnqueueArgs(device.queue(), cl::NDRange(std::size_t(groups) * group), cl::NDRange(group)), number_buffer,
        sum_buffer, cl::Local(group * sizeof(std::uint32_t)), count);
    std::vector<std::uint32_t> sums(groups, 0xffffffffu);
    device.queue().enqueueReadBuffer(sum_buffer, CL_TRUE, 0, groups * sizeof(std::uint32_t), sums.data());
    std::uint64_t total = 0;
    for (std::uint32_t part : sums) total += part;
    if (total == wanted) return {};
    return "a sum gave " + std::to_string(total) + " in place of " + std::to_string(wanted);
}

}  // namespace

std::string self_test_fault(ComputeDevice& device, ProgramLibrary& library, const JobContext& job,
                            const std::string& source) {
    try {
        return with_device_errors("running its self-test", [&]() -> std::string {
            job.check();
            if (std::string fault = sampling_fault(device, library, source); !fault.empty()) return fault;
            job.check();
            return summing_fault(device, library, source);
        });
    } catch (const Error& failure) {
        if (failure.code() == Errc::cancelled) throw;
        return failure.what();
    }
}

double measure_rank_ms(ComputeDevice& device, ProgramLibrary& library, const JobContext& job) {
    return with_device_errors("timing the ranking kernel", [&] {
        const int size = 64, rays = 128 * 128, steps = 64;
        const cl::Buffer voxels = copied(device, ramp_volume(size, size, size));
        const cl::Buffer out(device.context(), CL_MEM_WRITE_ONLY, rays * sizeof(float));
        cl::KernelFunctor<cl::Buffer, cl_int4, cl::Buffer, cl_int, cl_int> march(
            library.kernel(k_source, "march_ramp", ""));
        double least_ms = INFINITY;
        for (int run = 0; run < 4; ++run) {  // the first one also pays for late compilation and first touches
            job.check();
            const Stopwatch watch;
            march(cl::EnqueueArgs(device.queue(), cl::NDRange(rays), cl::NDRange(64)), voxels,
                  cl_int4{{size, size, size, 0}}, out, steps, rays);
            device.queue().finish();
            least_ms = std::min(least_ms, watch.ms());
        }
        return least_ms;
    });
}

}  // namespace lacuna
