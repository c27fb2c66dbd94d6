// The parser's inside: one object reads one text, statement by statement.
//
// Every reading function returns nothing, null or false once the statement has failed, and its caller then
// returns as well; the first failure of a statement is its only one. parse.cpp holds the loop over statements
// and the includes, the other parse_*.cpp files a part of the grammar each.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "language/document.h"
#include "language/lexer.h"
#include "language/parse.h"

namespace filigree {

// What the texts of one document share while they are parsed.
struct ParseSession {
    const IncludeLoader* include = nullptr;
    std::vector<std::unique_ptr<SourceFile>> sources;  // at stable addresses: tokens are views into them
    std::vector<Unit> units;
    std::vector<Statement> statements;
    Diagnostics diagnostics;
    std::size_t bytes = 0;                    // of all texts so far
    std::set<std::string, std::less<>> seen;  // files by their plain name
    std::vector<std::string> open_files;      // those being parsed, outermost first
    bool is_full = false;                     // of diagnostics: nothing more is read
};

// Parses one more text: the document or an included file.
void parse_source(ParseSession& session, std::string_view name, std::string_view text);

// An expression being built: its height bounds every later recursion over it.
struct Tree {
    std::shared_ptr<Expression> node;
    int height = 0;

    explicit operator bool() const { return node != nullptr; }
};

class Parser {
public:
    Parser(ParseSession& session, std::string_view text, std::uint32_t file)
        : session_(session), text_(text), file_(file), at_(text_start(text)), lookahead_left_(4 * text.size() + 1000) {}

    void parse_statements();
    // One thing and nothing else; none: the failure is in the session.
    std::optional<ExpressionPtr> parse_lone_expression();
    std::optional<ChoicePath> parse_lone_path();
    std::optional<OperatorCall> parse_lone_call();
    std::optional<OperatorCall> parse_lone_edit_call();
    std::optional<std::vector<OutputTag>> parse_lone_outputs();

private:
    // --- tokens (parse.cpp)
    const Token& peek(LexMode mode = LexMode::value);
    Token take(LexMode mode = LexMode::value);
    bool at(TokenKind kind, LexMode mode = LexMode::value) { return peek(mode).kind == kind; }
    bool accept(TokenKind kind, LexMode mode = LexMode::value);
    bool at_word(std::string_view word);  // a name of these bytes
    bool accept_word(std::string_view word);
    bool at_statement_end();
    void skip_line_ends();
    void skip_statement_ends();
    bool expect_text_end(std::string_view wanted);
    Token token_behind(const Token& token) const { return read_token(text_, token.end, LexMode::value, false); }
    std::string_view bytes_of(const Token& token) const { return text_.substr(token.begin, token.end - token.begin); }
    SourceSpan span_of(const Token& token) const { return {file_, token.begin, token.end}; }
    SourceSpan span_from(std::uint32_t begin) const { return {file_, begin, taken_end_}; }
    // Takes a '(' or '[', inside which lines go on; false where brackets nest too deep.
    bool open_bracket();
    void close_bracket();

    // --- failures (parse_recovery.cpp)
    void fail(const Token& at, Diagnostic diagnostic);
    // "expected WANTED, found ..." the token ahead, or what is wrong with that token itself.
    void fail_expected(std::string_view code, std::string_view wanted, std::vector<std::string> hints = {});
    // The same behind an expression, where a sign of another language is the likely reason.
    void fail_behind_value(std::string_view code, std::string_view wanted, std::vector<std::string> hints = {});
    // Neither a ',' nor the closing bracket ahead, behind an item.
    void fail_in_list();
    // If the token ahead shows that the innermost bracket was never closed.
    bool fail_if_unclosed();
    void fail_unclosed(const Token& open, const Token& found);
    void fail_trailing_comma(const Token& comma, std::vector<std::string> hints = {});
    void skip_failed_statement(const Token& first);
    std::uint32_t behind_line(std::uint32_t at, bool is_lost);
    void skip_continuation();
    void skip_right_side(std::uint32_t begin);
    std::optional<std::uint32_t> behind_brackets(std::uint32_t from, std::size_t depth);
    std::optional<std::uint32_t> end_of_block(std::uint32_t open);
    std::optional<std::uint32_t> behind_block(std::uint32_t open);
    bool spend(const Token& token, std::uint32_t from);

