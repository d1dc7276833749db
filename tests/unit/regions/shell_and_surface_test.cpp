#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/regions/bounding_sphere.h"
#include "core/regions/point_tree.h"
#include "core/regions/region_shell.h"
#include "core/regions/run_components.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna {
namespace {

using namespace test;

TEST(BoundingSphere, IsTheSmallestThatHoldsAllPoints) {
    EXPECT_EQ(smallest_enclosing_sphere({}).radius, 0);
    const std::vector<glm::dvec3> one{{1, 2, 3}}, two{{0, 0, 0}, {0, 6, 8}}, same(5, glm::dvec3(4, 4, 4));
    EXPECT_EQ(smallest_enclosing_sphere(one).radius, 0);
    EXPECT_NEAR(smallest_enclosing_sphere(two).radius, 5, 1e-12);
    EXPECT_NEAR(smallest_enclosing_sphere(same).radius, 0, 1e-12);
    const std::vector<glm::dvec3> obtuse{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}};  // the third lies inside
    EXPECT_NEAR(smallest_enclosing_sphere(obtuse).radius, 5, 1e-12);
    std::vector<glm::dvec3> cube;
    for (int c = 0; c < 8; ++c) cube.emplace_back(c & 1, c >> 1 & 1, c >> 2 & 1);
    EXPECT_NEAR(smallest_enclosing_sphere(cube).radius, std::sqrt(3) / 2, 1e-12);
}

TEST(BoundingSphere, NoPointLiesOutsideAndNoSmallerOneIsFoundByDescent) {
    Noise noise(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 40; ++i)
            points.emplace_back(noise.below(1000) * 0.1, noise.below(300) * 0.1, round % 3 ? noise.below(50) * 0.1 : 0);
        const Sphere s = smallest_enclosing_sphere(points);
        const auto radius_at = [&](const glm::dvec3& c) {
            double r = 0;
            for (const glm::dvec3& p : points) r = std::max(r, glm::length(p - c));
            return r;
        };
        EXPECT_LE(radius_at(s.centre), s.radius * (1 + 1e-9));
        // The radius a centre needs is convex: no better centre nearby means none anywhere.
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 step(noise.below(201) - 100, noise.below(201) - 100, noise.below(201) - 100);
            EXPECT_GE(radius_at(s.centre + 1e-4 * step), s.radius * (1 - 1e-9));
        }
    }
}

TEST(BoundingSphere, OfATinyBodyFarAwayKeepsItsDigits) {
    // As an isosurface that only just passes a voxel leaves it: six points a thousandth of a voxel round its centre.
    const glm::dvec3 centre(279, -179, 1546);
    std::vector<glm::dvec3> points;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1e-3, 1e-3}) {
            points.push_back(centre);
            points.back()[axis] += side;
        }
    const Sphere sphere = smallest_enclosing_sphere(points);
    EXPECT_NEAR(sphere.radius, 1e-3, 1e-9);
    EXPECT_NEAR(glm::length(sphere.centre - centre), 0, 1e-9);
}

TEST(PointTree, FindsWhatBruteForceFinds) {
    Noise noise(5);
    std::vector<PointTree::Point> points;
    for (int i = 0; i < 700; ++i)
        points.push_back({{noise.below(100), noise.below(80), noise.below(9)}, std::uint32_t(i / 100)});
    const PointTree tree(points);
    for (int i = 0; i < 300; ++i) {
        // One point or as many as take several blocks, all over or close together.
        std::vector<PointTree::Point> from(i % 4 == 0 ? 1u : std::size_t(noise.below(200) + 1));
        const int apart = i % 5 == 0 ? 3 : 140;
        for (PointTree::Point& p : from)
            p = {{noise.below(apart) - 20, noise.below(100), noise.below(30) - 40 * (i % 7 == 0)}, 99};
        const std::uint32_t but = i % 2 ? PointTree::k_any : std::uint32_t(noise.below(8));
        double best = i % 3 ? std::numeric_limits<double>::infinity() : 7.5;
        for (const auto& p : points)
            for (const auto& q : from)
                if (but == PointTree::k_any || p.tag != but)
                    best = std::min(best, glm::length(glm::dvec3(p.mm) - glm::dvec3(q.mm)));
        EXPECT_NEAR(tree.nearest_mm(from, but, i % 3 ? std::numeric_limits<double>::infinity() : 7.5), best, 1e-9);
    }
    std::vector<PointTree::Point> one{{{0, 0, 0}, 1}};
    EXPECT_EQ(PointTree().nearest_mm(one, PointTree::k_any, 3), 3);
    EXPECT_EQ(tree.nearest_mm({}, PointTree::k_any, 3), 3);
}

