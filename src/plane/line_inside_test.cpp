#include "plane/line_inside.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"

namespace filigree {
namespace {

Polygons polygon_of(const std::vector<Vec>& corners) {
    Polygons made;
    for (const Vec p : corners) made.points.push_back(snap(p));
    made.end_ring();
    made.end_polygon();
    return made;
}
std::vector<Point> line_of(const std::vector<Vec>& points) {
    std::vector<Point> line;
    for (const Vec p : points) line.push_back(snap(p));
    return line;
}
Polygons inside(const std::vector<Vec>& line, const Polygons& border) {
    Polygons parts;
    add_parts_inside(parts, line_of(line), EdgeTree(edges_of(border[0], Point{})));
    return parts;
}
double length_of(const Polygons& lines) {
    double sum = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const RingView line = lines[i].outer();
        for (std::size_t k = 1; k < line.size(); ++k) sum += length(to_px(line[k]) - to_px(line[k - 1]));
    }
    return sum;
}

TEST(LineInside, ALineIsCutAtTheBorder) {
    const Polygons square = polygon_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const Polygons parts = inside({{-5, 5}, {5, 5}, {5, 20}, {8, 20}, {8, 2}}, square);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(std::vector<Point>(parts[0].outer().begin(), parts[0].outer().end()), line_of({{0, 5}, {5, 5}, {5, 10}}));
    EXPECT_EQ(std::vector<Point>(parts[1].outer().begin(), parts[1].outer().end()), line_of({{8, 10}, {8, 2}}));
    EXPECT_TRUE(inside({{-5, 0.5}, {-1, 3}}, square).empty());
}

TEST(LineInside, AWayThroughCornersAndAlongBorders) {
    const Polygons notch = polygon_of({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}});
    // Touches the inner corner from outside.
    EXPECT_TRUE(inside({{0, 12}, {5, 6}, {10, 12}}, notch).empty());
    const Polygons through = inside({{-1, 5}, {11, 5}}, notch);
    EXPECT_DOUBLE_EQ(length_of(through), 10);
    // On along the border and then in.
    const Polygons along = inside({{-5, 0}, {5, 0}, {5, 2}}, notch);
    EXPECT_GE(length_of(along), 2);
}

TEST(LineInside, PartsInsideAndOutsideMakeTheWhole) {
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        CaseRandom random(seed);
        std::vector<Vec> star;  // star-shaped, so it does not cross itself
        const int corners = random.whole(3, 9);
        for (int i = 0; i < corners; ++i) {
            const double turn = 6.283185307179586 * i / corners, radius = random.between(5, 50);
            star.push_back({radius * std::cos(turn), radius * std::sin(turn)});
        }
        const Polygons border = polygon_of(star);
        // The same with a frame around it: inside there is outside here.
        Polygons frame = polygon_of({{-99, -99}, {99, -99}, {99, 99}, {-99, 99}});
        frame.polygon_ends.clear();
        frame.add_ring(border[0].outer());
        frame.end_polygon();
        std::vector<Vec> line;
        double whole = 0;
        const int points = random.whole(2, 8);
        for (int i = 0; i < points; ++i) {
            line.push_back({random.between(-60, 60), random.between(-60, 60)});
            if (i > 0) whole += length(line.back() - line[line.size() - 2]);
        }
        const Polygons in = inside(line, border), out = inside(line, frame);
        EXPECT_NEAR(length_of(in) + length_of(out), whole, 1e-5) << "seed " << seed;
        for (std::size_t i = 0; i < in.size(); ++i) {
            const RingView part = in[i].outer();
            for (std::size_t k = 1; k < part.size(); ++k) {
                const Vec middle = 0.5 * (to_px(part[k - 1]) + to_px(part[k]));
                if (length(to_px(part[k]) - to_px(part[k - 1])) < 1e-4) continue;
                EXPECT_GE(locate(border[0], snap(middle)), 0) << "seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace filigree
