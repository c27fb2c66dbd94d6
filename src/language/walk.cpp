#include "language/walk.h"

#include <algorithm>

#include "language/evaluate.h"
#include "language/functions.h"
#include "language/shape_forms.h"

namespace filigree {

Place operand_place(Place place) { return {false, false, false, place.by_shape}; }

Place operand_place(Place place, BinaryOperator op) {
    Place operand = operand_place(place);
    switch (op) {
        case BinaryOperator::add:
        case BinaryOperator::subtract:
        case BinaryOperator::multiply:
            operand.whole = place.whole;
            operand.shapes = place.shapes;
            break;
        case BinaryOperator::meet:
            operand.shapes = place.shapes;
            break;
        default:
            break;
    }
    operand.result = operand.shapes && place.result;
    return operand;
}

const ParameterDescription* parameter_of(const OperatorDescription& form, const CallArgument& argument,
                                         std::size_t positional) {
    const std::vector<ParameterDescription>& parameters = form.parameters;
    if (argument.key) {
        const auto* key = std::get_if<NameReference>(&argument.key->node);
        const auto named = std::find_if(parameters.begin(), parameters.end(), [key](const auto& parameter) {
            return key != nullptr && has_name(parameter, key->name);
        });
        return named == parameters.end() ? nullptr : &*named;
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (i == positional || parameters[i].repeats) return &parameters[i];
    }
    return nullptr;
}

Place shape_argument_place(Place place, std::string_view call, const CallArgument& argument, std::size_t positional) {
    const OperatorDescription* form = find_shape_form(call);
    const ParameterDescription* parameter = form == nullptr ? nullptr : parameter_of(*form, argument, positional);
    Place at = operand_place(place);
    if (parameter == nullptr) return at;
    at.whole = parameter->type == ParameterType::whole;
    at.symbols = parameter->type == ParameterType::colour;
    at.shapes = parameter->type == ParameterType::any;
    at.result = at.symbols || at.shapes;
    return at;
}

namespace {

struct PartLister {
    Place place;
    bool any_call = false;
    std::vector<PlacedExpression> parts = {};

    void add(const ExpressionPtr& part, Place at) {
        if (part) parts.push_back({part.get(), at});
    }

