// A rewriting grammar as plain data: systems of rules over letters (Roncoroni and Crousse, "Programming
// string-substitution rewriting systems").
//
// Letters, not symbols: which symbol a letter is depends on where it stands, and that is decided when the grammar is
// prepared for deriving (derive.h). The system with index 0 is the document's own; the others are its subsystems.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/random.h"
#include "engines/rewriting/lookup.h"
#include "engines/rewriting/symbols.h"
#include "engines/rewriting/word_edit.h"
#include "language/expression.h"

namespace filigree::rewriting {

// By what a map has where the symbol stands: the first row that holds it, both ends included. Where none does, the
// symbol stays.
struct Lookup {
    struct Row {
        double low = 0, high = 0;
        Pattern pattern;
        SourceSpan span;  // of the pattern
    };
    std::string map;
    Channel channel = Channel::luma;  // of pictures
    std::vector<Row> rows;
};

struct Successor {
    enum class Kind : std::uint8_t { pattern, jump, cell, lookup };
    Kind kind = Kind::pattern;
    Pattern pattern;
    char32_t target = 0;                 // jump: whose successor is taken,
    std::uint32_t target_iteration = 0;  // and that of which iteration
    std::string array;                   // cell: of which array,
    std::vector<ExpressionPtr> indexes;  // and where in it, from 0
    Lookup lookup;
    ExpressionPtr weight;  // null: 1
    std::string name;      // what presets call it: its text without blanks, with #2 where there is another like it
    SourceSpan span;
};

struct Assignment {
    std::string name;  // of a register
    ExpressionPtr value;
};

// [left <] letter [> right] [@ iterations] -> successors [loop ...] [when ...] [{ assignments }]
struct Rule {
    std::u32string left, right;  // contexts
    char32_t letter = 0;
    std::uint32_t first = 1, last = every_iteration;  // iterations in which it applies
    std::vector<Successor> successors;                // one is drawn by weight where there are several
    ExpressionPtr loop;                               // the rules of the letter are rows; null: none is said here
    ExpressionPtr condition;                          // null: always
    std::vector<Assignment> assignments;
    Key key;
    SourceSpan span;
};

// mask a@2 when depth > 2, or sleep a until age > 3: a symbol that stays as it is, with all '=' behind it.
struct Rest {
    char32_t letter = 0;
    std::uint32_t first = 1, last = every_iteration;
    ExpressionPtr condition;  // null: always
    bool is_until = false;    // it rests as long as the condition does not hold
    SourceSpan span;
};

// loop a@2 side: for how many iterations these rows of a letter serve, where their rules say nothing.
struct RowLoop {
    char32_t letter = 0;
    std::uint32_t first = 1, last = UINT32_MAX;  // rows
    ExpressionPtr length;
    SourceSpan span;
};

// R = random 1..8 "abbccc"
struct Macro {
    char32_t letter = 0;
    std::uint32_t low = 0, high = 0;  // how many letters
    std::u32string letters;           // drawn with replacement
    bool is_unique = false;           // one letter, repeated
};

enum class AfterRows : std::uint8_t { identity, hold, cycle };
enum class AgeMode : std::uint8_t { position, lineage };
enum class DrawMode : std::uint8_t { lineage, position };

struct Gain {
    char32_t letter = 0;
    std::uint32_t by = 1;
};

struct System {
    char32_t letter = 0;  // of a subsystem
    Roles roles;
    Pattern axiom;
    SourceSpan axiom_span;
    std::vector<Rule> rules;
    std::vector<Rest> rests;
    std::vector<RowLoop> loops;  // the last that names a row counts
    std::vector<Macro> macros;
    std::vector<Gain> gains;  // 1 where nothing is said
    std::u32string ignored;   // letters that contexts look past
    std::uint32_t iterations = 0;
    bool frees_braces = false;  // { and } are letters
    bool grows = false;         // a subsystem: rewritten along with the others, instead of put as a whole
    AfterRows after = AfterRows::identity;
    bool recalls_last = false;  // R= is what the last R drew, instead of the first
    Gait gait;                  // of a subsystem; where the document says no step, its own is so many times that
};

enum class OutOfRange : std::uint8_t { error, wrap, clamp };

// Words by their place: M[3][9].
struct Array {
    std::string name;
    std::vector<std::uint32_t> sizes;
    std::vector<Pattern> cells;                   // row by row
    OutOfRange out_of_range = OutOfRange::error;  // what an index outside leads to
};

struct Register {
    std::string name;
    double value = 0;
};

struct Grammar {
    std::vector<System> systems = std::vector<System>(1);
    std::vector<Array> arrays;
    std::vector<Map> maps;
    std::vector<Register> registers;  // with what they begin with
    std::vector<WordEdit> edits;      // in the order of the document
    AgeMode ages = AgeMode::position;
    DrawMode draws = DrawMode::lineage;
};

// The array, map or register of a name; null where there is none.
template <class Items>
auto find_named(Items& items, std::string_view name) -> decltype(items.data()) {
    for (auto& item : items) {
        if (item.name == name) return &item;
    }
    return nullptr;
}

// The subsystem that a letter stands for.
inline std::optional<std::uint32_t> find_system(const Grammar& grammar, char32_t letter) {
    for (std::uint32_t s = 1; s < grammar.systems.size(); ++s) {
        if (grammar.systems[s].letter == letter) return s;
    }
    return std::nullopt;
}

}  // namespace filigree::rewriting
