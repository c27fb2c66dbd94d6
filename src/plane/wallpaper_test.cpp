#include "plane/wallpaper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace filigree {
namespace {

struct Expected {
    std::string_view name;
    std::size_t operations;   // in a tile
    std::size_t point_group;  // different linear parts
};
constexpr Expected expected[] = {{"p1", 1, 1},  {"p2", 2, 2},   {"pm", 2, 2},  {"pg", 2, 2},    {"cm", 4, 2},
                                 {"pmm", 4, 4}, {"pmg", 4, 4},  {"pgg", 4, 4}, {"cmm", 8, 4},   {"p4", 4, 4},
                                 {"p4m", 8, 8}, {"p4g", 8, 8},  {"p3", 6, 3},  {"p3m1", 12, 6}, {"p31m", 12, 6},
                                 {"p6", 12, 6}, {"p6m", 24, 12}};

const std::vector<std::string_view> turned_names{"p11m", "p11g", "c11m", "pgm"};

SymmetryGroup group_named(std::string_view name) {
    Result<SymmetryGroup> group = find_symmetry(name);
    EXPECT_TRUE(group) << name;
    return group ? *group : SymmetryGroup{};
}

std::vector<SymmetryGroup> all_groups() {
    std::vector<SymmetryGroup> groups;
    for (const std::string_view name : wallpaper_names()) groups.push_back(group_named(name));
    for (const std::string_view name : turned_names) groups.push_back(group_named(name));
    return groups;
}

TileOperation within_tile(TileOperation op) {
    op.dx = (op.dx % 12 + 12) % 12;
    op.dy = (op.dy % 12 + 12) % 12;
    return op;
}

TEST(Wallpaper, GroupsHaveTheirOrders) {
    ASSERT_EQ(wallpaper_names().size(), std::size(expected));
    for (const Expected& row : expected) {
        const SymmetryGroup group = group_named(row.name);
        EXPECT_EQ(group.name, row.name);
        EXPECT_EQ(group.operations.size(), row.operations) << row.name;
        std::set<std::tuple<int, int, int, int>> linear;
        for (const TileOperation& op : group.operations) linear.emplace(op.xx, op.xy, op.yx, op.yy);
        EXPECT_EQ(linear.size(), row.point_group) << row.name;
    }
}

// In whole numbers, modulo the translations: those of the tile, and those among the operations.
TEST(Wallpaper, OperationsAreClosed) {
    for (const SymmetryGroup& group : all_groups()) {
        const std::vector<TileOperation>& ops = group.operations;
        ASSERT_FALSE(ops.empty());
        EXPECT_EQ(ops[0], TileOperation{});
        const auto count_of = [&](const TileOperation& op) { return std::count(ops.begin(), ops.end(), op); };
        for (const TileOperation& a : ops) {
            EXPECT_EQ(count_of(a), 1) << group.name;
            EXPECT_EQ(a, within_tile(a)) << group.name;
            bool has_inverse = false;
            for (const TileOperation& b : ops) {
                const TileOperation both = within_tile(compose(a, b));
                EXPECT_EQ(count_of(both), 1) << group.name;
                has_inverse = has_inverse || (both.xx == 2 && both.yy == 2);
            }
            EXPECT_TRUE(has_inverse) << group.name;
            // Whole tiles stay in the lattice: they go to whole tiles, or to translations that are operations.
            for (const TileOperation& step : {TileOperation{2, 0, 0, 2, 12, 0}, TileOperation{2, 0, 0, 2, 0, 12}}) {
                const TileOperation moved = within_tile(compose(a, step));
                EXPECT_EQ(count_of(moved), 1) << group.name;
            }
        }
    }
}

// Lengths are kept: with the squares of a tile's sides for a metric, which are whole.
TEST(Wallpaper, OperationsAreIsometriesOfTheirTiles) {
    for (const SymmetryGroup& group : all_groups()) {
        const int square = group.lattice == Lattice::hexagonal ? 3 : 1;
        for (const TileOperation& op : group.operations) {
            EXPECT_EQ(op.xx * op.xx + square * op.yx * op.yx, 4) << group.name;
            EXPECT_EQ(op.xy * op.xy + square * op.yy * op.yy, 4 * square) << group.name;
            EXPECT_EQ(op.xx * op.xy + square * op.yx * op.yy, 0) << group.name;
            if (group.lattice == Lattice::rectangular) {
                EXPECT_EQ(op.xy, 0) << group.name;
            }
        }
    }
}

TEST(Wallpaper, DomainsHaveTheAreaOfOneCopy) {
    for (const SymmetryGroup& group : all_groups()) {
        int doubled = 0;
        for (std::size_t i = 0; i < group.domain.size(); ++i) {
            const TilePoint a = group.domain[i], b = group.domain[(i + 1) % group.domain.size()];
            doubled += a.x * b.y - a.y * b.x;
        }
        EXPECT_EQ(doubled * static_cast<int>(group.operations.size()), 2 * 144) << group.name;
    }
}

TEST(Wallpaper, OtherNamesMeanTheSame) {
    const std::pair<std::string_view, std::string_view> names[] = {
        {"p211", "p2"},  {"p1m1", "pm"},  {"p1g1", "pg"},  {"c1m1", "cm"},  {"p2mm", "pmm"}, {"pmm2", "pmm"},
        {"p2mg", "pmg"}, {"pmg2", "pmg"}, {"p2gm", "pgm"}, {"pgm2", "pgm"}, {"p2gg", "pgg"}, {"pgg2", "pgg"},
        {"c2mm", "cmm"}, {"cmm2", "cmm"}, {"p4mm", "p4m"}, {"p4gm", "p4g"}, {"p6mm", "p6m"}};
    for (const auto& [other, name] : names) {
        EXPECT_EQ(group_named(other).name, name);
        EXPECT_EQ(group_named(other).operations, group_named(name).operations);
    }
    EXPECT_NE(group_named("p11m").operations, group_named("pm").operations);
}

TEST(Wallpaper, Rosettes) {
    for (const std::string_view name : {"c1", "c2", "c12", "d1", "d7", "d1000"}) {
        const SymmetryGroup group = group_named(name);
        EXPECT_EQ(group.name, name);
        EXPECT_TRUE(is_rosette(group));
        EXPECT_EQ(group.has_mirrors, name[0] == 'd');
        EXPECT_EQ(std::to_string(group.turns), name.substr(1));
        EXPECT_TRUE(group.operations.empty());
    }
    for (const std::string_view name :
         {"c0", "d0", "d01", "c", "d", "c-1", "c1.5", "e4", "c1001", "d99999999999999999999"}) {
        EXPECT_FALSE(find_symmetry(name)) << name;
    }
}

TEST(Wallpaper, UnknownGroupsHintAtTheNearest) {
    const SourceSpan span{0, 4, 9};
    for (const std::string_view name : {"", "p5", "q4m", "p4mmm", "P4M", "rosette"}) {
        const Result<SymmetryGroup> group = find_symmetry(name, span);
        ASSERT_FALSE(group) << name;
        ASSERT_EQ(group.diagnostics().size(), 1U);
        EXPECT_EQ(group.diagnostics()[0].code, "symmetry.unknown-group");
        EXPECT_EQ(group.diagnostics()[0].span, span);
        EXPECT_NE(group.diagnostics()[0].hints.back().find("p31m"), std::string::npos);
    }
    EXPECT_EQ(find_symmetry("p4mmm").diagnostics()[0].hints.front(), "did you mean 'p4mm'?");
    EXPECT_EQ(find_symmetry("c1001").diagnostics()[0].code, "symmetry.too-many-turns");
}

TEST(Wallpaper, TilesTakeTheShapeOfTheirGroup) {
    const auto check = [](std::string_view name, Vec px, Vec wanted, std::size_t warnings) {
        const Result<Point> tile = fit_tile(group_named(name), px);
        ASSERT_TRUE(tile) << name;
        EXPECT_EQ(tile.diagnostics().size(), warnings) << name;
        EXPECT_NEAR(to_px(*tile).x, wanted.x, 1e-6) << name;
        EXPECT_NEAR(to_px(*tile).y, wanted.y, 1e-6) << name;
    };
    for (const std::string_view name : {"p1", "pgg", "cmm", "pm", "p11m"}) check(name, {100, 70.5}, {100, 70.5}, 0);
    check("p4m", {100, 100}, {100, 100}, 0);
    check("p4m", {100, 70}, {100, 100}, 1);
    check("p4", {1000, 1001}, {1000, 1001}, 0);
    check("p6m", {100, 100 * std::sqrt(3.0)}, {100, 173.2050807}, 0);
    check("p6m", {100, 100}, {100, 173.2050808}, 1);
    check("p3", {56, 97}, {56, 97}, 0);
    // Whole px are exact but where a third is needed, and a rectangle's halves meet on the grid.
    EXPECT_EQ(fit_tile(group_named("p4m"), {100, 100})->x, std::int64_t{100} << 26);
    const double width = 377.9527559055118;
    EXPECT_EQ(fit_tile(group_named("p1"), {width, width})->x, 2 * snap({width / 2, 0}).x);
    for (const Vec px : {Vec{0, 10}, Vec{10, -1}, Vec{std::nan(""), 1}, Vec{1e9, 1e9}}) {
        EXPECT_FALSE(fit_tile(group_named("p1"), px));
    }
}

TEST(Wallpaper, TheTileAroundABoxHoldsIt) {
    const Box box{snap({-10, 3}), snap({25, 40})};
    EXPECT_EQ(tile_around(group_named("p2"), box), snap({50, 80}));
    EXPECT_EQ(tile_around(group_named("p4g"), box), snap({80, 80}));
    const Vec hexagonal = to_px(tile_around(group_named("p6"), box));
    EXPECT_NEAR(hexagonal.x, 50, 1e-6);
    EXPECT_NEAR(hexagonal.y, 50 * std::sqrt(3.0), 1e-6);
    EXPECT_EQ(tile_around(group_named("p1"), {}), snap({1, 1}));
}

}  // namespace
}  // namespace filigree
