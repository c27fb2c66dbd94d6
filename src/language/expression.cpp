#include "language/expression.h"

#include <algorithm>

namespace filigree {

namespace {

bool same(const ExpressionPtr& a, const ExpressionPtr& b) {
    if (!a || !b) return !a && !b;
    return a == b || same_meaning(*a, *b);
}

bool same(const std::vector<ExpressionPtr>& a, const std::vector<ExpressionPtr>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const ExpressionPtr& x, const ExpressionPtr& y) { return same(x, y); });
}

bool same(const CallArgument& a, const CallArgument& b) { return same(a.key, b.key) && same(a.value, b.value); }

bool same(const NumberLiteral& a, const NumberLiteral& b) { return a.value == b.value && a.unit == b.unit; }
bool same(const TextLiteral& a, const TextLiteral& b) { return a.text == b.text; }
bool same(const ColourLiteral& a, const ColourLiteral& b) { return a.colour == b.colour; }
bool same(const BoolLiteral& a, const BoolLiteral& b) { return a.value == b.value; }
bool same(const NameReference& a, const NameReference& b) { return a.name == b.name; }
bool same(const ListExpression& a, const ListExpression& b) { return same(a.items, b.items); }
bool same(const PointExpression& a, const PointExpression& b) { return same(a.coordinates, b.coordinates); }
bool same(const UnaryExpression& a, const UnaryExpression& b) { return a.op == b.op && same(a.operand, b.operand); }
bool same(const BinaryExpression& a, const BinaryExpression& b) {
    return a.op == b.op && same(a.left, b.left) && same(a.right, b.right);
}
bool same(const ConditionalExpression& a, const ConditionalExpression& b) {
    return same(a.condition, b.condition) && same(a.when_true, b.when_true) && same(a.when_false, b.when_false);
}
bool same(const RangeExpression& a, const RangeExpression& b) { return same(a.low, b.low) && same(a.high, b.high); }
bool same(const WithinExpression& a, const WithinExpression& b) {
    return same(a.value, b.value) && same(a.range, b.range);
}
bool same(const CallExpression& a, const CallExpression& b) {
    return a.name == b.name &&
           std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(),
                      [](const CallArgument& x, const CallArgument& y) { return same(x, y); });
}
bool same(const MemberExpression& a, const MemberExpression& b) { return a.name == b.name && same(a.object, b.object); }

}  // namespace

bool same_meaning(const Expression& a, const Expression& b) {
    return std::visit(
        [](const auto& x, const auto& y) {
            if constexpr (std::is_same_v<decltype(x), decltype(y)>) {
                return same(x, y);
            } else {
                return false;
            }
        },
        a.node, b.node);
}

}  // namespace filigree
