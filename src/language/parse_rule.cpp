// [label =] operator(arguments) : tag [when CONDITION] [weight W] -> tags
#include <algorithm>
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

// A keyword starts a rule only as a label: `start = outline(25) : leaf -> in, out`.
bool Parser::is_rule(const Token& first, bool is_keyword) const {
    const Token second = token_behind(first);
    if (!is_keyword) {
        return second.kind == TokenKind::open_round || second.kind == TokenKind::assign ||
               second.kind == TokenKind::colon;
    }
    if (second.kind != TokenKind::assign) return false;
    const Token third = token_behind(second);
    return third.kind == TokenKind::name && token_behind(third).kind == TokenKind::open_round;
}

std::optional<GroupRule> Parser::read_rule() {
    std::optional<OperatorCall> call = read_call();
    if (!call) return std::nullopt;
    GroupRule rule;
    rule.label = std::move(call->name);
    rule.operator_name = std::move(call->operator_name);
    rule.arguments = std::move(call->arguments);
    if (!accept(TokenKind::colon)) {
        std::vector<std::string> hints = {"a rule is written 'operator(arguments) : tag -> tags'"};
        if (rule.label) hints = {"a value with a name is written 'let " + rule.label->text + " = ...'"};
        fail_behind_value("language.missing-colon", "':' and the tag that the rule is for", std::move(hints));
        return std::nullopt;
    }
    std::optional<Name> tag = read_tag("behind ':'");
    if (!tag) return std::nullopt;
    rule.tag = std::move(*tag);
    if (!read_clauses({{"when", &rule.condition}, {"weight", &rule.weight}})) return std::nullopt;
    if (at_statement_end()) return rule;
    if (!at(TokenKind::arrow)) {
        fail_behind_tag("language.missing-arrow", "'->' and tags", true);
        return std::nullopt;
    }
    take();
    if (!read_outputs(rule.outputs, true)) return std::nullopt;
    return rule;
}

// Without an example, a name before '=' may have been meant for a value.
std::optional<OperatorCall> Parser::read_call(std::string_view example, bool takes_pairs) {
    OperatorCall call;
    const std::uint32_t begin = peek().begin;
    std::optional<Name> name = read_name("an operator");
    if (!name) return std::nullopt;
    if (accept(TokenKind::assign)) {
        call.name = std::move(*name);
        const Token found = peek();
        const TokenKind behind = found.kind == TokenKind::name ? token_behind(found).kind : TokenKind::end_of_text;
        if (behind != TokenKind::open_round && behind != TokenKind::colon) {
            const std::string value_hint = "a value with a name is written 'let " + call.name->text + " = ...'";
            fail_expected("language.missing-operator", "an operator with its arguments",
                          {example.empty() ? value_hint : std::string(example)});
            return std::nullopt;
        }
        name = read_name("an operator");
        if (!name) return std::nullopt;
    }
    call.operator_name = std::move(*name);
    if (!at(TokenKind::open_round)) {
        fail_expected("language.missing-arguments", "'(' behind the operator",
                      {"an operator without arguments is written '" + call.operator_name.text + "()'"});
        return std::nullopt;
    }
    int height = 0;
    if (!read_arguments(call.arguments, height, takes_pairs)) return std::nullopt;
    call.span = span_from(begin);
    return call;
}

// In any order; each once, but for those that take several values.
bool Parser::read_clauses(std::initializer_list<Clause> clauses) {
    while (true) {
        const auto found =
            std::find_if(clauses.begin(), clauses.end(), [this](const Clause& clause) { return at_word(clause.word); });
        if (found == clauses.end()) return true;
        const Token word = take();
        const auto* value = std::get_if<ExpressionPtr*>(&found->into);
        const auto* flag = std::get_if<bool*>(&found->into);
        if ((value != nullptr && **value) || (flag != nullptr && **flag)) {
            fail(word, error("language.repeated-clause",
                             "found a second " + in_quotes(bytes_of(word)) + " in one statement", span_of(word)));
            return false;
        }
        if (flag != nullptr) {
            **flag = true;
            continue;
        }
        ExpressionPtr read = read_expression();
        if (!read) return false;
        if (value != nullptr) {
            **value = std::move(read);
        } else {
            std::get<std::vector<ExpressionPtr>*>(found->into)->push_back(std::move(read));
        }
    }
}

