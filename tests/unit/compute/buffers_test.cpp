#include "core/compute/buffers.h"

#include <numeric>

#include "compute_fixture.h"
#include "core/base/error.h"
#include "core/compute/device_error.h"

namespace lacuna {

namespace {

using BuffersTest = ComputeTest;

Errc code_of(cl_int status) {
    try {
        with_device_errors("testing", [&] { throw cl::Error(status, "clSomeCall"); });
    } catch (const Error& failure) {
        EXPECT_NE(std::string(failure.what()).find("testing"), std::string::npos);
        EXPECT_NE(failure.about().find("clSomeCall"), std::string::npos);
        return failure.code();
    }
    return Errc::io;
}

}  // namespace

TEST_F(BuffersTest, HoldsTheBytesInPlaceOrCopied) {
    alignas(64) float values[33];
    std::iota(std::begin(values), std::end(values), 1.0f);
    for (const int first : {0, 1}) {  // aligned, and not
        EXPECT_EQ(is_zero_copy(*device_, values + first), device_->unified_memory() && first == 0);
        const cl::Buffer buffer = device_buffer(*device_, values + first, 32 * sizeof(float));
        float back[32] = {};
        read_values(*device_, buffer, std::span<float>(back));
        EXPECT_TRUE(std::equal(back, back + 32, values + first));
    }
}

TEST_F(BuffersTest, ACopyDoesNotFollowItsSource) {
    alignas(64) int values[2] = {1, 2};
    const cl::Buffer buffer = device_buffer(*device_, values + 1, sizeof(int));
    values[1] = 3;
    int back = 0;
    read_bytes(*device_, buffer, &back, sizeof back);
    EXPECT_EQ(back, 2);
}

TEST_F(BuffersTest, NothingAndTooMuchAreRefused) {
    const auto refusal = [&](std::size_t bytes) {
        try {
            scratch_buffer(*device_, bytes);
        } catch (const Error& failure) {
            return failure.code();
        }
        return Errc::io;
    };
    EXPECT_EQ(refusal(0), Errc::bad_input);
    EXPECT_EQ(refusal(device_->info().max_allocation_bytes + 1), Errc::out_of_memory);
    EXPECT_EQ(refusal(SIZE_MAX), Errc::out_of_memory);
    EXPECT_THROW(device_buffer(*device_, nullptr, 0), Error);
    EXPECT_EQ(refusal(1), Errc::io) << "one byte is possible";
}

TEST_F(BuffersTest, ReadingPastTheEndIsAnError) {
    const cl::Buffer buffer = scratch_buffer(*device_, 16);
    char back[32];
    EXPECT_THROW(read_bytes(*device_, buffer, back, sizeof back), Error);
    read_bytes(*device_, buffer, nullptr, 0);
}

TEST(DeviceErrors, AreTranslatedOnce) {
    EXPECT_EQ(code_of(CL_MEM_OBJECT_ALLOCATION_FAILURE), Errc::out_of_memory);
    EXPECT_EQ(code_of(CL_OUT_OF_HOST_MEMORY), Errc::out_of_memory);
    EXPECT_EQ(code_of(CL_INVALID_BUFFER_SIZE), Errc::out_of_memory);
    EXPECT_EQ(code_of(CL_OUT_OF_RESOURCES), Errc::device);
    EXPECT_EQ(code_of(CL_INVALID_KERNEL_ARGS), Errc::device);
    EXPECT_EQ(code_of(-9999), Errc::device);
    EXPECT_EQ(with_device_errors("testing", [] { return 7; }), 7);
    EXPECT_THROW(with_device_errors("testing", [] { throw Error(Errc::cancelled, "Cancelled."); }), Error);
    EXPECT_EQ(status_name(-1001), "CL_PLATFORM_NOT_FOUND_KHR");
}

}  // namespace lacuna