    // --- statements (parse_statement.cpp)
    std::optional<Statement> read_statement();
    void read_by_keyword(const Token& keyword, Statement& statement);
    void fail_first_token(const Token& first);
    void fail_unknown_statement(const Token& first);
    std::optional<VersionStatement> read_version();
    std::optional<SeedStatement> read_seed();
    std::optional<UnitStatement> read_unit();
    std::optional<ParamStatement> read_param();
    std::optional<PageStatement> read_page();
    std::optional<StartStatement> read_start();
    bool is_only_one(std::optional<std::uint32_t>& first, const Token& keyword);
    bool expect_assign(std::string_view example);
    void expect_statement_end();

    // --- words (parse_word.cpp)
    std::optional<std::string> normal_name(const Token& token);
    std::optional<Name> read_name(std::string_view wanted, LexMode mode = LexMode::value);
    std::optional<Name> read_tag(std::string_view place);  // "behind ':'"
    bool is_tag(const Token& token, std::string_view place);
    std::optional<std::string> read_text(std::string_view wanted, SourceSpan& span);

    // --- paths (parse_path.cpp) and what stands before them (parse_preset.cpp)
    std::optional<ChoicePath> read_path(std::string_view example);
    void fail_behind_path(std::string_view code, std::string_view wanted, std::vector<std::string> hints = {});
    std::optional<PresetStatement> read_preset(bool is_default);
    std::optional<KeepStatement> read_keep();
    std::optional<RerollStatement> read_reroll();
    bool read_times(RerollStatement& reroll);
    std::optional<ApplyStatement> read_apply();
    bool read_targets(std::vector<ChoicePath>& targets);

    // --- statements with statements inside (parse_block.cpp)
    struct Block {
        Token open;  // its '{'
        bool has_rules_alone = false;
        std::optional<Unit> unit = {};
    };
    // Where the statements that may stand once stand first.
    struct FirstPlaces {
        std::optional<std::uint32_t> version, seed, unit;
    };
    bool may_stand_here(const Token& keyword);
    std::optional<SystemStatement> read_system(const Token& keyword);
    std::optional<OperatorStatement> read_operator();
    bool read_definition_parameters(std::vector<DefinitionParameter>& parameters);
    bool read_ports(std::vector<Name>& ports);
    std::optional<Block> read_block(bool has_rules_alone, std::vector<Statement>& into, std::string_view wanted);

    // --- styles (parse_style.cpp) and rules (parse_rule.cpp)
    std::optional<StyleStatement> read_style();
    bool read_style_block(StyleStatement& style);
    std::optional<StyleProperty> read_property();
    bool is_rule(const Token& first, bool is_keyword) const;
    std::optional<GroupRule> read_rule();
    // `takes_pairs`: "ab" -> "c" may stand among the arguments, as the edits of words take it.
    std::optional<OperatorCall> read_call(std::string_view example = "", bool takes_pairs = false);
    struct Clause {
        std::string_view word;
        // A value, null until it is read; several; or a word alone.
        std::variant<ExpressionPtr*, std::vector<ExpressionPtr>*, bool*> into;
    };
    bool read_clauses(std::initializer_list<Clause> clauses);
    bool read_outputs(std::vector<OutputTag>& outputs, bool is_rule);
    bool read_output_list(std::vector<OutputTag>& outputs, bool is_rule);
    std::optional<OutputTag> read_output(std::string_view place);
    std::optional<OutputTag> read_angled_output();
    void fail_behind_tag(std::string_view code, std::string_view wanted, bool is_rule);

    // --- words and their rules (parse_rewriting.cpp)
    bool is_word_statement(const Token& first);
    bool line_has_arrow() const;
    bool is_cell(const Token& name) const;
    std::optional<Statement> read_word_statement();
    std::optional<SettingStatement> read_setting();
    std::optional<WordRule> read_word_rule(Name symbols);
    std::optional<MacroStatement> read_macro(Name symbol);
    std::optional<CellStatement> read_cell(Name array);
    bool read_indexes(std::vector<ExpressionPtr>& indexes);
    std::optional<RestStatement> read_rest();
    std::optional<LoopStatement> read_loop();
    bool read_numbered_symbols(std::vector<NumberedSymbols>& all, std::string_view wanted_number);
    bool read_iterations(std::uint32_t& first, std::uint32_t& last);
    bool read_numbers(std::uint32_t& first, std::uint32_t& last, std::string_view wanted);
    std::optional<std::uint32_t> read_number_from_one(std::string_view wanted);
    bool read_word_successors(WordRule& rule);
    std::optional<WordSuccessor> read_word_successor();
    bool read_assignments(WordRule& rule);
    std::optional<WordLookup> read_lookup();  // parse_lookup.cpp
    bool read_lookup_row(WordLookup& lookup);
    ExpressionPtr read_lone_word();
    // Symbols up to one that stands for itself only in quotes: < > @ = and an arrow.
    std::optional<Name> read_symbols(std::string_view wanted);
    std::optional<Name> read_symbol(std::string_view wanted);
    std::uint32_t behind_blanks(std::uint32_t at) const;
    bool is_arrow(std::uint32_t at) const;
    bool accept_sign(char sign);

