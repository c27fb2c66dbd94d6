// Recorded choices: every random decision of a derivation, as columns under keys.
//
// Evaluating an expression makes choices as a ChoiceMaking tells: drawn at random, in the middle of their domains,
// or replayed. What was made goes into a ChoiceBuffer, one for each piece of parallel work; buffers are appended to
// Choices in the order of the derivation. Neither holds a path: text is made only when choices are listed.
//
// Guarantee: rows stand in the order in which the choices were made, and the tables depend on nothing but the rows.
// Cost: at most 30 ns a choice (bench/choices_bench.cpp).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/random.h"
#include "language/expression.h"
#include "language/quantity.h"
#include "language/value.h"

namespace filigree {

struct Scope;

enum class ChoiceSource : std::uint8_t {
    drawn,     // by the document's own expression
    set,       // by, or inside, a `set`
    fallback,  // by, or inside, a `default`, where is_random is false
    middle,    // of its domain, where is_random is false
    replayed,
};
std::string_view name_of(ChoiceSource source);  // "drawn", "set", "default", "middle", "replayed"

// What a choice was made from.
struct ChoiceDomain {
    enum class Kind : std::uint8_t {
        range,         // low..high; whole numbers where `whole`
        normal,        // normal(mean, deviation), in low..high where they are finite
        alternatives,  // one of some values, with weights
        fixed,         // no choice any more: a preset has given the value
        worded,        // whatever an engine draws in its own way: `alternatives` are its domain in words, and the value
    };
    Kind kind = Kind::range;
    bool whole = false;
    Quantity dimension = {};  // of low, high and the value; its own value is 0
    // The ends of a whole range are whole; those of a normal are as written, infinite where it has no range.
    double low = 0, high = 0;
    double mean = 0, deviation = 0;
    std::vector<Value> alternatives = {};  // for all but `range` and `normal`: the value is an index into them
    std::vector<double> weights = {};      // of the alternatives

    bool operator==(const ChoiceDomain&) const = default;
};

struct Choices {
    std::vector<Key> keys;               // where: of a step, a group (`rule`), a shape in a step (each), a let
    std::vector<std::uint32_t> names;    // index into name_table
    std::vector<double> values;          // a number in its dimension, or the index of an alternative
    std::vector<std::uint32_t> domains;  // index into domain_table
    std::vector<ChoiceSource> sources;
    std::vector<std::string> name_table;  // "distance", "distance~2", "rule", "scatter"
    std::vector<ChoiceDomain> domain_table;

    std::size_t size() const { return keys.size(); }
};

Value value_of(const Choices& choices, std::size_t row);
// "5..9", "one_of(line: 3, wave: 1)", "normal(1, 0.2) in 0..2"; of a fixed value that value. Lengths have their unit,
// px, so that the text means the same in every document.
std::string domain_text(const ChoiceDomain& domain);
std::string text_with_unit(const Value& value);  // likewise

// Choices of one piece of work, before they are appended.
struct ChoiceBuffer {
    struct Row {
        Key key = {};
        double value = 0;
        std::uint32_t place = 0;  // index into places
        ChoiceSource source = ChoiceSource::drawn;
    };
    struct Place {                   // one choice of the text under one domain
        const void* text = nullptr;  // identifies it while the document lives: its expression
        std::string name = {};
        ChoiceDomain domain = {};
    };
    std::vector<Row> rows = {};
    std::vector<Place> places = {};
};

// Adds a row. Its place is found again behind the last row's, or among the last few; else it is written once more.
void record(ChoiceBuffer& buffer, const void* text, std::string_view name, const ChoiceDomain& domain, Key key,
            double value, ChoiceSource source);

// Appends rows in order. The recorder keeps what it needs to intern names and domains quickly.
class ChoiceRecorder {
public:
    void append(const ChoiceBuffer& buffer);
    // Rows first..end of another derivation's choices, as they are.
    void append(const Choices& from, std::size_t first, std::size_t end);
    Choices choices = {};

private:
    struct TextHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return static_cast<std::size_t>(hash_text(text)); }
    };
    // A table's index for each index of another table. All are guesses, which the content confirms.
    using Guesses = std::vector<std::uint32_t>;

    std::uint32_t name_index(std::string_view name);
    std::uint32_t domain_index(const void* text, const ChoiceDomain& domain);
    std::uint32_t domain_index(const ChoiceDomain& domain);

    std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> names_ = {};
    std::unordered_multimap<std::uint64_t, std::uint32_t> domains_ = {};       // by a hash of the content
    std::unordered_map<const void*, std::uint32_t> last_domain_of_text_ = {};  // a guess as well
    Guesses name_guesses_ = {}, domain_guesses_ = {};
    struct Interned {
        std::uint32_t name = 0, domain = 0;
        bool known = false;
    };
    std::vector<Interned> interned_ = {};  // the places of the buffer that is being appended
};

// Values to be taken instead of drawing, by where and what they are for.
class Replay {
public:
    void add(Key key, std::string_view name, Value value);  // the last one counts
    const Value* find(Key key, std::string_view name) const;
    std::size_t size() const { return values_.size(); }

private:
    std::unordered_map<std::uint64_t, Value> values_ = {};  // by fold(key, hash_text(name))
};

// A part of an argument that a preset fixes: `set PATH.distance~2 = ...`.
struct DrawPreset {
    std::uint32_t draw = 0;  // k
    ExpressionPtr value = {};
    ChoiceSource source = ChoiceSource::set;
    // What the value is evaluated with, where that is not what the choice is made with.
    const Document* document = nullptr;
    const Scope *scope = nullptr, *shape_scope = nullptr;
    bool by_shape = false;  // it is said of a single shape, so it is evaluated as if inside each(...)
};

// How choices are made while one expression is evaluated.
struct ChoiceMaking {
    bool is_random = true;                      // else the middle of a range, the heaviest (else first) alternative
    ChoiceSource source = ChoiceSource::drawn;  // of what is drawn here: `set` inside a preset's expression
    const Replay* replay = nullptr;
    ChoiceBuffer* record = nullptr;
    std::span<const DrawPreset> draws = {};
};

}  // namespace filigree
