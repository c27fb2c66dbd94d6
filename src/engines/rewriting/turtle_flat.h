// The turtle in the wall, fast: for words that turn about up alone and have no `?`, shrink, polygon or placed shape.
//
// What such a word draws is polylines. Every direction that can occur stands in a table, and symbols are gone through
// without branches between brackets and moves, so that a drawing costs hardly more than to write it down. Guarantee:
// the same points, bit by bit, as turtle_drawing gives.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/limits.h"
#include "base/result.h"
#include "engines/rewriting/byte_word.h"
#include "engines/rewriting/turtle.h"

namespace filigree::rewriting {

// A line that is drawn without lifting the pen: at least two points.
struct FlatRun {
    std::uint64_t first = 0, count = 0;  // points
    double width = 1;
    std::int64_t colour = 0;

    bool operator==(const FlatRun&) const = default;
};

struct FlatDrawing {
    ByteWord memory;  // of the points
    std::uint64_t point_count = 0;
    std::vector<FlatRun> runs;  // in the order of the word, their points one after another
    std::uint64_t segments = 0;
    Vec end;
    std::uint64_t stray_closings = 0, unclosed = 0;  // brackets

    std::span<const Vec> points() const { return {reinterpret_cast<const Vec*>(memory.data()), point_count}; }
};

// None where the word or its angles need the general turtle. A line goes on where it stopped if the turtle stands there
// when it draws again. The memory of `reuse` is taken for the result where it suffices.
Result<std::optional<FlatDrawing>> flat_drawing(std::span<const Symbol> word, const Alphabet& alphabet,
                                                const TurtleSettings& settings,
                                                std::uint64_t most_elements = Limits{}.elements,
                                                FlatDrawing reuse = {});

}  // namespace filigree::rewriting
