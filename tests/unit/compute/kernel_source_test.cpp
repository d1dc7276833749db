#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "core/base/error.h"
#include "core/compute/embedded_kernels.h"
#include "core/compute/program.h"

namespace lacuna {

namespace {

std::string kernel_error(const std::string& name) {
    try {
        expand_kernel_source(name);
    } catch (const Error& failure) {
        EXPECT_EQ(failure.code(), Errc::kernel_build);
        return failure.what();
    }
    return "no error";
}

}  // namespace

TEST(EmbeddedKernels, AreTheFilesByteForByte) {
    const auto files = embedded_kernel_files();
    ASSERT_GT(files.size(), 0u);
    for (const EmbeddedKernelFile& file : files) {
        std::ifstream in(std::string(LACUNA_SOURCE_DIR "/kernels/") + file.name, std::ios::binary);
        if (!in) continue;  // moved since the build
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(text, std::string(reinterpret_cast<const char*>(file.bytes), file.size)) << file.name;
    }
}

TEST(EmbeddedKernels, AreOrderedByNameEachOnce) {
    std::string last;
    for (const EmbeddedKernelFile& file : embedded_kernel_files()) {
        EXPECT_LT(last, std::string(file.name));
        last = file.name;
    }
}

TEST(ExpandKernelSource, UnknownNameIsAnErrorThatNamesIt) {
    EXPECT_NE(kernel_error("render/no_such.cl").find("render/no_such.cl"), std::string::npos);
    EXPECT_NE(kernel_error(""), "no error");
}

TEST(ExpandKernelSource, StartsWithALineDirectiveForTheFile) {
    EXPECT_TRUE(expand_kernel_source("compute/self_test.cl").starts_with("#line 1 \"compute/self_test.cl\"\n"));
}

TEST(ExpandKernelSource, LeavesNoQuotedIncludeInAnyKernel) {
    for (const EmbeddedKernelFile& file : embedded_kernel_files()) {
        if (!std::string_view(file.name).ends_with(".cl")) continue;
        EXPECT_EQ(expand_kernel_source(file.name).find("#include \""), std::string::npos) << file.name;
    }
}

/// Fixed texts in place of the embedded ones.
std::optional<std::string_view> fixed_text(std::string_view name) {
    static const std::map<std::string_view, std::string_view> files = {
        {"plain.cl", "int a;\n#include \"include/x.clh\"\nint b;"},
        {"twice.cl",
         "#include \"include/x.clh\"\n  #  include \"include/x.clh\" // again\n#include \"include/y.clh\"\n"},
        {"branch.cl",
         "#if MODE == 0\n#include \"include/x.clh\"\n#else\n#include \"include/y.clh\"\n#endif\n#include "
         "\"include/x.clh\"\n"},
        {"circle.cl", "#include \"include/c1.clh\"\n"},
        {"missing.cl", "\n\n#include \"include/none.clh\"\n"},
        {"system.cl", "#include <math.h>\n#pragma once\n#define LINE include \"no.h\"\n"},
        {"include/x.clh", "#pragma once\nint x;\n"},
        {"include/y.clh", "#include \"x.clh\"\nint y;\n"},  // beside it
        {"include/c1.clh", "#include \"include/c2.clh\"\nint c1;\n"},
        {"include/c2.clh", "#include \"include/c1.clh\"\nint c2;\n"},
        {"empty.cl", ""}};
    const auto at = files.find(name);
    return at == files.end() ? std::nullopt : std::optional(at->second);
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(ExpandKernelSource, LineDirectivesPointBackIntoTheIncludingFile) {
    EXPECT_EQ(expand_source("plain.cl", fixed_text),
              "#line 1 \"plain.cl\"\nint a;\n#ifndef LACUNA_INCLUDED_include_x_clh\n"
              "#define LACUNA_INCLUDED_include_x_clh\n#line 1 \"include/x.clh\"\n\nint x;\n#endif\n"
              "#line 3 \"plain.cl\"\nint b;\n");
}

TEST(ExpandKernelSource, IncludesEachFileOnce) {
    const std::string text = expand_source("twice.cl", fixed_text);
    EXPECT_EQ(occurrences(text, "int x;"), 1u);
    EXPECT_EQ(occurrences(text, "int y;"), 1u);
}

TEST(ExpandKernelSource, AFileSeenOnlyInABranchIsThereForLaterIncludes) {
    const std::string text = expand_source("branch.cl", fixed_text);
    EXPECT_EQ(occurrences(text, "int x;"), 3u);  // both branches and behind them, each behind the same guard
    EXPECT_EQ(occurrences(text, "#ifndef LACUNA_INCLUDED_include_x_clh"), 3u);
}

TEST(ExpandKernelSource, CirclesEnd) {
    const std::string text = expand_source("circle.cl", fixed_text);
    EXPECT_EQ(occurrences(text, "int c1;"), 1u);
    EXPECT_EQ(occurrences(text, "int c2;"), 1u);
}

TEST(ExpandKernelSource, MissingIncludeNamesFileAndLine) {
    try {
        expand_source("missing.cl", fixed_text);
        FAIL() << "no error";
    } catch (const Error& failure) {
        EXPECT_EQ(failure.code(), Errc::kernel_build);
        EXPECT_NE(std::string(failure.what()).find("missing.cl, line 3"), std::string::npos) << failure.what();
        EXPECT_NE(std::string(failure.what()).find("include/none.clh"), std::string::npos);
    }
}

TEST(ExpandKernelSource, LeavesSystemIncludesAndOtherDirectivesAlone) {
    EXPECT_EQ(expand_source("system.cl", fixed_text),
              "#line 1 \"system.cl\"\n#include <math.h>\n\n#define LINE include \"no.h\"\n");
    EXPECT_EQ(expand_source("empty.cl", fixed_text), "#line 1 \"empty.cl\"\n");
}

}  // namespace lacuna
