// Expressions, tier by tier.
#include <algorithm>
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

namespace {

struct BinarySign {
    BinaryOperator op;
    int tier;
};

std::optional<BinarySign> binary_sign(TokenKind kind) {
    switch (kind) {
        case TokenKind::either:
            return BinarySign{BinaryOperator::either, 1};
        case TokenKind::both:
            return BinarySign{BinaryOperator::both, 2};
        case TokenKind::equal:
            return BinarySign{BinaryOperator::equal, 3};
        case TokenKind::unequal:
            return BinarySign{BinaryOperator::unequal, 3};
        case TokenKind::less:
            return BinarySign{BinaryOperator::less, 3};
        case TokenKind::less_equal:
            return BinarySign{BinaryOperator::less_equal, 3};
        case TokenKind::greater:
            return BinarySign{BinaryOperator::greater, 3};
        case TokenKind::greater_equal:
            return BinarySign{BinaryOperator::greater_equal, 3};
        case TokenKind::plus:
            return BinarySign{BinaryOperator::add, 4};
        case TokenKind::minus:
            return BinarySign{BinaryOperator::subtract, 4};
        case TokenKind::star:
            return BinarySign{BinaryOperator::multiply, 5};
        case TokenKind::slash:
            return BinarySign{BinaryOperator::divide, 5};
        case TokenKind::meet:
            return BinarySign{BinaryOperator::meet, 5};
        default:
            return std::nullopt;
    }
}

}  // namespace

template <class Node>
Tree Parser::make(SourceSpan span, int height, Node node) {
    if (height > max_expression_height) {
        fail(peek(), error("language.long-chain", "this expression is a chain of more than 500 parts", span,
                           {"name parts of it with 'let'"}));
        return {};
    }
    return {std::make_shared<Expression>(Expression{span, std::move(node)}), height};
}

ExpressionPtr Parser::read_expression() { return read_conditional().node; }
ExpressionPtr Parser::read_plain_range() { return read_range().node; }

// A chain of conditions is read in a loop and folded from its end, so that only its middle parts nest.
Tree Parser::read_conditional() {
    struct Arm {
        Tree condition, when_true;
    };
    Tree last = read_within();
    if (!last || !at(TokenKind::question)) return last;
    std::vector<Arm> arms;
    while (at(TokenKind::question)) {
        const Token question = take();
        if (open_.size() + ++nesting_ > max_nesting) {
            fail(question, error("language.nesting", "conditions nest deeper than 200 here", span_of(question)));
            return {};
        }
        Tree when_true = read_conditional();
        --nesting_;
        if (!when_true) return {};
        if (!accept(TokenKind::colon)) {
            fail_behind_value("language.missing-colon", "':' and the value for the other case",
                              {"a choice by a condition is written 'condition ? a : b'"});
            return {};
        }
        arms.push_back({std::move(last), std::move(when_true)});
        last = read_within();
        if (!last) return {};
    }
    for (std::size_t i = arms.size(); i-- > 0 && last;) {
        Arm& arm = arms[i];
        const int height = 1 + std::max({arm.condition.height, arm.when_true.height, last.height});
        const SourceSpan span = span_over(arm.condition.node->span, last.node->span);
        last = make(span, height, ConditionalExpression{arm.condition.node, arm.when_true.node, last.node});
    }
    return last;
}

Tree Parser::read_within() {
    Tree value = read_range();
    if (!value || !accept_word("in")) return value;
    const Tree range = read_range();
    if (!range) return {};
    return make(span_over(value.node->span, range.node->span), 1 + std::max(value.height, range.height),
                WithinExpression{value.node, range.node});
}

Tree Parser::read_range() {
    Tree low = read_binary(1);
    if (!low || !accept(TokenKind::range)) return low;
    const Tree high = read_binary(1);
    if (!high) return {};
    return make(span_over(low.node->span, high.node->span), 1 + std::max(low.height, high.height),
                RangeExpression{low.node, high.node});
}

Tree Parser::read_binary(int least_tier) {
    Tree left = read_unary();
    while (left) {
        const std::optional<BinarySign> sign = binary_sign(peek().kind);
        if (!sign || sign->tier < least_tier) break;
        take();
        const Tree right = read_binary(sign->tier + 1);
        if (!right) return {};
        left = make(span_over(left.node->span, right.node->span), 1 + std::max(left.height, right.height),
                    BinaryExpression{sign->op, left.node, right.node});
    }
    return left;
}

Tree Parser::read_unary() {
    std::vector<Token> signs;
    while (at(TokenKind::minus) || at(TokenKind::invert)) signs.push_back(take());
    Tree operand = read_postfix();
    while (operand && !signs.empty()) {
        const UnaryOperator op = signs.back().kind == TokenKind::minus ? UnaryOperator::negate : UnaryOperator::invert;
        operand = make(span_over(span_of(signs.back()), operand.node->span), operand.height + 1,
                       UnaryExpression{op, operand.node});
        signs.pop_back();
    }
    return operand;
}

Tree Parser::read_postfix() {
    Tree object = read_primary();
    while (object && accept(TokenKind::dot)) {
        const std::optional<Name> member = read_name("a name behind '.'");
        if (!member) return {};
        object = make(span_over(object.node->span, member->span), object.height + 1,
                      MemberExpression{object.node, member->text});
    }
    return object;
}

Tree Parser::read_primary() {
    const Token token = peek();
    switch (token.kind) {
        case TokenKind::number:
            take();
            return make(span_of(token), 1, NumberLiteral{token.number, token.unit});
        case TokenKind::text: {
            SourceSpan span;
            std::optional<std::string> text = read_text("a text", span);
            if (!text) return {};
            return make(span, 1, TextLiteral{std::move(*text)});
        }
        case TokenKind::colour:
            take();
            return make(span_of(token), 1, ColourLiteral{colour_of(token, text_)});
        case TokenKind::name:
            return read_name_or_call();
        case TokenKind::open_round:
            return read_bracketed();
        case TokenKind::open_square:
            return read_list();
        default:
            fail_missing_value();
            return {};
    }
}

