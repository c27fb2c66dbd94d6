#include "language/parse.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/unicode.h"
#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

namespace {

// "./leaf.fil" and "leaf.fil" are one file.
std::string plain_name(std::string_view name) {
    return std::filesystem::path(name).lexically_normal().generic_string();
}

// Why a text cannot be read at all.
std::optional<Diagnostic> unreadable(std::string_view text, std::size_t bytes_before, std::uint32_t file) {
    if (text.size() > max_document_bytes - std::min(max_document_bytes, bytes_before)) {
        return error("language.too-large", "a document and what it includes may have 64 MiB, this has more",
                     {file, 0, 0});
    }
    const std::size_t invalid = unicode::find_invalid(text);
    if (invalid != std::string_view::npos) {
        const auto begin = static_cast<std::uint32_t>(invalid);
        return error("language.not-utf8", "this byte is no part of valid UTF-8", {file, begin, begin + 1},
                     {"save the file as UTF-8"});
    }
    return std::nullopt;
}

// Whether a statement of an included file is left out: it belongs to the document that is shown.
bool is_for_the_document_alone(const Statement& statement) {
    return std::visit(
        [](const auto& node) {
            using Node = std::decay_t<decltype(node)>;
            return std::is_same_v<Node, VersionStatement> || std::is_same_v<Node, GrammarStatement> ||
                   std::is_same_v<Node, SeedStatement> || std::is_same_v<Node, UnitStatement> ||
                   std::is_same_v<Node, PageStatement> || std::is_same_v<Node, StartStatement> ||
                   std::is_same_v<Node, LimitStatement>;
        },
        statement.node);
}

}  // namespace

void parse_source(ParseSession& session, std::string_view name, std::string_view text) {
    const auto file = static_cast<std::uint32_t>(session.sources.size());
    session.units.push_back(Unit::px);
    std::optional<Diagnostic> problem = unreadable(text, session.bytes, file);
    const bool is_too_large = problem && problem->code == "language.too-large";
    session.sources.push_back(
        std::make_unique<SourceFile>(SourceFile{std::string(name), std::string(is_too_large ? "" : text)}));
    if (problem) {
        session.diagnostics.push_back(std::move(*problem));
        return;
    }
    session.bytes += text.size();
    Parser(session, session.sources.back()->text, file).parse_statements();
}

Parsed parse_document(std::string_view name, std::string_view text, const IncludeLoader& include) {
    ParseSession session;
    session.include = &include;
    session.open_files.push_back(plain_name(name));
    parse_source(session, name, text);

    Parsed parsed;
    for (const std::unique_ptr<SourceFile>& source : session.sources) {
        parsed.document.sources.push_back(std::move(*source));
    }
    parsed.document.units = std::move(session.units);
    parsed.document.statements = std::move(session.statements);
    parsed.diagnostics = std::move(session.diagnostics);
    return parsed;
}

namespace {

template <class Part>
Result<Part> parse_part(std::string_view text, std::uint32_t file, std::optional<Part> (Parser::*read)()) {
    if (std::optional<Diagnostic> problem = unreadable(text, 0, file)) return std::move(*problem);
    ParseSession session;
    Parser parser(session, text, file);
    std::optional<Part> part = (parser.*read)();
    if (!part) return std::move(session.diagnostics);
    return std::move(*part);
}

}  // namespace

Result<ExpressionPtr> parse_expression(std::string_view text, std::uint32_t file) {
    return parse_part(text, file, &Parser::parse_lone_expression);
}
Result<ChoicePath> parse_path(std::string_view text, std::uint32_t file) {
    return parse_part(text, file, &Parser::parse_lone_path);
}
Result<OperatorCall> parse_call(std::string_view text, std::uint32_t file) {
    return parse_part(text, file, &Parser::parse_lone_call);
}
Result<OperatorCall> parse_edit_call(std::string_view text, std::uint32_t file) {
    return parse_part(text, file, &Parser::parse_lone_edit_call);
}
Result<std::vector<OutputTag>> parse_outputs(std::string_view text, std::uint32_t file) {
    return parse_part(text, file, &Parser::parse_lone_outputs);
}

// --- the loop over statements ----------------------------------------------------------------------------------

void Parser::parse_statements() {
    while (!session_.is_full) {
        skip_statement_ends();
        const Token first = peek();
        if (first.kind == TokenKind::end_of_text) return;
        std::optional<Statement> statement = read_statement();
        if (!statement) {
            skip_failed_statement(first);
            continue;
        }
        const std::optional<IncludeStatement> include = std::holds_alternative<IncludeStatement>(statement->node)
                                                            ? std::optional(std::get<IncludeStatement>(statement->node))
                                                            : std::nullopt;
        if (file_ == 0 || !is_for_the_document_alone(*statement)) {
            session_.statements.push_back(std::move(*statement));
        }
        if (include) include_file(*include);
    }
}

std::optional<ExpressionPtr> Parser::parse_lone_expression() {
    skip_line_ends();
    ExpressionPtr expression = read_expression();
    if (!expression || !expect_text_end("the end of the expression")) return std::nullopt;
    return expression;
}

