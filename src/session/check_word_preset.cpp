#include "session/check_word_preset.h"

#include "engines/rewriting/word_choices.h"
#include "language/check.h"

namespace filigree {
namespace {

using rewriting::Rule;
using rewriting::Successor;

std::string name_in(const Expression& expression) {
    const auto* text = std::get_if<TextLiteral>(&expression.node);
    const auto* word = std::get_if<NameReference>(&expression.node);
    return text != nullptr ? text->text : word != nullptr ? word->name : "";
}
bool is_name(const Expression& expression) {
    return std::holds_alternative<TextLiteral>(expression.node) ||
           std::holds_alternative<NameReference>(expression.node);
}

// The names of all successors.
std::string listed(const std::vector<const Rule*>& rules) {
    std::string list;
    for (const Rule* rule : rules) {
        for (const Successor& successor : rule->successors) {
            list += (list.empty() ? "\"" : ", \"") + successor.name + "\"";
        }
    }
    return list;
}

std::optional<Diagnostic> wrong_letters(const Expression& value) {
    if (is_name(value)) return std::nullopt;
    return error("preset.no-letters", "what a macro becomes is written in quotes", value.span, {"as in \"abba\""});
}

std::optional<Diagnostic> wrong_successor(const Expression& expression, const std::vector<const Rule*>& rules) {
    const auto* number = std::get_if<NumberLiteral>(&expression.node);
    if (!is_name(expression) && number == nullptr) {
        return error("preset.not-a-rule", "the value of a rule is one of its successors in quotes, or its number",
                     expression.span, {"there are " + listed(rules)});
    }
    Value value{name_in(expression), {}};
    if (number != nullptr) value.data = Quantity{number->value};
    const bool is_none = number == nullptr && name_in(expression) == rewriting::no_successor;
    if (is_none) return std::nullopt;
    std::vector<std::string_view> names;
    for (const Rule* rule : rules) {
        if (rewriting::successor_named(*rule, value)) return std::nullopt;
        for (const Successor& successor : rule->successors) names.push_back(successor.name);
    }
    std::vector<std::string> hints = did_you_mean(plain_text(value), names);
    if (hints.empty()) hints.push_back("there are " + listed(rules));
    const std::string wanted = number != nullptr ? "number " + to_text(value) : "'" + plain_text(value) + "'";
    return error("preset.unknown-rule", "there is no successor " + wanted + " to be chosen here", expression.span,
                 std::move(hints));
}

}  // namespace

Diagnostics check_word_preset(const PresetStatement& preset, std::span<const WordPathPlace> letters,
                              const Document& document, const Scope& globals) {
    const std::string& parameter = preset.path.parameter;
    if (preset.path.draw != 0) {
        return {error("preset.no-such-draw", "'" + parameter + "' is one choice", preset.path.span)};
    }
    Scope known{&globals};
    for (const rewriting::Register& one : letters[0].grammar->registers) {
        known.names[one.name] = Value{Quantity{one.value}, {}};
    }
    for (const std::string_view fact : rewriting::fact_names) known.names[std::string(fact)] = Value{Quantity{1}, {}};
    Evaluation at;
    at.document = &document;
    at.scope = &known;
    Diagnostics problems;
    if (preset.condition) problems = check_expression(*preset.condition, at);
    at.words = {"*"};
    append(problems, check_expression(*preset.value, at));
    std::vector<const Rule*> rules;  // that draw at these letters, or at one that they jump to
    for (const WordPathPlace& place : letters) {
        for (const Rule& rule : place.grammar->systems[place.system].rules) {
            const bool may_be_meant = parameter == "target" || rule.letter == place.letter;
            if (may_be_meant && rule.successors.size() > 1) rules.push_back(&rule);
        }
    }
    for (const Alternative& alternative : alternatives_of(*preset.value)) {
        const std::optional<Diagnostic> problem = parameter == "letters"
                                                      ? wrong_letters(*alternative.expression)
                                                      : wrong_successor(*alternative.expression, rules);
        if (problem) problems.push_back(*problem);
    }
    return problems;
}

}  // namespace filigree
