// Maps: pictures and tables of numbers over the turtle's wall, and what they have where a symbol stands (Roncoroni and
// Crousse, "Parametric, programmable image or data rules", Fig. 9).
//
// A map's first row is its top, as a picture is seen. Of its cells each holds its left and lower border, so that every
// place belongs to one; a place that is rounded off a border by less than a millionth of a cell counts as on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "language/evaluate.h"
#include "plane/colour_image.h"
#include "plane/point.h"

namespace filigree::rewriting {

struct NumberTable {
    std::uint32_t width = 0, height = 0;
    std::vector<double> numbers;  // finite; width * height of them, rows from the top
};

// What a map has beside it: its border's cells, itself again, or nothing.
enum class Outside : std::uint8_t { clamp, wrap, none };

struct Map {
    std::string name;
    std::variant<ColourImage, NumberTable> cells;
    double x = 0, y = 0, width = 1, height = 1;  // px of the wall, y upwards from the lower border
    Outside outside = Outside::clamp;
};

struct MapCell {
    std::uint32_t column = 0, row = 0;

    bool operator==(const MapCell&) const = default;
};
std::optional<MapCell> cell_at(const Map& map, Vec place);

using MapValue = std::variant<Colour, double>;
std::optional<MapValue> value_at(const Map& map, Vec place);

enum class Channel : std::uint8_t { red, green, blue, alpha, luma };
double channel_of(const MapValue& value, Channel channel);  // of a number: itself

// As expressions name them: the channels of a colour, in their order, and a number.
constexpr std::array<std::string_view, 5> channel_names = {"R", "G", "B", "A", "L"};
constexpr std::string_view number_name = "value";
void set_names(const MapValue& value, Scope& scope);

// As read_csv (formats/csv_read.h); blanks around a number are none of its.
Result<NumberTable> read_numbers_csv(std::string_view text);

}  // namespace filigree::rewriting