    void operator()(const NumberLiteral&) {}
    void operator()(const TextLiteral&) {}
    void operator()(const ColourLiteral&) {}
    void operator()(const BoolLiteral&) {}
    void operator()(const NameReference&) {}
    void operator()(const ListExpression& list) {
        for (const ExpressionPtr& item : list.items) add(item, place);
    }
    void operator()(const PointExpression& point) {
        for (const ExpressionPtr& coordinate : point.coordinates) add(coordinate, operand_place(place));
    }
    void operator()(const UnaryExpression& unary) {
        add(unary.operand,
            unary.op == UnaryOperator::negate ? operand_place(place, BinaryOperator::subtract) : operand_place(place));
    }
    void operator()(const BinaryExpression& binary) {
        add(binary.left, operand_place(place, binary.op));
        add(binary.right, operand_place(place, binary.op));
    }
    void operator()(const ConditionalExpression& conditional) {
        add(conditional.condition, operand_place(place));
        add(conditional.when_true, place);
        add(conditional.when_false, place);
    }
    void operator()(const RangeExpression& range) {
        Place end = operand_place(place);
        end.whole = place.whole;
        add(range.low, end);
        add(range.high, end);
    }
    void operator()(const WithinExpression& within) {
        add(within.value, place);
        if (!within.range) return;
        if (const auto* range = std::get_if<RangeExpression>(&within.range->node)) {
            add(range->low, operand_place(place));
            add(range->high, operand_place(place));
        } else {
            add(within.range, operand_place(place));
        }
    }
    void operator()(const CallExpression& call) {
        if (call.name == "one_of") {
            for (const CallArgument& argument : call.arguments) {
                add(argument.key ? argument.key : argument.value, place);
                if (argument.key) add(argument.value, operand_place(place));
            }
            return;
        }
        if (place.shapes && place.result && find_shape_form(call.name) != nullptr) {
            std::size_t positional = 0;
            for (const CallArgument& argument : call.arguments) {
                add(argument.value, shape_argument_place(place, call.name, argument, positional));
                if (!argument.key) ++positional;
            }
            return;
        }
        Place argument_place = operand_place(place);
        if (call.name == "each") {
            argument_place = place;
            argument_place.by_shape = true;
        } else if (any_call && place.result && !is_special_form(call.name) && find_function(call.name) == nullptr) {
            argument_place.result = true;
            argument_place.symbols = true;
        }
        for (const CallArgument& argument : call.arguments) add(argument.value, argument_place);
    }
    void operator()(const MemberExpression&) {}
};

// Whether any node of the tree satisfies the predicate; how many do.
template <class Predicate>
std::uint32_t count_nodes(const Expression& root, Predicate predicate, std::uint32_t enough) {
    std::uint32_t count = 0;
    std::vector<const Expression*> open{&root};
    while (!open.empty() && count < enough) {
        const Expression& expression = *open.back();
        open.pop_back();
        if (predicate(expression)) ++count;
        for (const PlacedExpression& part : parts_of(expression)) open.push_back(part.expression);
    }
    return count;
}

}  // namespace

std::vector<PlacedExpression> parts_of(const Expression& expression, Place place, bool any_call) {
    PartLister lister{place, any_call};
    std::visit(lister, expression.node);
    return std::move(lister.parts);
}

bool is_choice(const Expression& expression) {
    if (std::holds_alternative<RangeExpression>(expression.node)) return true;
    const auto* call = std::get_if<CallExpression>(&expression.node);
    return call != nullptr && (call->name == "one_of" || call->name == "normal");
}

std::uint32_t count_choices(const Expression& expression) { return count_nodes(expression, is_choice, UINT32_MAX); }

bool has_choice(const Expression& expression) { return count_nodes(expression, is_choice, 1) > 0; }

bool varies_by_shape(const Expression& expression) {
    return count_nodes(
               expression,
               [](const Expression& part) {
                   const auto* call = std::get_if<CallExpression>(&part.node);
                   return call != nullptr && call->name == "each";
               },
               1) > 0;
}

std::string dotted_name(const Expression& expression) {
    std::vector<const std::string*> members;
    const Expression* root = &expression;
    while (const auto* member = std::get_if<MemberExpression>(&root->node)) {
        if (!member->object) return {};
        members.push_back(&member->name);
        root = member->object.get();
    }
    const auto* name = std::get_if<NameReference>(&root->node);
    if (name == nullptr) return {};
    std::string out = name->name;
    for (auto member = members.rbegin(); member != members.rend(); ++member) out += "." + **member;
    return out;
}

std::vector<NameInExpression> names_in(const Expression& root) {
    std::vector<NameInExpression> out;
    std::vector<const Expression*> open{&root};
    while (!open.empty()) {
        const Expression& expression = *open.back();
        open.pop_back();
        if (const auto* call = std::get_if<CallExpression>(&expression.node)) {
            out.push_back({call->name, call->name_span == SourceSpan{} ? expression.span : call->name_span});
        }
        std::string name = dotted_name(expression);
        if (!name.empty()) out.push_back({std::move(name), expression.span});
        const std::vector<PlacedExpression> parts = parts_of(expression);
        for (auto part = parts.rbegin(); part != parts.rend(); ++part) open.push_back(part->expression);
    }
    return out;
}

std::vector<WeightedExpression> candidates_of(const CallExpression& one_of) {
    std::vector<WeightedExpression> out;
    for (const CallArgument& argument : one_of.arguments) {
        if (argument.key) {
            out.push_back({argument.key.get(), argument.value.get()});
        } else {
            out.push_back({argument.value.get(), nullptr});
        }
    }
    return out;
}

}  // namespace filigree
