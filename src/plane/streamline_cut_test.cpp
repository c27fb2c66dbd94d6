#include "plane/streamline_cut.h"

#include <gtest/gtest.h>

#include <set>

#include "plane/edge_tree.h"
#include "plane/streamline_test_shapes.h"
#include "plane/verify.h"

namespace filigree {
namespace {

using namespace test_shapes;

StreamlineCutOptions options_of(StreamlineKind kind, double offset) {
    StreamlineCutOptions options;
    options.kind = kind;
    options.offsets = {offset};
    return options;
}

std::set<std::int32_t> columns_of(const StreamlineCut& cut) {
    std::set<std::int32_t> columns;
    for (const StreamlineCut::Place& place : cut.places) columns.insert(place.column);
    return columns;
}

TEST(StreamlineCut, PartitionsRandomRegions) {
    std::uint64_t pieces = 0;
    for (std::uint64_t seed = 0; seed < case_count(400); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const double radius = random.between(10, 90);
        const Polygons shape = random_region(random, radius);
        StreamlineCutOptions options;
        options.kind = static_cast<StreamlineKind>(random.below(3));
        options.by_field = random.coin();
        options.dual = random.below(3) == 0;
        options.offsets = {radius * random.between(0.05, 0.6)};
        if (random.coin()) options.offsets.push_back(options.offsets[0] * random.between(0.3, 2));
        options.centre = {random.between(-2, 2) * radius, random.between(-2, 2) * radius};
        options.smoothing = random.below(4) == 0 ? 0 : random.between(0, 6);
        const StreamlineCut cut = cut_by_streamlines(shape[0], options);
        ASSERT_FALSE(cut.is_too_fine);
        ASSERT_EQ(cut.places.size(), cut.pieces.size());
        ASSERT_GE(cut.pieces.size(), 1U);
        pieces += cut.pieces.size();
        EXPECT_NEAR(area(cut.pieces), area(shape[0]), 1e-9 * std::max(1600.0, area(shape[0])));
        std::set<std::uint64_t> keys;
        for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
            EXPECT_EQ(find_flaw(cut.pieces[i]), std::nullopt);
            keys.insert(cut.places[i].key);
        }
        EXPECT_EQ(keys.size(), cut.pieces.size());
        EXPECT_EQ(find_overlap(cut.pieces), std::nullopt);
    }
    EXPECT_GT(pieces, 5 * case_count(400));
}

TEST(StreamlineCut, DependsOnTheGeometryAlone) {
    for (std::uint64_t seed = 0; seed < case_count(60); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons shape = random_region(random, 60);
        StreamlineCutOptions options = options_of(static_cast<StreamlineKind>(seed % 3), 9);
        options.by_field = random.coin();
        options.dual = random.coin();
        Polygons turned;
        std::vector<std::size_t> order;
        for (std::size_t r = shape[0].ring_count(); r-- > 1;) order.push_back(r);
        order.insert(order.begin(), 0);
        for (const std::size_t r : order) {
            std::vector<Point> ring(shape[0].ring(r).begin(), shape[0].ring(r).end());
            std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.index(ring.size())),
                        ring.end());
            turned.add_ring(ring);
        }
        turned.end_polygon();
        const StreamlineCut one = cut_by_streamlines(shape[0], options), other = cut_by_streamlines(turned[0], options);
        EXPECT_EQ(one.pieces, other.pieces);
        ASSERT_EQ(one.places.size(), other.places.size());
        for (std::size_t i = 0; i < one.places.size(); ++i) EXPECT_EQ(one.places[i].key, other.places[i].key);
    }
}

TEST(StreamlineCut, OutlinesOfASquareAreConcentric) {
    const Polygons square = rectangle(100, 100);
    const StreamlineCut cut = cut_by_streamlines(square[0], options_of(StreamlineKind::smooth, 10));
    ASSERT_EQ(cut.pieces.size(), 5U);
    EXPECT_EQ(columns_of(cut), (std::set<std::int32_t>{0, 1, 2, 3, 4}));
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(cut.pieces[i].ring_count(), cut.places[i].column < 4 ? 2U : 1U);
        const Box box = bounds(cut.pieces[i]);
        const double margin = 10.0 * cut.places[i].column;
        EXPECT_NEAR(to_px(box.min).x, margin, 0.2 * margin);
        EXPECT_NEAR(to_px(box.max).y, 100 - margin, 0.2 * margin);
        // Rounder and rounder: what a ring leaves of its box.
        if (cut.places[i].column == 4) {
            const double width = to_px(box.max).x - to_px(box.min).x;
            EXPECT_LT(area(cut.pieces[i]), 0.83 * width * width);  // a disc has 0.785
        }
    }
}

TEST(StreamlineCut, OutlinesKeepTheirOffsetFromTheBorderAndLeaveNoSlivers) {
    for (std::uint64_t seed = 0; seed < case_count(150); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons shape = wobbly_shape(random, 80, 150, 3);
        const double offset = random.between(5, 20);
        const StreamlineCut cut = cut_by_streamlines(shape[0], options_of(StreamlineKind::smooth, offset));
        const EdgeTree border(edges_of(shape[0], {}));
        for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
            EXPECT_GT(area(cut.pieces[i]), 0.3 * offset * offset);
            if (cut.places[i].column == 0) continue;
            for (const Point& p : cut.pieces[i].outer()) {
                EXPECT_GT(border.place(to_px(p), 1000, 1000).distance, 0.6 * offset);
            }
        }
    }
}

