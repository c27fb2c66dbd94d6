#include "engines/rewriting/lookup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"

namespace filigree::rewriting {
namespace {

Map table_of(std::uint32_t width, std::uint32_t height) {
    Map map;
    NumberTable table{width, height, {}};
    for (std::uint32_t i = 0; i < width * height; ++i) table.numbers.push_back(i);
    map.cells = std::move(table);
    map.width = width;
    map.height = height;
    return map;
}

std::string cell(const Map& map, Vec place) {
    const std::optional<MapCell> found = cell_at(map, place);
    return found ? std::to_string(found->column) + " " + std::to_string(found->row) : "none";
}

TEST(Lookup, TheFirstRowIsTheTop) {
    Map map = table_of(4, 3);
    map.x = 100;
    map.y = -10;
    map.width = 40;
    map.height = 30;
    EXPECT_EQ(cell(map, {100, -10}), "0 2");
    EXPECT_EQ(cell(map, {139, 19}), "3 0");
    EXPECT_EQ(cell(map, {100, 19}), "0 0");
    EXPECT_EQ(cell(map, {125, 5}), "2 1");
    EXPECT_EQ(value_at(map, {125, 5}), MapValue(6.0));
}

TEST(Lookup, EveryCellHoldsItsLeftAndLowerBorder) {
    Map map = table_of(3, 2);
    EXPECT_EQ(cell(map, {1, 0.5}), "1 1");
    EXPECT_EQ(cell(map, {0.999, 0.5}), "0 1");
    EXPECT_EQ(cell(map, {0.5, 1}), "0 0");
    EXPECT_EQ(cell(map, {0.5, 0.999}), "0 1");
    map.outside = Outside::none;
    EXPECT_EQ(cell(map, {0, 0}), "0 1");
    EXPECT_EQ(cell(map, {3, 0}), "none") << "the right border is the next map's";
    EXPECT_EQ(cell(map, {0, 2}), "none");
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const auto count = static_cast<std::uint32_t>(random.whole(1, 300));
        Map some = table_of(count, count);
        some.outside = Outside::none;
        some.x = random.between(-1000, 1000);
        some.y = random.between(-1000, 1000);
        some.width = random.between(0.5, 3000);
        some.height = random.between(0.5, 3000);
        const auto k = static_cast<double>(random.below(count));
        // By rounded steps to the border, and to the middle of the cell behind it.
        const Vec step{some.width / count, some.height / count};
        Vec place{some.x, some.y};
        for (double i = 0; i < k; ++i) place = place + step;
        const std::string wanted =
            std::to_string(static_cast<int>(k)) + " " + std::to_string(count - 1 - static_cast<std::uint32_t>(k));
        ASSERT_EQ(cell(some, place), wanted) << seed;
        ASSERT_EQ(cell(some, place + 0.5 * step), wanted) << seed;
    }
}

TEST(Lookup, BesideTheMap) {
    Map map = table_of(3, 2);
    const std::vector<Vec> places = {{-0.5, 0.5}, {3.5, 1.5}, {-7, 9}, {1.5, -0.5}, {1e18, 0.5}, {-1e18, 0.5}};
    const auto cells = [&](Outside outside) {
        map.outside = outside;
        std::vector<std::string> found;
        for (const Vec place : places) found.push_back(cell(map, place));
        return found;
    };
    using Cells = std::vector<std::string>;
    EXPECT_EQ(cells(Outside::clamp), (Cells{"0 1", "2 0", "0 0", "1 1", "2 1", "0 1"}));
    EXPECT_EQ(cells(Outside::none), Cells(6, "none"));
    const Cells wrapped = cells(Outside::wrap);
    EXPECT_EQ(Cells(wrapped.begin(), wrapped.begin() + 4), (Cells{"2 1", "0 0", "2 0", "1 0"}));
    EXPECT_EQ(cell(map, {-1e-9, 0.5}), "0 1") << "on the border, but for rounding";
    for (const Outside outside : {Outside::clamp, Outside::wrap, Outside::none}) {
        map.outside = outside;
        EXPECT_EQ(cell(map, {NAN, 0.5}), "none");
        EXPECT_EQ(cell(map, {0.5, INFINITY}), "none");
    }
    EXPECT_EQ(cell(Map{}, {0, 0}), "none") << "a map that could not be read";
    EXPECT_FALSE(value_at(Map{}, {0, 0}));
}

TEST(Lookup, ChannelsAndTheirNames) {
    const auto channels = [](const MapValue& value) {
        std::vector<double> all;
        for (const Channel channel : {Channel::red, Channel::green, Channel::blue, Channel::alpha, Channel::luma}) {
            all.push_back(channel_of(value, channel));
        }
        return all;
    };
    using Values = std::vector<double>;
    EXPECT_EQ(channels(Colour{1, 2, 3, 4}), (Values{1, 2, 3, 4, 2}));
    EXPECT_EQ(channels(Colour{255, 0, 0}), (Values{255, 0, 0, 255, 54}));
    EXPECT_EQ(channels(Colour{0, 255, 0, 0}), (Values{0, 255, 0, 0, 182}));
    EXPECT_EQ(channels(Colour{0, 0, 255}), (Values{0, 0, 255, 255, 18}));
    EXPECT_EQ(channel_of(Colour{5, 2, 14}, Channel::luma), 4) << "3.5042";
    EXPECT_EQ(channel_of(Colour{0, 2, 14}, Channel::luma), 2) << "2.4412";
    for (int level = 0; level < 256; ++level) {
        const auto byte = static_cast<std::uint8_t>(level);
        ASSERT_EQ(channel_of(Colour{byte, byte, byte}, Channel::luma), level);
    }
    EXPECT_EQ(channels(-2.5), Values(5, -2.5));

    Scope scope;
    set_names(Colour{9, 9, 9, 9}, scope);
    set_names(7.5, scope);
    set_names(Colour{1, 2, 3, 4}, scope);
    ASSERT_EQ(scope.names.size(), 6U);
    EXPECT_EQ(scope.names.at("G"), (Value{Quantity{2}, {}}));
    EXPECT_EQ(scope.names.at("A"), (Value{Quantity{4}, {}}));
    EXPECT_EQ(scope.names.at("value"), (Value{Quantity{7.5}, {}}));
}

TEST(Lookup, NumbersInRows) {
    const auto numbers = [](std::string_view text) -> std::string {
        const Result<NumberTable> table = read_numbers_csv(text);
        if (!table) return table.diagnostics()[0].code + ": " + table.diagnostics()[0].message;
        std::string all = std::to_string(table->width) + "x" + std::to_string(table->height);
        for (const double number : table->numbers) all += " " + std::to_string(number).substr(0, 5);
        return all;
    };
    EXPECT_EQ(numbers("1,2\n3,4\n"), "2x2 1.000 2.000 3.000 4.000");
    EXPECT_EQ(numbers("\xEF\xBB\xBF 1 , -2.5\r\n1e2,\t4"), "2x2 1.000 -2.50 100.0 4.000");
    EXPECT_EQ(numbers("7"), "1x1 7.000");
    EXPECT_EQ(numbers("").substr(0, 10), "csv.empty:");
    EXPECT_EQ(numbers("1,2\n3").substr(0, 11), "csv.ragged:");
    EXPECT_EQ(numbers("1,nan"), "rewriting.no-number: line 1 has no number in column 2");
    EXPECT_EQ(numbers("1\ninf"), "rewriting.no-number: line 2 has no number in column 1");
    EXPECT_EQ(numbers("1,2\n1,"), "rewriting.no-number: line 2 has no number in column 2");
    EXPECT_EQ(numbers("a,b\n1,2"), "rewriting.no-number: line 1 has no number in column 1");
    EXPECT_EQ(numbers("1 2\n"), "rewriting.no-number: line 1 has no number in column 1");
}

// Tables that are written are read again, and damaged ones are survived.
TEST(Lookup, TablesAreReadAsTheyAreWritten) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        NumberTable table{
            static_cast<std::uint32_t>(random.whole(1, 5)), static_cast<std::uint32_t>(random.whole(1, 5)), {}};
        std::string text;
        for (std::uint32_t i = 0; i < table.width * table.height; ++i) {
            table.numbers.push_back(random.whole(-1000, 1000));
            text += std::to_string(static_cast<int>(table.numbers.back())) + ".0";
            text += (i + 1) % table.width != 0 ? ',' : '\n';
        }
        const Result<NumberTable> read = read_numbers_csv(text);
        ASSERT_TRUE(read) << text;
        ASSERT_EQ(read->width, table.width);
        ASSERT_EQ(read->height, table.height);
        ASSERT_EQ(read->numbers, table.numbers);
        text[random.index(text.size())] = ",\n x\xFF\0"[random.index(6)];
        if (const Result<NumberTable> damaged = read_numbers_csv(text)) {
            ASSERT_EQ(damaged->numbers.size(), std::size_t{damaged->width} * damaged->height);
        }
    }
}

}  // namespace
}  // namespace filigree::rewriting
