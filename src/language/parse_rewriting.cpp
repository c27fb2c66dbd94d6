// Words and their rules: what stands below `grammar rewriting` beside the statements of all engines.
//
// The left side of a rule is read symbol by symbol, since any character may be one; all behind the arrow is read as
// everywhere.
#include <cmath>
#include <utility>

#include "base/unicode.h"
#include "language/parser.h"
#include "language/token_text.h"
#include "language/word_settings.h"

namespace filigree {
namespace {

constexpr std::string_view arrow_sign = "\xE2\x86\x92";  // U+2192
constexpr std::string_view iteration_wanted = "the number of an iteration, from 1";
constexpr std::string_view row_wanted = "the number of a row, from 1";
constexpr std::string_view rule_example = "a rule is written as in 'a -> \"ab\"'";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
// What follows a letter and changes it.
bool is_combining(char32_t c) { return c >= 0x300 && c <= 0x36F; }

std::size_t letter_count(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) at += unicode::decode(text, at).length;
    return count;
}

// In normal form, and ~n is another way to write ñ.
std::string with_tildes(std::string text) {
    for (std::size_t at = text.find("~n"); at != std::string::npos; at = text.find("~n", at)) {
        text.replace(at, 2, "\xC3\xB1");
    }
    return unicode::normalise(text);
}

}  // namespace

std::uint32_t Parser::behind_blanks(std::uint32_t at) const {
    while (at < text_.size() && is_blank(text_[at])) ++at;
    return at;
}
bool Parser::is_arrow(std::uint32_t at) const {
    return text_.substr(at).starts_with("->") || text_.substr(at).starts_with(arrow_sign);
}

// An arrow outside quotes.
bool Parser::line_has_arrow() const {
    bool is_quoted = false;
    for (std::uint32_t at = at_; at < text_.size() && text_[at] != '\n'; ++at) {
        if (text_[at] == '\\' && is_quoted) {
            ++at;
        } else if (text_[at] == '"') {
            is_quoted = !is_quoted;
        } else if (!is_quoted && is_arrow(at)) {
            return true;
        }
    }
    return false;
}

// All but statements that every engine has. A word of several letters is a name; context letters go in quotes there.
bool Parser::is_word_statement(const Token& first) {
    if (first.kind != TokenKind::name) return first.kind == TokenKind::text || line_has_arrow();
    const std::string_view word = bytes_of(first);
    return is_word_edit(first) || find_word_setting(word) != nullptr || letter_count(unicode::normalise(word)) == 1 ||
           is_cell(first);
}

// NAME[...][...] ->
bool Parser::is_cell(const Token& name) const {
    std::uint32_t at = name.end;
    while (at < text_.size() && text_[at] == '[') {
        while (at < text_.size() && text_[at] != ']' && text_[at] != '\n') ++at;
        if (at == text_.size() || text_[at] == '\n') return false;
        ++at;
    }
    return at > name.end && is_arrow(behind_blanks(at));
}

std::optional<Statement> Parser::read_word_statement() {
    Statement statement;
    const Token first = peek();
    const bool is_name = first.kind == TokenKind::name;
    if (is_name && (bytes_of(first) == "mask" || bytes_of(first) == "sleep")) {
        if (auto rest = read_rest()) statement.node = std::move(*rest);
    } else if (is_name && bytes_of(first) == "loop") {
        if (auto loop = read_loop()) statement.node = std::move(*loop);
    } else if (is_word_edit(first)) {
        if (auto edit = read_word_edit()) statement.node = std::move(*edit);
    } else if (is_name && find_word_setting(bytes_of(first)) != nullptr) {
        if (auto setting = read_setting()) statement.node = std::move(*setting);
    } else if (is_name && is_cell(first)) {
        std::optional<Name> array = read_name("an array");
        if (!array) return std::nullopt;
        if (auto cell = read_cell(std::move(*array))) statement.node = std::move(*cell);
    } else {
        std::optional<Name> symbols = read_symbols("a symbol");
        if (!symbols) return std::nullopt;
        if (at(TokenKind::assign)) {
            if (auto macro = read_macro(std::move(*symbols))) statement.node = std::move(*macro);
        } else if (auto rule = read_word_rule(std::move(*symbols))) {
            statement.node = std::move(*rule);
        }
    }
    if (has_failed_) return std::nullopt;
    return statement;
}

