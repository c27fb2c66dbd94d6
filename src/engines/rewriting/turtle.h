// The turtle: what a word draws, as plain geometry in space (Roncoroni and Crousse, "Expansion of the symbolic
// language", Fig. 7, 9, 11 and 19 to 22; what they leave open is said here).
//
// It starts at the origin, heading along +X in the plane of the wall, with +Y to its left and +Z, out of the wall, as
// its up. X Y Z make that axis of the world its heading, in the frames (X Y Z), (Y -X Z) and (Z Y -X). T, P and D
// select what is turned about: up, left, heading; T before any is. All turns are seen against their axis, so that `+`
// after T is clockwise in the wall and after P raises the nose. A turn bears on what is selected, not on the letter
// before it. Every lower-case letter is a step that draws a line, but `f`, which only steps; so is `F`. `[` and `]`
// keep and restore everything but open polygons. Other letters, signs and '=' do nothing unless the settings say so.
//
// Guarantee: the same bits everywhere. Turns about one axis add up as whole multiples of a fraction of the full turn
// (turtle_turns.h), so nothing drifts and opposite turns cancel; frames are orthonormal again whenever the axis
// changes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "base/result.h"
#include "engines/rewriting/word.h"
#include "plane/point.h"
#include "space/vector.h"

namespace filigree::rewriting {

using Frame = Frame3;  // not the plane's

// What a letter makes the turtle do.
enum class Act : std::uint8_t {
    nothing,
    line,    // a step that draws
    move,    // a step that draws nothing,
    corner,  // nor does this: a corner is all it gives
    shape,   // a step; a placed shape where it began
    head_x,
    head_y,
    head_z,
    select_up,  // T, P, D: what turns are about
    select_left,
    select_heading,
    plus,
    minus,
    less,  // as plus and minus, by angle2
    greater,
    formula,
    push,
    pop,
    shrink,  // ~(0.9), see word_tokens.h; a '~' with no factor does nothing
    wider,
    narrower,
    next_colour,
    previous_colour,
    begin_polygon,  // corners: where it stands, and where every step ends until the polygon does
    end_polygon,
};

struct LetterUse {
    char32_t letter = 0;
    Act act = Act::nothing;
    std::string shape = {};  // the name, for Act::shape
};

// What the turn of a `?` may depend on.
struct AngleFacts {
    std::uint64_t k = 0;      // how many `?` stand before it in the word
    std::uint64_t depth = 0;  // brackets around it
    std::uint32_t age = 1;    // Word::ages
    double x = 0, y = 0, z = 0;
};

enum class PlusTurn : std::uint8_t { clockwise, counterclockwise };

struct TurtleSettings {
    double angle = 30;                  // degrees, of + and -
    std::optional<double> angle2 = {};  // of < and >; none: angle
    PlusTurn plus = PlusTurn::clockwise;
    double step = 1;  // px
    double width = 1;
    double width_ratio = 1.25;            // of Act::wider
    std::vector<LetterUse> letters = {};  // before all that is said above; the last of a letter counts
    std::function<double(const AngleFacts&)> formula = {};  // degrees of a `?`, which turns as + does; none:
    std::vector<double> angles = {};                        // of the k-th `?`, from the start again behind the last
};

struct TurtleSegment {
    Vec3 from, to;
    Frame frame;
    double width = 1;
    std::int64_t colour = 0;   // next less previous; any whole number
    std::uint64_t symbol = 0;  // in Word::symbols
};

struct TurtlePolygon {
    std::uint64_t first = 0, count = 0;  // corners; at least 3, and the last is not the first again
    double width = 1;                    // as it began
    std::int64_t colour = 0;
    std::uint64_t symbol = 0;  // that began it
};

struct TurtleShape {
    Vec3 position;
    Frame frame;
    double scale = 1;        // by shrinks
    std::uint32_t name = 0;  // in shape_names
    double width = 1;
    std::int64_t colour = 0;
    std::uint64_t symbol = 0;
};

struct TurtleDrawing {
    std::vector<TurtleSegment> segments;
    std::vector<TurtlePolygon> polygons;  // in the order in which they end; those still open end with the word
    std::vector<Vec3> corners;
    std::vector<TurtleShape> shapes;
    std::vector<std::string> shape_names;
    Vec3 end;
    Frame end_frame;
    // What has no partner: does nothing, or ends with the word.
    std::uint64_t stray_closings = 0, unclosed = 0;
    std::uint64_t stray_polygon_ends = 0, unclosed_polygons = 0;
};

// Counts before it asks for memory: more than `most_elements` segments, shapes, corners or brackets inside each other
// are `limit.elements`. The memory of `reuse` is taken for the result where it suffices.
Result<TurtleDrawing> turtle_drawing(const Word& word, const Alphabet& alphabet, const TurtleSettings& settings,
                                     std::uint64_t most_elements = Limits{}.elements, TurtleDrawing reuse = {});

// Where in the wall each symbol that is no '=' stands before it acts: what image rules ask.
Result<std::vector<Vec>> symbol_positions(const Word& word, const Alphabet& alphabet, const TurtleSettings& settings,
                                          std::uint64_t most_elements = Limits{}.elements);

}  // namespace filigree::rewriting