// What stands behind the arrow, to the end of the statement.
bool Parser::read_outputs(std::vector<OutputTag>& outputs, bool is_rule) {
    if (!at(TokenKind::open_square)) return read_output_list(outputs, is_rule);
    if (!open_bracket()) return false;
    std::string_view place = "behind '['";
    do {
        std::optional<OutputTag> output = read_output(place);
        if (!output) return false;
        outputs.push_back(std::move(*output));
        if (at(TokenKind::close_square, LexMode::tag)) {
            close_bracket();
            if (at_statement_end()) return true;
            fail_behind_tag("language.unexpected-token", "the end of the statement", is_rule);
            return false;
        }
        if (!at(TokenKind::comma, LexMode::tag)) {
            fail_in_list();
            return false;
        }
        const Token comma = take(LexMode::tag);
        if (at(TokenKind::close_square, LexMode::tag)) {
            fail_trailing_comma(comma);
            return false;
        }
        place = "behind ','";
    } while (true);
}

bool Parser::read_output_list(std::vector<OutputTag>& outputs, bool is_rule) {
    std::string_view place = "behind '->'";
    while (true) {
        std::optional<OutputTag> output = read_output(place);
        if (!output) {
            is_continued_ = at(TokenKind::end_of_line, LexMode::tag);
            return false;
        }
        outputs.push_back(std::move(*output));
        if (at_statement_end()) return true;
        if (!at(TokenKind::comma)) {
            fail_behind_tag("language.unexpected-token", "',' or the end of the statement", is_rule);
            return false;
        }
        const Token comma = take();
        if (at_statement_end()) {
            is_continued_ = at(TokenKind::end_of_line);
            fail_trailing_comma(comma, {"tags go on in the next line only inside '[' and ']'"});
            return false;
        }
        place = "behind ','";
    }
}

// TAG | PORT: TAG | <TAG> | <> | _
std::optional<OutputTag> Parser::read_output(std::string_view place) {
    const Token first = peek(LexMode::tag);
    if (first.kind == TokenKind::less) return read_angled_output();
    const bool is_dropped = first.kind == TokenKind::name && bytes_of(first) == "_";
    if (!is_dropped) {
        if (!open_.empty() && fail_if_unclosed()) return std::nullopt;
        if (!is_tag(first, place)) return std::nullopt;
    }
    OutputTag output;
    output.span = span_of(take(LexMode::tag));
    if (is_dropped) {
        output.dropped = true;
        return output;
    }
    std::optional<std::string> name = normal_name(first);
    if (!name) return std::nullopt;
    if (!accept(TokenKind::colon)) {
        output.tag = std::move(*name);
        return output;
    }
    const Token second = peek(LexMode::tag);
    if (second.kind == TokenKind::less) {
        std::optional<OutputTag> angled = read_angled_output();
        if (!angled) return std::nullopt;
        output = std::move(*angled);
    } else if (second.kind == TokenKind::name && bytes_of(second) == "_") {
        take(LexMode::tag);
        output.dropped = true;
    } else {
        std::optional<Name> tag = read_tag("behind the port");
        if (!tag) return std::nullopt;
        output.tag = std::move(tag->text);
    }
    output.port = std::move(*name);
    output.span = span_from(first.begin);
    return output;
}

std::optional<OutputTag> Parser::read_angled_output() {
    const Token open = take(LexMode::tag);
    OutputTag output;
    if (at(TokenKind::name, LexMode::tag)) {
        std::optional<Name> tag = read_tag("behind '<'");
        if (!tag) return std::nullopt;
        output.tag = std::move(tag->text);
    }
    if (!at(TokenKind::greater, LexMode::tag)) {
        if (ahead_.kind == TokenKind::invalid) {
            fail_expected("language.unclosed-bracket", "'>'");
        } else {
            fail_unclosed(open, ahead_);
        }
        return std::nullopt;
    }
    take(LexMode::tag);
    output.span = span_from(open.begin);
    return output;
}

// What people write behind a tag that does not belong there.
void Parser::fail_behind_tag(std::string_view code, std::string_view wanted, bool is_rule) {
    const Token found = peek();
    std::vector<std::string> hints;
    const bool touches = found.begin == taken_end_;
    const bool is_line_sign =
        found.kind == TokenKind::minus || found.kind == TokenKind::dot || found.kind == TokenKind::slash;
    const bool is_clause = found.kind == TokenKind::name && (bytes_of(found) == "when" || bytes_of(found) == "weight");
    if (is_line_sign && touches && token_behind(found).begin == found.end) {
        hints = {"a tag has letters, digits and '_' only"};
    } else if (found.kind == TokenKind::minus || found.kind == TokenKind::greater) {
        hints = {"an arrow is written '->'"};
    } else if (found.kind == TokenKind::assign && token_behind(found).kind == TokenKind::greater) {
        return fail(found,
                    error(std::string(code), "expected " + std::string(wanted) + ", found '=>'",
                          span_over(span_of(found), span_of(token_behind(found))), {"an arrow is written '->'"}));
    } else if (is_clause && is_rule && code != "language.missing-arrow") {
        hints = {in_quotes(bytes_of(found)) + " stands before the arrow"};
    }
    fail_behind_value(code, wanted, std::move(hints));
}

}  // namespace filigree
