#include "engines/rewriting/lookup.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "formats/csv_read.h"

namespace filigree::rewriting {
namespace {

// Which of `count` cells over a length a place lies in, from the lower end.
std::optional<std::uint32_t> cell_along(double place, double begin, double length, std::uint32_t count,
                                        Outside outside) {
    if (count == 0) return std::nullopt;
    const double cells = count;
    double cell = std::floor((place - begin) * cells / length + 1e-6);
    if (!std::isfinite(cell)) return std::nullopt;
    if (outside == Outside::wrap) cell -= cells * std::floor(cell / cells);
    if (outside == Outside::none && !(cell >= 0 && cell < cells)) return std::nullopt;
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, cells - 1));
}

// The same everywhere: in whole numbers, rounded half up.
std::uint32_t luma_of(Colour colour) {
    return (2126U * colour.red + 7152U * colour.green + 722U * colour.blue + 5000U) / 10000U;
}

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace

std::optional<MapCell> cell_at(const Map& map, Vec place) {
    return std::visit(
        [&](const auto& cells) -> std::optional<MapCell> {
            const auto column = cell_along(place.x, map.x, map.width, cells.width, map.outside);
            const auto row = cell_along(place.y, map.y, map.height, cells.height, map.outside);
            if (!column || !row) return std::nullopt;
            return MapCell{*column, cells.height - 1 - *row};
        },
        map.cells);
}

std::optional<MapValue> value_at(const Map& map, Vec place) {
    const std::optional<MapCell> cell = cell_at(map, place);
    if (!cell) return std::nullopt;
    if (const auto* image = std::get_if<ColourImage>(&map.cells)) {
        return image->pixels[std::size_t{cell->row} * image->width + cell->column];
    }
    const auto& table = std::get<NumberTable>(map.cells);
    return table.numbers[std::size_t{cell->row} * table.width + cell->column];
}

double channel_of(const MapValue& value, Channel channel) {
    const auto* colour = std::get_if<Colour>(&value);
    if (colour == nullptr) return std::get<double>(value);
    switch (channel) {
        case Channel::red:
            return colour->red;
        case Channel::green:
            return colour->green;
        case Channel::blue:
            return colour->blue;
        case Channel::alpha:
            return colour->alpha;
        case Channel::luma:
            break;
    }
    return luma_of(*colour);
}

void set_names(const MapValue& value, Scope& scope) {
    const auto set = [&](std::string_view name, double number) {
        auto known = scope.names.find(name);
        if (known == scope.names.end()) known = scope.names.emplace(std::string(name), Value{}).first;
        known->second = Value{Quantity{number}, {}};
    };
    if (const double* number = std::get_if<double>(&value)) return set(number_name, *number);
    for (std::size_t i = 0; i < channel_names.size(); ++i) {
        set(channel_names[i], channel_of(value, static_cast<Channel>(i)));
    }
}

Result<NumberTable> read_numbers_csv(std::string_view text) {
    const Result<std::vector<CsvRow>> rows = read_csv(text);
    if (!rows) return rows.diagnostics();
    NumberTable table;
    table.width = static_cast<std::uint32_t>(rows->front().cells.size());
    table.height = static_cast<std::uint32_t>(rows->size());
    table.numbers.reserve(std::size_t{table.width} * table.height);
    for (const CsvRow& row : *rows) {
        for (const std::string& cell : row.cells) {
            const std::optional<double> number = parse_number(without_blanks(cell));
            if (number) {
                table.numbers.push_back(*number);
                continue;
            }
            const std::size_t column = 1 + static_cast<std::size_t>(&cell - row.cells.data());
            return error("rewriting.no-number",
                         "line " + std::to_string(row.line) + " has no number in column " + std::to_string(column));
        }
    }
    return table;
}

}  // namespace filigree::rewriting
