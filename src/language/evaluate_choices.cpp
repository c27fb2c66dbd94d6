// Choices: ranges, normal(...) and one_of(...).
#include <algorithm>
#include <cmath>
#include <limits>

#include "language/choice.h"
#include "language/evaluator.h"
#include "language/names.h"

namespace filigree {

using Maybe = std::optional<Value>;

namespace {

Quantity dimension_of(Quantity quantity) {
    quantity.value = 0;
    return quantity;
}

const DrawPreset* preset_of(const ChoiceMaking& making, std::uint32_t k) {
    const auto found = std::find_if(making.draws.begin(), making.draws.end(),
                                    [k](const DrawPreset& preset) { return preset.draw == k; });
    return found != making.draws.end() ? &*found : nullptr;
}

// A bare number takes its dimension from the domain, or from the alternative that it equals.
void adapt(Value& value, Unit unit, const ChoiceDomain& domain) {
    Quantity* quantity = std::get_if<Quantity>(&value.data);
    if (quantity == nullptr || !is_bare(*quantity)) return;
    if (domain.kind != ChoiceDomain::Kind::alternatives) {
        if (const auto like = adapted(*quantity, unit, domain.dimension)) *quantity = *like;
        return;
    }
    for (const Value& alternative : domain.alternatives) {
        const Quantity* known = std::get_if<Quantity>(&alternative.data);
        if (known != nullptr && adapted(*quantity, unit, *known) == *known) {
            *quantity = *known;
            return;
        }
    }
}

}  // namespace

std::optional<double> Evaluator::choose(const Expression& expression, std::uint32_t k, Place place,
                                        const ChoiceDomain& domain) {
    const Key key = place.by_shape && at_.shape_key ? *at_.shape_key : at_.site.key;
    ChoiceNames names{choice_name(at_.site.name, k), {}};
    if (at_.choices == nullptr) return draw_from(domain, at_.site.seed, key, names.drawn);
    const ChoiceMaking& making = *at_.choices;
    const ChoiceAddress* elsewhere = at_.site.recorded_at;
    const Key recorded_key = elsewhere != nullptr ? elsewhere->key : key;
    if (elsewhere != nullptr) names.recorded = choice_name(elsewhere->name, k);
    const std::string& name = elsewhere != nullptr ? names.recorded : names.drawn;
    if (const DrawPreset* preset = preset_of(making, k)) return preset_draw(expression, *preset, names, place, domain);

    const Value* replayed = making.replay != nullptr ? making.replay->find(recorded_key, name) : nullptr;
    ChoiceSource source = making.source;
    double value = 0;
    if (replayed != nullptr) {
        const std::optional<double> found = place_in(domain, *replayed);
        if (!found) {
            return fail("choices.outside-domain",
                        "the recorded " + text_with_unit(*replayed) + " of '" + name + "' does not lie in " +
                            domain_text(domain),
                        expression.span);
        }
        value = *found;
        source = ChoiceSource::replayed;
    } else if (!making.is_random) {
        value = middle_of(domain);
        if (source == ChoiceSource::drawn) source = ChoiceSource::middle;
    } else {
        value = draw_from(domain, at_.site.seed, key, names.drawn);
    }
    if (making.record != nullptr) record(*making.record, &expression, name, domain, recorded_key, value, source);
    return value;
}

// The preset's value lies in the choice's own domain, so that nothing else of the expression needs to know of it.
std::optional<double> Evaluator::preset_draw(const Expression& expression, const DrawPreset& preset,
                                             const ChoiceNames& names, Place place, const ChoiceDomain& domain) {
    place.by_shape = place.by_shape || preset.by_shape;
    ChoiceMaking making = *at_.choices;
    making.source = preset.source;
    making.draws = {};
    Evaluation at = at_;
    at.choices = &making;
    at.site.name = names.drawn;
    const bool by_shape = place.by_shape || varies_by_shape(*preset.value);
    ChoiceAddress recorded_at{by_shape && at.shape_key ? *at.shape_key : at.site.key, names.drawn};
    if (at.site.recorded_at != nullptr) {
        recorded_at = {at.site.recorded_at->key, names.recorded};
        at.site.recorded_at = &recorded_at;
    }
    if (preset.document != nullptr) at.document = preset.document;
    if (preset.scope != nullptr) at.scope = preset.scope;
    if (preset.shape_scope != nullptr) at.shape_scope = preset.shape_scope;

    const std::size_t recorded = making.record != nullptr ? making.record->rows.size() : 0;
    Evaluator inner(at);
    inner.depth_ = depth_;
    Maybe value = inner.value(*preset.value, place);
    for (Diagnostic& problem : inner.diagnostics) fail(std::move(problem));
    if (!value) return std::nullopt;
    adapt(*value, bare_unit(at.document, value->span), domain);
    const std::optional<double> found = place_in(domain, *value);
    if (!found) {
        return fail(
            "preset.outside-domain",
            "'" + recorded_at.name + "' must lie in " + domain_text(domain) + ", but this is " + text_with_unit(*value),
            preset.value->span);
    }
    // What the preset's own choices are is recorded already.
    if (making.record != nullptr && making.record->rows.size() == recorded) {
        record(*making.record, &expression, recorded_at.name, domain, recorded_at.key, *found, preset.source);
    }
    return found;
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
    ChoiceDomain domain{ChoiceDomain::Kind::range, place.whole, dimension_of(found->dimension)};
    domain.low = place.whole ? std::ceil(found->low) : found->low;
    domain.high = place.whole ? std::floor(found->high) : found->high;
    if (domain.low > domain.high) {
        return fail("language.empty-range", "there is no whole number in this range", expression.span);
    }
    const std::optional<double> value = choose(expression, k, place, domain);
    if (!value) return std::nullopt;
    Quantity chosen = found->dimension;
    chosen.value = *value;
    return quantity(expression, chosen, found->origin);
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
    Quantity chosen = pair->first;
    ChoiceDomain domain{ChoiceDomain::Kind::normal, place.whole};
    domain.mean = pair->first.value;
    domain.deviation = pair->second.value;
    domain.low = -std::numeric_limits<double>::infinity();
    domain.high = std::numeric_limits<double>::infinity();
    if (within) {
        chosen = within->dimension;
        const auto centre = adapted(pair->first, unit(mean->origin), chosen);
        const auto spread = adapted(pair->second, unit(deviation->origin), chosen);
        if (!centre || !spread) {
            return fail(
                "language.wrong-kind",
                "cannot keep " + std::string(kind_of(pair->first)) + " in a range of " + std::string(kind_of(chosen)),
                range_expression->span);
        }
        domain.mean = centre->value;
        domain.deviation = spread->value;
        domain.low = within->low;
        domain.high = within->high;
        from = origin(expression, {from, within->origin});
        if (place.whole && std::ceil(domain.low) > std::floor(domain.high)) {
            return fail("language.empty-range", "there is no whole number in this range", range_expression->span);
        }
    }
    if (!std::isfinite(domain.mean) || !std::isfinite(domain.deviation)) {
        return fail("language.not-finite", "this has no finite value", expression.span);
    }
    domain.dimension = dimension_of(chosen);
    const std::optional<double> value = choose(expression, k, place, domain);
    if (!value) return std::nullopt;
    chosen.value = *value;
    return quantity(expression, chosen, from);
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
    if (std::none_of(weights.begin(), weights.end(), [](double weight) { return weight > 0; })) {
        return fail("language.no-alternative", "no alternative has a weight above zero", expression.span);
    }
    ChoiceDomain domain{ChoiceDomain::Kind::alternatives};
    domain.alternatives = std::move(candidates);
    domain.weights = std::move(weights);
    const std::optional<double> winner = choose(expression, k, place, domain);
    if (!winner) return std::nullopt;
    return std::move(domain.alternatives[static_cast<std::size_t>(*winner)]);
}

}  // namespace filigree