// NAME value [value ...], with or without commas between.
std::optional<SettingStatement> Parser::read_setting() {
    SettingStatement setting;
    std::optional<Name> name = read_name("a setting");
    if (!name) return std::nullopt;
    setting.name = std::move(*name);
    const std::string example = "write it as in '" + std::string(find_word_setting(setting.name.text)->example) + "'";
    if (at(TokenKind::assign)) {
        fail_expected("language.lone-equals", "a value, without '='", {example});
        return std::nullopt;
    }
    do {
        if (at_statement_end()) {
            fail_expected("language.missing-value", "a value", {example});
            return std::nullopt;
        }
        // `register k -5` says what k is, and takes nothing away from it.
        const bool is_register = setting.name.text == "register" && setting.values.empty() && at(TokenKind::name);
        const bool is_lone = is_register || (find_word_setting(setting.name.text)->is_map && at_word("over"));
        ExpressionPtr value = is_lone ? read_lone_word() : read_expression();
        if (!value) return std::nullopt;
        setting.values.push_back(std::move(value));
        accept(TokenKind::comma);
    } while (!at_statement_end());
    return setting;
}

// mask SYMBOLS[@iterations], ... [when condition], or sleep SYMBOLS, ... until condition
std::optional<RestStatement> Parser::read_rest() {
    RestStatement rest;
    const Token keyword = take();
    rest.is_until = bytes_of(keyword) == "sleep";
    const std::string example = "write it as in '" + std::string(find_word_setting(bytes_of(keyword))->example) + "'";
    if (!read_numbered_symbols(rest.symbols, iteration_wanted)) return std::nullopt;
    const std::string_view clause = rest.is_until ? "until" : "when";
    if (rest.is_until && !at_word(clause)) {
        fail_expected("language.missing-condition", "'until' and a condition", {example});
        return std::nullopt;
    }
    if (!read_clauses({{clause, &rest.condition}})) return std::nullopt;
    return rest;
}

// loop SYMBOLS[@rows], ... LENGTH
std::optional<LoopStatement> Parser::read_loop() {
    LoopStatement loop;
    take();
    if (!read_numbered_symbols(loop.symbols, row_wanted)) return std::nullopt;
    if (at_statement_end()) {
        fail_expected("language.missing-value", "a number of iterations",
                      {"write it as in '" + std::string(find_word_setting("loop")->example) + "'"});
        return std::nullopt;
    }
    loop.length = read_expression();
    if (!loop.length) return std::nullopt;
    return loop;
}

// SYMBOLS[@numbers], ...: one without quotes, or several in quotes
bool Parser::read_numbered_symbols(std::vector<NumberedSymbols>& all, std::string_view wanted_number) {
    do {
        NumberedSymbols symbols;
        if (at(TokenKind::text)) {
            std::optional<std::string> text = read_text("symbols", symbols.text.span);
            if (!text) return false;
            symbols.text.text = with_tildes(std::move(*text));
        } else {
            std::optional<Name> symbol = read_symbol("a symbol");
            if (!symbol) return false;
            symbols.text = std::move(*symbol);
        }
        if (accept_sign('@') && !read_numbers(symbols.first, symbols.last, wanted_number)) return false;
        all.push_back(std::move(symbols));
    } while (accept(TokenKind::comma));
    return true;
}

// R = random 1..8 "abbccc" [unique]
std::optional<MacroStatement> Parser::read_macro(Name symbol) {
    take();
    const std::vector<std::string> hints = {"letters drawn at random are written as in 'R = random 1..8 \"abbccc\"'"};
    if (letter_count(symbol.text) != 1) {
        fail(peek(), error("language.missing-symbol", "expected one symbol before '='", symbol.span, hints));
        return std::nullopt;
    }
    if (!accept_word("random")) {
        fail_expected("language.missing-random", "'random'", hints);
        return std::nullopt;
    }
    MacroStatement macro;
    macro.symbol = std::move(symbol);
    macro.length = read_expression();
    if (!macro.length) return std::nullopt;
    std::optional<std::string> letters = read_text("the letters in quotes", macro.letters.span);
    if (!letters) return std::nullopt;
    macro.letters.text = std::move(*letters);
    macro.is_unique = accept_word("unique");
    return macro;
}

// [i][j]...
bool Parser::read_indexes(std::vector<ExpressionPtr>& indexes) {
    while (at(TokenKind::open_square)) {
        if (!open_bracket()) return false;
        ExpressionPtr index = read_expression();
        if (!index) return false;
        if (!at(TokenKind::close_square)) {
            fail_in_list();
            return false;
        }
        close_bracket();
        indexes.push_back(std::move(index));
    }
    return true;
}

