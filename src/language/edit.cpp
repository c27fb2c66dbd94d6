#include "language/edit.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/number_text.h"
#include "base/unicode.h"
#include "language/edit_text.h"
#include "language/evaluate.h"
#include "language/lexer.h"
#include "language/param_domain.h"
#include "language/parse.h"
#include "language/token_text.h"

namespace filigree {

namespace {

// --- the seed --------------------------------------------------------------------------------------------------

std::string with_new_line_at_start(std::string_view text, std::string_view line) {
    const std::size_t first_end = text.find('\n');
    const bool has_returns = first_end != std::string_view::npos && first_end > 0 && text[first_end - 1] == '\r';
    return spliced(text, text_start(text), text_start(text), std::string(line) + (has_returns ? "\r\n" : "\n"));
}

// A statement in the line behind the one that ends at `offset`, or behind it with a ';' where others share its line.
std::string with_new_line_behind(std::string_view text, std::uint32_t offset, std::string_view line) {
    const Token next = read_token(text, offset, LexMode::value, false);
    if (next.kind == TokenKind::semicolon) return spliced(text, offset, offset, "; " + std::string(line));
    if (next.kind == TokenKind::end_of_text) {
        const std::size_t last = text.rfind('\n');
        const bool has_returns = last != std::string_view::npos && last > 0 && text[last - 1] == '\r';
        return spliced(text, text.size(), text.size(), (has_returns ? "\r\n" : "\n") + std::string(line));
    }
    const bool has_returns = text[next.end - 2] == '\r';
    return spliced(text, next.end, next.end, std::string(line) + (has_returns ? "\r\n" : "\n"));
}

// --- parameters --------------------------------------------------------------------------------------------------

const ParamStatement* find_parameter(const Document& document, std::string_view name) {
    for (const Statement& statement : document.statements) {
        const ParamStatement* param = std::get_if<ParamStatement>(&statement.node);
        if (param != nullptr && param->name.span.file == 0 && param->name.text == name) return param;
    }
    return nullptr;
}

Diagnostic unknown_parameter(const Document& document, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Statement& statement : document.statements) {
        const ParamStatement* param = std::get_if<ParamStatement>(&statement.node);
        if (param == nullptr) continue;
        if (param->name.text == name) {
            return error("edit.included-parameter",
                         "the parameter " + in_quotes(name) + " belongs to the included file " +
                             in_quotes(document.sources[param->name.span.file].name),
                         {}, {"change it there"});
        }
        if (param->name.span.file == 0) names.push_back(param->name.text);
    }
    return error("edit.unknown-parameter", "there is no parameter " + in_quotes(name), {}, did_you_mean(name, names));
}

bool is_defined(const Document& document, std::string_view name) {
    return std::any_of(document.statements.begin(), document.statements.end(), [&](const Statement& statement) {
        const ParamStatement* param = std::get_if<ParamStatement>(&statement.node);
        const LetStatement* let = std::get_if<LetStatement>(&statement.node);
        const PaletteStatement* palette = std::get_if<PaletteStatement>(&statement.node);
        return (param != nullptr && param->name.text == name) || (let != nullptr && let->name.text == name) ||
               (palette != nullptr && palette->name.text == name);
    });
}

// A value that depends neither on other names nor on choices. A word that names nothing means itself.
std::optional<Value> constant(const Expression& expression, const Document& document) {
    if (has_choice(expression)) return std::nullopt;
    const Scope nothing;
    Evaluation at;
    at.document = &document;
    at.scope = &nothing;
    const NameReference* reference = std::get_if<NameReference>(&expression.node);
    if (reference != nullptr && !is_defined(document, reference->name)) at.words = {reference->name};
    Result<Value> value = evaluate(expression, at);
    return value ? std::optional(std::move(*value)) : std::nullopt;
}

std::optional<ParamDomain> constant_domain(const Expression& expression, const Document& document) {
    if (const RangeExpression* range = std::get_if<RangeExpression>(&expression.node)) {
        const std::optional<Value> low = constant(*range->low, document), high = constant(*range->high, document);
        if (!low || !high) return std::nullopt;
        Result<ParamDomain> domain = range_domain(*low, *high, document, expression.span);
        return domain ? std::optional(std::move(*domain)) : std::nullopt;
    }
    ParamDomain domain;
    for (const ExpressionPtr& item : items_of_domain(expression)) {
        std::optional<Value> value = constant(*item, document);
        if (!value) return std::nullopt;
        domain.alternatives.push_back(std::move(*value));
    }
    return domain.alternatives.empty() ? std::nullopt : std::optional(std::move(domain));
}

// Why a value, or an end of the range that it is drawn from, is outside a constant domain.
std::optional<Diagnostic> outside_domain(const Expression& value, const Expression& domain_expression,
                                         const Document& document) {
    const std::optional<ParamDomain> domain = constant_domain(domain_expression, document);
    if (!domain) return std::nullopt;
    const RangeExpression* range = std::get_if<RangeExpression>(&value.node);
    const Expression* const first = range != nullptr ? range->low.get() : &value;
    const Expression* const last = range != nullptr ? range->high.get() : &value;
    for (const Expression* part : {first, last}) {
        const std::optional<Value> known = constant(*part, document);
        if (!known) continue;
        if (std::optional<Diagnostic> problem = outside(*domain, *known, document, {})) return problem;
    }
    return std::nullopt;
}

// Whether a `?` or an `in` of the value, outside brackets, would meet the statement's own words.
bool meets_statement(const Expression& value) {
    if (const ConditionalExpression* conditional = std::get_if<ConditionalExpression>(&value.node)) {
        return conditional->condition->span.begin == value.span.begin;
    }
    const WithinExpression* within = std::get_if<WithinExpression>(&value.node);
    return within != nullptr && within->value->span.begin == value.span.begin;
}

}  // namespace

