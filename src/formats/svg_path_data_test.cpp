#include "formats/svg_path_data.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/test_cases.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

std::string data_of(const Polygons& polygons, int decimals, Point from = {}) {
    TextBuffer out;
    put_path_data(out, polygons[0], decimals, from);
    return std::move(out).take();
}

// The oracle: reads the few commands that are written, in units of 10^-decimals, and keeps whole numbers whole.
struct Token {
    char command;  // 0 for a number
    std::int64_t value;
};
std::vector<Token> tokens_of(const std::string& data, int decimals) {
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < data.size();) {
        if (data[i] == ' ') {
            ++i;
            continue;
        }
        if (std::isalpha(static_cast<unsigned char>(data[i])) != 0) {
            tokens.push_back({data[i++], 0});
            continue;
        }
        bool is_negative = false;
        if (data[i] == '-') {
            is_negative = true;
            ++i;
        }
        std::int64_t value = 0;
        int places = 0;
        bool after_point = false;
        while (i < data.size() && ((data[i] >= '0' && data[i] <= '9') || (data[i] == '.' && !after_point))) {
            if (data[i] == '.') {
                after_point = true;
            } else {
                value = value * 10 + (data[i] - '0');
                if (after_point) ++places;
            }
            ++i;
        }
        EXPECT_LE(places, decimals);
        for (; places < decimals; ++places) value *= 10;
        tokens.push_back({0, is_negative ? -value : value});
    }
    return tokens;
}

std::vector<std::vector<Point>> rings_of(const std::string& data, int decimals, Point at = {}) {
    std::vector<std::vector<Point>> rings;
    char command = 0;
    Point start;
    const std::vector<Token> tokens = tokens_of(data, decimals);
    for (std::size_t i = 0; i < tokens.size();) {
        if (tokens[i].command != 0) {
            command = tokens[i++].command;
            if (command == 'z') at = start;
            continue;
        }
        if (command == 'm') {
            at = {at.x + tokens[i].value, at.y + tokens[i + 1].value};
            start = at;
            rings.push_back({at});
            command = 'l';
            i += 2;
            continue;
        }
        if (command == 'h') at.x += tokens[i++].value;
        if (command == 'v') at.y += tokens[i++].value;
        if (command == 'l') {
            at = {at.x + tokens[i].value, at.y + tokens[i + 1].value};
            i += 2;
        }
        rings.back().push_back(at);
    }
    return rings;
}

// Half away from zero, by division in 128 bits.
std::int64_t exactly_rounded(std::int64_t grid, int decimals) {
    Int128 unit = 1;
    for (int i = 0; i < decimals; ++i) unit *= 10;
    const Int128 size = grid < 0 ? -static_cast<Int128>(grid) : static_cast<Int128>(grid);
    const Int128 half_steps = size * unit * 2 / (Int128{1} << 26);  // rounded down
    const Int128 result = (half_steps + 1) / 2;
    return static_cast<std::int64_t>(grid < 0 ? -result : result);
}

TEST(SvgPathData, FewestBytes) {
    EXPECT_EQ(data_of(polygons_of({rectangle_ring(1, 2, 10, 20)}), 3), "m1 2h10v20h-10z");
    EXPECT_EQ(data_of(polygons_of({{at_px(0.5, 0.25), at_px(1.5, -0.25), at_px(1.25, 5)}}), 3),
              "m.5.25 1-.5-.25 5.25z");
    EXPECT_EQ(data_of(polygons_of({{at_px(-3, 0), at_px(5, 0), at_px(7.125, 4)}}), 1), "m-3 0h8l2.1 4z");
    EXPECT_EQ(data_of(polygons_of({rectangle_ring(0, 0, 9, 9), rectangle_ring(3, 3, 3, 3, true)}), 2),
              "m0 0h9v9h-9zm3 3v3h3v-3z");
    EXPECT_EQ(data_of(polygons_of({rectangle_ring(1, 2, 10, 20)}), 0, {1, 5}), "m0-3h10v20h-10z");
}

