// Rules of shapes: what stands below `grammar shape` beside the statements of all engines.
#include <algorithm>
#include <utility>

#include "language/parser.h"
#include "language/shape_settings.h"
#include "language/token_text.h"

namespace filigree {
namespace {

constexpr std::string_view rule_example = "a rule is written as in 'slide = petal -> translate(2, 2) * petal'";
constexpr std::string_view match_example = "write it as in 'apply slide at (3, 3) angle 90'";

}  // namespace

Parser::ShapeStatement Parser::shape_statement(const Token& first, bool is_keyword) const {
    const std::string_view word = bytes_of(first);
    const bool is_setting = find_shape_setting(word) != nullptr;
    if (is_shape_rule(first, is_keyword || is_setting || word == "rules")) return ShapeStatement::rule;
    if (is_setting) return ShapeStatement::setting;
    if (word == "rules") return ShapeStatement::rules_from;
    if (is_way_back(first)) return ShapeStatement::back;
    return word == "apply" && is_match(first) ? ShapeStatement::match : ShapeStatement::none;
}

// A reserved word names a rule only where an arrow follows: `match = petal -> lens`.
bool Parser::is_shape_rule(const Token& first, bool is_reserved) const {
    const Token second = token_behind(first);
    if (second.kind == TokenKind::assign) return !is_reserved || has_arrow_behind(second);
    return !is_reserved && has_arrow_behind(first);
}

// Rules may be called `back`.
bool Parser::is_way_back(const Token& first) const {
    return bytes_of(first) == "back" && bytes_of(token_behind(first)) == "to";
}

// Else it is a step of an operator, as group grammars have it: [NAME =] operator(
bool Parser::is_match(const Token& apply) const {
    Token name = token_behind(apply);
    if (name.kind != TokenKind::name) return true;
    Token behind = token_behind(name);
    if (behind.kind == TokenKind::assign) {
        name = token_behind(behind);
        behind = token_behind(name);
    }
    return behind.kind != TokenKind::open_round;
}

bool Parser::has_arrow_behind(const Token& token) const {
    for (Token at = token_behind(token);; at = token_behind(at)) {
        if (at.kind == TokenKind::arrow) return true;
        const bool is_end = at.kind == TokenKind::end_of_line || at.kind == TokenKind::end_of_text ||
                            at.kind == TokenKind::semicolon || at.kind == TokenKind::close_curly;
        if (is_end) return false;
    }
}

void Parser::read_shape_statement(ShapeStatement kind, Statement& statement) {
    const auto put = [&](auto node) {
        if (node) statement.node = std::move(*node);
    };
    if (kind == ShapeStatement::rule) put(read_shape_rule());
    if (kind == ShapeStatement::setting) put(read_shape_setting());
    if (kind == ShapeStatement::rules_from) put(read_rules_from());
    if (kind == ShapeStatement::match) put(read_match());
    if (kind == ShapeStatement::back) put(read_back());
}

// --- rules ------------------------------------------------------------------------------------------------------

// NAME = left -> right {clause}, or NAME = inverse(OTHER)
std::optional<ShapeRule> Parser::read_shape_rule() {
    ShapeRule rule;
    std::optional<Name> name = read_name("a rule");
    if (!name) return std::nullopt;
    rule.name = std::move(*name);
    if (!accept(TokenKind::assign)) {
        fail_expected("language.missing-equals", "'=' behind the name of a rule", {std::string(rule_example)});
        return std::nullopt;
    }
    if (at(TokenKind::arrow)) {
        fail_expected("language.missing-side", "the left side of the rule",
                      {"what a rule adds stands in relation to something that it finds", std::string(rule_example)});
        return std::nullopt;
    }
    rule.left = read_expression();
    if (!rule.left) return std::nullopt;
    if (accept(TokenKind::arrow)) {
        if (!read_right_side(rule)) return std::nullopt;
        return rule;
    }
    if (!at_statement_end() || !std::holds_alternative<CallExpression>(rule.left->node)) {
        fail_without_arrow(rule);
        return std::nullopt;
    }
    rule.derivation = std::move(rule.left);
    return rule;
}

bool Parser::read_right_side(ShapeRule& rule) {
    if (next_line_is_right_side()) skip_line_ends();
    const std::initializer_list<Clause> clauses = {{"match", &rule.match},
                                                   {"weight", &rule.weight},
                                                   {"priority", &rule.priority},
                                                   {"unless", &rule.unless},
                                                   {"when", &rule.condition}};
    const bool is_clause =
        std::any_of(clauses.begin(), clauses.end(), [this](const Clause& clause) { return at_word(clause.word); });
    // A name may be spelt as a clause is; then no number follows.
    if (at_statement_end() || (is_clause && token_behind(peek()).kind == TokenKind::number)) {
        fail_expected("language.missing-side", "the right side of the rule",
                      {"a rule that takes its left side away is written 'name = shape -> empty'"});
        return false;
    }
    rule.right = read_expression();
    return rule.right && read_all_clauses(clauses, "a rule");
}

// Behind an arrow at the line's end, whether no other rule begins there.
bool Parser::next_line_is_right_side() {
    Token word = peek();
    while (word.kind == TokenKind::end_of_line) word = token_behind(word);
    return word.kind != TokenKind::name || token_behind(word).kind != TokenKind::assign;
}

void Parser::fail_without_arrow(const ShapeRule& rule) {
    const Token found = peek();
    const Token behind = token_behind(found);
    if (found.kind == TokenKind::assign && behind.kind == TokenKind::greater) {
        return fail(found, error("language.missing-arrow", "expected '->' and the right side, found '=>'",
                                 span_over(span_of(found), span_of(behind)), {"an arrow is written '->'"}));
    }
    std::vector<std::string> hints = {std::string(rule_example)};
    if (at_statement_end()) hints.push_back("a value with a name is written 'let " + rule.name.text + " = ...'");
    const bool is_call = std::holds_alternative<CallExpression>(rule.left->node);
    if (found.kind == TokenKind::name && is_call)
        hints = {"a rule that follows from another one has no clauses of its own"};
    fail_behind_value("language.missing-arrow", "'->' and the right side", std::move(hints));
}

bool Parser::read_all_clauses(std::initializer_list<Clause> clauses, std::string_view owner) {
    if (!read_clauses(clauses)) return false;
    if (at_statement_end()) return true;
    const Token found = peek();
    const std::string_view word = bytes_of(found);
    if (found.kind != TokenKind::name || word == "and" || word == "or" || word == "mod") return true;
    std::vector<std::string_view> known;
    std::string list;
    for (const Clause& clause : clauses) {
        list += (known.empty() ? "" : ", ") + std::string(clause.word);
        known.push_back(clause.word);
    }
    std::vector<std::string> hints = did_you_mean(word, known);
    if (hints.empty()) hints = {"the clauses are " + list};
    fail(found, error("language.unknown-clause", std::string(owner) + " has no clause " + in_quotes(word),
                      span_of(found), std::move(hints)));
    return false;
}

// rules from "rules.svg"
std::optional<RulesFromStatement> Parser::read_rules_from() {
    take();
    if (!accept_word("from")) {
        fail_expected("language.missing-from", "'from' and a file's name",
                      {"drawn rules are read as in 'rules from \"rules.svg\"'", std::string(rule_example)});
        return std::nullopt;
    }
    SourceSpan span;
    std::optional<std::string> file = read_text("a file's name in quotes", span);
    if (!file) return std::nullopt;
    return RulesFromStatement{{std::move(*file), span}};
}

// --- settings and matches ---------------------------------------------------------------------------------------

// NAME value, or of a list NAME value, value
std::optional<SettingStatement> Parser::read_shape_setting() {
    SettingStatement setting;
    std::optional<Name> name = read_name("a setting");
    if (!name) return std::nullopt;
    setting.name = std::move(*name);
    const ShapeSetting& described = *find_shape_setting(setting.name.text);
    const std::string example = "write it as in '" + std::string(described.example) + "'";
    if (at(TokenKind::assign)) {
        fail_expected("language.lone-equals", "a value, without '='", {example});
        return std::nullopt;
    }
    do {
        if (at_statement_end()) {
            fail_expected("language.missing-value", "a value", {example});
            return std::nullopt;
        }
        ExpressionPtr value = read_expression();
        if (!value) return std::nullopt;
        setting.values.push_back(std::move(value));
    } while (described.is_list && accept(TokenKind::comma));
    if (!at_statement_end()) {
        fail_behind_value("language.unexpected-token",
                          described.is_list ? "',' or the end of the statement" : "the end of the statement",
                          {example});
        return std::nullopt;
    }
    return setting;
}

// back to STATE
std::optional<BackStatement> Parser::read_back() {
    take();
    if (!accept_word("to")) {
        fail_expected("language.missing-to", "'to' and the name of a state",
                      {"a derivation goes back as in 'back to first', behind 'apply first = slide at (3, 3)'"});
        return std::nullopt;
    }
    std::optional<Name> name = read_name("a state, or start");
    if (!name) return std::nullopt;
    return BackStatement{std::move(*name)};
}

// apply [STATE =] NAME at (x, y) {clause}
std::optional<MatchStatement> Parser::read_match() {
    take();
    MatchStatement match;
    if (token_behind(peek()).kind == TokenKind::assign) {
        match.name = read_name("a state");
        if (!match.name) return std::nullopt;
        take();
    }
    std::optional<Name> rule = read_name("a rule");
    if (!rule) return std::nullopt;
    match.rule = std::move(*rule);
    const bool is_read = read_all_clauses({{"at", &match.at},
                                           {"angle", &match.angle},
                                           {"scale", &match.scale},
                                           {"mirrored", &match.is_mirrored},
                                           {"orbit", &match.is_orbit}},
                                          "'apply'");
    if (!is_read) return std::nullopt;
    if (!match.at && at_statement_end()) {
        fail_expected("language.missing-place", "'at' and the point where the match lies",
                      {std::string(match_example)});
        return std::nullopt;
    }
    return match;
}

}  // namespace filigree