TEST(RegionShell, DistancesAreThoseOfBruteForce) {
    const GridGeometry g = grid({9, 8, 7});
    LabelVolume labels{g, std::make_shared<std::vector<std::uint32_t>>(std::size_t(g.voxel_count()), 0u)};
    MaskVolume part{g, std::make_shared<std::vector<std::uint8_t>>(std::size_t(g.voxel_count()), std::uint8_t(1))};
    Noise noise(7);
    glm::ivec3 first(100), last(-1);
    for (int z = 0; z < 7; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 9; ++x) {
                const std::size_t i = std::size_t(g.linear_index(x, y, z));
                const int dice = noise.below(20);
                if (dice == 0 && x < 5) {
                    (*labels.labels)[i] = 4, first = glm::min(first, glm::ivec3(x, y, z)),
                    last = glm::max(last, glm::ivec3(x, y, z));
                } else if (dice == 1) {
                    (*labels.labels)[i] = 2;
                } else if (dice == 2) {
                    (*part.labels)[i] = 0;
                }
            }
    ASSERT_LE(first.x, last.x);
    for (const int reach : {1, 2, 3}) {
        RegionShell shell(labels, &part, 4, first, last, reach);
        const auto brute = [&](const glm::ivec3& p, auto counts) {
            int best = reach + 1;
            for (int dz = -reach; dz <= reach; ++dz)
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx) {
                        const glm::ivec3 q = p + glm::ivec3(dx, dy, dz);
                        // Only what the window holds is seen; it is reach + 1 wide, so nothing nearer is missed.
                        if (counts(q)) best = std::min(best, std::max({std::abs(dx), std::abs(dy), std::abs(dz)}));
                    }
            return best;
        };
        const auto in_grid = [&](const glm::ivec3& q) {
            return glm::all(glm::greaterThanEqual(q, glm::ivec3(0))) && glm::all(glm::lessThan(q, g.size));
        };
        const auto own = [&](const glm::ivec3& q) { return in_grid(q) && labels(q.x, q.y, q.z) == 4; };
        for (int z = 0; z < shell.extent().z; ++z) {
            const auto at = shell.slice(z);
            for (int y = 0; y < shell.extent().y; ++y)
                for (int x = 0; x < shell.extent().x; ++x) {
                    const glm::ivec3 p = shell.first() + glm::ivec3(x, y, z);
                    const std::size_t i = std::size_t(y) * std::size_t(shell.extent().x) + std::size_t(x);
                    EXPECT_EQ(at.own[i], brute(p, own));
                    if (own(p)) {
                        EXPECT_EQ(at.beyond[i], brute(p, [&](const glm::ivec3& q) { return !own(q); }));
                    } else {
                        EXPECT_EQ(at.beyond[i], 0);
                    }
                    const bool deep = at.own[i] <= reach;  // away from the window's edge
                    if (deep && x >= reach && y >= reach && x < shell.extent().x - reach &&
                        y < shell.extent().y - reach) {
                        EXPECT_EQ(at.foreign[i], brute(p, [&](const glm::ivec3& q) {
                                      return in_grid(q) && !own(q) &&
                                             (labels(q.x, q.y, q.z) != 0 || !part(q.x, q.y, q.z));
                                  }));
                    }
                }
        }
    }
}

TEST(RunComponents, AreTheSameForOneThreadAndForMany) {
    Noise noise(11);
    const Volume volume = volume_of<std::uint8_t>(grid({37, 41, 131}), [&](int, int, int) { return noise.below(5); });
    for (const Connectivity c : {Connectivity::c6, Connectivity::c18, Connectivity::c26}) {
        std::vector<std::uint32_t> labels[2];
        for (const int threads : {1, 2}) {
            set_thread_count(threads);
            RegionOptions options;
            options.threshold = ValueRange{0, c == Connectivity::c6 ? 1.0 : 0.0};
            options.connectivity = c;
            labels[threads - 1] = *find_regions(volume, options).labels.labels;
        }
        set_thread_count(0);
        EXPECT_EQ(labels[0], labels[1]);
    }
}

TEST(RunComponents, MarksFollowTheValuesExactly) {
    const Volume u = volume_of<std::int16_t>(grid({7, 1, 1}), [](int x, int, int) { return x - 3; });
    const auto marks = [&](const Volume& v, const runs::MarkRow& mark) {
        std::vector<std::uint8_t> m(std::size_t(v.geometry().size.x));
        mark(0, 0, m.data());
        std::string s;
        for (const std::uint8_t b : m) s += b ? '1' : '0';
        return s;
    };
    EXPECT_EQ(marks(u, runs::mark_in_range(u, {-1.5, 1})), "0011100");
    EXPECT_EQ(marks(u, runs::mark_in_range(u, {-1e9, 1e9})), "1111111");
    EXPECT_EQ(marks(u, runs::mark_in_range(u, {0.2, 0.8})), "0000000");
    EXPECT_EQ(marks(u, runs::mark_below(u, 0)), "1110000");
    EXPECT_EQ(marks(u, runs::mark_below(u, 0.5)), "1111000");
    EXPECT_EQ(marks(u, runs::mark_below(u, 1e9)), "1111111");
    EXPECT_EQ(marks(u, runs::mark_below(u, -1e9)), "0000000");
    EXPECT_EQ(marks(u, runs::mark_above(u, 1)), "0000011");
    const float inf = std::numeric_limits<float>::infinity();
    const float values[] = {NAN, -inf, 0, 1, inf};
    const Volume f = volume_of<float>(grid({5, 1, 1}), [&](int x, int, int) { return values[x]; });
    EXPECT_EQ(marks(f, runs::mark_below(f, 1)), "11100");
    EXPECT_EQ(marks(f, runs::mark_above(f, 0)), "00010");
    EXPECT_EQ(marks(f, runs::mark_in_range(f, {-inf, inf})), "00110");
}