Tree Parser::read_name_or_call() {
    const Token token = take();
    const std::string_view bytes = bytes_of(token);
    if (bytes == "true" || bytes == "false") return make(span_of(token), 1, BoolLiteral{bytes == "true"});
    std::optional<std::string> name = normal_name(token);
    if (!name) return {};
    if (!at(TokenKind::open_round)) return make(span_of(token), 1, NameReference{std::move(*name)});
    CallExpression call{std::move(*name), span_of(token), {}};
    int height = 0;
    if (!read_arguments(call.arguments, height)) return {};
    return make(span_from(token.begin), height + 1, std::move(call));
}

Tree Parser::read_bracketed() {
    const std::uint32_t begin = peek().begin;
    std::vector<ExpressionPtr> items;
    int height = 0;
    // The first item is kept as it was built, for a lone one only gets a wider span.
    if (!open_bracket()) return {};
    Tree first = read_conditional();
    if (!first) return {};
    if (at(TokenKind::close_round)) {
        close_bracket();
        first.node->span = span_from(begin);
        return first;
    }
    items.push_back(first.node);
    height = first.height;
    if (!read_items(TokenKind::close_round, items, height)) return {};
    const SourceSpan span = span_from(begin);
    if (items.size() > 3) {
        fail(peek(),
             error("language.bad-point", "a point has 2 or 3 coordinates, found " + std::to_string(items.size()), span,
                   {"a list is written in square brackets: [1, 2, 3, 4]"}));
        return {};
    }
    return make(span, height + 1, PointExpression{std::move(items)});
}

Tree Parser::read_list() {
    const std::uint32_t begin = peek().begin;
    std::vector<ExpressionPtr> items;
    int height = 0;
    if (!open_bracket()) return {};
    if (at(TokenKind::close_square)) {
        close_bracket();
        return make(span_from(begin), 1, ListExpression{});
    }
    const Tree first = read_conditional();
    if (!first) return {};
    items.push_back(first.node);
    height = first.height;
    if (!read_items(TokenKind::close_square, items, height)) return {};
    return make(span_from(begin), height + 1, ListExpression{std::move(items)});
}

// What follows the first item, with the closing bracket.
bool Parser::read_items(TokenKind close, std::vector<ExpressionPtr>& items, int& height) {
    while (!at(close)) {
        if (!at(TokenKind::comma)) {
            fail_in_list();
            return false;
        }
        const Token comma = take();
        if (at(close)) {
            fail_trailing_comma(comma);
            return false;
        }
        const Tree item = read_conditional();
        if (!item) return false;
        items.push_back(item.node);
        height = std::max(height, item.height);
    }
    close_bracket();
    return true;
}

bool Parser::read_arguments(std::vector<CallArgument>& arguments, int& height, bool takes_pairs) {
    if (!open_bracket()) return false;
    while (!at(TokenKind::close_round)) {
        if (!arguments.empty()) {
            if (!at(TokenKind::comma)) {
                fail_in_list();
                return false;
            }
            const Token comma = take();
            if (at(TokenKind::close_round)) {
                fail_trailing_comma(comma);
                return false;
            }
        }
        const Token first = peek();
        Tree value = read_conditional();
        if (!value) return false;
        height = std::max(height, value.height);
        CallArgument argument{nullptr, value.node};
        if (!read_key(argument, first, takes_pairs)) return false;
        if (argument.key) {
            value = read_conditional();
            if (!value) return false;
            height = std::max(height, value.height);
            argument.value = value.node;
        }
        arguments.push_back(std::move(argument));
    }
    close_bracket();
    return true;
}

// Whether what was read is the key of an argument: takes the ':', or the '->' of a pair, behind it.
bool Parser::read_key(CallArgument& argument, const Token& first, bool takes_pairs) {
    const bool is_text = std::holds_alternative<TextLiteral>(argument.value->node);
    if (takes_pairs && is_text && at(TokenKind::colon)) {
        fail_expected("language.missing-arrow", "'->' behind a text", {"pairs are written as in \"aaa\" -> \"b\""});
        return false;
    }
    if (takes_pairs && !is_text && at(TokenKind::arrow)) {
        fail(first, error("language.missing-text", "expected a text in quotes before '->'", argument.value->span,
                          {"pairs are written as in \"aaa\" -> \"b\""}));
        return false;
    }
    if (accept(TokenKind::colon) || (takes_pairs && accept(TokenKind::arrow))) argument.key = argument.value;
    return true;
}

void Parser::fail_missing_value() {
    if (fail_if_unclosed()) return;
    const Token found = ahead_;
    if (found.kind == TokenKind::assign) return fail_behind_value("language.missing-value", "a value");
    if (found.trouble == Trouble::hash && found.end > found.begin + 1) {
        return fail(found, error("language.bad-colour", describe(found, text_) + " is no colour", span_of(found),
                                 {"a colour has 3, 4, 6 or 8 hexadecimal digits",
                                  "a comment is written '# ...', with a blank behind the '#'"}));
    }
    std::vector<std::string> hints;
    if (found.kind == TokenKind::star && found.begin > 0 && text_[found.begin - 1] == '*') {
        hints = {"a power is written 'pow(a, b)'"};
    } else if (found.kind == TokenKind::plus) {
        hints = {"a number stands without '+'"};
    }
    fail_expected("language.missing-value", "a value", std::move(hints));
}

}  // namespace filigree
