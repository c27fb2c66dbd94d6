// Statements that hold statements in braces: system and operator.
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

// system NAME [(parameters)] { statements }
std::optional<SystemStatement> Parser::read_system(const Token& keyword) {
    if (blocks_.size() >= max_system_depth) {
        fail(keyword, error("language.nesting", "systems nest deeper than 32 here", span_of(keyword)));
        return std::nullopt;
    }
    SystemStatement system;
    std::optional<Name> name = read_name("a name");
    if (!name) return std::nullopt;
    system.name = std::move(*name);
    std::string_view wanted = "'(' and parameters, or '{' and statements";
    if (at(TokenKind::open_round)) {
        if (!read_definition_parameters(system.parameters)) return std::nullopt;
        wanted = "'{' and statements";
    }
    std::optional<Block> block = read_block(false, system.statements, wanted);
    if (!block) return std::nullopt;
    system.unit = block->unit;
    return system;
}

// operator NAME(parameters) [-> ports] { rules }
std::optional<OperatorStatement> Parser::read_operator() {
    OperatorStatement definition;
    std::optional<Name> name = read_name("a name");
    if (!name) return std::nullopt;
    definition.name = std::move(*name);
    if (!at(TokenKind::open_round)) {
        fail_expected("language.missing-arguments", "'(' and parameters",
                      {"an operator without parameters is written 'operator " + definition.name.text + "() { ... }'"});
        return std::nullopt;
    }
    if (!read_definition_parameters(definition.parameters)) return std::nullopt;
    std::string_view wanted = "'->' and ports, or '{' and rules";
    if (accept(TokenKind::arrow)) {
        if (!read_ports(definition.ports)) return std::nullopt;
        wanted = "',' or '{' and rules";
    }
    if (!read_block(true, definition.statements, wanted)) return std::nullopt;
    return definition;
}

// Whether a statement with this keyword may stand in the block around it.
bool Parser::may_stand_here(const Token& keyword) {
    if (blocks_.empty()) return true;
    const std::string_view word = bytes_of(keyword);
    if (blocks_.back().has_rules_alone) {
        fail(keyword,
             error("language.not-a-rule", "found " + in_quotes(word) + " inside an operator, which has rules alone",
                   span_of(keyword), {"write it before the operator"}));
    } else if (word == "include") {
        fail(keyword, error("language.include-in-system", "nothing can be included inside a system", span_of(keyword),
                            {"another document is derived inside a shape with 'embed(\"file.fil\")'"}));
    }
    return !has_failed_;
}

// (NAME [= VALUE], ...)
bool Parser::read_definition_parameters(std::vector<DefinitionParameter>& parameters) {
    if (!open_bracket()) return false;
    while (!at(TokenKind::close_round)) {
        if (!parameters.empty()) {
            if (!at(TokenKind::comma)) {
                if (fail_if_unclosed()) return false;
                std::vector<std::string> hints;
                if (at(TokenKind::colon)) hints = {"a parameter's value is written 'size = 3'"};
                fail_expected("language.unexpected-token", parameters.back().value ? "',' or ')'" : "'=', ',' or ')'",
                              std::move(hints));
                return false;
            }
            const Token comma = take();
            if (at(TokenKind::close_round)) {
                fail_trailing_comma(comma);
                return false;
            }
        }
        if (!at(TokenKind::name) && fail_if_unclosed()) return false;
        std::optional<Name> name = read_name("a parameter");
        if (!name) return false;
        parameters.push_back({std::move(*name), nullptr});
        if (!accept(TokenKind::assign)) continue;
        parameters.back().value = read_expression();
        if (!parameters.back().value) return false;
    }
    close_bracket();
    return true;
}

bool Parser::read_ports(std::vector<Name>& ports) {
    do {
        std::optional<Name> port = read_tag(ports.empty() ? "behind '->'" : "behind ','");
        if (!port) return false;
        ports.push_back(std::move(*port));
    } while (accept(TokenKind::comma));
    return true;
}

// The statements in braces; one that is broken costs itself alone.
std::optional<Parser::Block> Parser::read_block(bool has_rules_alone, std::vector<Statement>& into,
                                                std::string_view wanted) {
    if (!at(TokenKind::open_curly)) {
        is_continued_ = at(TokenKind::end_of_line);
        const std::string example = has_rules_alone ? "operator lace() {" : "system dots {";
        fail_behind_value("language.missing-brace", wanted,
                          {"the '{' stands on the line of the name, as in '" + example + "'"});
        return std::nullopt;
    }
    const Token open = take();
    blocks_.push_back({.open = open, .has_rules_alone = has_rules_alone});
    const FirstPlaces outer = std::exchange(first_, {});
    const Rules rules = rules_;
    bool is_closed = false;
    while (!session_.is_full) {
        skip_statement_ends();
        is_closed = accept(TokenKind::close_curly);
        if (is_closed) break;
        const Token first = peek();
        if (first.kind == TokenKind::end_of_text) {
            fail_unclosed(open, first);
            break;
        }
        if (std::optional<Statement> statement = read_statement()) {
            into.push_back(std::move(*statement));
        } else {
            skip_failed_statement(first);
            has_failed_ = false;
            is_continued_ = false;
        }
    }
    has_failed_ = !is_closed;
    Block block = std::move(blocks_.back());
    blocks_.pop_back();
    first_ = outer;
    rules_ = rules;
    return is_closed ? std::optional(std::move(block)) : std::nullopt;
}

}  // namespace filigree