/// A ball as a smooth field: 100 inside, 0 outside, half way at its radius.
Volume smooth_ball(const glm::dvec3& spacing, double radius) {
    const glm::ivec3 n = glm::ivec3(glm::ceil(glm::dvec3(2 * radius + 8) / spacing));
    const glm::dvec3 centre = glm::dvec3(n - 1) * spacing / 2.0 + 0.21;
    return volume_of<float>(grid(n, spacing), [&](int x, int y, int z) {
        return 50 * std::erfc((glm::length(glm::dvec3(x, y, z) * spacing - centre) - radius) / 1.2);
    });
}

TEST(ValueExactMesh, LiesOnTheThresholdAndIsClosed) {
    const Volume volume = smooth_ball({1, 1, 1}, 6);
    const RegionTable table = regions_of(volume);
    ASSERT_EQ(table.rows.size(), 1u);
    const TriangleMesh mesh = region_mesh(volume, {50, 150}, table.labels, table.rows[0]);
    EXPECT_TRUE(is_closed(mesh));
    const GridGeometry& g = volume.geometry();
    int along_edges = 0;
    for (const glm::dvec3& v : mesh.vertices) {
        const glm::dvec3 p = g.mm_to_voxel(v), whole = glm::round(p);
        const glm::dvec3 off = glm::abs(p - whole);
        int axis = 0;
        for (int a = 1; a < 3; ++a)
            if (off[a] > off[axis]) axis = a;
        if (off[(axis + 1) % 3] > 1e-9 || off[(axis + 2) % 3] > 1e-9) continue;  // the hub of a wheel
        ++along_edges;
        glm::ivec3 low(whole);
        low[axis] = int(std::floor(p[axis]));
        glm::ivec3 high = low;
        high[axis] += 1;
        const double share = p[axis] - low[axis];
        const double value =
            volume.value(low.x, low.y, low.z) * (1 - share) + volume.value(high.x, high.y, high.z) * share;
        EXPECT_NEAR(value, 50, 0.11);  // the ends of an edge are kept clear by a thousandth of it
    }
    EXPECT_GT(along_edges, 500);
}

TEST(ValueExactMesh, WithTheLinearDeficitEnclosesTheBallOnAnySpacing) {
    for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.8, 1, 1.3), glm::dvec3(0.5, 0.5, 1.5)})
        for (const double radius : {3.0, 5.0, 9.0}) {
            Volume volume = smooth_ball(spacing, radius);
            for (const double mirror : {1.0, -1.0}) {
                GridGeometry g = volume.geometry();
                g.direction[0] *= mirror;
                volume = Volume(g, volume.type(), volume.buffer());
                const RegionTable table = regions_of(volume);
                ASSERT_EQ(table.rows.size(), 1u);
                TriangleMesh mesh = region_mesh(volume, {50, 150}, table.labels, table.rows[0]);
                const double truth = 4.0 / 3 * M_PI * radius * radius * radius;
                const double plain = enclosed_volume_mm3(mesh), deficit = linear_deficit_mm3(mesh, g);
                EXPECT_LT(plain, truth);
                EXPECT_NEAR(plain + deficit, truth,
                            (0.012 + (spacing.x == spacing.z ? 0 : 0.15 / (radius * radius))) * truth)
                    << radius << " plain " << plain / truth;
                offset_to_volume(mesh, truth, 0.5);
                EXPECT_NEAR(enclosed_volume_mm3(mesh), truth, 1e-3 * truth);
                EXPECT_TRUE(is_closed(mesh));
            }
        }
}

TEST(ValueExactMesh, StaysOnTheMaskAgainstTheFrame) {
    const Volume volume = volume_of<std::uint8_t>(grid({6, 4, 4}), [](int x, int, int) { return x < 2 ? 100 : 60; });
    const RegionTable table = regions_of(volume);  // one region, up to the frame
    const TriangleMesh mesh = region_mesh(volume, {50, 150}, table.labels, table.rows.at(0));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(enclosed_volume_mm3(mesh), enclosed_volume_mm3(region_mesh(table.labels, table.rows.at(0))));
    EXPECT_THROW(region_mesh(volume_of<std::uint8_t>(grid({2, 2, 2}), [](int, int, int) { return 0; }), {0, 1},
                             table.labels, table.rows.at(0)),
                 Error);
}

}  // namespace
}  // namespace lacuna
