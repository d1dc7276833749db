#include "core/io/dicom_stack.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/io/dicom_samples.h"

namespace lacuna::dicom {
namespace {

struct StepCase {
    const char* name;
    std::vector<double> along;
    bool uniform;
    int missing, duplicates;
    double step;
};

class SliceSteps : public testing::TestWithParam<StepCase> {};

TEST_P(SliceSteps, EvenMissingOrUneven) {
    const StepCase& row = GetParam();
    const StepFit fit = find_step(row.along);
    EXPECT_EQ(fit.uniform(), row.uniform);
    EXPECT_EQ(fit.duplicates, row.duplicates);
    if (!row.uniform) return;
    EXPECT_EQ(fit.missing, row.missing);
    EXPECT_NEAR(fit.step_mm, row.step, 1e-3 * (row.step + 1e-9));
}

INSTANTIATE_TEST_SUITE_P(
    Dicom, SliceSteps,
    testing::Values(StepCase{"one", {3.0}, true, 0, 0, 0}, StepCase{"repeated", {1, 1, 1}, true, 0, 2, 0},
                    StepCase{"pair", {0, 2.5}, true, 0, 0, 2.5},
                    StepCase{"micrometres", {0, 0.007, 0.014, 0.021, 0.028}, true, 0, 0, 0.007},
                    StepCase{"rounded_strings", {0, 0.33, 0.67, 1.0, 1.33, 1.67, 2.0}, true, 0, 0, 0.3333},
                    StepCase{"one_missing", {0, 1, 3, 4, 5}, true, 1, 0, 1},
                    StepCase{"only_gap_of_two", {0, 1, 3}, true, 1, 0, 1},
                    StepCase{"three_missing_in_a_row", {0, 2, 4, 12, 14}, true, 3, 0, 2},
                    StepCase{"thick_after_thin", {0, 2.5, 5, 10, 15, 20}, false, 0, 0, 0},
                    StepCase{"no_multiple", {0, 1, 2, 3.4, 4.4}, false, 0, 0, 0},
                    StepCase{"one_twice", {0, 1, 1, 2, 3}, true, 0, 1, 1}),
    [](const auto& row) { return row.param.name; });

TEST(SliceSteps, InstanceNumbersConfirmManyGaps) {
    const std::vector<double> along = {0, 1, 2, 4, 6, 8};
    const std::vector<std::optional<int>> counted = {1, 2, 3, 5, 7, 9}, consecutive = {1, 2, 3, 4, 5, 6};
    EXPECT_EQ(find_step(along, counted).missing, 3);
    EXPECT_FALSE(find_step(along, consecutive).uniform());
}

std::vector<Frame> stack_at(const std::vector<glm::dvec3>& positions) {
    std::vector<Frame> slices;
    for (const glm::dvec3& p : positions) {
        Frame f;
        f.file = int(slices.size());
        f.position = p;
        f.has_orientation = true;
        f.spacing = glm::dvec2(0.5, 0.25);
        slices.push_back(f);
    }
    return slices;
}

std::vector<std::string> names_for(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back("s" + std::to_string(i));
    return names;
}

TEST(StackPlan, OrdersByPositionAlongTheNormalWhateverTheInput) {
    const auto slices = stack_at({{1, 2, 9}, {1, 2, 3}, {1, 2, 5}, {1, 2, 7}});
    const StackPlan plan = plan_stack(slices, {4, 6}, names_for(4));
    EXPECT_EQ(plan.order, (std::vector<std::size_t>{1, 2, 3, 0}));
    EXPECT_EQ(plan.grid.size, glm::ivec3(4, 6, 4));
    EXPECT_EQ(plan.grid.spacing, glm::dvec3(0.5, 0.25, 2));
    EXPECT_EQ(plan.grid.origin, glm::dvec3(1, 2, 3));
    EXPECT_FALSE(plan.resampled());
    EXPECT_TRUE(plan.warnings.empty());
}

TEST(StackPlan, OfSeveralPassesOverTheSamePositionsOneStaysWhole) {
    for (const bool pass_by_pass : {true, false}) {
        // Three positions in two phases, in the order of files named at random.
        auto slices = stack_at({{0, 0, 4}, {0, 0, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 4}});
        const std::vector<int> phase = {0, 1, 0, 1, 0, 1}, place = {2, 1, 0, 0, 1, 2};
        for (std::size_t i = 0; i < slices.size(); ++i)
            slices[i].instance = pass_by_pass ? 1 + 3 * phase[i] + place[i] : 1 + 2 * place[i] + phase[i];
        const StackPlan plan = plan_stack(slices, {4, 6}, names_for(6));
        EXPECT_EQ(plan.order, (std::vector<std::size_t>{2, 4, 0})) << pass_by_pass;
        EXPECT_EQ(plan.duplicates.size(), 3u);
        EXPECT_EQ(plan.grid.size.z, 3);
    }
}

TEST(StackPlan, PassesWhosePositionsDifferByRoundingAreOnePosition) {
    // Passes over the same positions, written with other digits: as a float, to six digits, to two.
    for (const double rounding : {1e-6, 1e-5, 1e-4, 0.0033})
        for (const int passes : {2, 3, 5}) {
            std::vector<glm::dvec3> positions;
            std::vector<int> instances;
            for (int place = 0; place < 6; ++place)
                for (int pass = 0; pass < passes; ++pass) {
                    positions.push_back({0, 0, 1.25 * place + rounding * ((pass + place) % passes) / (passes - 1.0)});
                    instances.push_back(1 + 6 * pass + place);
                }
            auto slices = stack_at(positions);
            for (std::size_t i = 0; i < slices.size(); ++i) slices[i].instance = instances[i];
            const StackPlan plan = plan_stack(slices, {4, 6}, names_for(slices.size()));
            EXPECT_EQ(plan.grid.size.z, 6) << rounding << " in " << passes;
            EXPECT_NEAR(plan.grid.spacing.z, 1.25, rounding);
            EXPECT_EQ(plan.duplicates.size(), std::size_t(6 * (passes - 1)));
            for (const std::size_t kept : plan.order) EXPECT_LE(*slices[kept].instance, 6) << "of the first pass";
        }
}

TEST(StackPlan, SlicesOfMicrometresAreNoRounding) {
    auto slices = stack_at({{0, 0, 0}, {0, 0, 0.0007}, {0, 0, 0.0014}, {0, 0, 0.0021}});
    for (Frame& f : slices) f.spacing = glm::dvec2(0.0007);
    EXPECT_EQ(plan_stack(slices, {4, 6}, names_for(4)).grid.size.z, 4);
    // Nor do pixels that claim metres make neighbours of slices 0.02 mm apart.
    slices = stack_at({{0, 0, 0}, {0, 0, 0.02}, {0, 0, 0.04}});
    for (Frame& f : slices) f.spacing = glm::dvec2(1e4);
    EXPECT_EQ(plan_stack(slices, {4, 6}, names_for(3)).grid.size.z, 3);
}

TEST(StackPlan, RefusesAGapFarLargerThanTheStack) {
    const auto slices = stack_at({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 500}});
    try {
        plan_stack(slices, {4, 6}, names_for(4));
        FAIL() << "a gap of 498 slices was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_input);
        EXPECT_NE(std::string(error.what()).find("s2"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("s3"), std::string::npos);
    }
}

TEST(StackPlan, SeparateFilesWithoutPositionsHaveNoOrder) {
    auto slices = stack_at({{0, 0, 0}, {0, 0, 1}});
    for (Frame& f : slices) f.position.reset();
    EXPECT_THROW(plan_stack(slices, {4, 6}, names_for(2)), Error);
}

TEST(Samples, GarbageAboveTheHighBitIsMaskedAndTheSignExtended) {
    PixelFormat format{.kind = PixelKind::integer, .bits_allocated = 16, .bits_stored = 12, .high_bit = 11};
    std::vector<std::uint16_t> words = {0xF001, 0x0FFF, 0xA800, 0x07FF};
    SliceState plain;
    settle_samples<std::uint16_t>(words, format, std::nullopt, plain);
    EXPECT_EQ(words, (std::vector<std::uint16_t>{1, 0xFFF, 0x800, 0x7FF}));
    EXPECT_EQ(plain.lo, 1);
    EXPECT_EQ(plain.hi, 0xFFF);

    format.is_signed = true;
    words = {0xF001, 0x0FFF, 0xA800, 0x07FF};
    SliceState extended;
    settle_samples<std::uint16_t>(words, format, std::nullopt, extended);
    EXPECT_EQ(extended.lo, -2048);
    EXPECT_EQ(extended.hi, 2047);
    EXPECT_EQ(std::int16_t(words[1]), -1);
}

TEST(Samples, SampleBitsMayLieHighInTheWord) {
    const PixelFormat format{.kind = PixelKind::integer, .bits_allocated = 16, .bits_stored = 10, .high_bit = 13};
    std::vector<std::uint16_t> words = {std::uint16_t(5 << 4 | 0xC00F)};
    SliceState state;
    settle_samples<std::uint16_t>(words, format, std::nullopt, state);
    EXPECT_EQ(words[0], 5);
}

TEST(Samples, AShiftThatLeavesTheWordComesBackExactly) {
    const PixelFormat format{
        .kind = PixelKind::integer, .bits_allocated = 16, .bits_stored = 16, .high_bit = 15, .is_signed = true};
    std::vector<std::uint16_t> words = {std::uint16_t(-32768), 32767, 0};
    SliceState state;
    state.intercept = -1024;
    settle_samples<std::uint16_t>(words, format, std::nullopt, state);
    ASSERT_TRUE(state.shifted);
    std::vector<float> real(3);
    finish_samples<std::uint16_t, float>(words.data(), real.data(), 3, state, 0);
    EXPECT_EQ(real, (std::vector<float>{-33792, 31743, -1024}));
}

TEST(Samples, PaddingOutsideTheStoredBitsIsFoundInTheRawWord) {
    // 12 stored bits, padding 0xF000: masked it would be 0, which is a measured value elsewhere.
    const PixelFormat format{.kind = PixelKind::integer, .bits_allocated = 16, .bits_stored = 12, .high_bit = 11};
    std::vector<std::uint16_t> words = {0xF000, 0, 7, 0xF000, 0xF000};
    SliceState state;
    settle_samples<std::uint16_t>(words, format, Padding{0xF000, 0xF000}, state);
    EXPECT_EQ(state.padding_voxels, 3);
    ASSERT_EQ(state.padding.size(), 2u);
    EXPECT_EQ(state.padding[1].first, 3u);
    EXPECT_EQ(state.padding[1].count, 2u);
    EXPECT_EQ(state.lo, 0);
    EXPECT_EQ(state.hi, 7);
}

}  // namespace
}  // namespace lacuna::dicom
