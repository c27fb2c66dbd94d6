// Statements that every engine has.
#include <algorithm>
#include <array>
#include <utility>

#include "language/parser.h"
#include "language/quantity.h"
#include "language/shape_settings.h"
#include "language/token_text.h"
#include "language/word_settings.h"

namespace filigree {

namespace {

constexpr std::array<std::string_view, 21> keywords = {
    "filigree", "grammar", "seed",  "unit", "resolution", "include", "param",  "let",   "page",   "limit",   "symmetry",
    "palette",  "start",   "style", "set",  "default",    "keep",    "reroll", "apply", "system", "operator"};

bool is_keyword(std::string_view word) { return std::find(keywords.begin(), keywords.end(), word) != keywords.end(); }

// Those that a person may take for assignments.
bool takes_no_assign(std::string_view word) {
    return word == "filigree" || word == "grammar" || word == "seed" || word == "unit" || word == "resolution" ||
           word == "include" || word == "page" || word == "limit" || word == "symmetry";
}

bool has_only_digits(std::string_view bytes) {
    return !bytes.empty() && bytes.find_first_not_of("0123456789") == std::string_view::npos;
}

// Digits alone, as a whole number of 64 bits.
std::optional<std::uint64_t> whole_number(std::string_view digits) {
    std::uint64_t value = 0;
    for (const char c : digits) {
        const auto digit = static_cast<std::uint64_t>(c - '0');
        if (value > (UINT64_MAX - digit) / 10) return std::nullopt;
        value = value * 10 + digit;
    }
    return value;
}

}  // namespace

std::optional<Statement> Parser::read_statement() {
    has_failed_ = false;
    is_continued_ = false;

    const Token first = peek();
    Statement statement;
    const bool has_keyword = first.kind == TokenKind::name && is_keyword(bytes_of(first));
    const bool may_be_of_shapes = rules_ == Rules::of_shapes && first.kind == TokenKind::name;
    const ShapeStatement of_shapes = may_be_of_shapes ? shape_statement(first, has_keyword) : ShapeStatement::none;
    if (rules_ == Rules::of_words && is_word_statement(first)) {
        if (std::optional<Statement> words = read_word_statement()) statement = std::move(*words);
        if (!has_failed_) expect_statement_end();
    } else if (first.kind != TokenKind::name) {
        fail_first_token(first);
    } else if (of_shapes != ShapeStatement::none) {
        read_shape_statement(of_shapes, statement);
        if (!has_failed_) expect_statement_end();
    } else if (rules_ == Rules::of_groups && is_rule(first, has_keyword)) {
        if (std::optional<GroupRule> rule = read_rule()) statement.node = std::move(*rule);
    } else if (has_keyword) {
        if (may_stand_here(first)) read_by_keyword(take(), statement);
        if (!has_failed_) expect_statement_end();
    } else {
        fail_unknown_statement(first);
    }
    if (has_failed_) return std::nullopt;
    statement.span = span_from(first.begin);
    return statement;
}

void Parser::read_by_keyword(const Token& keyword, Statement& statement) {
    const std::string_view word = bytes_of(keyword);
    const auto put = [&](auto node) {
        if (node) statement.node = std::move(*node);
    };
    const auto named = [&](std::string_view wanted, std::string_view example, auto make) {
        std::optional<Name> name = read_name(wanted);
        if (!name || (!example.empty() && !expect_assign(example))) return;
        make(std::move(*name));
    };
    const auto fail_at_assign = [&] {
        fail(peek(), error("language.lone-equals", "found '=' behind " + in_quotes(word), span_of(peek()),
                           {in_quotes(word) + " takes its value without '='"}));
    };
    if (takes_no_assign(word) && at(TokenKind::assign)) return fail_at_assign();
    if (word == "filigree") {
        if (is_only_one(first_.version, keyword)) put(read_version());
    } else if (word == "grammar") {
        named("the kind of grammar", "", [&](Name name) {
            rules_ = name.text == "rewriting" ? Rules::of_words
                     : name.text == "shape"   ? Rules::of_shapes
                                              : Rules::of_groups;
            statement.node = GrammarStatement{std::move(name)};
        });
    } else if (word == "seed") {
        if (is_only_one(first_.seed, keyword)) put(read_seed());
    } else if (word == "unit") {
        if (is_only_one(first_.unit, keyword)) put(read_unit());
    } else if (word == "resolution") {
        if (ExpressionPtr value = read_expression()) statement.node = ResolutionStatement{std::move(value)};
    } else if (word == "include") {
        SourceSpan span;
        std::optional<std::string> file = read_text("a file's name in quotes", span);
        if (file) statement.node = IncludeStatement{{std::move(*file), span}};
    } else if (word == "param") {
        put(read_param());
    } else if (word == "let") {
        named("a name", "'let gap = 5'", [&](Name name) {
            if (ExpressionPtr value = read_expression())
                statement.node = LetStatement{std::move(name), std::move(value)};
        });
    } else if (word == "page") {
        put(read_page());
    } else if (word == "limit") {
        named("what is limited", "", [&](Name name) {
            if (at(TokenKind::assign)) return fail_at_assign();
            if (ExpressionPtr value = read_expression()) {
                statement.node = LimitStatement{std::move(name), std::move(value)};
            }
        });
    } else if (word == "symmetry") {
        named("a symmetry group", "", [&](Name name) { statement.node = SymmetryStatement{std::move(name)}; });
    } else if (word == "palette") {
        named("a name", "'palette ink = [#000, #a03]'", [&](Name name) {
            if (ExpressionPtr colours = read_expression()) {
                statement.node = PaletteStatement{std::move(name), std::move(colours)};
            }
        });
    } else if (word == "start") {
        put(read_start());
    } else if (word == "style") {
        put(read_style());
    } else if (word == "set" || word == "default") {
        put(read_preset(word == "default"));
    } else if (word == "keep") {
        put(read_keep());
    } else if (word == "reroll") {
        put(read_reroll());
    } else if (word == "apply") {
        put(read_apply());
    } else if (word == "system") {
        put(read_system(keyword));
    } else {
        put(read_operator());
    }
}

// --- what cannot start a statement -----------------------------------------------------------------------------

void Parser::fail_first_token(const Token& first) {
    const std::string found = describe(first, text_);
    const auto report_at = [&](std::string code, std::string message, std::vector<std::string> hints) {
        fail(first, error(std::move(code), std::move(message), span_of(first), std::move(hints)));
    };
    if (first.kind == TokenKind::colour || (first.kind == TokenKind::invalid && first.trouble == Trouble::hash)) {
        report_at("language.comment-blank", "found " + found + " where a statement was expected",
                  {"a comment is written '# ...', with a blank behind the '#'"});
    } else if (first.kind == TokenKind::arrow) {
        report_at("language.unexpected-token", "expected a statement, found " + found,
                  {rules_ == Rules::of_shapes
                       ? "the left side of a rule and its arrow stand on one line; behind the arrow it may go on"
                       : "a rule stays on one line; only inside brackets may it go on in the next"});
    } else if (first.kind == TokenKind::slash) {
        report_at("language.unexpected-token", "expected a statement, found " + found,
                  {"a comment is written '# ...'"});
    } else if (first.kind == TokenKind::number || first.trouble == Trouble::bad_unit) {
        report_at("language.unexpected-token", "expected a statement, found " + found,
                  {"a name starts with a letter or '_'"});
    } else {
        fail_expected("language.unexpected-token", "a statement");
    }
}

void Parser::fail_unknown_statement(const Token& first) {
    const std::string_view word = bytes_of(first);
    std::vector<std::string_view> known(keywords.begin(), keywords.end());
    if (rules_ == Rules::of_words) {
        for (const WordSetting& setting : word_settings()) known.push_back(setting.name);
        known.insert(known.end(), {"once", "each"});
    } else if (rules_ == Rules::of_shapes) {
        for (const ShapeSetting& setting : shape_settings()) known.push_back(setting.name);
        known.insert(known.end(), {"rules", "back"});
    }
    std::vector<std::string> hints = did_you_mean(word, known);
    if (rules_ == Rules::of_words && token_behind(first).kind == TokenKind::open_round) {
        hints = {"an edit of the word stands behind 'once', 'after 3' or 'each iteration'"};
    }
    if (hints.empty()) {
        std::string list;
        for (const std::string_view keyword : keywords) list += (list.empty() ? "" : ", ") + std::string(keyword);
        const bool of_shapes = rules_ == Rules::of_shapes;
        hints = {"the statements are " + list, of_shapes ? "a rule is written 'name = left side -> right side'"
                                                         : "a rule is written 'operator(arguments) : tag -> tags'"};
    }
    fail(first, error("language.unknown-statement", "there is no statement " + in_quotes(word), span_of(first), hints));
}

void Parser::expect_statement_end() {
    if (!at_statement_end()) fail_behind_value("language.unexpected-token", "the end of the statement");
}

bool Parser::expect_assign(std::string_view example) {
    if (accept(TokenKind::assign)) return true;
    fail_expected("language.missing-equals", "'='", {"write it as in " + std::string(example)});
    return false;
}

bool Parser::is_only_one(std::optional<std::uint32_t>& first, const Token& keyword) {
    if (first) {
        const std::uint32_t line = line_column(text_, *first).line;
        fail(keyword, error("language.repeated-statement", "found a second " + in_quotes(bytes_of(keyword)),
                            span_of(keyword), {"the first is on line " + std::to_string(line)}));
        return false;
    }
    first = keyword.begin;
    return true;
}

// --- one by one ------------------------------------------------------------------------------------------------

std::optional<VersionStatement> Parser::read_version() {
    const Token token = peek();
    if (token.kind != TokenKind::number) {
        fail_expected("language.missing-value", "the version of the language", {"this is version 1: 'filigree 1'"});
        return std::nullopt;
    }
    if (token.unit != Unit::none || token.number != 1) {
        fail(token,
             error("language.unknown-version", "there is no version " + describe(token, text_) + " of the language",
                   span_of(token), {"this program knows version 1"}));
        return std::nullopt;
    }
    take();
    return VersionStatement{token.number};
}

std::optional<SeedStatement> Parser::read_seed() {
    const Token token = peek();
    const std::vector<std::string> hints = {"a seed is a whole number from 0 to 18446744073709551615"};
    if (has_only_digits(bytes_of(token))) {
        if (const std::optional<std::uint64_t> seed = whole_number(bytes_of(token))) {
            take();
            return SeedStatement{*seed, span_of(token)};
        }
        fail(token,
             error("language.bad-seed", "the seed " + describe(token, text_) + " is too large", span_of(token), hints));
        return std::nullopt;
    }
    const Token next = token_behind(token);
    const bool is_negative = token.kind == TokenKind::minus && next.kind == TokenKind::number;
    const bool is_number = token.kind == TokenKind::number || token.trouble == Trouble::bad_unit || is_negative;
    if (is_number) {
        const SourceSpan span = is_negative ? span_over(span_of(token), span_of(next)) : span_of(token);
        fail(token, error("language.bad-seed",
                          in_quotes(text_.substr(span.begin, span.end - span.begin)) + " is no seed", span, hints));
    } else {
        fail_expected("language.bad-seed", "a whole number", hints);
    }
    return std::nullopt;
}

std::optional<UnitStatement> Parser::read_unit() {
    if (!at(TokenKind::name)) {
        fail_expected("language.unknown-unit", "a unit of length",
                      {"the units of length are mm, cm, m, in, pt and px"});
        return std::nullopt;
    }
    const Token token = take();
    const std::optional<Unit> unit = unit_named(bytes_of(token));
    if (!unit || !is_length_unit(*unit)) {
        std::vector<std::string> hints = did_you_mean(bytes_of(token), {"mm", "cm", "m", "in", "pt", "px"});
        if (hints.empty()) hints = {"the units of length are mm, cm, m, in, pt and px"};
        fail(token, error("language.unknown-unit", "there is no unit of length " + describe(token, text_),
                          span_of(token), std::move(hints)));
        return std::nullopt;
    }
    if (blocks_.empty()) {
        session_.units[file_] = *unit;
    } else {
        blocks_.back().unit = *unit;
    }
    return UnitStatement{*unit};
}

std::optional<ParamStatement> Parser::read_param() {
    ParamStatement param;
    std::optional<Name> name = read_name("a name");
    if (!name || !expect_assign("'param spacing = 25 in 10..60'")) return std::nullopt;
    param.name = std::move(*name);
    param.value = read_plain_range();
    if (!param.value) return std::nullopt;
    std::string wanted = "'in', 'step', a text or the end of the statement";
    if (accept_word("in")) {
        param.domain = read_plain_range();
        if (!param.domain) return std::nullopt;
        wanted = "'step', a text or the end of the statement";
    }
    if (accept_word("step")) {
        param.step = read_expression();
        if (!param.step) return std::nullopt;
        wanted = "a text or the end of the statement";
    }
    if (at(TokenKind::text)) {
        SourceSpan span;
        param.help = read_text("a text", span);
        if (!param.help) return std::nullopt;
        wanted = "the end of the statement";
    }
    if (!at_statement_end()) fail_behind_value("language.unexpected-token", wanted);
    return param;
}

std::optional<PageStatement> Parser::read_page() {
    using Kind = PageStatement::Kind;
    constexpr std::string_view example =
        "a page is written 'page fit', 'page a4', 'page 210mm x 297mm' or 'page tile 10mm x 10mm'";
    PageStatement page;
    if (accept_word("fit")) {
        page.kind = Kind::fit;
    } else {
        const bool is_tile = accept_word("tile");
        page.width = read_expression();
        if (!page.width) return std::nullopt;
        const NameReference* name = std::get_if<NameReference>(&page.width->node);
        if (accept_word("x")) {
            page.kind = is_tile ? Kind::tile : Kind::size;
            page.height = read_expression();
            if (!page.height) return std::nullopt;
        } else if (!is_tile && name != nullptr) {
            page.kind = Kind::named;
            page.name = {name->name, page.width->span};
            page.width = nullptr;
        } else {
            fail_behind_value("language.bad-page", "'x' and a height", {std::string(example)});
            return std::nullopt;
        }
    }
    if (accept_word("margin")) {
        page.margin = read_expression();
        if (!page.margin) return std::nullopt;
    } else if (!at_statement_end()) {
        fail_behind_value("language.bad-page", "'margin' or the end of the statement", {std::string(example)});
    }
    return page;
}

std::optional<StartStatement> Parser::read_start() {
    const Token token = peek(LexMode::tag);
    if (token.kind == TokenKind::name && bytes_of(token) == "from" && token_behind(token).kind == TokenKind::text) {
        take(LexMode::tag);
        SourceSpan span;
        std::optional<std::string> file = read_text("a file's name in quotes", span);
        if (!file) return std::nullopt;
        return StartStatement{{}, nullptr, Name{std::move(*file), span}};
    }
    std::optional<Name> tag = read_tag("behind 'start'");
    if (!tag || !expect_assign("'start leaf = circle(100)'")) return std::nullopt;
    ExpressionPtr value = read_expression();
    if (!value) return std::nullopt;
    return StartStatement{std::move(*tag), std::move(value), std::nullopt};
}

}  // namespace filigree
