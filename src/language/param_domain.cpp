#include "language/param_domain.h"

#include "base/number_text.h"

namespace filigree {

namespace {

// Whether one number is above another, in one dimension; none where they have none together.
std::optional<bool> is_above(const Value& a, const Value& b, const Document& document) {
    const Quantity* x = std::get_if<Quantity>(&a.data);
    const Quantity* y = std::get_if<Quantity>(&b.data);
    if (x == nullptr || y == nullptr) return std::nullopt;
    const auto pair = adapted(*x, bare_unit(&document, a.span), *y, bare_unit(&document, b.span));
    if (!pair) return std::nullopt;
    return pair->first.value > pair->second.value;
}

bool is_equal(const Value& a, const Value& b, const Document& document) {
    const auto above = is_above(a, b, document), below = is_above(b, a, document);
    return above && below ? !*above && !*below : a == b;
}

std::string with_unit(const Value& value) {
    const Quantity* quantity = std::get_if<Quantity>(&value.data);
    return to_text(value) + (quantity != nullptr && quantity->length_power == 1 ? "px" : "");
}

}  // namespace

Result<ParamDomain> range_domain(const Value& low, const Value& high, const Document& document, SourceSpan span) {
    ParamDomain domain;
    const Quantity* a = std::get_if<Quantity>(&low.data);
    const Quantity* b = std::get_if<Quantity>(&high.data);
    if (a != nullptr && b != nullptr) {
        domain.range = adapted(*a, bare_unit(&document, low.span), *b, bare_unit(&document, high.span));
    }
    if (!domain.range) {
        return error("language.wrong-kind",
                     "a range cannot go from " + std::string(kind_of(low)) + " to " + std::string(kind_of(high)), span);
    }
    if (domain.range->first.value > domain.range->second.value) {
        return error("language.empty-range", "the low end of the range lies above its high end", span);
    }
    domain.low_span = low.span;
    domain.high_span = high.span;
    return domain;
}

std::vector<ExpressionPtr> items_of_domain(const Expression& domain) {
    if (const auto* list = std::get_if<ListExpression>(&domain.node)) return list->items;
    std::vector<ExpressionPtr> items;
    const auto* call = std::get_if<CallExpression>(&domain.node);
    if (call == nullptr || call->name != "one_of") return items;
    for (const CallArgument& argument : call->arguments) items.push_back(argument.key ? argument.key : argument.value);
    return items;
}

std::optional<Diagnostic> outside(const ParamDomain& domain, const Value& value, const Document& document,
                                  SourceSpan span) {
    if (!domain.range) {
        std::string allowed;
        for (const Value& alternative : domain.alternatives) {
            if (is_equal(value, alternative, document)) return std::nullopt;
            allowed += (allowed.empty() ? "" : ", ") + with_unit(alternative);
        }
        return error("language.out-of-range",
                     "the value must be one of " + allowed + ", but this is " + with_unit(value), span);
    }
    const Value low{domain.range->first, domain.low_span}, high{domain.range->second, domain.high_span};
    const auto too_low = is_above(low, value, document), too_high = is_above(value, high, document);
    if (!too_low || !too_high) {
        return error("language.wrong-kind",
                     "the value is " + std::string(kind_of(value)) + ", but its domain is a range of another kind",
                     span);
    }
    if (!*too_low && !*too_high) return std::nullopt;
    return error(
        "language.out-of-range",
        "the value must be from " + with_unit(low) + " to " + with_unit(high) + ", but this is " + with_unit(value),
        span);
}

}  // namespace filigree
