// What the symbols of a word mean to a turtle, and how much they will make it draw.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engines/rewriting/turtle.h"
#include "engines/rewriting/turtle_turns.h"

namespace filigree::rewriting {

struct TurtleLetters {
    std::array<Act, max_symbols> acts{};
    std::array<std::uint32_t, max_symbols> names{};  // in shape_names
    std::vector<std::string> shape_names;
    TurnScale scale;                            // of all angles of the document and of gaits
    std::array<Int128, max_symbols> turns{};    // of signs: amounts
    std::array<double, max_symbols> lengths{};  // of steps, px

    // Whether all steps are as long as the document says.
    bool have_one_length = true;
};
TurtleLetters turtle_letters(const Alphabet& alphabet, const TurtleSettings& settings);

constexpr bool is_step(Act act) {
    return act == Act::line || act == Act::move || act == Act::corner || act == Act::shape;
}

struct TurtleShrink {
    std::size_t begin = 0, end = 0;  // symbols
    double factor = 1;
};

struct TurtleCounts {
    std::uint64_t segments = 0, shapes = 0, polygons = 0, corners = 0;
    std::uint64_t deepest = 0;  // brackets inside each other
    std::uint64_t stray_closings = 0, unclosed = 0;
    std::uint64_t stray_polygon_ends = 0, unclosed_polygons = 0;
    std::vector<TurtleShrink> shrinks;  // in the order of the word
};
TurtleCounts count_acts(const Word& word, const Alphabet& alphabet, const TurtleLetters& letters);

std::optional<Diagnostic> check_settings(const TurtleSettings& settings, const Alphabet& alphabet);
Diagnostic too_much_to_draw(std::uint64_t count, const char* what, std::uint64_t most);
Diagnostic out_of_range(std::uint64_t symbol);

double width_of(const TurtleSettings& settings, std::int64_t level);  // so many times wider

}  // namespace filigree::rewriting
