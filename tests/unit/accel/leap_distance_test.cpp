#include "core/accel/leap_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/base/parallel.h"

// The three ways of leap values against a search over all voxels.
namespace lacuna {
namespace {

struct Labels {
    std::string name;
    glm::ivec3 size;
    glm::dvec3 spacing;
    std::vector<std::uint32_t> label;

    LabelGrid grid() const { return {size, spacing, label.data()}; }
    std::uint32_t most() const { return *std::max_element(label.begin(), label.end()); }
};

void PrintTo(const Labels& l, std::ostream* out) { *out << l.name; }

/// Balls of several labels, touching one another, in a background of label 0 or of a region of its own.
Labels balls(std::string name, glm::ivec3 size, glm::dvec3 spacing, unsigned seed, std::uint32_t background) {
    Labels l{std::move(name), size, spacing, {}};
    l.label.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), background);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    for (std::uint32_t ball = 1; ball <= 5; ++ball) {
        const glm::dvec3 centre = glm::dvec3(share(random), share(random), share(random)) * glm::dvec3(size);
        const double radius = (0.15 + 0.25 * share(random)) * std::max({size.x, size.y, size.z});
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x, ++i)
                    if (glm::length(glm::dvec3(x, y, z) - centre) < radius) l.label[i] = ball;
    }
    return l;
}

std::vector<Labels> cases() {
    std::vector<Labels> all{
        balls("odd", {23, 17, 19}, {1, 1, 1}, 1, 0),         balls("no_background", {16, 25, 13}, {1, 1, 1}, 2, 6),
        balls("one_one_five", {21, 22, 9}, {1, 1, 5}, 3, 0), balls("uneven", {15, 14, 16}, {0.7, 1.3, 0.4}, 4, 6),
        balls("one_slice", {30, 20, 1}, {1, 2, 1}, 5, 0),    balls("one_row", {1, 1, 40}, {1, 1, 0.5}, 6, 0),
        balls("one_column", {1, 31, 1}, {1, 1, 1}, 7, 6),
    };
    Labels flat{"flat", {9, 8, 7}, {1, 1, 1}, std::vector<std::uint32_t>(504, 1)};
    all.push_back(flat);
    flat.name = "nothing";
    std::fill(flat.label.begin(), flat.label.end(), 0u);
    all.push_back(flat);
    flat.name = "one_voxel";
    flat.size = {1, 1, 1};
    flat.label.assign(1, 1);
    all.push_back(flat);
    std::mt19937 random(8);
    Labels noise{"noise", {13, 12, 11}, {1, 1, 2}, std::vector<std::uint32_t>(13 * 12 * 11)};
    for (std::uint32_t& label : noise.label) label = random() % 3;
    all.push_back(noise);
    return all;
}

/// mm to the nearest voxel of another label; infinite where there is none.
std::vector<double> searched(const Labels& l) {
    std::vector<double> found(l.label.size(), 0);
    const glm::ivec3 n = l.size;
    const auto at = [&](std::size_t i) {
        return glm::dvec3(int(i) % n.x, int(i) / n.x % n.y, int(i) / (n.x * n.y)) * l.spacing;
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (l.label[i] == 0) continue;
        found[i] = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < found.size(); ++j)
            if (l.label[j] != l.label[i]) found[i] = std::min(found[i], glm::length(at(i) - at(j)));
    }
    return found;
}

double unit_of(const Labels& l) { return std::min({l.spacing.x, l.spacing.y, l.spacing.z}) / 8; }

class LeapDistance : public testing::TestWithParam<Labels> {};

TEST_P(LeapDistance, TransformIsExactAndRoundedDown) {
    const Labels& l = GetParam();
    const double unit = unit_of(l);
    std::vector<std::uint16_t> made(l.label.size(), 7);
    exact_distances(l.grid(), unit, made.data());
    const std::vector<double> truth = searched(l);
    for (std::size_t i = 0; i < made.size(); ++i) {
        ASSERT_EQ(int(made[i]), leap_units(truth[i], unit)) << i << ", true distance " << truth[i];
        ASSERT_LE(made[i] * unit, truth[i] * (1 + 1e-9));
    }
}