// M[3][9] -> "ab"
std::optional<CellStatement> Parser::read_cell(Name array) {
    CellStatement cell;
    cell.array = std::move(array);
    if (!read_indexes(cell.indexes)) return std::nullopt;
    if (!accept(TokenKind::arrow)) {
        fail_expected("language.missing-arrow", "'->'", {"a cell is written as in 'M[3][9] -> \"ab\"'"});
        return std::nullopt;
    }
    std::optional<std::string> text = read_text("a word in quotes", cell.text.span);
    if (!text) return std::nullopt;
    cell.text.text = std::move(*text);
    return cell;
}

// --- the left side ----------------------------------------------------------------------------------------------

std::optional<Name> Parser::read_symbols(std::string_view wanted) {
    Name symbols;
    has_ahead_ = false;
    at_ = behind_blanks(at_);
    const std::uint32_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != ';' && !is_arrow(at_) &&
           std::string_view("<>@=").find(text_[at_]) == std::string_view::npos) {
        if (text_[at_] == '"') {
            SourceSpan span;
            std::optional<std::string> quoted = read_text(wanted, span);
            if (!quoted) return std::nullopt;
            symbols.text += *quoted;
        } else {
            const unicode::Decoded symbol = unicode::decode(text_, at_);
            symbols.text += text_.substr(at_, symbol.length);
            at_ += symbol.length;
        }
        taken_end_ = at_;
        has_ahead_ = false;
        at_ = behind_blanks(at_);
        if (symbols.text.size() > max_name_bytes) {
            fail(peek(), error("language.long-name", "these symbols have more than 1000 bytes", {file_, begin, at_}));
            return std::nullopt;
        }
    }
    symbols.span = span_from(begin);
    if (symbols.text.empty()) {
        peek();
        fail_expected("language.missing-symbol", wanted, {std::string(rule_example)});
        return std::nullopt;
    }
    symbols.text = with_tildes(symbols.text);
    return symbols;
}

std::optional<Name> Parser::read_symbol(std::string_view wanted) {
    has_ahead_ = false;
    at_ = behind_blanks(at_);
    if (at_ == text_.size() || text_[at_] == '\n') {
        peek();
        fail_expected("language.missing-symbol", wanted);
        return std::nullopt;
    }
    Name symbol;
    if (text_[at_] == '"') {
        std::optional<std::string> quoted = read_text(wanted, symbol.span);
        if (!quoted) return std::nullopt;
        symbol.text = std::move(*quoted);
    } else {
        const std::uint32_t begin = at_;
        const bool is_tilde = text_.substr(at_).starts_with("~n");
        at_ += is_tilde ? 2 : unicode::decode(text_, at_).length;
        while (at_ < text_.size() && is_combining(unicode::decode(text_, at_).code_point)) {
            at_ += unicode::decode(text_, at_).length;
        }
        taken_end_ = at_;
        symbol = {std::string(text_.substr(begin, at_ - begin)), span_from(begin)};
    }
    symbol.text = with_tildes(symbol.text);
    if (letter_count(symbol.text) != 1) {
        fail(peek(), error("language.missing-symbol", "expected " + std::string(wanted) + ", one symbol", symbol.span));
        return std::nullopt;
    }
    return symbol;
}

bool Parser::accept_sign(char sign) {
    const std::uint32_t at = behind_blanks(at_);
    if (at >= text_.size() || text_[at] != sign) return false;
    at_ = taken_end_ = at + 1;
    has_ahead_ = false;
    return true;
}

std::optional<WordRule> Parser::read_word_rule(Name symbols) {
    WordRule rule;
    rule.symbol = std::move(symbols);
    if (accept_sign('<')) {
        rule.left = std::move(rule.symbol);
        std::optional<Name> symbol = read_symbols("a symbol behind '<'");
        if (!symbol) return std::nullopt;
        rule.symbol = std::move(*symbol);
    }
    if (accept_sign('>')) {
        std::optional<Name> right = read_symbols("symbols behind '>'");
        if (!right) return std::nullopt;
        rule.right = std::move(*right);
    }
    if (letter_count(rule.symbol.text) != 1) {
        fail(peek(), error("language.missing-symbol", "a rule rewrites one symbol, but here are several",
                           rule.symbol.span, {"what stands around it is written 'left < symbol > right'"}));
        return std::nullopt;
    }
    if (accept_sign('@') && !read_iterations(rule.first, rule.last)) return std::nullopt;
    if (!accept(TokenKind::arrow)) {
        fail_expected("language.missing-arrow", "'->'", {std::string(rule_example)});
        return std::nullopt;
    }
    skip_line_ends();
    if (!read_word_successors(rule)) return std::nullopt;
    if (!read_clauses({{"loop", &rule.loop}, {"when", &rule.condition}})) return std::nullopt;
    if (at(TokenKind::open_curly) && !read_assignments(rule)) return std::nullopt;
    return rule;
}

