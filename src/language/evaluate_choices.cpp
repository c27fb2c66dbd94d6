// Choices: ranges, normal(...) and one_of(...).
#include <algorithm>
#include <cmath>

#include "language/choice.h"
#include "language/evaluator.h"
#include "language/names.h"

namespace filigree {

using Maybe = std::optional<Value>;

std::uint64_t Evaluator::bits(std::uint32_t k, Place place) const {
    const Key key = place.by_shape && at_.shape_key ? *at_.shape_key : at_.site.key;
    return random_bits(at_.site.seed, key, choice_name(at_.site.name, k));
}

// The ends of a range in one dimension, also with the mean that stands beside it.
std::optional<Evaluator::Ends> Evaluator::ends(const Expression& expression, const RangeExpression& range,
                                               Place end_place, std::optional<Number> beside) {
    const std::optional<Number> low = number(range.low, end_place, expression);
    const std::optional<Number> high = number(range.high, end_place, expression);
    if (!low || !high) return std::nullopt;
    Quantity like = is_bare(low->quantity) ? high->quantity : low->quantity;
    if (beside && is_bare(like)) like = beside->quantity;
    const auto a = adapted(low->quantity, unit(low->origin), like);
    const auto b = adapted(high->quantity, unit(high->origin), like);
    if (!a || !b) {
        return fail("language.wrong-kind",
                    "a range cannot go from " + std::string(kind_of(low->quantity)) + " to " +
                        std::string(kind_of(high->quantity)),
                    expression.span);
    }
    if (!std::isfinite(a->value) || !std::isfinite(b->value) || !std::isfinite(b->value - a->value)) {
        return fail("language.not-finite", "this range is too wide", expression.span);
    }
    if (a->value > b->value) {
        return fail("language.empty-range", "the low end of the range lies above its high end", expression.span);
    }
    return Ends{a->value, b->value, like, origin(expression, {low->origin, high->origin})};
}

Maybe Evaluator::node(const Expression& expression, const RangeExpression& range, Place place) {
    const std::uint32_t k = ++choices_;
    Place end_place = operand_place(place);
    end_place.whole = place.whole;
    const std::optional<Ends> found = ends(expression, range, end_place);
    if (!found) return std::nullopt;
    Quantity drawn = found->dimension;
    if (place.whole) {
        const double low = std::ceil(found->low), high = std::floor(found->high);
        if (low > high) {
            return fail("language.empty-range", "there is no whole number in this range", expression.span);
        }
        drawn.value = draw_whole(low, high, bits(k, place));
    } else {
        drawn.value = draw_between(found->low, found->high, bits(k, place));
    }
    return quantity(expression, drawn, found->origin);
}

Maybe Evaluator::node(const Expression& expression, const WithinExpression& within, Place place) {
    const CallExpression* call = nullptr;
    if (within.value) call = std::get_if<CallExpression>(&within.value->node);
    const RangeExpression* range = nullptr;
    if (within.range) range = std::get_if<RangeExpression>(&within.range->node);
    if (call == nullptr || call->name != "normal" || range == nullptr) {
        return fail("language.wrong-kind", "'in' keeps a normal(...) in a range low..high", expression.span,
                    {"for other values write clamp(value, low, high)"});
    }
    return normal(*within.value, *call, range, within.range.get(), place);
}

Maybe Evaluator::normal(const Expression& expression, const CallExpression& call, const RangeExpression* range,
                        const Expression* range_expression, Place place) {
    const std::uint32_t k = ++choices_;
    if (std::optional<Diagnostic> wrong = wrong_arguments(call, CallMeaning::special, expression.span)) {
        return fail(std::move(*wrong));
    }
    const Place operand = operand_place(place);
    const std::optional<Number> mean = number(call.arguments[0].value, operand, expression);
    const std::optional<Number> deviation = number(call.arguments[1].value, operand, expression);
    std::optional<AdaptedPair> pair;
    if (mean && deviation) {
        pair = adapted(mean->quantity, unit(mean->origin), deviation->quantity, unit(deviation->origin));
        if (!pair) {
            fail("language.wrong-kind",
                 "the deviation of " + std::string(kind_of(mean->quantity)) + " cannot be " +
                     std::string(kind_of(deviation->quantity)),
                 call.arguments[1].value->span);
        } else if (pair->second.value < 0) {
            fail("language.out-of-range", "a deviation cannot be below zero", call.arguments[1].value->span);
            pair.reset();
        }
    }
    std::optional<Ends> within;
    if (range != nullptr) {
        std::optional<Number> beside;
        if (pair) beside = Number{pair->first, mean->origin};
        within = ends(*range_expression, *range, operand, beside);
        if (!within) return std::nullopt;
    }
    if (!pair) return std::nullopt;
    SourceSpan from = origin(expression, {mean->origin, deviation->origin});
    Quantity drawn = pair->first;
    if (!within) {
        drawn.value += pair->second.value * to_normal(bits(k, place));
        if (place.whole) drawn.value = std::round(drawn.value);
        return quantity(expression, drawn, from);
    }
    const auto like = within->dimension;
    const auto centre = adapted(pair->first, unit(mean->origin), like);
    const auto spread = adapted(pair->second, unit(deviation->origin), like);
    if (!centre || !spread) {
        return fail("language.wrong-kind",
                    "cannot keep " + std::string(kind_of(pair->first)) + " in a range of " + std::string(kind_of(like)),
                    range_expression->span);
    }
    if (!std::isfinite(centre->value) || !std::isfinite(spread->value)) {
        return fail("language.not-finite", "this has no finite value", expression.span);
    }
    drawn = like;
    drawn.value = draw_normal_between(centre->value, spread->value, within->low, within->high, bits(k, place));
    if (place.whole) {
        const double low = std::ceil(within->low), high = std::floor(within->high);
        if (low > high) {
            return fail("language.empty-range", "there is no whole number in this range", range_expression->span);
        }
        drawn.value = std::min(std::max(std::round(drawn.value), low), high);
    }
    return quantity(expression, drawn, origin(expression, {from, within->origin}));
}

std::optional<std::size_t> Evaluator::run_race(const Expression& expression, std::span<const Value> candidates,
                                               std::span<const double> weights, std::uint32_t k, Place place) {
    const Key key = place.by_shape && at_.shape_key ? *at_.shape_key : at_.site.key;
    const std::vector<Key> keys = candidate_keys(candidates);
    const std::size_t winner = race(at_.site.seed, key, choice_name(at_.site.name, k), keys, weights);
    if (winner < candidates.size()) return winner;
    return fail("language.no-alternative", "no alternative has a weight above zero", expression.span);
}

Maybe Evaluator::one_of(const Expression& expression, const CallExpression& call, Place place) {
    const std::uint32_t k = ++choices_;
    std::vector<Value> candidates;
    std::vector<double> weights;
    bool complete = true;
    for (const CallArgument& argument : call.arguments) {
        Maybe candidate = part(argument.key ? argument.key : argument.value, place, expression);
        double weight = 1;
        if (argument.key) {
            const auto given = plain_number(argument.value, operand_place(place), expression, "a weight");
            if (given && *given < 0) {
                fail("language.out-of-range", "a weight cannot be below zero", argument.value->span);
            }
            complete = complete && given && *given >= 0;
            weight = given.value_or(0);
        }
        complete = complete && candidate;
        if (!complete) continue;
        candidates.push_back(std::move(*candidate));
        weights.push_back(weight);
    }
    if (!complete) return std::nullopt;
    if (candidates.size() == 1 && std::holds_alternative<ValueList>(candidates[0].data)) {
        Value list = std::move(candidates[0]);
        candidates = std::move(std::get<ValueList>(list.data).items);
        weights.assign(candidates.size(), 1.0);
    }
    const std::optional<std::size_t> winner = run_race(expression, candidates, weights, k, place);
    if (!winner) return std::nullopt;
    return std::move(candidates[*winner]);
}

}  // namespace filigree
