// The document as plain data: statements in order, with the text they were read from.
//
// Parsing loses nothing: `document.sources[0].text` is the text, every statement and the parts that an edit
// may replace know their bytes in it, and an edit (edit.h) is a new text that is parsed again. Which names
// and operators exist is not known here; engines check that against their descriptions.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "language/expression.h"

namespace filigree {

struct Name {
    std::string text;  // in normal form C
    SourceSpan span;
};

struct VersionStatement {
    double version = 1;
};  // filigree 1
struct GrammarStatement {
    Name engine;
};  // grammar tangle
struct SeedStatement {
    std::uint64_t seed = 0;
    SourceSpan value_span;
};
struct UnitStatement {
    Unit unit = Unit::px;
};
struct ResolutionStatement {
    ExpressionPtr value;
};
struct IncludeStatement {
    Name file;
};  // its text is the unescaped string
struct ParamStatement {
    Name name;
    ExpressionPtr value;
    ExpressionPtr domain;  // after `in`; null if absent
    ExpressionPtr step;    // null if absent
    std::optional<std::string> help;
};
struct LetStatement {
    Name name;
    ExpressionPtr value;
};
struct PageStatement {
    enum class Kind { fit, named, size, tile };
    Kind kind = Kind::fit;
    Name name;                    // for `named`: a4, letter, ...
    ExpressionPtr width, height;  // for `size` and `tile`
    ExpressionPtr margin;         // null if absent
};
struct LimitStatement {
    Name name;
    ExpressionPtr value;
};
struct SymmetryStatement {
    Name group;
};
struct PaletteStatement {
    Name name;
    ExpressionPtr colours;
};
struct StartStatement {
    Name tag;                  // empty text for `start from`
    ExpressionPtr value;       // null for `start from`
    std::optional<Name> from;  // the file of `start from`
};
struct StyleProperty {
    Name name;
    ExpressionPtr value;
};
struct StyleStatement {
    std::vector<Name> tags;   // `*` stands for every tag
    ExpressionPtr condition;  // null if absent
    std::vector<StyleProperty> properties;
};

// [label =] operator(arguments) : tag [when ...] [weight ...] -> tags      (engines tangle and surface)
struct OutputTag {
    std::string port;      // `remainder: rem`; empty where outputs are given by order
    std::string tag;       // empty for `<>`: an unnamed terminal
    bool dropped = false;  // `_`
    SourceSpan span;
};
struct GroupRule {
    std::optional<Name> label;
    Name operator_name;
    std::vector<CallArgument> arguments;
    Name tag;                 // what it matches
    ExpressionPtr condition;  // null if absent
    ExpressionPtr weight;     // null if absent
    std::vector<OutputTag> outputs;
};

// image wall L { 0..85 "T+b"; 86..170 "b" }, or data heights { ... }: by what stands there where the symbol does
struct WordLookupRow {
    ExpressionPtr range;  // or one number
    Name text;            // as written between its quotes
};
struct WordLookup {
    bool is_image = false;  // else data
    Name map;
    Name channel;  // of images
    std::vector<WordLookupRow> rows;
};
// A successor of a rewriting rule: "a[P<n]", goto a@3, M[ix][iy], or a lookup; one is drawn where there are several.
struct WordSuccessor {
    std::optional<Name> text;     // as written between its quotes
    std::optional<Name> target;   // goto: one symbol,
    std::uint32_t iteration = 0;  // and in which iteration
    std::optional<Name> array;
    std::vector<ExpressionPtr> indexes;
    std::optional<WordLookup> lookup;
    ExpressionPtr weight;  // behind '*'; null if absent
    SourceSpan span;
};
struct WordAssignment {
    Name name;
    ExpressionPtr value;
};
// [left <] symbol [> right] [@ first[..last]] -> successors [loop ...] [when ...] [{ name = value; ... }]
struct WordRule {
    Name left, symbol, right;  // contexts have no text where there are none
    std::uint32_t first = 1, last = UINT32_MAX;
    std::vector<WordSuccessor> successors;
    ExpressionPtr loop;       // null if absent
    ExpressionPtr condition;  // null if absent
    std::vector<WordAssignment> assignments;
};
// R = random 1..8 "abbccc" [unique]
struct MacroStatement {
    Name symbol;
    ExpressionPtr length;  // a number or a range
    Name letters;
    bool is_unique = false;
};
// M[3][9] -> "ab"
struct CellStatement {
    Name array;
    std::vector<ExpressionPtr> indexes;
    Name text;
};
// "ab"@2..5: symbols, and of what they go through some numbers
struct NumberedSymbols {
    Name text;
    std::uint32_t first = 1, last = UINT32_MAX;
};
// mask a@2, "b+" when depth > 2, or sleep a until age > 3: symbols that stay as they are, in these iterations, where
// the condition holds, or as long as it does not
struct RestStatement {
    bool is_until = false;
    std::vector<NumberedSymbols> symbols;
    ExpressionPtr condition;  // null if absent, which may be in a mask
};
// loop a 3, or loop "ab"@2, c side: for how many iterations these rules of the symbols serve, counted from 1
struct LoopStatement {
    std::vector<NumberedSymbols> symbols;
    ExpressionPtr length;
};
// once insert("T+", at: "a"), or after 3, after 2..5, each iteration: an edit of the whole word
struct WordEditStatement {
    bool is_once = false;                        // behind the last iteration;
    std::uint32_t first = 1, last = UINT32_MAX;  // else behind each of these
    Name edit_name;
    std::vector<CallArgument> arguments;  // of a pair "aaa" -> "b" the key is a text
    SourceSpan call_span;
};
// angle 30: what is said of words (word_settings.h) or shapes (shape_settings.h) in one form, a name and values
struct SettingStatement {
    Name name;
    std::vector<ExpressionPtr> values;
};

// NAME = left -> right [match M] [weight W] [priority P] [unless U ...] [when C] of a shape grammar; or a rule that
// follows from another, NAME = inverse(OTHER) or mirror(OTHER, angle)
struct ShapeRule {
    Name name;
    ExpressionPtr derivation;  // inverse(OTHER); null of a rule that has sides
    ExpressionPtr left, right;
    ExpressionPtr match, weight, priority, condition;  // each null if absent
    std::vector<ExpressionPtr> unless;
};
// rules from "rules.svg"
struct RulesFromStatement {
    Name file;
};
// apply [STATE =] NAME at (x, y) [angle A] [scale S] [mirrored] [orbit]: a match chosen by where it lies
struct MatchStatement {
    std::optional<Name> name;  // of the state behind it
    Name rule;
    ExpressionPtr at;
    ExpressionPtr angle, scale;  // each null if absent
    bool is_mirrored = false, is_orbit = false;
};

// back to STATE: the derivation goes on from there; `start` is the initial shape
struct BackStatement {
    Name name;
};

// A place in a derivation, or several: big_poly/outline/in/regular_split/quads[3]/outline.distance~2. Tags and rules
// take turns from the start downwards; `*` stands for one segment, `**` for any number of them.
struct PathSegment {
    enum class Kind : std::uint8_t { name, shapes, any, any_depth };
    Kind kind = Kind::name;
    std::string name;  // a tag, or a rule's segment with its #n, in normal form C
    std::vector<std::uint32_t>
        ordinals;  // of groups (quads[3]) or shapes (the segment 2,5), from 1, ascending, each once