std::string with_seed(const Document& document, std::uint64_t seed) {
    const std::string& text = document.text();
    const std::string digits = to_text(seed);
    std::optional<std::uint32_t> behind_grammar, behind_version;
    for (const Statement& statement : document.statements) {
        if (statement.span.file != 0) continue;
        if (const SeedStatement* old = std::get_if<SeedStatement>(&statement.node)) {
            return spliced(text, old->value_span.begin, old->value_span.end, digits);
        }
        if (std::holds_alternative<GrammarStatement>(statement.node) && !behind_grammar) {
            behind_grammar = statement.span.end;
        }
        if (std::holds_alternative<VersionStatement>(statement.node)) behind_version = statement.span.end;
    }
    const std::string line = "seed " + digits;
    const std::optional<std::uint32_t> behind = behind_grammar ? behind_grammar : behind_version;
    return behind ? with_new_line_behind(text, *behind, line) : with_new_line_at_start(text, line);
}

Result<std::string> with_parameter(const Document& document, std::string_view name, std::string_view value) {
    const std::string& text = document.text();
    const std::string wanted = unicode::normalise(name);
    const ParamStatement* param = find_parameter(document, wanted);
    if (param == nullptr) return unknown_parameter(document, wanted);
    Result<ExpressionPtr> parsed = parse_expression(value);
    if (!parsed) return std::move(parsed).diagnostics();
    // Bare lengths are in the document's unit.
    const ExpressionPtr expression = *parse_expression(value, 0);
    if (param->domain) {
        if (std::optional<Diagnostic> problem = outside_domain(*expression, *param->domain, document)) {
            return std::move(*problem);
        }
    }
    std::string written(text_of(*expression, value));
    if (meets_statement(*expression)) {
        written = "(" + written + ")";
        Result<ExpressionPtr> again = parse_expression(written);
        if (!again) return std::move(again).diagnostics();
    }
    // A number must not meet the letters behind it.
    const std::uint32_t end = param->value->span.end;
    const bool is_alone = end == text.size() || std::string_view(" \t\r\n;").find(text[end]) != std::string_view::npos;
    if (!is_alone) written += ' ';
    return spliced(text, param->value->span.begin, end, written);
}

}  // namespace filigree
