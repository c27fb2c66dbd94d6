#include "curves/faces.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree::curves {
namespace {

Shape lines(std::vector<std::pair<Vec, Vec>> ends) {
    Shape shape;
    for (const auto& [a, b] : ends) shape.elements.push_back(line_element(a, b));
    return shape;
}

TEST(ConvexFaces, OfASquareWithADiagonalAreTwoTriangles) {
    const Shape square = lines({{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}});
    const std::vector<Face> whole = convex_faces(square, 1e-6);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].corners, (std::vector<Vec>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
    Shape cut = square;
    cut.elements.push_back(line_element({0, 0}, {4, 4}));
    const std::vector<Face> halves = convex_faces(cut, 1e-6);
    ASSERT_EQ(halves.size(), 2U);
    for (const Face& half : halves) {
        EXPECT_EQ(half.corners.size(), 3U);
        EXPECT_NEAR(area_of(half.corners), 8, 1e-12);
    }
}

TEST(ConvexFaces, PassOverLinesThatOnlyTouch) {
    // A line from side to side: two quadrilaterals whose long sides are straight where the line ends.
    const Shape cut = lines({{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}, {{1, 0}, {3, 4}}});
    const std::vector<Face> faces = convex_faces(cut, 1e-6);
    ASSERT_EQ(faces.size(), 2U);
    EXPECT_EQ(faces[0].corners.size(), 4U);
    EXPECT_EQ(faces[1].corners.size(), 4U);
}

TEST(ConvexFaces, AreVoid) {
    Shape square = lines({{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}});
    Shape with_stub = square;
    with_stub.elements.push_back(line_element({1, 1}, {2, 2}));
    EXPECT_TRUE(convex_faces(with_stub, 1e-6).empty());
    square.elements.push_back(circle_element({2, 2}, 0.5));
    EXPECT_TRUE(convex_faces(square, 1e-6).empty());
}

TEST(ConvexFaces, ShareTheAreaOfAPolygonThatChordsCut) {
    for (std::uint64_t n = 0; n < case_count(1000); ++n) {
        CaseRandom random(first_seed() + n);
        Shape shape = lines({{{0, 0}, {100, 0}}, {{100, 0}, {100, 80}}, {{100, 80}, {0, 80}}, {{0, 80}, {0, 0}}});
        const int chords = static_cast<int>(random.whole(1, 8));
        for (int i = 0; i < chords; ++i) {
            shape.elements.push_back(line_element({random.between(1, 99), 0}, {random.between(1, 99), 80}));
        }
        double sum = 0;
        const std::vector<Face> faces = convex_faces(shape, 1e-7);
        for (const Face& face : faces) sum += area_of(face.corners);
        EXPECT_NEAR(sum, 8000, 1e-6) << n;
        EXPECT_GE(faces.size(), static_cast<std::size_t>(chords) + 1) << n;
    }
}

TEST(Stretched, KeepsCornersAndDividesSidesEvenly) {
    const std::vector<Vec> from = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, to = {{0, 0}, {5, 1}, {4, 6}, {-1, 3}};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(stretched(from[i], from, to), to[i]);
    EXPECT_NEAR(stretched({0.25, 0}, from, to).x, 1.25, 1e-12);
    const Vec inside = stretched({0.5, 0.5}, from, to);
    EXPECT_NEAR(inside.x, 2, 1e-9);  // of a square, the mean of the corners
    EXPECT_NEAR(inside.y, 2.5, 1e-9);
}

TEST(Stretched, IsExactForAffineMaps) {
    const std::vector<Vec> from = {{0, 0}, {2, 0}, {3, 1}, {1, 3}, {-1, 1}};
    std::vector<Vec> to;
    const Transform by{2, 1, -0.5, 1.5, 7, -3};
    for (const Vec p : from) to.push_back(apply(by, p));
    const Vec p{0.7, 0.9}, expected = apply(by, p), found = stretched(p, from, to);
    EXPECT_NEAR(found.x, expected.x, 1e-9);
    EXPECT_NEAR(found.y, expected.y, 1e-9);
}

}  // namespace
}  // namespace filigree::curves
