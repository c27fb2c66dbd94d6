// What the picture says of an order of painting: which pieces become whole again, which strokes are painted again.
#include <gtest/gtest.h>

#include <vector>

#include "space/rejoin.h"
#include "space/stroke_again.h"

namespace filigree {
namespace {

struct Picture {
    Pieces pieces;
    std::vector<Vec> places;
    std::vector<double> widths, strokes;

    std::uint32_t add_rectangle(Vec min, Vec max, double stroke, std::uint32_t parent = no_piece) {
        const auto first = static_cast<std::uint32_t>(places.size());
        for (const Vec p : {min, Vec{max.x, min.y}, max, Vec{min.x, max.y}}) {
            places.push_back(p);
            pieces.corners.push_back({{p.x, p.y, 0}, 0});
            strokes.push_back(stroke);
        }
        pieces.pieces.push_back({first, 4, 0, 0, parent, false});
        widths.push_back(0);
        return static_cast<std::uint32_t>(pieces.pieces.size() - 1);
    }
    std::vector<std::uint32_t> rejoined(const std::vector<std::uint32_t>& order) const {
        return filigree::rejoined(pieces, order, picture_hulls(pieces, places, widths, CutEnds::shorter));
    }
    std::vector<StrokeAgain> strokes_again(const std::vector<std::uint32_t>& order) const {
        return filigree::strokes_again(pieces, order, places, picture_hulls(pieces, places, widths, CutEnds::whole),
                                       strokes);
    }
};

using Order = std::vector<std::uint32_t>;

TEST(Rejoin, PiecesGoWhereNothingComesBetween) {
    Picture picture;
    const std::uint32_t whole = picture.add_rectangle({0, 0}, {20, 10}, 0);
    const std::uint32_t left = picture.add_rectangle({0, 0}, {10, 10}, 0, whole);
    const std::uint32_t right = picture.add_rectangle({10, 0}, {20, 10}, 0, whole);
    const std::uint32_t on_left = picture.add_rectangle({4, 4}, {10, 6}, 0);
    const std::uint32_t on_right = picture.add_rectangle({11, 4}, {15, 6}, 0);
    EXPECT_EQ(picture.rejoined({left, right}), (Order{whole}));
    EXPECT_EQ(picture.rejoined({left, on_left, right}), (Order{whole, on_left})) << "the later goes down";
    EXPECT_EQ(picture.rejoined({left, on_right, right}), (Order{on_right, whole})) << "the earlier goes up";
    EXPECT_EQ(picture.rejoined({left, on_left, on_right, right}), (Order{left, on_left, on_right, right}));
    EXPECT_EQ(picture.rejoined({left, on_left}), (Order{left, on_left})) << "a part is not there";
}

TEST(Rejoin, WholesAreRejoinedInTurn) {
    Picture picture;
    const std::uint32_t whole = picture.add_rectangle({0, 0}, {30, 10}, 0);
    const std::uint32_t left = picture.add_rectangle({0, 0}, {20, 10}, 0, whole);
    const std::uint32_t right = picture.add_rectangle({20, 0}, {30, 10}, 0, whole);
    const std::uint32_t first = picture.add_rectangle({0, 0}, {10, 10}, 0, left);
    const std::uint32_t second = picture.add_rectangle({10, 0}, {20, 10}, 0, left);
    EXPECT_EQ(picture.rejoined({second, right, first}), (Order{whole}));
}

TEST(StrokesAgain, WhatLiesBesideAnEdgeCoversHalfItsStroke) {
    Picture picture;
    const std::uint32_t face = picture.add_rectangle({0, 0}, {10, 10}, 1);
    const std::uint32_t beside = picture.add_rectangle({10, -5}, {20, 15}, 0);
    const std::uint32_t over = picture.add_rectangle({5, 4}, {15, 20}, 0);
    const std::uint32_t neighbour = picture.add_rectangle({10, -5}, {20, 15}, 1);

    std::vector<StrokeAgain> again = picture.strokes_again({face, beside});
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].place, 1U);
    EXPECT_EQ(again[0].piece, face);
    EXPECT_EQ(again[0].line, (std::vector<Vec>{{10, 0}, {10, 10}}));

    EXPECT_TRUE(picture.strokes_again({beside, face}).empty());
    EXPECT_TRUE(picture.strokes_again({face, neighbour}).empty()) << "it strokes that edge itself";

    again = picture.strokes_again({face, over, beside});
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].place, 2U);
    EXPECT_EQ(again[0].line, (std::vector<Vec>{{10, 0}, {10, 4}})) << "the rest is hidden";
}

}  // namespace
}  // namespace filigree
