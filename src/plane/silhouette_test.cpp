#include "plane/silhouette.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "base/test_cases.h"
#include "plane/silhouette_test_shapes.h"

namespace filigree {
namespace {

constexpr int smooth = 8, hard = 1;  // samples a pixel and side

Rings found(const Rings& shape, std::uint32_t size, int samples) {
    const std::vector<Polyline> outlines = silhouette(drawn(shape, size, size, samples));
    for (const Polyline& line : outlines) EXPECT_TRUE(line.closed);
    return rings_of(outlines);
}

double ink(const Rings& shape, int samples) {  // of the picture of it
    double sum = 0;
    for (const float value : drawn(shape, 200, 200, samples).darkness) sum += value;
    return sum;
}

double total_area(const Rings& rings) {
    double sum = 0;
    for (const std::vector<Vec>& ring : rings) sum += signed_area(ring);
    return sum;
}

std::vector<Vec> square_ring(Vec centre, double side, double degrees) {
    const double h = side / 2;
    return turned_ring({centre + Vec{-h, -h}, centre + Vec{h, -h}, centre + Vec{h, h}, centre + Vec{-h, h}}, degrees,
                       centre);
}

TEST(Silhouette, Discs) {
    for (const int samples : {smooth, hard}) {
        for (const double radius : {2.5, 4.0, 8.0, 15.0, 40.0, 90.0}) {
            for (const Vec shift : {Vec{0, 0}, Vec{0.3, 0.6}}) {
                const Rings disc = {disc_ring(Vec{100, 100} + shift, radius)};
                const Rings rings = found(disc, 200, samples);
                ASSERT_EQ(rings.size(), 1U);
                const double most = samples == smooth ? 0.25 : 0.75;  // px beside the edge; a pixel is off by that
                EXPECT_LT(farthest(rings, disc), most) << radius;
                EXPECT_LT(farthest(disc, rings), most) << radius;
                EXPECT_NEAR(signed_area(rings[0]), signed_area(disc[0]),
                            2 * elementary::pi * radius * (samples == smooth ? 0.12 : 0.3))
                    << radius;
                EXPECT_LT(whole_turn(rings[0]), samples == smooth ? 361 : 380) << radius;  // no steps
                for (std::size_t i = 0; i < rings[0].size(); ++i) {                        // and no corner
                    const Vec a = rings[0][i], b = rings[0][(i + 1) % rings[0].size()];
                    const Vec c = rings[0][(i + 2) % rings[0].size()];
                    EXPECT_GT(dot(b - a, c - b), 0.7 * length(b - a) * length(c - b)) << radius;
                }
            }
        }
    }
}

TEST(Silhouette, SquaresKeepTheirCorners) {
    for (const double side : {12.0, 20.0, 60.0, 120.0}) {
        for (int degrees = 0; degrees < 90; degrees += 5) {
            for (const Vec shift : {Vec{0, 0}, Vec{0.2, 0.4}}) {
                const std::vector<Vec> square = square_ring(Vec{100, 100} + shift, side, degrees);
                const Rings exact = found({square}, 200, smooth);
                ASSERT_EQ(exact.size(), 1U);
                EXPECT_LE(exact[0].size(), 20U) << side << " " << degrees;
                EXPECT_LT(corner_miss(square, exact), 0.8) << side << " " << degrees;
                EXPECT_LT(farthest(exact, {square}), 0.5) << side << " " << degrees;
                EXPECT_NEAR(signed_area(exact[0]), ink({square}, smooth), 4 * side * 0.04) << side << " " << degrees;
                EXPECT_LT(whole_turn(exact[0]), 365) << side << " " << degrees;
                // Pixels that are black or white leave more open; what lies along them is exact.
                const Rings rough = found({square}, 200, hard);
                ASSERT_EQ(rough.size(), 1U);
                EXPECT_LT(corner_miss(square, rough), 1.4) << side << " " << degrees;
                EXPECT_LT(farthest(rough, {square}), 1) << side << " " << degrees;
                EXPECT_NEAR(signed_area(rough[0]), ink({square}, hard), 4 * side * 0.15) << side << " " << degrees;
                EXPECT_LT(whole_turn(rough[0]), 420) << side << " " << degrees;
            }
        }
    }
    const std::vector<Vec> aligned = {{50, 40}, {130, 40}, {130, 90}, {50, 90}};
    const Rings rings = found({aligned}, 200, hard);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_EQ(rings[0].size(), 4U);
    EXPECT_LT(farthest(rings, {aligned}), 1e-9);
}

TEST(Silhouette, LettersWithHolesAndSharpCorners) {
    const std::vector<Vec> a = {{92, 30},   {108, 30}, {150, 170}, {130, 170},
                                {117, 130}, {83, 130}, {70, 170},  {50, 170}};
    const std::vector<Vec> in_a = {{100, 60}, {88, 112}, {112, 112}};
    const std::vector<Vec> z = {{40, 40},   {160, 40}, {160, 60}, {75, 140}, {160, 140},
                                {160, 160}, {40, 160}, {40, 140}, {125, 60}, {40, 60}};
    std::vector<Vec> star, d = {{60, 40}};
    for (int i = 0; i < 10; ++i) {
        const auto turn = elementary::cos_sin_degrees(36 * i + 7);
        star.push_back(Vec{100, 100} + (i % 2 != 0 ? 30.0 : 80.0) * Vec{turn.cos, turn.sin});
    }
    for (int i = 0; i <= 180; ++i) {
        const auto turn = elementary::cos_sin_degrees(i - 90);
        d.push_back(Vec{90, 100} + 60.0 * Vec{turn.cos, turn.sin});
    }
    d.push_back({60, 160});
    struct Case {
        Rings shape;
        std::vector<Vec> corners;
    };
    std::vector<Vec> corners_of_a = a;
    corners_of_a.insert(corners_of_a.end(), in_a.begin(), in_a.end());
    for (const Case& letter :
         {Case{{a, in_a}, corners_of_a}, Case{{z}, z}, Case{{star}, star}, Case{{d}, {{60, 40}, {60, 160}}}}) {
        double inked = 0;  // even-odd: the hole of the A counts against it
        for (std::size_t i = 0; i < letter.shape.size(); ++i) {
            inked += (i == 0 ? 1 : -1) * std::fabs(signed_area(letter.shape[i]));
        }
        for (const int samples : {smooth, hard}) {
            const Rings rings = found(letter.shape, 200, samples);
            ASSERT_EQ(rings.size(), letter.shape.size());
            EXPECT_LT(corner_miss(letter.corners, rings), samples == smooth ? 0.5 : 1.2);
            EXPECT_LT(farthest(rings, letter.shape), samples == smooth ? 0.3 : 0.8);
            EXPECT_NEAR(total_area(rings), inked, (samples == smooth ? 0.001 : 0.01) * inked);
            EXPECT_GT(signed_area(rings[0]), 0);
            EXPECT_LT(signed_area(rings.back()), rings.size() > 1 ? 0 : HUGE_VAL);
        }
    }
}

TEST(Silhouette, ThinLinesSurviveAndSpecksDoNot) {
    const Rings line = found({{{10, 20}, {60, 20}, {60, 21}, {10, 21}}}, 80, hard);
    ASSERT_EQ(line.size(), 1U);
    EXPECT_NEAR(signed_area(line[0]), 50, 12);
    const Rings shapes = {{{10, 10}, {40, 10}, {40, 40}, {10, 40}},
                          {{20, 20}, {22, 20}, {22, 22}, {20, 22}},
                          {{60, 60}, {61, 60}, {61, 62}, {60, 62}}};
    const GreyImage image = drawn(shapes, 80, 80, hard);
    EXPECT_EQ(silhouette(image, {0.5, 0}).size(), 3U);
    EXPECT_EQ(silhouette(image, {0.5, 1.5}).size(), 2U);  // of the specks only the larger
    EXPECT_EQ(silhouette(image, {0.5, 10}).size(), 1U);
    EXPECT_EQ(silhouette(image, {0.5, 1000}).size(), 0U);
}

TEST(Silhouette, ThresholdsAndBorders) {
    GreyImage ramp{64, 16, {}};
    for (std::uint32_t i = 0; i < 64 * 16; ++i) ramp.darkness.push_back(static_cast<float>(i % 64) / 63);
    for (const double threshold : {0.25, 0.5, 0.75}) {
        const std::vector<Polyline> dark = silhouette(ramp, {threshold, 4});
        ASSERT_EQ(dark.size(), 1U);
        EXPECT_NEAR(signed_area(dark[0].points), 16 * (63.5 - 63 * threshold), 30) << threshold;
    }
    const GreyImage black{30, 20, std::vector<float>(600, 1)}, white{30, 20, std::vector<float>(600, 0)};
    const std::vector<Polyline> whole = silhouette(black);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].points.size(), 4U);
    EXPECT_NEAR(signed_area(whole[0].points), 600, 1e-9);  // the picture itself
    EXPECT_TRUE(silhouette(white).empty());
    EXPECT_TRUE(silhouette(white, {0, 0}).empty());
    EXPECT_EQ(silhouette(black, {2, 0}).size(), 1U);
    EXPECT_TRUE(silhouette(GreyImage{}).empty());
    EXPECT_EQ(silhouette({1, 1, {1}}, {0.5, 0}).size(), 1U);
}