TEST(SvgPathData, RoundsHalfAwayFromZero) {
    const std::int64_t px = 1 << 26;
    EXPECT_EQ(rounded_coordinate(px / 2, 0), 1);
    EXPECT_EQ(rounded_coordinate(-px / 2, 0), -1);
    EXPECT_EQ(rounded_coordinate(px / 2 - 1, 0), 0);
    EXPECT_EQ(rounded_coordinate(px / 16, 3), 63);  // 0.0625
    EXPECT_EQ(rounded_coordinate(-px / 16, 3), -63);
    EXPECT_EQ(rounded_coordinate(grid_limit, 6), (std::int64_t{1} << 30) * 1'000'000);
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const int decimals = static_cast<int>(to_whole(random_bits(seed, Key{}, "decimals"), 7));
        const int shift = static_cast<int>(to_whole(random_bits(seed, Key{}, "shift"), 60)) + 4;
        const std::int64_t grid = static_cast<std::int64_t>(random_bits(seed, Key{}, "grid")) >> shift;
        ASSERT_EQ(rounded_coordinate(grid, decimals), exactly_rounded(grid, decimals)) << "seed " << seed;
    }
}

TEST(SvgPathData, LeavesOutWhatRoundsAway) {
    // Repeated places, also across the ring's end.
    EXPECT_EQ(data_of(polygons_of({{at_px(0, 0), at_px(0.2, 0.1), at_px(5, 0), at_px(5, 5), at_px(0.1, 0.3)}}), 0),
              "m0 0h5v5z");
    // A hole without area goes, an outer ring stays as a place.
    EXPECT_EQ(data_of(polygons_of({rectangle_ring(0, 0, 9, 9), rectangle_ring(3, 3, 0.1, 2, true)}), 0),
              "m0 0h9v9h-9z");
    EXPECT_EQ(data_of(polygons_of({rectangle_ring(3, 3, 0.1, 0.1)}), 0), "m3 3z");
    EXPECT_EQ(data_of(polygons_of({{}}), 3), "");
}

TEST(SvgPathData, ComesBackAsTheRoundedPoints) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto pick = [&](const char* name, std::uint32_t count, std::uint64_t draw = 0) {
            return to_whole(random_bits(seed, Key{}, name, draw), count);
        };
        const int decimals = static_cast<int>(pick("decimals", 7));
        const int shift = 8 + static_cast<int>(pick("shift", 45));
        Polygons polygons;
        std::vector<std::vector<Point>> expected;
        const std::uint64_t rings = 1 + pick("rings", 3);
        for (std::uint64_t r = 0; r < rings; ++r) {
            std::vector<Point> ring, places;
            const std::uint64_t count = 3 + pick("count", 20, r);
            for (std::uint64_t i = 0; i < count; ++i) {
                const auto coordinate = [&](const char* name) {
                    return static_cast<std::int64_t>(random_bits(seed, Key{r}, name, i)) >> shift;
                };
                Point p{coordinate("x"), coordinate("y")};
                if (i > 0 && pick("straight", 4, i) == 0) p.x = ring.back().x;
                if (i > 0 && pick("level", 4, i) == 0) p.y = ring.back().y;
                ring.push_back(p);
                const Point place{exactly_rounded(p.x, decimals), exactly_rounded(p.y, decimals)};
                if (places.empty() || places.back() != place) places.push_back(place);
            }
            while (places.size() > 1 && places.back() == places.front()) places.pop_back();
            polygons.add_ring(ring);
            if (r == 0 || places.size() >= 3) expected.push_back(places);
        }
        polygons.end_polygon();
        const Point from{static_cast<std::int64_t>(pick("from", 1000)), -7};
        ASSERT_EQ(rings_of(data_of(polygons, decimals, from), decimals, from), expected) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
