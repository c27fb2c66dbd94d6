// Expressions as plain data: what stands after `=`, inside `( )` and behind `when` and `weight`.
//
// A tree of immutable nodes that remember where they stand in the source. Evaluating them is evaluate.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/colour.h"
#include "base/diagnostic.h"

namespace filigree {

enum class Unit : std::uint8_t {
    none,
    mm,
    cm,
    m,
    inch,
    pt,
    px,  // lengths; inch is written `in`
    deg,
    rad,
    turn,     // angles
    percent,  // a factor of 0.01
    kilobyte,
    megabyte,
    gigabyte,  // powers of 1000
    second,
};

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;  // never null where a field is not said to be optional

struct NumberLiteral {
    double value = 0;  // as written, before its unit: 3.5mm is 3.5
    Unit unit = Unit::none;
};
struct TextLiteral {
    std::string text;  // escapes resolved
};
struct ColourLiteral {
    Colour colour;  // #rgb, #rgba, #rrggbb, #rrggbbaa
};
struct BoolLiteral {
    bool value = false;
};
struct NameReference {
    std::string name;  // in normal form C
};
struct ListExpression {
    std::vector<ExpressionPtr> items;
};
struct PointExpression {  // (x, y) or (x, y, z); a single expression in parentheses is that expression
    std::vector<ExpressionPtr> coordinates;
};
enum class UnaryOperator : std::uint8_t { negate, invert };
struct UnaryExpression {
    UnaryOperator op = UnaryOperator::negate;
    ExpressionPtr operand;
};
enum class BinaryOperator : std::uint8_t {
    either,
    both,  // || &&
    equal,
    unequal,
    less,
    less_equal,
    greater,
    greater_equal,  // `=` alone is no comparison
    add,
    subtract,
    multiply,
    divide,
    meet,  // & : the product of shapes
};
struct BinaryExpression {
    BinaryOperator op = BinaryOperator::add;
    ExpressionPtr left, right;
};
struct ConditionalExpression {
    ExpressionPtr condition, when_true, when_false;
};
struct RangeExpression {  // low .. high
    ExpressionPtr low, high;
};
struct WithinExpression {  // value in low..high; `range` is usually a RangeExpression
    ExpressionPtr value, range;
};
struct CallArgument {
    ExpressionPtr key;  // before the colon; null where there is none
    ExpressionPtr value;
};
struct CallExpression {
    std::string name;  // in normal form C
    SourceSpan name_span;
    std::vector<CallArgument> arguments;
};
struct MemberExpression {  // page.width
    ExpressionPtr object;
    std::string name;
};

struct Expression {
    SourceSpan span;
    std::variant<NumberLiteral, TextLiteral, ColourLiteral, BoolLiteral, NameReference, ListExpression, PointExpression,
                 UnaryExpression, BinaryExpression, ConditionalExpression, RangeExpression, WithinExpression,
                 CallExpression, MemberExpression>
        node;
};

// Whether two trees say the same, wherever they stand.
bool same_meaning(const Expression& a, const Expression& b);

}  // namespace filigree
