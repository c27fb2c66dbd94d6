// Operators: arithmetic with dimensions, comparisons, conditions that stop early.
#include <cmath>

#include "language/evaluator.h"
#include "language/shape_forms.h"

namespace filigree {

using Maybe = std::optional<Value>;

Maybe Evaluator::node(const Expression& expression, const UnaryExpression& unary, Place place) {
    if (unary.op == UnaryOperator::invert) {
        const std::optional<bool> flag = condition(unary.operand, operand_place(place), expression);
        if (!flag) return std::nullopt;
        return Value{!*flag, expression.span};
    }
    Maybe found = part(unary.operand, operand_place(place, BinaryOperator::subtract), expression);
    if (!found) return std::nullopt;
    if (const Vec* point = std::get_if<Vec>(&found->data)) return Value{-*point, expression.span};
    if (const Quantity* known = std::get_if<Quantity>(&found->data)) {
        Quantity negative = *known;
        negative.value = 0 - negative.value;  // no minus zero
        return quantity(expression, negative, origin(expression, {found->span}));
    }
    if (at_.shapes && shape_kind(*found)) {
        return fail("language.wrong-kind", "a shape cannot be negated", expression.span,
                    {"a shape is taken from another one by 'a - b'"});
    }
    return fail("language.wrong-kind", "cannot negate " + std::string(kind_of(*found)), expression.span);
}

// Chains of operators lean to the left and may be long, so they are followed in a loop.
Maybe Evaluator::node(const Expression& expression, const BinaryExpression&, Place place) {
    std::vector<PlacedExpression> spine;
    const Expression* left = &expression;
    while (left != nullptr && std::holds_alternative<BinaryExpression>(left->node)) {
        spine.push_back({left, place});
        const auto& node = std::get<BinaryExpression>(left->node);
        place = operand_place(place, node.op);
        left = node.left.get();
    }
    Maybe result;
    if (left == nullptr) {
        fail("language.incomplete", "a part of this expression is missing", spine.back().expression->span);
    } else {
        result = value(*left, place);
    }
    for (auto step = spine.rbegin(); step != spine.rend(); ++step) {
        const Expression& outer = *step->expression;
        result = binary(outer, std::get<BinaryExpression>(outer.node), std::move(result), step->place);
    }
    return result;
}

Maybe Evaluator::binary(const Expression& expression, const BinaryExpression& node, Maybe left, Place place) {
    const Place operand = operand_place(place, node.op);
    if (node.op == BinaryOperator::both || node.op == BinaryOperator::either) {
        if (!left) return std::nullopt;
        Result<bool> flag = as_flag(*left);
        if (!flag) {
            Diagnostic diagnostic = std::move(flag).diagnostics().front();
            diagnostic.span = node.left->span;
            return fail(std::move(diagnostic));
        }
        if (*flag == (node.op == BinaryOperator::either)) {
            skip(node.right);
            return Value{*flag, expression.span};
        }
        const std::optional<bool> right = condition(node.right, operand, expression);
        if (!right) return std::nullopt;
        return Value{*right, expression.span};
    }
    Maybe right = part(node.right, operand, expression);
    if (!left || !right) return std::nullopt;
    if (at_.shapes && (shape_kind(*left) || shape_kind(*right))) {
        return shape_operation(expression, node.op, std::move(*left), std::move(*right));
    }
    switch (node.op) {
        case BinaryOperator::add:
        case BinaryOperator::subtract:
        case BinaryOperator::multiply:
        case BinaryOperator::divide:
            return arithmetic(expression, node.op, *left, *right);
        case BinaryOperator::meet:
            return fail("language.wrong-kind",
                        "'&' is the product of shapes, but this is " + std::string(kind_of(*left)), expression.span,
                        {"'both of two conditions' is written &&"});
        default:
            return comparison(expression, node.op, *left, *right);
    }
}

std::string cannot(BinaryOperator op, std::string_view left, std::string_view right) {
    const std::string a(left), b(right);
    switch (op) {
        case BinaryOperator::add:
            return "cannot add " + b + " to " + a;
        case BinaryOperator::subtract:
            return "cannot subtract " + b + " from " + a;
        case BinaryOperator::multiply:
            return "cannot multiply " + a + " by " + b;
        case BinaryOperator::divide:
            return "cannot divide " + a + " by " + b;
        case BinaryOperator::meet:
            return "cannot intersect " + a + " with " + b;
        default:
            return "cannot compare " + a + " with " + b;
    }
}

Maybe Evaluator::arithmetic(const Expression& expression, BinaryOperator op, const Value& left, const Value& right) {
    const Quantity* a = std::get_if<Quantity>(&left.data);
    const Quantity* b = std::get_if<Quantity>(&right.data);
    if (a == nullptr || b == nullptr) return point_arithmetic(expression, op, left, right);
    std::optional<Quantity> result;
    if (op == BinaryOperator::multiply) {
        result = multiplied(*a, *b);
    } else if (op == BinaryOperator::divide) {
        if (b->value == 0) return fail("language.not-finite", "division by zero", expression.span);
        result = divided(*a, *b);
    } else if (const auto pair = adapted(*a, unit(left.span), *b, unit(right.span))) {
        result = pair->first;
        result->value += op == BinaryOperator::add ? pair->second.value : -pair->second.value;
    }
    if (!result) return fail("language.wrong-kind", cannot(op, kind_of(left), kind_of(right)), expression.span);
    return quantity(expression, *result, origin(expression, {left.span, right.span}));
}

Maybe Evaluator::point_arithmetic(const Expression& expression, BinaryOperator op, const Value& left,
                                  const Value& right) {
    const Vec* a = std::get_if<Vec>(&left.data);
    const Vec* b = std::get_if<Vec>(&right.data);
    const Quantity* factor = std::get_if<Quantity>(a != nullptr ? &right.data : &left.data);
    std::optional<Vec> result;
    if (a != nullptr && b != nullptr) {
        if (op == BinaryOperator::add) result = *a + *b;
        if (op == BinaryOperator::subtract) result = *a - *b;
    } else if ((a != nullptr || b != nullptr) && factor != nullptr && is_bare(*factor)) {
        if (op == BinaryOperator::multiply) result = (a != nullptr ? *a : *b) * factor->value;
        if (op == BinaryOperator::divide && a != nullptr) {
            if (factor->value == 0) return fail("language.not-finite", "division by zero", expression.span);
            result = Vec{a->x / factor->value, a->y / factor->value};
        }
    }
    if (!result) return fail("language.wrong-kind", cannot(op, kind_of(left), kind_of(right)), expression.span);
    if (!std::isfinite(result->x) || !std::isfinite(result->y)) {
        return fail("language.not-finite", "this has no finite value", expression.span);
    }
    return Value{*result, expression.span};
}

Maybe Evaluator::comparison(const Expression& expression, BinaryOperator op, const Value& left, const Value& right) {
    const Quantity* a = std::get_if<Quantity>(&left.data);
    const Quantity* b = std::get_if<Quantity>(&right.data);
    bool result = false;
    if (a != nullptr && b != nullptr) {
        const auto pair = adapted(*a, unit(left.span), *b, unit(right.span));
        if (!pair) return fail("language.wrong-kind", cannot(op, kind_of(left), kind_of(right)), expression.span);
        const double x = pair->first.value, y = pair->second.value;
        if (!std::isfinite(x) || !std::isfinite(y)) {
            return fail("language.not-finite", "this has no finite value", expression.span);
        }
        switch (op) {
            case BinaryOperator::equal:
                result = x == y;
                break;
            case BinaryOperator::unequal:
                result = x != y;
                break;
            case BinaryOperator::less:
                result = x < y;
                break;
            case BinaryOperator::less_equal:
                result = x <= y;
                break;
            case BinaryOperator::greater:
                result = x > y;
                break;
            default:
                result = x >= y;
                break;
        }
    } else if (left.data.index() == right.data.index() &&
               (op == BinaryOperator::equal || op == BinaryOperator::unequal)) {
        result = (left == right) == (op == BinaryOperator::equal);
    } else {
        return fail("language.wrong-kind", cannot(op, kind_of(left), kind_of(right)), expression.span);
    }
    return Value{result, expression.span};
}

}  // namespace filigree
