#include "core/compute/program.h"

#include <fstream>
#include <thread>

#include "compute_fixture.h"
#include "core/base/error.h"
#include "core/compute/program_cache.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

using ProgramTest = ComputeTest;

constexpr const char* k_fill = "__kernel void fill(__global int* out) { out[get_global_id(0)] = VALUE; }\n";

int run_fill(ComputeDevice& device, cl::Kernel kernel) {
    const cl::Buffer out(device.context(), CL_MEM_READ_WRITE, 16 * sizeof(int));
    kernel.setArg(0, out);
    device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(16), cl::NDRange(4));
    int values[16] = {};
    device.queue().enqueueReadBuffer(out, CL_TRUE, 0, sizeof values, values);
    return values[15];
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ec;
    for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec)) files.push_back(at->path());
    return files;
}

}  // namespace

TEST_F(ProgramTest, ASecondLibraryLoadsFromDisk) {
    ProgramLibrary first(device_);
    EXPECT_EQ(run_fill(*device_, first.kernel_of_text("fill", k_fill, "fill", "-DVALUE=41")), 41);
    EXPECT_EQ(run_fill(*device_, first.kernel_of_text("fill", k_fill, "fill", "-DVALUE=41")), 41);
    EXPECT_EQ(first.counts().compiled, 1);
    EXPECT_EQ(first.counts().loaded_from_disk, 0);
    first.keep_binaries();
    ASSERT_EQ(files_in(cache_folder()).size(), 1u);
    EXPECT_EQ(first.keep_binaries(), 0) << "once is enough";
    ProgramLibrary second(device_);
    EXPECT_EQ(run_fill(*device_, second.kernel_of_text("fill", k_fill, "fill", "-DVALUE=41")), 41);
    EXPECT_EQ(second.counts().compiled, 0);
    EXPECT_EQ(second.counts().loaded_from_disk, 1);
}

TEST_F(ProgramTest, OtherOptionsOrSourceAreOtherPrograms) {
    ProgramLibrary library(device_);
    EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=1")), 1);
    EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=2")), 2);
    const std::string other = "#define VALUE 3\n" + std::string(k_fill);
    EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", other, "fill", "")), 3);
    EXPECT_EQ(library.counts().compiled, 3);
    library.keep_binaries();
    EXPECT_EQ(files_in(cache_folder()).size(), 3u);
}

TEST_F(ProgramTest, DamagedEntriesAreCompiledAgain) {
    {
        ProgramLibrary library(device_);
        library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=5");
        library.keep_binaries();
    }
    const fs::path file = files_in(cache_folder()).at(0);
    const auto size = [&] { return fs::file_size(file); };
    const auto flip_at = [&](std::uintmax_t offset) {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekg(std::streamoff(offset));
        const char old = char(stream.get());
        stream.seekp(std::streamoff(offset));
        stream.put(char(old ^ 0x5a));
    };
    const std::function<void()> damages[] = {
        [&] { fs::resize_file(file, 0); },
        [&] { fs::resize_file(file, size() / 2); },
        [&] { fs::resize_file(file, size() - 1); },
        [&] { fs::resize_file(file, size() + 1); },
        [&] { flip_at(0); },
        [&] { flip_at(20); },  // a length
        [&] { flip_at(60); },  // the key's source
        [&] { flip_at(size() / 2); },
        [&] { flip_at(size() - 1); },
    };
    for (const auto& damage : damages) {
        damage();
        ProgramLibrary library(device_);
        EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=5")), 5);
        EXPECT_EQ(library.counts().compiled, 1);
        library.keep_binaries();
        ProgramLibrary after(device_);
        after.kernel_of_text("fill", k_fill, "fill", "-DVALUE=5");
        EXPECT_EQ(after.counts().loaded_from_disk, 1) << "stored again, whole";
    }
}

TEST_F(ProgramTest, ABinaryTheDriverRefusesIsCompiledAgain) {
    const ProgramKey key = program_key(*device_, k_fill, "-DVALUE=6");
    ASSERT_TRUE(ProgramCache(cache_folder()).store(key, "not a binary of any driver"));
    ProgramLibrary library(device_);
    EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=6")), 6);
    EXPECT_EQ(library.counts().compiled, 1);
    library.keep_binaries();
    EXPECT_NE(ProgramCache(cache_folder()).load(key), "not a binary of any driver");
}

TEST_F(ProgramTest, AFolderThatCannotBeMadeIsTolerated) {
    std::ofstream(folder_.path() / "kernels") << "a file where the folder would be";
    ProgramLibrary library(device_);
    EXPECT_EQ(run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=7")), 7);
    EXPECT_EQ(library.counts().compiled, 1);
    EXPECT_EQ(library.keep_binaries(), 0);
    ::setenv("LACUNA_CACHE", "", 1);  // switched off
    ProgramLibrary without(device_);
    EXPECT_EQ(run_fill(*device_, without.kernel_of_text("fill", k_fill, "fill", "-DVALUE=7")), 7);
}

TEST_F(ProgramTest, AFailedBuildCarriesItsLogAndIsNotCached) {
    ProgramLibrary library(device_);
    for (int attempt = 0; attempt < 2; ++attempt) {
        try {
            library.kernel_of_text("spoilt.cl", "#line 7 \"render/spoilt.cl\"\n__kernel void k() { no_such(); }\n", "k",
                                   "");
            FAIL() << "compiled";
        } catch (const Error& failure) {
            EXPECT_EQ(failure.code(), Errc::kernel_build);
            EXPECT_NE(failure.about().find("no_such"), std::string::npos) << failure.about();
            EXPECT_NE(std::string(failure.what()).find("no_such"), std::string::npos) << failure.what();
            EXPECT_NE(std::string(failure.what()).find("spoilt.cl"), std::string::npos);
            EXPECT_NE(failure.about().find("render/spoilt.cl:7"), std::string::npos) << failure.about();
        }
    }
    EXPECT_EQ(library.counts().compiled, 0);
    EXPECT_EQ(library.keep_binaries(), 0);
    EXPECT_TRUE(files_in(cache_folder()).empty());
}

TEST_F(ProgramTest, KeepingStopsWhenAsked) {
    ProgramLibrary library(device_);
    library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=9");
    library.keep_binaries();
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(library.keep_binaries({source.get_token()}), 0) << "nothing is left to stop";
}

TEST_F(ProgramTest, AMissingKernelIsNamed) {
    ProgramLibrary library(device_);
    try {
        library.kernel("compute/self_test.cl", "no_such_kernel", "");
        FAIL() << "found";
    } catch (const Error& failure) {
        EXPECT_EQ(failure.code(), Errc::kernel_build);
        EXPECT_NE(std::string(failure.what()).find("no_such_kernel"), std::string::npos);
    }
    EXPECT_THROW(library.kernel("compute/none.cl", "k", ""), Error);
}

TEST_F(ProgramTest, ThreadsShareOneBuild) {
    ProgramLibrary library(device_);
    std::atomic<int> right = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 6; ++i)
            threads.emplace_back(
                [&] { right += run_fill(*device_, library.kernel_of_text("fill", k_fill, "fill", "-DVALUE=8")) == 8; });
    }
    EXPECT_EQ(right, 6);
    EXPECT_EQ(library.counts().compiled, 1);
}

TEST_F(ProgramTest, KernelObjectsAreFresh) {
    ProgramLibrary library(device_);
    const cl::Kernel a = library.kernel("compute/self_test.cl", "march_ramp", "");
    const cl::Kernel b = library.kernel("compute/self_test.cl", "march_ramp", "");
    EXPECT_NE(a(), b());
}

}  // namespace lacuna
