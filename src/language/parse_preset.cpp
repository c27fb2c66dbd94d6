// What is said of the places of a derivation: set, default, keep, reroll and apply.
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

namespace {

constexpr std::string_view digits = "0123456789";

// From 1 to max_rerolls, or none.
std::optional<std::uint32_t> times_of(std::string_view bytes) {
    if (bytes.empty() || bytes.find_first_not_of(digits) != std::string_view::npos) return std::nullopt;
    std::uint64_t times = 0;
    for (const char c : bytes) {
        times = times * 10 + static_cast<std::uint64_t>(c - '0');
        if (times > max_rerolls) return std::nullopt;
    }
    return times == 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(times));
}

}  // namespace

// {set|default} PATH = VALUE [when CONDITION]
std::optional<PresetStatement> Parser::read_preset(bool is_default) {
    const std::string example = std::string("write it as in '") + (is_default ? "default" : "set") +
                                " leaf/outline.distance = " + (is_default ? "25'" : "5..9'");
    PresetStatement preset;
    preset.is_default = is_default;
    std::optional<ChoicePath> path = read_path(example);
    if (!path) return std::nullopt;
    preset.path = std::move(*path);
    if (!accept(TokenKind::assign)) {
        fail_behind_path("language.missing-equals", "'=' and a value", {example});
        return std::nullopt;
    }
    preset.value = read_expression();
    if (!preset.value) return std::nullopt;
    if (accept_word("when")) {
        preset.condition = read_expression();
        if (!preset.condition) return std::nullopt;
    } else if (!at_statement_end()) {
        fail_behind_value("language.unexpected-token", "'when' or the end of the statement");
    }
    return preset;
}

// keep PATH
std::optional<KeepStatement> Parser::read_keep() {
    std::optional<ChoicePath> path = read_path("write it as in 'keep leaf/outline'");
    if (!path) return std::nullopt;
    if (!at_statement_end()) {
        std::vector<std::string> hints;
        if (at(TokenKind::assign)) hints = {"'keep' takes a path alone; a value is given with 'set'"};
        if (at(TokenKind::comma)) hints = {"each path has a 'keep' of its own"};
        fail_behind_path("language.unexpected-token", "the end of the statement", std::move(hints));
    }
    return KeepStatement{std::move(*path)};
}

// reroll PATH [x N]
std::optional<RerollStatement> Parser::read_reroll() {
    RerollStatement reroll;
    std::optional<ChoicePath> path = read_path("write it as in 'reroll leaf/outline x 2'");
    if (!path) return std::nullopt;
    reroll.path = std::move(*path);
    if (at_statement_end()) return reroll;
    const std::string_view word = at(TokenKind::name) ? bytes_of(ahead_) : "";
    const bool has_times = word.starts_with('x') && word.find_first_not_of(digits, 1) == std::string_view::npos;
    if (has_times) {
        if (!read_times(reroll)) return std::nullopt;
        expect_statement_end();
        return reroll;
    }
    std::vector<std::string> hints;
    if (at(TokenKind::number)) hints = {"how often is written with an 'x', as in 'x 2'"};
    if (at(TokenKind::assign)) hints = {"'reroll' takes no value; one is given with 'set'"};
    if (at(TokenKind::comma)) hints = {"each path has a 'reroll' of its own"};
    fail_behind_path("language.unexpected-token", "'x' and how often, or the end of the statement", std::move(hints));
    return std::nullopt;
}

// The `x 3` or `x3` ahead.
bool Parser::read_times(RerollStatement& reroll) {
    const std::vector<std::string> hints = {"how often is a whole number from 1 to 1000000000"};
    const Token word = take();
    Token number = word;
    number.begin = word.begin + 1;
    if (number.begin == word.end) {
        number = peek();
        const bool is_number = number.kind == TokenKind::number || number.trouble == Trouble::bad_unit;
        if (!is_number) {
            fail_expected("language.bad-times", "how often", hints);
            return false;
        }
        take();
    }
    const std::optional<std::uint32_t> times = times_of(bytes_of(number));
    if (!times) {
        fail(number, error("language.bad-times", in_quotes(bytes_of(number)) + " is no number of times",
                           span_of(number), hints));
        return false;
    }
    reroll.times = *times;
    reroll.times_span = span_of(number);
    return true;
}

// apply [NAME =] operator(arguments) to PATH, PATH [-> tags]
std::optional<ApplyStatement> Parser::read_apply() {
    const std::string example = rules_ == Rules::of_shapes
                                    ? "write it as in 'apply slide at (3, 3)'"
                                    : "write it as in 'apply outline(5) to leaf/outline/in -> rim, core'";
    std::optional<OperatorCall> call = read_call(example);
    if (!call) return std::nullopt;
    ApplyStatement apply;
    apply.name = std::move(call->name);
    apply.operator_name = std::move(call->operator_name);
    apply.arguments = std::move(call->arguments);
    if (!accept_word("to")) {
        fail_expected("language.missing-to", "'to' and a path", {example});
        return std::nullopt;
    }
    if (!read_targets(apply.targets)) return std::nullopt;
    if (accept(TokenKind::arrow)) {
        if (!read_outputs(apply.outputs, false)) return std::nullopt;
    } else if (!at_statement_end()) {
        std::vector<std::string> hints;
        if (at_word("when") || at_word("weight")) {
            hints = {"a step by hand takes no " + in_quotes(bytes_of(ahead_)) + ", for it is always made"};
        }
        fail_behind_path("language.unexpected-token", "',', '->' or the end of the statement", std::move(hints));
    }
    return apply;
}

bool Parser::read_targets(std::vector<ChoicePath>& targets) {
    while (true) {
        std::optional<ChoicePath> path = read_path("the path of a group is written as in 'leaf/outline/in'");
        if (!path) return false;
        if (!path->parameter.empty() || path->draw != 0) {
            const char sign = path->parameter.empty() ? '~' : '.';
            const auto begin = static_cast<std::uint32_t>(text_.rfind(sign, path->span.end - 1));
            const SourceSpan span{file_, begin, path->span.end};
            const std::string rest = in_quotes(text_.substr(begin, span.end - begin));
            fail(peek(), error("language.bad-target", "a step is applied to groups, not to a parameter", span,
                               {"write the path without " + rest}));
            return false;
        }
        targets.push_back(std::move(*path));
        if (!at(TokenKind::comma)) return true;
        const Token comma = take();
        if (at_statement_end() || at(TokenKind::arrow)) {
            is_continued_ = at(TokenKind::end_of_line);
            fail_trailing_comma(comma, {"paths stay on one line"});
            return false;
        }
    }
}

}  // namespace filigree
