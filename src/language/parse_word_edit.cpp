// Edits of words: what stands below `grammar rewriting` beside words and their rules.
#include "language/parser.h"

namespace filigree {
namespace {

constexpr std::string_view edit_example = "an edit is written as in 'once insert(\"T+\", at: \"a\")'";

}  // namespace

// `after hold` is a setting.
bool Parser::is_word_edit(const Token& first) const {
    if (first.kind != TokenKind::name) return false;
    const std::string_view word = bytes_of(first);
    return word == "once" || word == "each" || (word == "after" && token_behind(first).kind == TokenKind::number);
}

std::optional<WordEditStatement> Parser::read_word_edit() {
    const Token when = take();
    WordEditStatement edit;
    edit.is_once = bytes_of(when) == "once";
    if (bytes_of(when) == "each" && !accept_word("iteration")) {
        fail_expected("language.missing-iteration", "'iteration'", {"write it as in 'each iteration clean()'"});
        return std::nullopt;
    }
    if (bytes_of(when) == "after" && !read_iterations(edit.first, edit.last)) return std::nullopt;
    std::optional<OperatorCall> call = read_edit_call();
    if (!call) return std::nullopt;
    edit.edit_name = std::move(call->operator_name);
    edit.arguments = std::move(call->arguments);
    edit.call_span = call->span;
    return edit;
}

std::optional<OperatorCall> Parser::read_edit_call() {
    const Token first = peek();
    if (first.kind != TokenKind::name || token_behind(first).kind == TokenKind::assign) {
        if (first.kind == TokenKind::name) take();
        fail_expected("language.missing-operator", "an edit with its arguments", {std::string(edit_example)});
        return std::nullopt;
    }
    return read_call(edit_example, true);
}

}  // namespace filigree
