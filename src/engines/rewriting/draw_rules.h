// What a document says of drawing its words: the turtle's settings, what letters place, colours and the view.
#pragma once

#include <optional>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "derivation/shape_source.h"
#include "engines/rewriting/turtle.h"
#include "language/settings.h"
#include "space/view.h"

namespace filigree::rewriting {

// A shape that a letter places, and what it is in space.
struct PlacedForm {
    SymbolicCall form;  // of letter_forms(), converted
    SourceSpan span;
};

struct DrawRules {
    TurtleSettings turtle;
    ExpressionPtr formula;          // degrees of a `?`, of k, t, depth, age, x, y and z; null: turtle.angles
    std::vector<PlacedForm> forms;  // by the number that is the shape's name in turtle.letters
    std::vector<Colour> colours;    // by the turtle's colour, over and over; none: ink
    std::optional<View> view;       // none: words that stay in the wall are drawn as they are
    std::uint32_t tubes = 0;        // sides of lines in space; 0: they are lines
    bool has_own_step = false;      // else a page scales the drawing to its size
};

// Which of `forms` it is that the turtle places under a name.
std::size_t form_number(const TurtleDrawing& turtled, std::uint32_t name);

// What `letter` places: the forms of starts, and box.
const std::vector<OperatorDescription>& letter_forms();

// Reads the settings of the outermost system that word_settings.h has for drawing. Errors as for all settings. What
// subsystems say is in the grammar (System::gait).
Result<DrawRules> read_draw_rules(const Settings& settings, const Document& document);

}  // namespace filigree::rewriting
