// Values: what expressions evaluate to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/colour.h"
#include "base/diagnostic.h"
#include "language/expression.h"
#include "plane/point.h"

namespace filigree {

// A number with its dimension. Lengths are in px, areas in px^2 (length_power 2), angles in degrees. A bare
// number has power 0 and becomes a length, in its file's unit, or an angle, where one is asked for.
struct Quantity {
    double value = 0;
    std::int8_t length_power = 0;
    bool is_angle = false;

    bool operator==(const Quantity&) const = default;
};

// A bare word that is no parameter and no known quantity: line, keep, disc.
struct Symbol {
    std::string name;

    bool operator==(const Symbol&) const = default;
};

struct Value;
struct NamedValue;

// A call that is no function of the language: turn(30), rectangle(100, 50), file("leaf.svg", id: "hair").
struct SymbolicCall {
    std::string name;
    std::vector<NamedValue> arguments;

    bool operator==(const SymbolicCall&) const;
};
struct ValueList {
    std::vector<Value> items;

    bool operator==(const ValueList&) const;
};

struct Value {
    std::variant<Quantity, bool, std::string, Colour, Symbol, Vec, ValueList, SymbolicCall> data;  // Vec: a point, px
    SourceSpan span;  // of the expression it came from

    bool operator==(const Value& other) const { return data == other.data; }
};
struct NamedValue {
    std::string name;  // empty for a positional argument
    Value value;
    SourceSpan name_span;

    bool operator==(const NamedValue& other) const { return name == other.name && value == other.value; }
};

// Whether the call is a sum, difference, product or transformed shape (shape_forms.h): named by its sign.
// It has two operands or more, folded from the left.
bool is_operation(const SymbolicCall& call);

struct ValueSize {
    std::size_t parts = 0;  // of lists and calls inside each other, itself included
    std::size_t depth = 0;
};
ValueSize size_of(const Value& value);

// As a document would write it: 25, 30deg, "text", [1, 2], turn(30). Lengths in px without a unit.
std::string to_text(const Value& value);
// The same, but a text without its quotes.
std::string plain_text(const Value& value);
// "a number", "a length", "a list", ... for messages.
std::string_view kind_of(const Value& value);

}  // namespace filigree
