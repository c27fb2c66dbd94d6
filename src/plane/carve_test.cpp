#include "plane/carve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/fit.h"
#include "plane/inset_test_shapes.h"
#include "plane/spread.h"
#include "plane/verify.h"

namespace filigree {
namespace {

struct Scene {
    Polygons region;
    Polygons objects;
    std::vector<std::uint32_t> owners;
};

Motif frame_motif() {  // with a hole, and a square in it
    return drawn_motif({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true},
                        {{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, true},
                        {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, true}},
                       FillRule::even_odd, 1e-3);
}

Scene random_scene(CaseRandom& random, bool may_cross) {
    Scene scene;
    scene.region = random.coin() ? test_shapes::wobbly_shape(random, 100, random.whole(8, 60), 6)
                                 : test_shapes::one_polygon({test_shapes::wild_ring(random, {3, 4}, 100, 12)});
    const EdgeTree border(edges_of(scene.region[0], Point{0, 0}));
    SpreadOptions options;
    options.spacing = options.apart = random.between(8, 40);
    options.seed = random.bits();
    const Motif motif = random.coin() ? disc_motif(16) : random.coin() ? square_motif() : frame_motif();
    std::vector<Pose> poses;
    for (const SpreadPoint& point : spread(scene.region[0], options)) {
        const elementary::CosSin turn = elementary::cos_sin_degrees(random.between(0, 360));
        poses.push_back({point.at, {turn.cos, turn.sin}, 0.5 * options.spacing});
    }
    FitOptions fitting;
    fitting.border_counts = !may_cross;
    fit(poses, motif, border, fitting);
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
        if (poses[i].radius > 0) append(scene.objects, motif, poses[i]);
        scene.owners.resize(scene.objects.size(), i);
    }
    return scene;
}

void expect_partition(const Scene& scene, bool may_cross) {
    const EdgeTree border(edges_of(scene.region[0], Point{0, 0}));
    const Carving carving = carve(scene.region[0], border, scene.objects, scene.owners, may_cross);
    Polygons all = carving.placed;
    all.add_all(carving.remainder);
    EXPECT_NEAR(area(all), area(scene.region), 1e-9 * area(scene.region));
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(find_flaw(all[i]), std::nullopt);
    EXPECT_EQ(find_overlap(all), std::nullopt);
    ASSERT_EQ(carving.owners.size(), carving.placed.size());
    ASSERT_EQ(carving.enclosing.size(), carving.remainder.size());
    EXPECT_TRUE(std::is_sorted(carving.owners.begin(), carving.owners.end()));
    // Every piece lies in its owner, every piece of the remainder outside all objects.
    const auto holds = [&](std::uint32_t owner, Point p) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            if (scene.owners[i] != owner) continue;
            for (int x = -4; x <= 4; x += 4) {
                for (int y = -4; y <= 4; y += 4) {
                    if (locate(scene.objects[i], {p.x + x, p.y + y}) >= 0) return true;
                }
            }
        }
        return false;
    };
    for (std::size_t i = 0; i < carving.placed.size(); ++i) {
        for (const Point p : carving.placed[i].outer()) EXPECT_TRUE(holds(carving.owners[i], p));
    }
    EXPECT_TRUE(may_cross || carving.placed.size() == scene.objects.size());
}

TEST(Carve, PartsARegionExactly) {
    const std::uint64_t count = case_count(150);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const bool may_cross = random.coin();
        expect_partition(random_scene(random, may_cross), may_cross);
    }
}

TEST(Carve, HolesOfObjectsBelongToTheRemainder) {
    Scene scene;
    scene.region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})}});
    const Motif motif = frame_motif();
    for (std::uint32_t i = 0; i < 3; ++i) {
        append(scene.objects, motif, {{25.0 * (i + 1), 50}, {1, 0}, 10});
        scene.owners.resize(scene.objects.size(), 7 * i);
    }
    ASSERT_EQ(scene.objects.size(), 6U);  // a frame and a square in it each
    const EdgeTree border(edges_of(scene.region[0], Point{0, 0}));
    const Carving carving = carve(scene.region[0], border, scene.objects, scene.owners, false);
    const std::vector<std::uint32_t> expected{Carving::none, 0, 7, 14};
    EXPECT_EQ(carving.enclosing, expected);
    EXPECT_EQ(carving.remainder[0].ring_count(), 4U);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(carving.remainder[i].ring_count(), 2U);
    expect_partition(scene, false);
}

TEST(Carve, ObjectsAreCutByTheBorder) {
    Scene scene;
    scene.region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})},
                                             {snap({48, 49}), snap({52, 49}), snap({50, 52})}});
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::vector<Vec> places{{0, 50}, {100, 100}, {30, 30}, {50, 50}};
        append(scene.objects, square_motif(), {places[i], {1, 0}, std::sqrt(200.0)});
        scene.owners.push_back(i);
    }
    const EdgeTree border(edges_of(scene.region[0], Point{0, 0}));
    const Carving carving = carve(scene.region[0], border, scene.objects, scene.owners, true);
    ASSERT_EQ(carving.placed.size(), 4U);
    EXPECT_NEAR(area(carving.placed[0]), 200, 1e-5);
    EXPECT_NEAR(area(carving.placed[1]), 100, 1e-5);
    EXPECT_NEAR(area(carving.placed[2]), 400, 1e-5);
    EXPECT_NEAR(area(carving.placed[3]), 394, 1e-5);
    EXPECT_EQ(carving.remainder.size(), 1U);
    expect_partition(scene, true);
}

TEST(Carve, ObjectsOutsideAreLeftOutWhereTheyMayCross) {
    const Polygons region =
        test_shapes::one_polygon({{snap({0, 0}), snap({50, 0}), snap({50, 50}), snap({0, 50})},
                                  {snap({20, 20}), snap({30, 20}), snap({30, 30}), snap({20, 30})}});
    Polygons objects;
    for (const Vec at : {Vec{25, 25}, Vec{80, 25}, Vec{10, 10}}) append(objects, square_motif(), {at, {1, 0}, 4});
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    const Carving carving = carve(region[0], border, objects, {0, 1, 2}, true);
    EXPECT_EQ(carving.owners, std::vector<std::uint32_t>{2});
    EXPECT_NEAR(area(carving.placed) + area(carving.remainder), 2400, 1e-6);
}

TEST(Carve, WithoutObjectsAllRemains) {
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({9, 0}), snap({0, 9})}});
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    const Carving carving = carve(region[0], border, {}, {}, true);
    EXPECT_TRUE(carving.placed.empty());
    EXPECT_EQ(carving.remainder, region);
    EXPECT_EQ(carving.enclosing, std::vector<std::uint32_t>{Carving::none});
}

TEST(Carve, ObjectsThatCoverAllLeaveNothing) {
    Scene scene;
    scene.region = test_shapes::one_polygon({{snap({0, 0}), snap({9, 0}), snap({0, 9})}});
    append(scene.objects, square_motif(), {{4, 4}, {1, 0}, 100});
    scene.owners = {0};
    const EdgeTree border(edges_of(scene.region[0], Point{0, 0}));
    const Carving carving = carve(scene.region[0], border, scene.objects, scene.owners, true);
    EXPECT_TRUE(carving.remainder.empty());
    EXPECT_NEAR(area(carving.placed), area(scene.region), 1e-9);
}

}  // namespace
}  // namespace filigree