// 3, or 2..5
bool Parser::read_iterations(std::uint32_t& first, std::uint32_t& last) {
    return read_numbers(first, last, iteration_wanted);
}
bool Parser::read_numbers(std::uint32_t& first, std::uint32_t& last, std::string_view wanted) {
    const std::optional<std::uint32_t> low = read_number_from_one(wanted);
    if (!low) return false;
    first = last = *low;
    if (!accept(TokenKind::range)) return true;
    const std::optional<std::uint32_t> high = read_number_from_one(wanted);
    if (!high) return false;
    last = *high;
    if (last >= first) return true;
    fail(peek(), error("language.empty-range", "this range is empty", span_from(taken_end_ - 1)));
    return false;
}

std::optional<std::uint32_t> Parser::read_number_from_one(std::string_view wanted) {
    const Token token = peek();
    const bool is_whole = token.kind == TokenKind::number && token.unit == Unit::none &&
                          token.number == std::floor(token.number) && token.number >= 1 && token.number < 4e9;
    if (!is_whole) {
        fail_expected("language.missing-iteration", wanted);
        return std::nullopt;
    }
    take();
    return static_cast<std::uint32_t>(token.number);
}

// --- behind the arrow -------------------------------------------------------------------------------------------

bool Parser::read_word_successors(WordRule& rule) {
    do {
        std::optional<WordSuccessor> successor = read_word_successor();
        if (!successor) return false;
        rule.successors.push_back(std::move(*successor));
    } while (accept(TokenKind::comma));
    return true;
}

std::optional<WordSuccessor> Parser::read_word_successor() {
    WordSuccessor successor;
    const std::uint32_t begin = peek().begin;
    if (at(TokenKind::text)) {
        SourceSpan span;
        std::optional<std::string> text = read_text("a word in quotes", span);
        if (!text) return std::nullopt;
        successor.text = Name{std::move(*text), span};
    } else if (accept_word("goto")) {
        std::optional<Name> target = read_symbol("a symbol behind 'goto'");
        if (!target) return std::nullopt;
        successor.target = std::move(*target);
        if (!accept_sign('@')) {
            peek();
            fail_expected("language.missing-iteration", "'@' and an iteration", {"write it as in 'goto a@3'"});
            return std::nullopt;
        }
        const std::optional<std::uint32_t> iteration = read_number_from_one(iteration_wanted);
        if (!iteration) return std::nullopt;
        successor.iteration = *iteration;
    } else if (at(TokenKind::name) && token_behind(peek()).kind == TokenKind::open_square) {
        successor.array = read_name("an array");
        if (!successor.array || !read_indexes(successor.indexes)) return std::nullopt;
    } else if (at_word("image") || at_word("data")) {
        successor.lookup = read_lookup();
        if (!successor.lookup) return std::nullopt;
    } else {
        fail_expected("language.missing-word", "a word in quotes", {"successors are written in quotes, as in \"ab\""});
        return std::nullopt;
    }
    if (accept(TokenKind::star)) {
        const Tree weight = read_unary();
        if (!weight) return std::nullopt;
        successor.weight = weight.node;
    }
    successor.span = span_from(begin);
    return successor;
}

// { ix = ix + 1; iy = 0 }
bool Parser::read_assignments(WordRule& rule) {
    const Token open = take();
    while (true) {
        while (accept(TokenKind::end_of_line) || accept(TokenKind::semicolon) || accept(TokenKind::comma)) {}
        if (accept(TokenKind::close_curly)) return true;
        if (at(TokenKind::end_of_text)) {
            fail_unclosed(open, peek());
            return false;
        }
        std::optional<Name> name = read_name("a register");
        if (!name || !expect_assign("'{ ix = ix + 1 }'")) return false;
        ExpressionPtr value = read_expression();
        if (!value) return false;
        rule.assignments.push_back({std::move(*name), std::move(value)});
        const bool may_follow = at(TokenKind::end_of_line) || at(TokenKind::semicolon) || at(TokenKind::comma) ||
                                at(TokenKind::close_curly);
        if (!may_follow) {
            fail_behind_value("language.unexpected-token", "';' or '}'");
            return false;
        }
    }
}

}  // namespace filigree
