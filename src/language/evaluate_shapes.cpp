// Operations over shapes: they stay calls, named by their sign (shape_forms.h).
#include "language/evaluator.h"
#include "language/shape_forms.h"

namespace filigree {

using Maybe = std::optional<Value>;

namespace {

std::string_view sign_of(BinaryOperator op) {
    switch (op) {
        case BinaryOperator::add:
            return "+";
        case BinaryOperator::subtract:
            return "-";
        case BinaryOperator::multiply:
            return "*";
        case BinaryOperator::meet:
            return "&";
        default:
            return "";
    }
}

// What a person may have meant that has joined two values so.
std::vector<std::string> hints_for(BinaryOperator op, const Value& left, const Value& right) {
    const bool has_number = std::holds_alternative<Quantity>(left.data) || std::holds_alternative<Quantity>(right.data);
    const bool has_point = std::holds_alternative<Vec>(left.data) || std::holds_alternative<Vec>(right.data);
    if (op == BinaryOperator::multiply || op == BinaryOperator::divide) {
        if (has_number) return {"a shape is made larger or smaller by 'scale(2) * shape'"};
        if (shape_kind(right) == ShapeKind::transform) return {"a transform stands before its shape"};
        return {"what two shapes have in common is written 'a & b'"};
    }
    if (has_point) return {"a shape is moved by 'translate(2, 2) * shape'"};
    if (shape_kind(left) == ShapeKind::transform || shape_kind(right) == ShapeKind::transform) {
        return {"a transform is applied by '*', as in 'rotate(90) * shape'"};
    }
    return {};
}

bool is_operation(const Value& value, std::string_view sign) {
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    return call != nullptr && call->name == sign;
}

}  // namespace

// Operands that are the same operation are taken in, so that a chain is no deeper than its parts.
Maybe Evaluator::shape_operation(const Expression& expression, BinaryOperator op, Value left, Value right) {
    const std::string_view sign = sign_of(op);
    const bool are_shapes = shape_kind(left) == ShapeKind::shape && shape_kind(right) == ShapeKind::shape;
    const bool is_transformed =
        shape_kind(left) == ShapeKind::transform && shape_kind(right) && shape_kind(right) != ShapeKind::region;
    if (sign.empty() || !(op == BinaryOperator::multiply ? is_transformed : are_shapes)) {
        return fail("language.wrong-kind", cannot(op, kind_among_shapes(left), kind_among_shapes(right)),
                    expression.span, hints_for(op, left, right));
    }
    SymbolicCall result{std::string(sign), {}};
    const auto deepest = [&](const Value& operand) { return size_of(operand).depth >= max_evaluation_depth; };
    if (is_operation(left, sign)) {
        result.arguments = std::move(std::get<SymbolicCall>(left.data).arguments);
    } else if (deepest(left)) {
        return fail("language.too-deep", "this shape is nested too deeply", expression.span);
    } else {
        result.arguments.push_back({{}, std::move(left), {}});
    }
    if (is_operation(right, sign) && op != BinaryOperator::subtract) {
        for (NamedValue& operand : std::get<SymbolicCall>(right.data).arguments) {
            result.arguments.push_back(std::move(operand));
        }
    } else if (deepest(right)) {
        return fail("language.too-deep", "this shape is nested too deeply", expression.span);
    } else {
        result.arguments.push_back({{}, std::move(right), {}});
    }
    return Value{std::move(result), expression.span};
}

}  // namespace filigree