    bool operator==(const PathSegment&) const = default;
};
struct ChoicePath {
    std::vector<PathSegment> segments;  // never empty; without two `**` in a row
    std::string parameter;              // behind the dot; empty where there is none
    std::uint32_t draw = 0;             // the k of `~k`, from 1; 0 where none is given
    SourceSpan span;
};

// set PATH = VALUE [when CONDITION]; `default` counts only where is_random is false
struct PresetStatement {
    bool is_default = false;
    ChoicePath path;
    ExpressionPtr value;
    ExpressionPtr condition;  // null if absent
};
struct KeepStatement {
    ChoicePath path;
};
struct RerollStatement {
    ChoicePath path;
    std::uint32_t times = 1;  // 1..1,000,000,000
    SourceSpan times_span;    // of the number; no_file where `x N` is absent
};
// apply [NAME =] operator(arguments) to PATH, PATH [-> tags]
struct ApplyStatement {
    std::optional<Name> name;
    Name operator_name;
    std::vector<CallArgument> arguments;
    std::vector<ChoicePath> targets;  // without parameters
    std::vector<OutputTag> outputs;
};

struct Statement;
struct DefinitionParameter {
    Name name;
    ExpressionPtr value;  // its default; null where it must be given
};
// system NAME (parameters) { statements }: a document inside this one, for `embed` and for subsystems
struct SystemStatement {
    Name name;
    std::vector<DefinitionParameter> parameters;
    std::vector<Statement> statements;
    std::optional<Unit> unit;  // of its own; else that of the file it stands in
};
// operator NAME (parameters) -> ports { rules }: a rule sequence with a name. It begins with its first rule's tag.
struct OperatorStatement {
    Name name;
    std::vector<DefinitionParameter> parameters;
    std::vector<Name> ports;
    std::vector<Statement> statements;  // rules alone
};

struct Statement {
    SourceSpan span;  // without the comment behind it
    std::variant<VersionStatement, GrammarStatement, SeedStatement, UnitStatement, ResolutionStatement,
                 IncludeStatement, ParamStatement, LetStatement, PageStatement, LimitStatement, SymmetryStatement,
                 PaletteStatement, StartStatement, StyleStatement, GroupRule, PresetStatement, KeepStatement,
                 RerollStatement, ApplyStatement, SystemStatement, OperatorStatement, WordRule, MacroStatement,
                 CellStatement, SettingStatement, RestStatement, LoopStatement, WordEditStatement, ShapeRule,
                 RulesFromStatement, MatchStatement, BackStatement>
        node;
};

struct Document {
    Sources sources;                    // [0] is the document; then included files in the order of their mention
    std::vector<Unit> units;            // what a bare length means in each source
    std::vector<Statement> statements;  // of all sources, an included file's right behind its `include`

    const std::string& text() const { return sources.at(0).text; }
};

}  // namespace filigree
