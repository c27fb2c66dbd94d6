#include "language/check.h"

#include <algorithm>

#include "language/names.h"
#include "language/walk.h"

namespace filigree {

Scope example_scope(std::span<const std::string_view> names, const Scope* outer) {
    // Nothing round, so that differences and quotients of them are hardly ever zero.
    constexpr double lengths[] = {103.7, 97.1, 211.3, 179.9};
    Scope scope{outer};
    std::size_t used = 0;
    for (const std::string_view name : names) {
        Quantity quantity{static_cast<double>(3 + used % 4), 0, false};
        if (name == "area") quantity = {10069.27, 2, false};
        if (name == "width" || name == "height" || name == "x" || name == "y" || name == "z") {
            quantity = {lengths[used % std::size(lengths)], 1, false};
        }
        scope.names.emplace(std::string(name), Value{quantity, {}});
        ++used;
    }
    return scope;
}

Scope scope_between(const Scope& globals, const Scope* varying) {
    Scope between{&globals};
    for (; varying != nullptr && varying != &globals; varying = varying->outer) {
        between.names.insert(varying->names.begin(), varying->names.end());
    }
    return between;
}

std::vector<std::string_view> varying_names(const Scope& between) {
    std::vector<std::string_view> names(step_names().begin(), step_names().end());
    for (const auto& [name, value] : between.names) names.push_back(name);
    return names;
}

namespace {

std::optional<Diagnostic> wrong_node(const Expression& expression, Place place, const Evaluation& at) {
    if (const auto* name = std::get_if<NameReference>(&expression.node)) {
        if (is_word(at, name->name, place) || place.symbols || find_value(at, name->name, place.by_shape) != nullptr) {
            return std::nullopt;
        }
        return unknown_name(name->name, expression.span, at, place);
    }
    if (std::holds_alternative<MemberExpression>(expression.node)) {
        const std::string name = dotted_name(expression);
        if (name.empty() || find_value(at, name, place.by_shape) != nullptr) return std::nullopt;
        return unknown_name(name, expression.span, at, operand_place(place));
    }
    if (const auto* call = std::get_if<CallExpression>(&expression.node)) {
        const CallMeaning meaning = meaning_of(*call, at, place);
        if (meaning == CallMeaning::none) {
            return unknown_call(*call, call->name_span == SourceSpan{} ? expression.span : call->name_span, at, place);
        }
        if (call->name == "each" && !at.by_shape && at.shape_scope == nullptr) return each_outside(expression.span);
        return wrong_arguments(*call, meaning, expression.span);
    }
    return std::nullopt;
}

// Visits every node, parents first and in the order of the text, until the visitor returns false.
template <class Visitor>
void visit_nodes(const Expression& root, const Evaluation& at, Visitor visitor) {
    const bool any_call = bare_words_in_calls(at);
    std::vector<PlacedExpression> open{{&root, top_place(at)}};
    while (!open.empty()) {
        const PlacedExpression node = open.back();
        open.pop_back();
        if (!visitor(*node.expression, node.place)) return;
        const std::vector<PlacedExpression> parts = parts_of(*node.expression, node.place, any_call);
        open.insert(open.end(), parts.rbegin(), parts.rend());
    }
}

void append_new(Diagnostics& to, Diagnostics from) {
    for (Diagnostic& diagnostic : from) {
        if (std::find(to.begin(), to.end(), diagnostic) == to.end()) to.push_back(std::move(diagnostic));
    }
}

}  // namespace

bool depends_on_values(const Diagnostic& diagnostic) {
    return diagnostic.code == "language.not-finite" || diagnostic.code == "language.empty-range" ||
           diagnostic.code == "language.out-of-range" || diagnostic.code == "language.no-alternative";
}

Diagnostics check_expression(const Expression& expression, const Evaluation& at) {
    constexpr std::size_t enough = 50;
    Diagnostics out;
    visit_nodes(expression, at, [&](const Expression& node, Place place) {
        if (std::optional<Diagnostic> wrong = wrong_node(node, place, at)) out.push_back(std::move(*wrong));
        return out.size() < enough;
    });
    if (!out.empty()) return out;
    Evaluation example = at;
    if (example.shape_scope != nullptr && !example.shape_key) example.shape_key = Key{};
    for (const Alternative& alternative : alternatives_of(expression, at.by_shape)) {
        if (alternative.kind == Alternative::Kind::range_end) continue;  // met in its range
        example.by_shape = alternative.by_shape;
        Result<Value> value = evaluate(*alternative.expression, example);
        if (value) continue;
        Diagnostics problems = std::move(value).diagnostics();
        std::erase_if(problems, depends_on_values);
        append_new(out, std::move(problems));
    }
    // What decides between the alternatives.
    example.by_shape = at.by_shape;
    Result<Value> value = evaluate(expression, example);
    if (!value) {
        Diagnostics problems = std::move(value).diagnostics();
        std::erase_if(problems, depends_on_values);
        append_new(out, std::move(problems));
    }
    return out;
}

bool uses_only(const Expression& expression, const Evaluation& at, const Scope* fixed,
               std::span<const std::string_view> varying) {
    bool only = true;
    const auto varies = [&](std::string_view name) {
        return std::find(varying.begin(), varying.end(), name) != varying.end();
    };
    const auto is_fixed = [&](std::string_view name) {
        return !varies(name) && fixed != nullptr && fixed->find(name) != nullptr;
    };
    visit_nodes(expression, at, [&](const Expression& node, Place place) {
        if (const auto* name = std::get_if<NameReference>(&node.node)) {
            const bool is_symbol =
                place.symbols && !varies(name->name) && find_value(at, name->name, place.by_shape) == nullptr;
            only = is_word(at, name->name, place) || is_fixed(name->name) || is_symbol;
        } else if (std::holds_alternative<MemberExpression>(node.node)) {
            only = is_fixed(dotted_name(node));
        } else if (const auto* call = std::get_if<CallExpression>(&node.node)) {
            if (meaning_of(*call, at, place) == CallMeaning::list) only = is_fixed(call->name);
        }
        return only;
    });
    return only;
}

bool is_constant(const Expression& expression, const Evaluation& at, const Scope* fixed,
                 std::span<const std::string_view> varying) {
    return !has_choice(expression) && !varies_by_shape(expression) && uses_only(expression, at, fixed, varying);
}

namespace {

template <class Convert>
Diagnostics check_converted(const Expression& expression, Evaluation at, const Scope& globals,
                            std::span<const std::string_view> varying, Convert convert) {
    Diagnostics out = check_expression(expression, at);
    if (!out.empty()) return out;
    const bool constant = is_constant(expression, at, &globals, varying);
    if (constant) at.scope = &globals;
    Result<Value> value = evaluate(expression, at);
    if (value) {
        value->span = expression.span;
        out = convert(*value);
    } else {
        out = std::move(value).diagnostics();
    }
    if (!constant) std::erase_if(out, depends_on_values);
    return out;
}

template <class Convert>
Diagnostics check_in_rule(const Expression& expression, const Document& document, const Scope& globals,
                          const Scope* varying, Convert convert) {
    const Scope between = scope_between(globals, varying);
    const Scope example = example_scope(step_names(), &between);
    Evaluation at;
    at.document = &document;
    at.scope = &example;
    return check_converted(expression, at, globals, varying_names(between), convert);
}

Diagnostics problems_of_flag(const Value& value) { return as_flag(value).diagnostics(); }

}  // namespace

Diagnostics check_condition(const Expression& expression, const Document& document, const Scope& globals,
                            const Scope* varying) {
    return check_in_rule(expression, document, globals, varying, problems_of_flag);
}

Diagnostics check_condition(const Expression& expression, const Evaluation& at, const Scope& globals,
                            std::span<const std::string_view> varying) {
    return check_converted(expression, at, globals, varying, problems_of_flag);
}

Diagnostics check_weight(const Expression& expression, const Document& document, const Scope& globals,
                         const Scope* varying) {
    return check_in_rule(expression, document, globals, varying, [](const Value& value) {
        const Result<double> weight = as_number(value);
        if (!weight) return weight.diagnostics();
        if (*weight >= 0) return Diagnostics{};
        return Diagnostics{error("language.out-of-range", "a weight cannot be below zero", value.span)};
    });
}

std::vector<Alternative> alternatives_of(const Expression& root, bool by_shape) {
    using Kind = Alternative::Kind;
    std::vector<Alternative> out;
    std::vector<Alternative> open{{&root, Kind::value, by_shape}};
    const auto open_part = [&open](const ExpressionPtr& part, Kind kind, bool in_each) {
        if (part) open.push_back({part.get(), kind, in_each});
    };
    while (!open.empty()) {
        const Alternative next = open.back();
        open.pop_back();
        const auto& node = next.expression->node;
        const auto* conditional = std::get_if<ConditionalExpression>(&node);
        const auto* call = std::get_if<CallExpression>(&node);
        const RangeExpression* range = std::get_if<RangeExpression>(&node);
        if (const auto* within = std::get_if<WithinExpression>(&node); within != nullptr && within->range) {
            range = std::get_if<RangeExpression>(&within->range->node);
        }
        if (conditional != nullptr) {
            open_part(conditional->when_false, Kind::value, next.by_shape);
            open_part(conditional->when_true, Kind::value, next.by_shape);
        } else if (range != nullptr && next.kind != Kind::range_end) {
            out.push_back({next.expression, Kind::range, next.by_shape});
            open_part(range->high, Kind::range_end, next.by_shape);
            open_part(range->low, Kind::range_end, next.by_shape);
        } else if (call != nullptr && call->name == "one_of" && !call->arguments.empty()) {
            const Kind kind = call->arguments.size() == 1 ? Kind::items : Kind::value;
            const std::vector<WeightedExpression> candidates = candidates_of(*call);
            for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
                if (candidate->candidate != nullptr) open.push_back({candidate->candidate, kind, next.by_shape});
            }
        } else if (call != nullptr && call->name == "each" && call->arguments.size() == 1) {
            open_part(call->arguments[0].value, Kind::value, true);
        } else {
            out.push_back(next);
        }
    }
    return out;
}

}  // namespace filigree