TEST(Silhouette, AnyPictureGivesItsAreaInTurns) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::uint32_t width = 1 + random.below(24), height = 1 + random.below(24);
        GreyImage image{width, height, {}};
        const bool is_hard = random.coin();
        const double share = random.unit();
        for (std::uint32_t i = 0; i < width * height; ++i) {
            image.darkness.push_back(static_cast<float>(is_hard ? (random.unit() < share ? 1 : 0) : random.unit()));
        }
        const std::vector<Polyline> outlines = silhouette(image, {0.5, 0});
        double dark = 0, area = 0, around = 0;  // around: sides of pixels between dark and light
        for (std::uint32_t y = 0; y <= height; ++y) {
            for (std::uint32_t x = 0; x <= width; ++x) {
                const auto at = [&](std::uint32_t i, std::uint32_t j) {
                    return i < width && j < height ? static_cast<double>(image.darkness[j * width + i]) : 0;
                };
                dark += at(x, y);
                around += std::fabs(at(x, y) - at(x - 1, y)) + std::fabs(at(x, y) - at(x, y - 1));
            }
        }
        for (const Polyline& line : outlines) {
            ASSERT_TRUE(line.closed);
            ASSERT_GE(line.points.size(), 3U);
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                const Vec p = line.points[i];
                ASSERT_TRUE(p.x > -3 && p.y > -3 && p.x < width + 3.0 && p.y < height + 3.0) << "seed " << seed;
            }
            area += signed_area(line.points);
        }
        if (is_hard) {
            ASSERT_NEAR(area, dark, 0.3 * around) << "seed " << seed;
        }
        ASSERT_EQ(outlines, silhouette(image, {0.5, 0}));
    }
}

TEST(Silhouette, LargePicturesAreQuick) {
    Rings shapes;
    for (int i = 0; i < 100; ++i) {
        shapes.push_back(disc_ring({100.0 + 200 * (i % 10), 100.0 + 200 * (i / 10)}, 60.0 + i % 30, 90));
    }
    const GreyImage image = drawn(shapes, 2000, 2000, 2);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Polyline> outlines = silhouette(image);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("4 million pixels with 100 discs: %.0f ms\n", 1e3 * seconds);
    EXPECT_EQ(outlines.size(), 100U);
}

}  // namespace
}  // namespace filigree
