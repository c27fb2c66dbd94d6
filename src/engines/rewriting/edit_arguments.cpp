#include "engines/rewriting/edit_arguments.h"

#include <algorithm>

#include "engines/rewriting/edit_operators.h"
#include "engines/rewriting/pattern.h"
#include "language/parameter_value.h"

namespace filigree::rewriting {

Result<std::vector<ChunkPair>> put_pairs(const std::vector<WordEdit::Pair>& pairs, const Document& document,
                                         const Scope& names, std::uint64_t most) {
    std::vector<ChunkPair> put;
    for (const WordEdit::Pair& pair : pairs) {
        Result<std::u32string> to = put_text(pair.to, &document, names, most);
        if (!to) return std::move(to).diagnostics();
        put.push_back({pair.from, std::move(*to)});
    }
    return put;
}

Diagnostics EditArguments::evaluate_common(std::uint64_t most) {
    Result<Arguments> arguments = evaluate_arguments(edit_.call, document_, names_, choices_, key_, {});
    if (!arguments) return std::move(arguments).diagnostics();
    common_ = std::move(*arguments);
    const std::vector<ParameterDescription>& parameters = edit_.call.description->parameters;
    letters_.resize(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto* text = std::get_if<std::string>(&common_.values[i].common.data);
        if (parameters[i].type != ParameterType::text || text == nullptr) continue;
        const Result<Pattern> pattern = read_pattern(*text, edit_.call.expressions[i]->span, edit_.frees_braces);
        if (!pattern) return pattern.diagnostics();
        Result<std::u32string> letters = put_text(*pattern, &document_, names_, most);
        if (!letters) return std::move(letters).diagnostics();
        letters_[i] = std::move(*letters);
    }
    return {};
}

std::size_t EditArguments::index_of(std::string_view parameter) const {
    const std::vector<ParameterDescription>& parameters = edit_.call.description->parameters;
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const ParameterDescription& known) { return known.name == parameter; });
    return static_cast<std::size_t>(found - parameters.begin());
}

bool EditArguments::is_given(std::string_view parameter) const { return edit_.call.given[index_of(parameter)]; }

const WordEdit::TokenExpression* EditArguments::find_by_token(std::string_view parameter) const {
    const std::size_t index = index_of(parameter);
    for (const WordEdit::TokenExpression& one : edit_.by_token) {
        if (one.parameter == index) return &one;
    }
    return nullptr;
}

EditArguments::Facts& EditArguments::facts_for(const WordEdit::TokenExpression& expression) {
    for (auto& [parameter, facts] : facts_) {
        if (parameter == expression.parameter) return facts;
    }
    facts_.push_back({expression.parameter, {}});
    Facts& facts = facts_.back().second;
    facts.scope.outer = &names_;
    const std::string_view name = edit_.call.description->parameters[expression.parameter].name;
    for (const EditOperator::TokenParameter& known : edit_.op->by_token) {
        if (known.name != name) continue;
        for (const std::string_view fact : known.facts) {
            facts.values.push_back(&facts.scope.names[std::string(fact)]);
        }
    }
    return facts;
}

std::optional<Value> EditArguments::value_at(std::string_view parameter, std::uint32_t token,
                                             std::span<const Value> known) {
    if (problem_) return std::nullopt;
    const WordEdit::TokenExpression* by_token = find_by_token(parameter);
    if (by_token == nullptr) return common_.value(parameter);
    Facts& facts = facts_for(*by_token);
    for (std::size_t i = 0; i < known.size(); ++i) *facts.values[i] = known[i];
    const ParameterDescription& description = edit_.call.description->parameters[by_token->parameter];
    Evaluation at = edit_.call.expected[by_token->parameter];
    at.document = &document_;
    at.scope = &facts.scope;
    std::uint64_t seed = choices_.seed.value;
    if (!choices_.accepted.empty()) {
        seed = seed_of_parameter(*choices_.presets, choices_.accepted, parameter, choices_.seed);
    }
    at.site = {seed, child(key_, token), std::string(parameter)};
    const ChoiceMaking making{choices_.is_random, ChoiceSource::drawn, choices_.replay, choices_.record, {}};
    at.choices = &making;
    const SourceSpan span = by_token->expression->span;
    Result<Value> value = evaluate(*by_token->expression, at);
    if (value) value = converted(description, *value, document_, span);
    if (!value) {
        problem_ = value.diagnostics().front();
        return std::nullopt;
    }
    problem_ = out_of_range(description, *value, span);
    if (problem_) return std::nullopt;
    return std::move(*value);
}

bool EditArguments::holds(std::string_view parameter, std::uint32_t token, std::span<const Value> facts) {
    const std::optional<Value> value = value_at(parameter, token, facts);
    return value && std::get<bool>(value->data);
}

double EditArguments::number_of(std::string_view parameter, std::uint32_t token, std::span<const Value> facts) {
    const std::optional<Value> value = value_at(parameter, token, facts);
    return value ? std::get<Quantity>(value->data).value : 0;
}

}  // namespace filigree::rewriting
