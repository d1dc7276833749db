#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/compute/device.h"

namespace lacuna {

/// A folder of this test's own, gone with it.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "lacuna-compute-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~ScratchFolder() {
        std::error_code ec;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ec);
        std::filesystem::remove_all(path_, ec);
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Opens the default device, or skips; the program cache lies in a folder of the test's own.
class ComputeTest : public testing::Test {
protected:
    void SetUp() override {
        ::setenv("LACUNA_CACHE", (folder_.path() / "kernels").c_str(), 1);
        device_ = open_device();
        if (!device_) GTEST_SKIP() << "there is no usable OpenCL device";
        std::filesystem::remove_all(cache_folder());  // what the self-test left
    }
    void TearDown() override { ::unsetenv("LACUNA_CACHE"); }
    std::filesystem::path cache_folder() const { return folder_.path() / "kernels"; }

    ScratchFolder folder_;
    std::shared_ptr<ComputeDevice> device_;
};

}  // namespace lacuna
