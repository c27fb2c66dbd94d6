// How what a word draws looks: the turtle's widths and colours, and over them what the document's styles say of the
// letter. `style a { ... }` is of the letter a; polygons have the style of the letter that begins them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "engines/rewriting/derive.h"
#include "engines/rewriting/draw_rules.h"
#include "engines/rewriting/symbol_facts.h"
#include "language/settings.h"
#include "language/style.h"

namespace filigree::rewriting {

enum class Drawn : std::uint8_t {
    line,
    face,
    solid,  // a face in space, with thin edges
    tube,   // a line in space that is a solid: filled in what is said of its stroke
};

struct Look {
    Style style;
    bool is_by_hand = false;  // lines: drawn as by a pen in a hand
};

// A symbol that draws, and what the turtle knows there.
struct DrawnSymbol {
    std::uint64_t place = 0;  // in Word::symbols
    double width = 1;         // px
    std::int64_t colour = 0;
    Vec3 at;
};

class WordStyles {
public:
    // All must outlive this. `root` is folded into all keys.
    WordStyles(const Derivation& derivation, const DrawRules& rules, const Settings& settings, StyleSheet sheet,
               Key root);

    Diagnostics errors;  // what went wrong first, if anything did

    // Symbols are best asked for in their order.
    Look look_of(Drawn kind, const DrawnSymbol& symbol);
    Key key_of(std::uint64_t place);

    // What all letters have in common, where no style asks which letter it is or what stands around it, and no pen is
    // moved by hand; null else.
    const StyleOverride* common() const;
    Look look_of(Drawn kind, double width, std::int64_t colour, const StyleOverride& over) const;

private:
    std::uint64_t index_of(std::uint64_t place);
    Colour colour_of(std::int64_t level) const;
    double fact_of(Fact fact, std::uint64_t place);

    const Derivation& derivation_;
    const DrawRules& rules_;
    const Settings& settings_;
    const StyleSheet sheet_;
    const Key root_;
    std::vector<TagStyle> letters_;  // by symbol
    const FactSet asked_;
    std::unique_ptr<SymbolFacts> facts_;
    std::uint64_t place_ = 0, index_ = 0;  // of the symbol that was asked for last
};

// Whether a style or the formula asks how old symbols are: only then must the word have ages.
bool asks_for_ages(const DrawRules& rules, const Settings& settings);

}  // namespace filigree::rewriting
