#include "core/compute/device.h"

#include <gtest/gtest.h>

#include "core/base/stopwatch.h"
#include "core/compute/program.h"

namespace lacuna {

TEST(Device, OpensAndRunsAnEmbeddedKernel) {
    const auto device = open_device();
    if (!device) GTEST_SKIP() << "no OpenCL device";
    EXPECT_TRUE(device->info().usable);
    EXPECT_TRUE(device->info().fault.empty());
    ProgramLibrary library(device);
    EXPECT_NE(library.kernel("compute/self_test.cl", "march_ramp", "")(), nullptr);
}

}  // namespace lacuna
