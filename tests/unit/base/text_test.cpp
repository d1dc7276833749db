// Words and numbers as other programs read them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <locale>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/order_statistics.h"
#include "core/base/shell_word.h"

namespace lacuna {
namespace {

/// What a shell makes of a word.
std::string as_read_by_shell(const std::string& word) {
    FILE* pipe = ::popen(("printf '%s' " + word).c_str(), "r");
    std::string text;
    for (int c = pipe ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe)) text += char(c);
    if (pipe) ::pclose(pipe);
    return text;
}

TEST(ShellWord, IsReadBackAsItWas) {
    for (const std::string word :
         {"part.raw", "--raw=512x512x400:u16:0.1,0.1,0.1", "a b", "it's", "''", "$HOME `id` $(id)", "a\\b", "a\"b",
          "line\nline", "*?[]{}~#!&;|<>()", "3=looks like a crack", "M\xC3\xBCnchen", "-"})
        EXPECT_EQ(as_read_by_shell(shell_word(word)), word);
    EXPECT_EQ(shell_word(""), "''");
}

TEST(ShellWord, LeavesPlainWordsBare) {
    EXPECT_EQ(shell_word("sample:casting@64"), "sample:casting@64");
    EXPECT_EQ(shell_word("a/b_c-d.mhd"), "a/b_c-d.mhd");
    EXPECT_EQ(shell_word("~/x"), "'~/x'") << "a shell would put a folder there";
}

TEST(ExactNumber, ReadsBackTheSameWithADotInEveryLocale) {
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    for (const double value : {0.1, -1e-300, 1.0 / 3, 123456789.125, 5e-324, 1.7976931348623157e308})
        EXPECT_EQ(std::strtod(exact_number(value).c_str(), nullptr), value);
    EXPECT_EQ(exact_number(0.1), "0.1");
    EXPECT_EQ(exact_number(INFINITY), "");
    EXPECT_EQ(exact_number(NAN), "");
    std::locale::global(before);
}

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoMiddleOnes) {
    EXPECT_EQ(median(std::vector<double>{3}), 3);
    EXPECT_EQ(median(std::vector<double>{5, 1, 3}), 3);
    EXPECT_EQ(median(std::vector<float>{4, 1, 3, 2}), 2.5);
    EXPECT_EQ(median(std::array<double, 5>{9, 9, 0, 1, 2}), 2);
    EXPECT_EQ(median(std::vector<int>{7, 7, 7, 7}), 7);
    EXPECT_TRUE(std::isnan(median(std::vector<double>{})));
}

TEST(Median, LeavesTheCallersValuesAsTheyAre) {
    std::vector<double> values{3, 1, 2};
    EXPECT_EQ(median(values), 2);
    EXPECT_EQ(values, (std::vector<double>{3, 1, 2}));
}

}  // namespace
}  // namespace lacuna
