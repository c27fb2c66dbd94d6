#include "language/evaluate.h"

#include <algorithm>
#include <cmath>

#include "language/description.h"
#include "language/evaluator.h"
#include "language/functions.h"
#include "language/names.h"

namespace filigree {

using Maybe = std::optional<Value>;

std::optional<Value> Evaluator::value(const Expression& expression, Place place) {
    if (depth_ >= max_evaluation_depth) {
        return fail("language.too-deep", "this expression is nested too deeply", expression.span);
    }
    ++depth_;
    Maybe result = std::visit([&](const auto& data) { return node(expression, data, place); }, expression.node);
    --depth_;
    return result;
}

Maybe Evaluator::quantity(const Expression& expression, const Quantity& quantity, SourceSpan origin) {
    if (!std::isfinite(quantity.value)) {
        return fail("language.not-finite", "this has no finite value", expression.span);
    }
    return Value{quantity, is_bare(quantity) ? origin : expression.span};
}

// A value from elsewhere: found at this expression, but a bare length keeps its unit. How much of shapes is taken over
// is bounded, for a name may hold another one twice.
Maybe Evaluator::here(const Expression& expression, const Value& value) {
    if (const Quantity* known = std::get_if<Quantity>(&value.data)) {
        return quantity(expression, *known, origin(expression, {value.span}));
    }
    if (at_.shapes) {
        const ValueSize size = size_of(value);
        shape_parts_ += size.parts;
        if (size.depth > max_evaluation_depth) {
            return fail("language.too-deep", "this shape is nested too deeply", expression.span);
        }
        if (shape_parts_ > max_shape_parts) {
            return fail("language.large-shape", "this shape has more than 100000 parts", expression.span);
        }
    }
    return Value{value.data, expression.span};
}

std::optional<Number> Evaluator::number(const ExpressionPtr& expression, Place place, const Expression& whole) {
    const Maybe found = part(expression, place, whole);
    if (!found) return std::nullopt;
    const Quantity* quantity = std::get_if<Quantity>(&found->data);
    if (quantity == nullptr) {
        return fail("language.wrong-kind", "a number is needed here, but this is " + std::string(kind_of(*found)),
                    expression->span);
    }
    return Number{*quantity, found->span};
}

std::optional<double> Evaluator::plain_number(const ExpressionPtr& expression, Place place, const Expression& whole,
                                              std::string_view what) {
    const std::optional<Number> found = number(expression, place, whole);
    if (!found) return std::nullopt;
    if (!is_bare(found->quantity)) {
        return fail("language.wrong-kind",
                    std::string(what) + " must be a plain number, but this is " + std::string(kind_of(found->quantity)),
                    expression->span);
    }
    return found->quantity.value;
}

std::optional<bool> Evaluator::condition(const ExpressionPtr& expression, Place place, const Expression& whole) {
    const Maybe found = part(expression, place, whole);
    if (!found) return std::nullopt;
    Result<bool> flag = as_flag(*found);
    if (flag) return *flag;
    Diagnostic diagnostic = std::move(flag).diagnostics().front();
    diagnostic.span = expression->span;
    return fail(std::move(diagnostic));
}

Maybe Evaluator::node(const Expression& expression, const NumberLiteral& literal, Place) {
    return quantity(expression, quantity_of(literal), expression.span);
}
Maybe Evaluator::node(const Expression& expression, const TextLiteral& literal, Place) {
    return Value{literal.text, expression.span};
}
Maybe Evaluator::node(const Expression& expression, const ColourLiteral& literal, Place) {
    return Value{literal.colour, expression.span};
}
Maybe Evaluator::node(const Expression& expression, const BoolLiteral& literal, Place) {
    return Value{literal.value, expression.span};
}
Maybe Evaluator::node(const Expression& expression, const NameReference& name, Place place) {
    return named(expression, name.name, place);
}

Maybe Evaluator::named(const Expression& expression, std::string_view name, Place place) {
    if (is_word(at_, name, place)) return Value{Symbol{std::string(name)}, expression.span};
    if (const Value* found = find_value(at_, name, place.by_shape)) {
        return here(expression, *found);
    }
    if (place.symbols) return Value{Symbol{std::string(name)}, expression.span};
    return fail(unknown_name(name, expression.span, at_, place));
}

Maybe Evaluator::node(const Expression& expression, const MemberExpression&, Place place) {
    const std::string name = dotted_name(expression);
    if (name.empty()) return fail("language.wrong-kind", "only names have parts, as in page.width", expression.span);
    place.result = place.symbols = false;
    return named(expression, name, place);
}

Maybe Evaluator::node(const Expression& expression, const ListExpression& list, Place place) {
    ValueList items;
    items.items.reserve(list.items.size());
    bool complete = true;
    for (const ExpressionPtr& item : list.items) {
        Maybe found = part(item, place, expression);
        complete = complete && found;
        if (complete) items.items.push_back(std::move(*found));
    }
    if (!complete) return std::nullopt;
    return Value{std::move(items), expression.span};
}

Maybe Evaluator::node(const Expression& expression, const PointExpression& point, Place place) {
    std::vector<double> coordinates;
    for (const ExpressionPtr& coordinate : point.coordinates) {
        const std::optional<Number> found = number(coordinate, operand_place(place), expression);
        if (!found) continue;
        const std::optional<Quantity> length = adapted(found->quantity, unit(found->origin), Quantity{0, 1, false});
        if (!length) {
            fail("language.wrong-kind",
                 "a coordinate must be a length, but this is " + std::string(kind_of(found->quantity)),
                 coordinate->span);
            continue;
        }
        if (!quantity(*coordinate, *length, coordinate->span)) continue;
        coordinates.push_back(length->value);
    }
    if (coordinates.size() != point.coordinates.size()) return std::nullopt;
    if (coordinates.size() != 2) {
        return fail("language.wrong-kind", "a point of the plane has two coordinates", expression.span);
    }
    return Value{Vec{coordinates[0], coordinates[1]}, expression.span};
}

Maybe Evaluator::node(const Expression& expression, const ConditionalExpression& conditional, Place place) {
    const std::optional<bool> flag = condition(conditional.condition, operand_place(place), expression);
    if (!flag) return std::nullopt;
    if (!*flag) skip(conditional.when_true);
    Maybe result = part(*flag ? conditional.when_true : conditional.when_false, place, expression);
    if (*flag) skip(conditional.when_false);
    return result;
}

Maybe Evaluator::node(const Expression& expression, const CallExpression& call, Place place) {
    const CallMeaning meaning = meaning_of(call, at_, place);
    std::optional<Diagnostic> wrong = wrong_arguments(call, meaning, expression.span);
    if (meaning == CallMeaning::none) {
        wrong = unknown_call(call, call.name_span == SourceSpan{} ? expression.span : call.name_span, at_, place);
    }
    if (wrong) return fail(std::move(*wrong));
    switch (meaning) {
        case CallMeaning::function:
            return function(expression, call, place);
        case CallMeaning::list:
            return list_item(expression, call, place);
        case CallMeaning::symbolic:
            return symbolic(expression, call, place);
        default:
            break;
    }
    if (call.name == "one_of") return one_of(expression, call, place);
    if (call.name == "each") return each(expression, call, place);
    return normal(expression, call, nullptr, nullptr, place);
}

Maybe Evaluator::each(const Expression& expression, const CallExpression& call, Place place) {
    if (!at_.by_shape && (at_.shape_scope == nullptr || !at_.shape_key)) {
        return fail(each_outside(expression.span));
    }
    place.by_shape = true;
    return part(call.arguments[0].value, place, expression);
}

Maybe Evaluator::function(const Expression& expression, const CallExpression& call, Place place) {
    const Function& found = *find_function(call.name);
    std::vector<FunctionArgument> arguments;
    std::vector<SourceSpan> origins;
    for (const CallArgument& argument : call.arguments) {
        const std::optional<Number> one = number(argument.value, operand_place(place), expression);
        if (!one) continue;
        arguments.push_back({one->quantity, unit(one->origin)});
        origins.push_back(one->origin);
    }
    if (arguments.size() != call.arguments.size()) return std::nullopt;
    const FunctionResult result = found.call(arguments, unit(expression.span));
    if (const FunctionProblem* problem = std::get_if<FunctionProblem>(&result)) {
        const std::size_t which = std::min(problem->argument, call.arguments.size() - 1);
        return fail(problem->code, problem->message, call.arguments[which].value->span);
    }
    SourceSpan from = expression.span;
    for (const SourceSpan& one : origins) {
        if (from == expression.span) from = origin(expression, {one});
    }
    return quantity(expression, std::get<Quantity>(result), from);
}

Maybe Evaluator::list_item(const Expression& expression, const CallExpression& call, Place place) {
    const std::optional<double> place_in_list =
        plain_number(call.arguments[0].value, operand_place(place), expression, "the place in a list");
    if (!place_in_list) return std::nullopt;
    const ValueList& list = std::get<ValueList>(find_value(at_, call.name, place.by_shape)->data);
    if (list.items.empty()) return fail("language.wrong-kind", "'" + call.name + "' is empty", expression.span);
    if (*place_in_list != std::round(*place_in_list)) {
        return fail("language.out-of-range", "the place in a list must be a whole number",
                    call.arguments[0].value->span);
    }
    const double count = static_cast<double>(list.items.size());
    double index = std::fmod(*place_in_list - 1, count);
    if (index < 0) index += count;
    return here(expression, list.items[static_cast<std::size_t>(index)]);
}

Maybe Evaluator::symbolic(const Expression& expression, const CallExpression& call, Place place) {
    SymbolicCall result{call.name, {}};
    Place argument_place = operand_place(place);
    argument_place.result = argument_place.symbols = bare_words_in_calls(at_);
    const OperatorDescription* form = at_.forms == nullptr ? nullptr : find_operator(*at_.forms, call.name);
    std::size_t positional = 0;
    bool complete = true;
    for (const CallArgument& argument : call.arguments) {
        if (place.shapes) {
            argument_place = shape_argument_place(place, call.name, argument, positional);
        } else {
            const ParameterDescription* parameter =
                form == nullptr ? nullptr : parameter_of(*form, argument, positional);
            argument_place.whole = parameter != nullptr && parameter->type == ParameterType::whole;
        }
        if (!argument.key) ++positional;
        Maybe found = part(argument.value, argument_place, expression);
        complete = complete && found;
        if (!complete) continue;
        NamedValue named_value{{}, std::move(*found), {}};
        if (argument.key) {
            named_value.name = std::get<NameReference>(argument.key->node).name;
            named_value.name_span = argument.key->span;
        }
        result.arguments.push_back(std::move(named_value));
    }
    if (!complete) return std::nullopt;
    return Value{std::move(result), expression.span};
}

Result<Value> evaluate(const Expression& expression, const Evaluation& at) {
    Evaluator evaluator(at);
    std::optional<Value> result = evaluator.value(expression, top_place(at));
    if (!result) return std::move(evaluator.diagnostics);
    return std::move(*result);
}

std::vector<FunctionDescription> function_descriptions() {
    std::vector<FunctionDescription> out;
    for (const Function& function : functions()) out.push_back({function.signature, function.help});
    out.push_back({"one_of(a, b, ...)", "a choice among values, with weights as one_of(a: 3, b: 1), or among a list"});
    out.push_back(
        {"normal(mean, deviation)", "a choice from the normal distribution; `in low..high` keeps it in a range"});
    out.push_back({"each(value)", "evaluated for every shape of the step, which knows index, x, y, i and j"});
    out.push_back({"LIST(k)", "the k-th item of a palette or list, from 1, over and over"});
    return out;
}

}  // namespace filigree
