// The evaluator behind evaluate.h: one object evaluates one expression once.
//
// Its parts: evaluate.cpp (values, names, conditions, calls), evaluate_operators.cpp, evaluate_shapes.cpp,
// evaluate_choices.cpp.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/choices.h"
#include "language/evaluate.h"
#include "language/walk.h"

namespace filigree {

// More problems of one expression would help nobody.
constexpr std::size_t max_diagnostics = 50;

struct Number {
    Quantity quantity;
    SourceSpan origin;  // says the unit of a bare length
};

// "cannot add an angle to a length"
std::string cannot(BinaryOperator op, std::string_view left, std::string_view right);

class Evaluator {
public:
    explicit Evaluator(const Evaluation& at) : at_(at) {}

    std::optional<Value> value(const Expression& expression, Place place);
    Diagnostics diagnostics;

private:
    using Maybe = std::optional<Value>;

    const Evaluation& at_;
    std::uint32_t choices_ = 0;  // met so far, taken or not
    int depth_ = 0;
    std::size_t shape_parts_ = 0;  // taken over from names

    std::nullopt_t fail(std::string_view code, std::string message, SourceSpan span,
                        std::vector<std::string> hints = {}) {
        return fail(error(std::string(code), std::move(message), span, std::move(hints)));
    }
    std::nullopt_t fail(Diagnostic diagnostic) {
        if (diagnostics.size() < max_diagnostics) diagnostics.push_back(std::move(diagnostic));
        return std::nullopt;
    }
    // Counts the choices of a branch that is not taken.
    void skip(const ExpressionPtr& expression) {
        if (expression) choices_ += count_choices(*expression);
    }

    Unit unit(const SourceSpan& span) const { return bare_unit(at_.document, span); }
    // A bare result belongs to the file where it is computed, except that a number from a file with another
    // unit stays one of that file: so an included `let gap = 5` means 5mm in `gap * 2` as in `gap`. What the
    // program itself supplies has no file and no unit of its own.
    SourceSpan origin(const Expression& expression, std::initializer_list<SourceSpan> operands) const {
        for (const SourceSpan& span : operands) {
            if (span.file != SourceSpan::no_file && unit(span) != unit(expression.span)) return span;
        }
        return expression.span;
    }
    Maybe quantity(const Expression& expression, const Quantity& quantity, SourceSpan origin);

    Maybe here(const Expression& expression, const Value& value);

    Maybe part(const ExpressionPtr& expression, Place place, const Expression& whole) {
        if (!expression) return fail("language.incomplete", "a part of this expression is missing", whole.span);
        return value(*expression, place);
    }
    std::optional<Number> number(const ExpressionPtr& expression, Place place, const Expression& whole);
    std::optional<double> plain_number(const ExpressionPtr& expression, Place place, const Expression& whole,
                                       std::string_view what);
    std::optional<bool> condition(const ExpressionPtr& expression, Place place, const Expression& whole);

    Maybe node(const Expression&, const NumberLiteral& literal, Place);
    Maybe node(const Expression&, const TextLiteral& literal, Place);
    Maybe node(const Expression&, const ColourLiteral& literal, Place);
    Maybe node(const Expression&, const BoolLiteral& literal, Place);
    Maybe node(const Expression&, const NameReference& name, Place);
    Maybe node(const Expression&, const ListExpression& list, Place);
    Maybe node(const Expression&, const PointExpression& point, Place);
    Maybe node(const Expression&, const UnaryExpression& unary, Place);
    Maybe node(const Expression&, const BinaryExpression& binary, Place);
    Maybe node(const Expression&, const ConditionalExpression& conditional, Place);
    Maybe node(const Expression&, const RangeExpression& range, Place);
    Maybe node(const Expression&, const WithinExpression& within, Place);
    Maybe node(const Expression&, const CallExpression& call, Place);
    Maybe node(const Expression&, const MemberExpression& member, Place);

    Maybe named(const Expression& expression, std::string_view name, Place place);
    Maybe binary(const Expression& expression, const BinaryExpression& node, Maybe left, Place place);
    Maybe arithmetic(const Expression& expression, BinaryOperator op, const Value& left, const Value& right);
    Maybe point_arithmetic(const Expression& expression, BinaryOperator op, const Value& left, const Value& right);
    Maybe shape_operation(const Expression& expression, BinaryOperator op, Value left, Value right);
    Maybe comparison(const Expression& expression, BinaryOperator op, const Value& left, const Value& right);

    struct Ends {
        double low = 0, high = 0;
        Quantity dimension;
        SourceSpan origin;
    };
    std::optional<Ends> ends(const Expression& expression, const RangeExpression& range, Place end_place,
                             std::optional<Number> beside = {});
    // The k-th choice, as a ChoiceBuffer's row holds it.
    std::optional<double> choose(const Expression& expression, std::uint32_t k, Place place,
                                 const ChoiceDomain& domain);
    struct ChoiceNames {
        std::string drawn, recorded;
    };
    std::optional<double> preset_draw(const Expression& expression, const DrawPreset& preset, const ChoiceNames& names,
                                      Place place, const ChoiceDomain& domain);
    Maybe normal(const Expression& expression, const CallExpression& call, const RangeExpression* range,
                 const Expression* range_expression, Place place);
    Maybe one_of(const Expression& expression, const CallExpression& call, Place place);
    Maybe each(const Expression& expression, const CallExpression& call, Place place);
    Maybe function(const Expression& expression, const CallExpression& call, Place place);
    Maybe list_item(const Expression& expression, const CallExpression& call, Place place);
    Maybe symbolic(const Expression& expression, const CallExpression& call, Place place);
};

}  // namespace filigree