TEST_P(LeapDistance, TreeAgreesAndGroupsNeverExceed) {
    const Labels& l = GetParam();
    const double unit = unit_of(l);
    const int radius = 12;
    std::vector<std::uint16_t> exact(l.label.size()), leaps(exact), groups(exact), centres(exact);
    exact_distances(l.grid(), unit, exact.data());
    const BoundaryList boundary = boundary_list(l.grid(), l.most());
    classify_by_neighbours(l.grid(), boundary, unit, radius, leaps.data());
    for (std::size_t i = 0; i < exact.size(); ++i) ASSERT_EQ(leaps[i] != 0, exact[i] > radius) << i;
    groups = centres = leaps;
    tree_distances(l.grid(), boundary, unit, leaps.data());
    group_distances(l.grid(), boundary, unit, radius, {0.1, 0.6, 1}, groups.data());
    group_distances(l.grid(), boundary, unit, radius, {1.0, 0.0, 1}, centres.data());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const int wanted = exact[i] > radius ? exact[i] : 0;
        ASSERT_EQ(int(leaps[i]), wanted) << i;
        ASSERT_EQ(int(centres[i]), wanted) << "every voxel a centre of its own " << i;
        ASSERT_LE(int(groups[i]), wanted) << i;
        ASSERT_EQ(groups[i] > radius, wanted > 0) << i;
    }
}

TEST_P(LeapDistance, BoundaryIsTheLayerOfRefusedNeighbours) {
    const Labels& l = GetParam();
    const BoundaryList boundary = boundary_list(l.grid(), l.most());
    std::set<std::pair<std::uint32_t, std::int64_t>> truth, made;
    const glm::ivec3 n = l.size;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x)
                for (int side = 0; side < 6; ++side) {
                    glm::ivec3 q(x, y, z);
                    q[side / 2] += side % 2 ? 1 : -1;
                    if (q[side / 2] < 0 || q[side / 2] >= n[side / 2]) continue;
                    const std::int64_t i = (std::int64_t(z) * n.y + y) * n.x + x;
                    const std::uint32_t other = l.label[std::size_t((std::int64_t(q.z) * n.y + q.y) * n.x + q.x)];
                    if (other != 0 && other != l.label[std::size_t(i)]) truth.insert({other, i});
                }
    for (std::size_t label = 0; label + 1 < boundary.first.size(); ++label)
        for (std::int64_t i = boundary.first[label]; i < boundary.first[label + 1]; ++i)
            EXPECT_TRUE(made.insert({std::uint32_t(label), boundary.voxel[std::size_t(i)]}).second) << "listed twice";
    EXPECT_EQ(made, truth);
}

INSTANTIATE_TEST_SUITE_P(Grids, LeapDistance, testing::ValuesIn(cases()),
                         [](const auto& row) { return row.param.name; });

TEST(LeapGroups, SameSeedSameValuesOnAnyNumberOfThreads) {
    const Labels l = balls("balls", {40, 41, 39}, {1, 1, 1}, 9, 0);
    const BoundaryList boundary = boundary_list(l.grid(), l.most());
    const auto values = [&](int threads, std::uint64_t seed) {
        set_thread_count(threads);
        std::vector<std::uint16_t> made(l.label.size());
        classify_by_neighbours(l.grid(), boundary, 0.125, 20, made.data());
        group_distances(l.grid(), boundary, 0.125, 20, {0.05, 0.5, seed}, made.data());
        set_thread_count(0);
        return made;
    };
    const auto first = values(1, 1);
    EXPECT_EQ(values(4, 1), first);
    EXPECT_NE(values(1, 2), first) << "the seed chooses the centres";
}

TEST(LeapGroups, MoreCentresLargerValues) {
    const Labels l = balls("balls", {40, 41, 39}, {1, 1, 1}, 9, 0);
    const BoundaryList boundary = boundary_list(l.grid(), l.most());
    double before = 0;
    for (const double probability : {0.001, 0.02, 0.3}) {
        std::vector<std::uint16_t> made(l.label.size());
        classify_by_neighbours(l.grid(), boundary, 0.125, 20, made.data());
        group_distances(l.grid(), boundary, 0.125, 20, {probability, 0.5, 1}, made.data());
        double sum = 0;
        for (const std::uint16_t value : made) sum += value;
        EXPECT_GT(sum, before);
        before = sum;
    }
}

TEST(LeapDistance, LongDistancesSaturate) {
    Labels l{"row", {1, 1, 6000}, {1, 1, 1}, std::vector<std::uint32_t>(6000, 1)};
    l.label[0] = 0;
    std::vector<std::uint16_t> made(6000);
    exact_distances(l.grid(), 0.125, made.data());
    EXPECT_EQ(made[100], 800);
    EXPECT_EQ(made[4500], k_leap_limit);
    EXPECT_EQ(made[5999], k_leap_limit);
}

}  // namespace
}  // namespace lacuna
