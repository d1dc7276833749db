#include "core/volume/axis_names.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lacuna;

TEST(AxisNames, SidesAreAPatientsLettersOrSignedAxes) {
    const double c = std::cos(glm::radians(45.0));
    struct Row {
        glm::dvec3 direction;
        const char *patient, *xyz;
    };
    const Row rows[] = {{{1, 0, 0}, "L", "+X"},     {{-1, 0, 0}, "R", "-X"},     {{0, 1, 0}, "P", "+Y"},
                        {{0, -1, 0}, "A", "-Y"},    {{0, 0, 1}, "H", "+Z"},      {{0, 0, -1}, "F", "-Z"},
                        {{c, -c, 0}, "LA", "+X-Y"}, {{0.2, 0, -0.98}, "F", "-Z"}};
    for (const Row& row : rows) {
        EXPECT_EQ(sides_of(AxisNames::patient, row.direction), row.patient);
        EXPECT_EQ(sides_of(AxisNames::xyz, row.direction), row.xyz);
    }
}

TEST(AxisNames, ACoordinateIsADistanceOnASideOfAPatientAndASignedNumberOfAPart) {
    EXPECT_EQ(place_along(AxisNames::patient, 0, -12.5).name, "R");
    EXPECT_EQ(place_along(AxisNames::patient, 0, -12.5).mm, 12.5);
    EXPECT_EQ(place_along(AxisNames::patient, 2, 3).name, "H");
    EXPECT_EQ(place_along(AxisNames::xyz, 0, -12.5).name, "X");
    EXPECT_EQ(place_along(AxisNames::xyz, 0, -12.5).mm, -12.5);
    EXPECT_EQ(place_along(AxisNames::xyz, 2, 3).name, "Z");
}

TEST(AxisNames, AGridAxisIsNamedByItsEnds) {
    EXPECT_EQ(axis_span(AxisNames::patient, {1, 0, 0}), "R–L");
    EXPECT_EQ(axis_span(AxisNames::patient, {0.1, -0.9, 0.2}), "P–A");
    EXPECT_EQ(axis_span(AxisNames::xyz, {0, 0, 1}), "-Z…+Z");
    EXPECT_EQ(axis_span(AxisNames::xyz, {0, 0, -1}), "+Z…-Z");
}

TEST(AxisNames, APlainGridIsAPartsUntilItsInputSaysMore) { EXPECT_EQ(GridGeometry{}.axis_names, AxisNames::xyz); }