std::optional<ChoicePath> Parser::parse_lone_path() {
    skip_line_ends();
    std::optional<ChoicePath> path = read_path("a path is written as in 'leaf/outline.distance'");
    if (!path) return std::nullopt;
    skip_line_ends();
    if (!at(TokenKind::end_of_text)) {
        fail_behind_path("language.unexpected-token", "the end of the path");
        return std::nullopt;
    }
    return path;
}

std::optional<OperatorCall> Parser::parse_lone_call() {
    skip_line_ends();
    std::optional<OperatorCall> call = read_call("a step by hand is written as in 'outline(5)' or 'ring = outline(5)'");
    if (!call || !expect_text_end("the end of the call")) return std::nullopt;
    return call;
}

std::optional<OperatorCall> Parser::parse_lone_edit_call() {
    skip_line_ends();
    std::optional<OperatorCall> call = read_edit_call();
    if (!call || !expect_text_end("the end of the edit")) return std::nullopt;
    return call;
}

std::optional<std::vector<OutputTag>> Parser::parse_lone_outputs() {
    skip_line_ends();
    std::vector<OutputTag> outputs;
    if (!read_outputs(outputs, false) || !expect_text_end("the end of the tags")) return std::nullopt;
    return outputs;
}

void Parser::report(Diagnostic diagnostic) {
    if (session_.is_full) return;
    if (session_.diagnostics.size() >= max_diagnostics) {
        session_.is_full = true;
        session_.diagnostics.push_back(error(
            "language.too-many-errors", "there are more errors than these; the rest is not read", diagnostic.span));
        return;
    }
    session_.diagnostics.push_back(std::move(diagnostic));
}

// --- includes ----------------------------------------------------------------------------------------------------

void Parser::include_file(const IncludeStatement& statement) {
    const std::string& name = statement.file.text;
    const SourceSpan span = statement.file.span;
    if (session_.include == nullptr || !*session_.include) {
        return report(error("language.no-include", "nothing can be included here", span));
    }
    const std::string plain = plain_name(name);
    std::vector<std::string>& open = session_.open_files;
    const auto outer = std::find(open.begin(), open.end(), plain);
    if (outer != open.end()) {
        std::string chain;
        for (auto file = outer; file != open.end(); ++file) chain += *file + " -> ";
        return report(error("language.include-cycle", "the file " + in_quotes(name) + " includes itself", span,
                            {"the circle is " + chain + plain}));
    }
    if (!session_.seen.insert(plain).second) return;
    if (open.size() >= max_include_depth) {
        return report(error("language.include-depth", "files include each other more than 32 deep", span));
    }
    Result<std::string> text = (*session_.include)(name);
    const bool is_loaded = static_cast<bool>(text);
    Diagnostics notes = text.diagnostics();
    if (!is_loaded && !has_errors(notes)) {
        notes.push_back(error("language.no-include", "the file " + in_quotes(name) + " cannot be included"));
    }
    for (Diagnostic& note : notes) {
        note.span = span;
        report(std::move(note));
    }
    if (!is_loaded) return;
    open.push_back(plain);
    parse_source(session_, name, *text);
    open.pop_back();
}

// --- tokens --------------------------------------------------------------------------------------------------------

const Token& Parser::peek(LexMode mode) {
    const bool lines_go_on = !open_.empty();
    if (!has_ahead_ || ahead_mode_ != mode || ahead_lines_go_on_ != lines_go_on) {
        ahead_ = read_token(text_, at_, mode, lines_go_on);
        ahead_mode_ = mode;
        ahead_lines_go_on_ = lines_go_on;
        has_ahead_ = true;
    }
    return ahead_;
}

Token Parser::take(LexMode mode) {
    const Token token = peek(mode);
    at_ = token.end;
    taken_end_ = token.end;
    taken_kind_ = token.kind;
    has_ahead_ = false;
    return token;
}

bool Parser::accept(TokenKind kind, LexMode mode) {
    if (!at(kind, mode)) return false;
    take(mode);
    return true;
}

bool Parser::at_word(std::string_view word) { return at(TokenKind::name) && bytes_of(ahead_) == word; }

bool Parser::accept_word(std::string_view word) {
    if (!at_word(word)) return false;
    take();
    return true;
}

bool Parser::at_statement_end() {
    return at(TokenKind::end_of_line) || at(TokenKind::semicolon) || at(TokenKind::end_of_text) ||
           (at(TokenKind::close_curly) && !blocks_.empty());
}

void Parser::skip_line_ends() {
    while (accept(TokenKind::end_of_line)) {}
}

void Parser::skip_statement_ends() {
    while (accept(TokenKind::end_of_line) || accept(TokenKind::semicolon)) {}
}

bool Parser::expect_text_end(std::string_view wanted) {
    skip_line_ends();
    if (!at(TokenKind::end_of_text)) fail_behind_value("language.unexpected-token", wanted);
    return !has_failed_;
}

bool Parser::open_bracket() {
    const Token token = peek();
    if (open_.size() + nesting_ >= max_nesting) {
        fail(token, error("language.nesting", "brackets nest deeper than 200 here", span_of(token)));
        return false;
    }
    take();
    open_.push_back(token);
    return true;
}

void Parser::close_bracket() {
    take();
    open_.pop_back();
    has_ahead_ = false;
}

}  // namespace filigree