TEST(StreamlineCut, StripsOfARectangleAreStraightAndCounted) {
    const Polygons bar = rectangle(200, 40);
    const StreamlineCut cut = cut_by_streamlines(bar[0], options_of(StreamlineKind::strip, 10));
    ASSERT_EQ(cut.pieces.size(), 20U);
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        const Box box = bounds(cut.pieces[i]);
        EXPECT_NEAR(to_px(box.max).x - to_px(box.min).x, 10, 0.5);
        EXPECT_EQ(cut.places[i].column, static_cast<int>(i) - 10);
    }
}

TEST(StreamlineCut, CirclesAreExactWhereverTheirCentreLies) {
    const Polygons shape = one_polygon({regular_ring({0, 0}, 50, 90), regular_ring({10, 0}, 15, 30)});
    for (const Vec centre : {Vec{0, 0}, Vec{10, 0}, Vec{70, 20}, Vec{-4000, 900}}) {
        StreamlineCutOptions options = options_of(StreamlineKind::circular, 8);
        options.centre = centre;
        options.tolerance = 0.01;
        const StreamlineCut cut = cut_by_streamlines(shape[0], options);
        ASSERT_GE(cut.pieces.size(), 5U);
        for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
            for (const Point& p : cut.pieces[i].outer()) {
                const double at = length(to_px(p) - centre), low = 8.0 * cut.places[i].column;
                EXPECT_GT(at, low - 2.01);  // slivers of a quarter join the last strip
                EXPECT_LT(at, low + 10.01);
            }
        }
    }
}

TEST(StreamlineCut, OffsetsAreUsedInTurn) {
    const Polygons disc = one_polygon({regular_ring({0, 0}, 50, 360)});
    StreamlineCutOptions options = options_of(StreamlineKind::circular, 4);
    options.offsets = {4, 12};
    const StreamlineCut cut = cut_by_streamlines(disc[0], options);
    ASSERT_EQ(cut.pieces.size(), 7U);  // 4, 16, 20, 32, 36, 48
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        const int k = cut.places[i].column;
        const auto radius = [](int n) { return std::min(50.0, 16.0 * (n / 2) + 4.0 * (n % 2)); };
        const double ring = elementary::pi * (radius(k + 1) * radius(k + 1) - radius(k) * radius(k));
        EXPECT_NEAR(area(cut.pieces[i]), ring, 0.01 * ring + 1) << k;
    }
}

TEST(StreamlineCut, ADualCutMakesALattice) {
    const Polygons bar = rectangle(200, 60);
    StreamlineCutOptions options = options_of(StreamlineKind::strip, 10);
    options.dual = true;
    const StreamlineCut cut = cut_by_streamlines(bar[0], options);
    EXPECT_GT(cut.pieces.size(), 90U);
    std::set<std::pair<int, int>> seen;
    for (const StreamlineCut::Place& place : cut.places) seen.insert({place.column, place.row});
    EXPECT_EQ(seen.size(), cut.pieces.size());
}

TEST(StreamlineCut, FarStripsKeepTheirKeysWhenTheShapeGrowsElsewhere) {
    const StreamlineCut small = cut_by_streamlines(rectangle(100, 100)[0], options_of(StreamlineKind::smooth, 10));
    const StreamlineCut large = cut_by_streamlines(rectangle(160, 160)[0], options_of(StreamlineKind::smooth, 10));
    std::set<std::uint64_t> keys;
    for (const StreamlineCut::Place& place : large.places) keys.insert(place.key);
    for (const StreamlineCut::Place& place : small.places) EXPECT_EQ(keys.count(place.key), 1U);
}

TEST(StreamlineCut, RefusesMorePiecesThanTheLimit) {
    const Polygons square = rectangle(1000, 1000);
    for (const StreamlineKind kind : {StreamlineKind::smooth, StreamlineKind::strip, StreamlineKind::circular}) {
        for (const bool by_field : {false, true}) {
            StreamlineCutOptions options = options_of(kind, 0.01);
            options.centre = {500, 500};
            options.by_field = by_field;
            options.limit = 1000;
            const StreamlineCut cut = cut_by_streamlines(square[0], options);
            EXPECT_TRUE(cut.is_too_fine);
            EXPECT_TRUE(cut.pieces.empty());
        }
    }
}

TEST(StreamlineCut, WhatIsTooSmallStaysWhole) {
    const Polygons square = rectangle(10, 10);
    for (const StreamlineKind kind : {StreamlineKind::smooth, StreamlineKind::circular}) {
        StreamlineCutOptions options = options_of(kind, 30);
        options.centre = {5, 5};
        const StreamlineCut cut = cut_by_streamlines(square[0], options);
        ASSERT_EQ(cut.pieces.size(), 1U);
        EXPECT_EQ(cut.places[0].column, 0);
    }
}

}  // namespace
}  // namespace filigree