    // --- edits of words (parse_word_edit.cpp)
    bool is_word_edit(const Token& first) const;
    std::optional<WordEditStatement> read_word_edit();
    std::optional<OperatorCall> read_edit_call();

    // --- rules of shapes and matches chosen by hand (parse_shape.cpp)
    enum class ShapeStatement { none, rule, setting, rules_from, match, back };
    ShapeStatement shape_statement(const Token& first, bool is_keyword) const;
    bool is_shape_rule(const Token& first, bool is_reserved) const;
    bool is_match(const Token& apply) const;
    bool is_way_back(const Token& first) const;
    bool has_arrow_behind(const Token& token) const;  // on its line, in its statement
    void read_shape_statement(ShapeStatement kind, Statement& statement);
    std::optional<ShapeRule> read_shape_rule();
    bool read_right_side(ShapeRule& rule);
    bool next_line_is_right_side();
    void fail_without_arrow(const ShapeRule& rule);
    std::optional<RulesFromStatement> read_rules_from();
    std::optional<SettingStatement> read_shape_setting();
    std::optional<MatchStatement> read_match();
    std::optional<BackStatement> read_back();
    // Each clause once, but for those that hold several, up to the end of the statement.
    bool read_all_clauses(std::initializer_list<Clause> clauses, std::string_view owner);

    // --- expressions (parse_expression.cpp)
    ExpressionPtr read_expression();   // the whole of `expr`
    ExpressionPtr read_plain_range();  // without `? :` and `in`: what `param` takes
    Tree read_conditional();
    Tree read_within();
    Tree read_range();
    Tree read_binary(int least_tier);
    Tree read_unary();
    Tree read_postfix();
    Tree read_primary();
    Tree read_name_or_call();
    Tree read_bracketed();
    Tree read_list();
    bool read_items(TokenKind close, std::vector<ExpressionPtr>& items, int& height);
    bool read_arguments(std::vector<CallArgument>& arguments, int& height, bool takes_pairs = false);
    bool read_key(CallArgument& argument, const Token& first, bool takes_pairs);
    void fail_missing_value();
    template <class Node>
    Tree make(SourceSpan span, int height, Node node);

    // --- includes (parse.cpp)
    void include_file(const IncludeStatement& statement);
    void report(Diagnostic diagnostic);

    ParseSession& session_;
    std::string_view text_;
    std::uint32_t file_;
    std::uint32_t at_;             // where the next token is read
    std::uint32_t taken_end_ = 0;  // the end of the last token taken
    TokenKind taken_kind_ = TokenKind::end_of_line;

    Token ahead_;  // read at at_ in this way, if has_ahead_
    LexMode ahead_mode_ = LexMode::value;
    bool ahead_lines_go_on_ = false;
    bool has_ahead_ = false;

    std::vector<Token> open_;          // the ( and [ around the place
    std::optional<Token> open_block_;  // the { of a style around the place
    std::vector<Block> blocks_;        // the systems and the operator around the statement
    std::size_t nesting_ = 0;          // `?` around the place
    bool has_failed_ = false;
    Token failed_at_;               // the token that could not be taken
    bool is_continued_ = false;     // the statement broke off where its author went on in the next line
    std::uint64_t lookahead_left_;  // bytes

    struct BlockEnd {
        std::uint32_t begin = 0, end = 0;  // end 0: nothing closes it
    };
    std::vector<BlockEnd> block_ends_;
    bool has_block_ends_ = false;
    FirstPlaces first_;  // in the innermost block
    enum class Rules { of_groups, of_words, of_shapes };
    Rules rules_ = Rules::of_groups;  // by the `grammar` above
};

}  // namespace filigree
