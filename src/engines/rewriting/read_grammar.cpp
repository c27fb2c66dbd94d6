#include "engines/rewriting/read_grammar.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engines/rewriting/pattern.h"
#include "engines/rewriting/read_edit.h"
#include "engines/rewriting/read_lookup.h"
#include "engines/rewriting/rule_match.h"
#include "engines/rewriting/setting_values.h"
#include "engines/rewriting/symbol_facts.h"
#include "formats/csv_read.h"
#include "language/check.h"
#include "language/walk.h"
#include "language/word_settings.h"

namespace filigree::rewriting {
namespace {

constexpr double most_iterations = 1e6;
constexpr std::size_t most_cells = 1'000'000;
constexpr double most_letters = 1e6;  // of a macro

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }
std::string quoted(char32_t letter) { return "'" + to_utf8(std::u32string(1, letter)) + "'"; }

class GrammarReader : private SettingValues {
public:
    GrammarReader(const Settings& settings, const Document& document, const Inputs& inputs)
        : SettingValues(settings, document), settings_(settings), document_(document), inputs_(inputs) {}

    Result<Grammar> run() {
        grammar_.maps = read_maps(settings_, document_, inputs_, diagnostics);
        find_registers_and_arrays(document_.statements);
        add_examples();
        read_system(document_.statements, 0, {});
        check_cells();
        read_edits();
        const bool failed = has_errors(diagnostics);
        if (failed) return std::move(diagnostics);
        return Result<Grammar>(std::move(grammar_), std::move(diagnostics));
    }

private:
    // --- values ---

    Pattern pattern_of(const Name& text, bool frees_braces) {
        Result<Pattern> pattern = read_pattern(text.text, text.span, frees_braces);
        if (pattern) return std::move(*pattern);
        for (Diagnostic problem : pattern.diagnostics()) report(std::move(problem));
        return {};
    }

    // --- what rules will ask ---

    // Values as rules may meet them, for checking their expressions before anything is derived.
    void add_examples() {
        registers_.outer = &settings_.globals;
        for (const Register& known : grammar_.registers)
            registers_.names[known.name] = Value{Quantity{known.value}, {}};
        constexpr std::span names(fact_names);
        facts_of_row_ = example_scope(names.first(row_fact_count), &registers_);
        facts_of_symbol_ = example_scope(names, &registers_);
    }
    Evaluation with(const Scope& scope) const {
        Evaluation at;
        at.document = &document_;
        at.scope = &scope;
        return at;
    }
    // What is no number, whatever the values.
    Diagnostics problems_of_number(const ExpressionPtr& expression, const Scope& scope) const {
        Diagnostics problems = check_expression(*expression, with(scope));
        if (!problems.empty()) return problems;
        if (has_choice(*expression)) {
            return {error("rewriting.choice-in-rule", "the expressions of rules draw nothing", expression->span,
                          {"several successors, and macros as in 'R = random 1..8 \"ab\"', draw at random"})};
        }
        const Result<Value> value = evaluate(*expression, with(scope));
        if (value) return as_number(Value{value->data, expression->span}).diagnostics();
        return {};  // with these values alone
    }
    void check_number(const ExpressionPtr& expression, const Scope& scope) {
        if (expression) append(diagnostics, problems_of_number(expression, scope));
    }
    // One that is the same whatever the values, and so is wrong from the beginning.
    template <class Wrong>
    void check_constant(const ExpressionPtr& expression, const Scope& scope, Wrong wrong) {
        if (!expression || hangs_on(scope, *expression)) return;
        const Result<Value> value = evaluate(*expression, with(scope));
        const Result<double> number = value ? as_number(*value) : Result<double>(value.diagnostics());
        if (!number) return;
        if (std::optional<Diagnostic> problem = wrong(*number, expression->span)) report(std::move(*problem));
    }
    // Whether it names what is no name of the whole document.
    bool hangs_on(const Scope& scope, const Expression& expression) const {
        const std::vector<NameInExpression> names = names_in(expression);
        return std::any_of(names.begin(), names.end(), [&](const NameInExpression& name) {
            for (const Scope* at = &scope; at != nullptr && at != &settings_.globals; at = at->outer) {
                if (at->names.contains(name.text)) return true;
            }
            return false;
        });
    }
    void check_text(const Pattern& text, const Scope& scope, SourceSpan span) {
        check_counts(text.parts, scope, span);
        const std::optional<double> length = letter_count(text);
        if (!length || *length <= static_cast<double>(settings_.limits.elements)) return;
        report(fault(
            Fault::limit, "limit.elements",
            "this text has more symbols than the " + std::to_string(settings_.limits.elements) + " that are allowed",
            span));
    }
    // The numbers of repeats have no place of their own in the document.
    void check_counts(const std::vector<Pattern::Part>& parts, const Scope& scope, SourceSpan text) {
        for (const Pattern::Part& part : parts) {
            if (!part.count) continue;
            for (Diagnostic problem : problems_of_number(part.count, scope)) {
                problem.span = text;
                report(std::move(problem));
            }
            check_counts(part.repeated, scope, text);
        }
    }
    void check_condition_of(const ExpressionPtr& condition, std::vector<std::string_view> looked_up = {}) {
        const Scope known = example_scope(looked_up, &facts_of_symbol_);
        std::vector<std::string_view> varying = std::move(looked_up);
        varying.insert(varying.end(), fact_names.begin(), fact_names.end());
        append(diagnostics, check_condition(*condition, with(known), settings_.globals, varying));
    }
    void check_expressions(const Rule& rule) {
        const std::vector<std::string_view> looked_up = names_looked_up(rule, grammar_.maps);
        const Scope known = example_scope(looked_up, &facts_of_symbol_);
        check_number(rule.loop, facts_of_row_);
        check_constant(rule.loop, facts_of_row_, wrong_loop);
        if (rule.condition) check_condition_of(rule.condition, looked_up);
        for (const Assignment& assignment : rule.assignments) check_number(assignment.value, known);
        for (const Successor& successor : rule.successors) {
            check_number(successor.weight, known);
            check_constant(successor.weight, known, wrong_weight);
            for (const ExpressionPtr& index : successor.indexes) check_number(index, known);
            check_text(successor.pattern, known, successor.span);
            for (const Lookup::Row& row : successor.lookup.rows) check_text(row.pattern, known, row.span);
        }
    }

    // --- what holds for the whole document ---

    void find_registers_and_arrays(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) {
            if (const auto* system = std::get_if<SystemStatement>(&statement.node)) {
                find_registers_and_arrays(system->statements);
            }
            const auto* setting = std::get_if<SettingStatement>(&statement.node);
            if (setting == nullptr) continue;
            if (setting->name.text == "register") add_register(*setting);
            if (setting->name.text == "array") add_array(*setting);
        }
        for (const Statement& statement : statements) {
            if (const auto* cell = std::get_if<CellStatement>(&statement.node)) fill_cell(*cell);
        }
    }
    static Diagnostic doubled(const std::string& what, SourceSpan span) {
        return error("rewriting.doubled-name", what + " is already there", span);
    }
    void add_register(const SettingStatement& setting) {
        const std::string* name = word_of(setting.values[0]);
        if (name == nullptr || setting.values.size() > 2) return fail_usage(setting);
        Register added{*name, 0};
        if (setting.values.size() == 2) {
            const std::optional<double> value = number_of(setting.values[1]);
            if (!value) return;
            added.value = *value;
        }
        if (find_named(grammar_.registers, *name) != nullptr) {
            return report(doubled("the register " + quoted(*name), setting.name.span));
        }
        if (std::find(fact_names.begin(), fact_names.end(), *name) != fact_names.end()) {
            return report(error("rewriting.reserved-name",
                                quoted(*name) + " is what rules know of a symbol, so no register can have this name",
                                setting.values[0]->span));
        }
        grammar_.registers.push_back(std::move(added));
    }
    // array NAME [rows] [columns]... [wrap | clamp], or array NAME from "rules.csv" [wrap | clamp]
    void add_array(const SettingStatement& setting) {
        std::vector<ExpressionPtr> values = setting.values;
        const std::string* name = word_of(values[0]);
        if (name == nullptr) return fail_usage(setting);
        Array array{*name, {}, {}, OutOfRange::error};
        if (values.size() > 2 && word_of(values.back()) != nullptr) {
            array.out_of_range = static_cast<OutOfRange>(one_of(values.back(), {"error", "wrap", "clamp"}));
            values.pop_back();
        }
        const std::string* from = values.size() == 3 ? word_of(values[1]) : nullptr;
        const std::string* file = from != nullptr && *from == "from" ? text_of(values[2]) : nullptr;
        const bool is_read =
            file != nullptr ? read_cells(array, *file, values[2]->span) : read_sizes(array, setting, values);
        if (!is_read) {
            broken_arrays_.insert(*name);
            return;
        }
        if (find_named(grammar_.arrays, *name) != nullptr) {
            return report(doubled("the array " + quoted(*name), setting.name.span));
        }
        grammar_.arrays.push_back(std::move(array));
    }
    bool read_sizes(Array& array, const SettingStatement& setting, const std::vector<ExpressionPtr>& values) {
        if (values.size() < 2) {
            fail_usage(setting);
            return false;
        }
        std::size_t cells = 1;
        for (std::size_t i = 1; i < values.size(); ++i) {
            const auto* list = std::get_if<ListExpression>(&values[i]->node);
            if (list == nullptr || list->items.size() != 1) {
                fail_usage(setting);
                return false;
            }
            const std::optional<double> size = whole_of(list->items[0], 1, most_cells);
            if (!size) return false;
            array.sizes.push_back(static_cast<std::uint32_t>(*size));
            cells *= array.sizes.back();
            if (!may_have(cells, setting.name.span)) return false;
        }
        array.cells.resize(cells);
        return true;
    }
    bool may_have(std::size_t cells, SourceSpan span) {
        if (cells <= most_cells) return true;
        report(error("rewriting.out-of-range", "an array may have a million cells, this has more", span));
        return false;
    }
    // A table with one column is a sequence: its cells have one index.
    bool read_cells(Array& array, const std::string& file, SourceSpan span) {
        const Input* input = find_input(inputs_, file);
        if (input == nullptr) {
            report(error("input.missing", "the file " + quoted(file) + " is not there", span));
            return false;
        }
        const Result<std::vector<CsvRow>> rows = read_csv(input->bytes);
        if (!rows) {
            Diagnostic problem = rows.diagnostics().front();
            problem.message = "in " + quoted(file) + ", " + problem.message;
            problem.span = span;
            report(std::move(problem));
            return false;
        }
        const std::size_t columns = rows->front().cells.size();
        if (!may_have(rows->size() * columns, span)) return false;
        array.sizes.push_back(static_cast<std::uint32_t>(rows->size()));
        if (columns > 1) array.sizes.push_back(static_cast<std::uint32_t>(columns));
        for (const CsvRow& row : *rows) {
            for (const std::string& cell : row.cells) {
                Result<Pattern> pattern = read_pattern(cell, span);
                for (Diagnostic problem : pattern.diagnostics()) {
                    problem.message =
                        "in line " + std::to_string(row.line) + " of " + quoted(file) + ", " + problem.message;
                    report(std::move(problem));
                }
                array.cells.push_back(pattern ? std::move(*pattern) : Pattern{});
                cell_texts_.emplace_back(array.cells.back(), span);
            }
        }
        return true;
    }
    void fill_cell(const CellStatement& cell) {
        Array* array = array_of(cell.array, cell.indexes.size());
        if (array == nullptr) return;
        std::size_t at = 0;
        for (std::size_t i = 0; i < cell.indexes.size(); ++i) {
            const std::optional<double> index = whole_of(cell.indexes[i], 0, array->sizes[i] - 1.0);
            if (!index) return;
            at = at * array->sizes[i] + static_cast<std::size_t>(*index);
        }
        array->cells[at] = pattern_of(cell.text, false);
        cell_texts_.emplace_back(array->cells[at], cell.text.span);
    }
    void check_cells() {
        for (const auto& [pattern, span] : cell_texts_) check_text(pattern, facts_of_symbol_, span);
    }
    // Null where there is none with so many indexes, which is reported, unless the array itself was.
    Array* array_of(const Name& name, std::size_t indexes) {
        Array* array = find_named(grammar_.arrays, name.text);
        if (array != nullptr && array->sizes.size() == indexes) return array;
        if (!broken_arrays_.contains(name.text)) report(unknown_array(name));
        return nullptr;
    }
    Diagnostic unknown_array(const Name& name) {
        std::vector<std::string_view> names;
        for (const Array& array : grammar_.arrays) names.push_back(array.name);
        std::vector<std::string> hints = did_you_mean(name.text, names);
        if (hints.empty()) hints.push_back("an array is declared as in 'array M [10] [10]'");
        return error("rewriting.unknown-array", "there is no array " + quoted(name.text) + " with so many indexes",
                     name.span, std::move(hints));
    }

    // --- edits, which are said of the whole word ---

    void read_edits() {
        for (const Statement& statement : document_.statements) {
            if (const auto* edit = std::get_if<WordEditStatement>(&statement.node)) read_one_edit(*edit);
        }
    }
    void read_one_edit(const WordEditStatement& said) {
        Result<WordEdit> edit =
            read_edit({said.edit_name, said.arguments, said.call_span}, grammar_, document_, settings_.globals);
        for (const Diagnostic& problem : edit.diagnostics()) report(problem);
        if (!edit) return;
        edit->is_once = said.is_once;
        edit->first = said.first;
        edit->last = said.last;
        grammar_.edits.push_back(std::move(*edit));
    }

    // --- one system ---

    void read_system(const std::vector<Statement>& statements, std::size_t which, const Name& name) {
        grammar_.systems[which].letter = name.text.empty() ? U'\0' : letters_of(name.text)[0];
        read_subsystems(statements, which);
        bool frees_braces = false;
        for (const Statement& statement : statements) {
            const auto* setting = std::get_if<SettingStatement>(&statement.node);
            if (setting != nullptr && setting->name.text == "free") read_free(*setting, which, frees_braces);
            if (const auto* macro = std::get_if<MacroStatement>(&statement.node)) read_macro(*macro, which);
        }
        grammar_.systems[which].frees_braces = frees_braces;
        std::set<std::string_view> said;
        const Name* axiom = nullptr;
        for (const Statement& statement : statements) {
            if (const auto* setting = std::get_if<SettingStatement>(&statement.node)) {
                const WordSetting& known = *find_word_setting(setting->name.text);
                const bool is_of_gait = which != 0 && known.is_of_systems;
                if (known.is_of_drawing && !is_of_gait) continue;  // read_draw_rules
                if (known.is_map) continue;                        // read_maps
                const bool may_repeat = setting->name.text == "free" || setting->name.text == "array" ||
                                        setting->name.text == "register" || setting->name.text == "gain";
                if (!may_repeat && !said.insert(setting->name.text).second) {
                    report(error("rewriting.repeated-setting", "found a second " + quoted(setting->name.text),
                                 setting->name.span));
                    continue;
                }
                if (setting->name.text == "axiom") axiom = &setting->name;
                read_setting(*setting, which, frees_braces);
            }
            if (const auto* edit = std::get_if<WordEditStatement>(&statement.node); edit != nullptr && which != 0) {
                report(error("rewriting.edit-in-system", "a system's word is not edited", edit->edit_name.span,
                             {"edits stand outside of systems, and are for the whole word"}));
            }
            if (const auto* rule = std::get_if<WordRule>(&statement.node)) {
                read_rule(*rule, statement.span, which, frees_braces);
            }
            if (const auto* rest = std::get_if<RestStatement>(&statement.node)) {
                read_rest(*rest, statement.span, grammar_.systems[which]);
            }
            if (const auto* loop = std::get_if<LoopStatement>(&statement.node)) {
                read_loop(*loop, grammar_.systems[which]);
            }
        }
        check_loops(grammar_.systems[which]);
        if (axiom == nullptr) {
            const SourceSpan at = which == 0 ? settings_.engine_span : name.span;
            report(error("rewriting.missing-axiom", "there is no axiom to begin with", at,
                         {"write it as in 'axiom \"a\"'"}));
        }
    }

    void read_subsystems(const std::vector<Statement>& statements, std::size_t which) {
        for (const Statement& statement : statements) {
            const auto* inner = std::get_if<SystemStatement>(&statement.node);
            if (inner == nullptr) continue;
            const std::u32string letters = letters_of(inner->name.text);
            if (letters.size() != 1) continue;
            if (find_system(grammar_, letters[0])) {
                report(doubled("the system " + quoted(inner->name.text), inner->name.span));
                continue;
            }
            grammar_.systems[which].roles.subsystems += letters;
            grammar_.systems.emplace_back();
            read_system(inner->statements, grammar_.systems.size() - 1, inner->name);
        }
    }

    void read_free(const SettingStatement& setting, std::size_t which, bool& frees_braces) {
        for (const ExpressionPtr& value : setting.values) {
            const std::string* said = word_of(value) != nullptr ? word_of(value) : text_of(value);
            if (said == nullptr) return fail_usage(setting);
            for (const char32_t letter : letters_of(*said)) {
                grammar_.systems[which].roles.free(letter);
                frees_braces = frees_braces || letter == U'{' || letter == U'}';
            }
        }
    }

    void read_macro(const MacroStatement& statement, std::size_t which) {
        System& system = grammar_.systems[which];
        Macro macro;
        const std::u32string letters = letters_of(statement.symbol.text);
        if (letters.size() != 1) {
            return report(error("rewriting.bad-letter", "a blank is no symbol", statement.symbol.span));
        }
        macro.letter = letters[0];
        macro.letters = letters_of(statement.letters.text);
        macro.is_unique = statement.is_unique;
        const auto* range = std::get_if<RangeExpression>(&statement.length->node);
        const std::optional<double> low = whole_of(range ? range->low : statement.length, 0, most_letters);
        const std::optional<double> high = range ? whole_of(range->high, 0, most_letters) : low;
        if (!low || !high) return;
        if (*high < *low || macro.letters.empty()) {
            return report(error("rewriting.bad-macro",
                                macro.letters.empty() ? "there are no letters to draw from" : "this range is empty",
                                macro.letters.empty() ? statement.letters.span : statement.length->span));
        }
        macro.low = static_cast<std::uint32_t>(*low);
        macro.high = static_cast<std::uint32_t>(*high);
        for (const Macro& known : system.macros) {
            if (known.letter == macro.letter) {
                return report(doubled(quoted(macro.letter), statement.symbol.span));
            }
        }
        system.roles.free(macro.letter);
        system.roles.macros += macro.letter;
        system.macros.push_back(std::move(macro));
    }

    void read_setting(const SettingStatement& setting, std::size_t which, bool frees_braces) {
        System& system = grammar_.systems[which];
        const std::string& name = setting.name.text;
        const ExpressionPtr& value = setting.values[0];
        if (name == "free" || name == "array" || name == "register") return;
        if (name == "gain") return read_gain(setting, system);
        if (!has_values(setting, 1, 1)) return;
        if (name == "dialect") {
            one_of(value, {"gdesign"});
        } else if (name == "axiom") {
            const std::string* text = text_of(value);
            if (text == nullptr) return fail_usage(setting);
            system.axiom = pattern_of({*text, value->span}, frees_braces);
            check_text(system.axiom, registers_, value->span);
            system.axiom_span = value->span;
        } else if (name == "iterations") {
            if (const auto count = whole_of(value, 0, most_iterations)) {
                system.iterations = static_cast<std::uint32_t>(*count);
            }
        } else if (name == "after") {
            system.after = static_cast<AfterRows>(one_of(value, {"identity", "hold", "cycle"}));
        } else if (name == "memory") {
            system.recalls_last = one_of(value, {"first", "last"}) == 1;
        } else if (name == "random") {
            grammar_.draws = static_cast<DrawMode>(one_of(value, {"lineage", "position"}));
        } else if (name == "ages") {
            grammar_.ages = static_cast<AgeMode>(one_of(value, {"position", "lineage"}));
        } else if (name == "ignore") {
            const std::string* text = text_of(value);
            if (text == nullptr) return fail_usage(setting);
            system.ignored = letters_of(*text);
        } else if (name == "mode") {
            system.grows = one_of(value, {"instant", "grow"}) == 1;
        } else if (name == "angle") {
            system.gait.angle = angle_of(value);
        } else if (name == "angle2") {
            system.gait.angle2 = angle_of(value);
        } else if (name == "step") {
            system.gait.step = own_step(value);
        }
    }
    // Where the document says none, it goes 1 px, and who says 2 goes twice as far, whatever the unit.
    std::optional<double> own_step(const ExpressionPtr& value) {
        const std::optional<double> step = length_from(value, smallest_step);
        const bool is_said =
            std::any_of(document_.statements.begin(), document_.statements.end(), [](const Statement& statement) {
                const auto* setting = std::get_if<SettingStatement>(&statement.node);
                return setting != nullptr && setting->name.text == "step";
            });
        if (!step || is_said) return step;
        return *step / *as_length(Value{Quantity{1}, value->span}, document_);
    }
    void read_gain(const SettingStatement& setting, System& system) {
        if (setting.values.size() % 2 != 0) return fail_usage(setting);
        for (std::size_t i = 0; i < setting.values.size(); i += 2) {
            const std::optional<char32_t> letter = letter_of(setting.values[i]);
            const std::optional<double> by = whole_of(setting.values[i + 1], 0, 1e9);
            if (letter && by) system.gains.push_back({*letter, static_cast<std::uint32_t>(*by)});
        }
    }

    void read_rest(const RestStatement& said, SourceSpan span, System& system) {
        if (said.condition) check_condition_of(said.condition);
        for (const NumberedSymbols& symbols : said.symbols) {
            const std::u32string letters = letters_of(symbols.text.text);
            if (letters.empty() || letters.find(U'=') != std::u32string::npos) {
                report(error("rewriting.bad-letter", "expected symbols that can stay as they are, not '=' or a blank",
                             symbols.text.span));
                continue;
            }
            for (const char32_t letter : letters) {
                system.rests.push_back({letter, symbols.first, symbols.last, said.condition, said.is_until, span});
            }
        }
    }

    void read_loop(const LoopStatement& said, System& system) {
        check_number(said.length, facts_of_row_);
        for (const NumberedSymbols& symbols : said.symbols) {
            for (const char32_t letter : letters_of(symbols.text.text)) {
                system.loops.push_back({letter, symbols.first, symbols.last, said.length, symbols.text.span});
            }
        }
    }
    // Once all rules are there.
    void check_loops(const System& system) {
        for (const RowLoop& loop : system.loops) {
            const auto rows = std::count_if(system.rules.begin(), system.rules.end(),
                                            [&](const Rule& rule) { return rule.letter == loop.letter; });
            if (rows >= loop.first) continue;
            report(warning("rewriting.no-such-row",
                           quoted(loop.letter) + " has " + (rows == 0 ? "no rules" : "fewer rules") +
                               ", so this loop does nothing",
                           loop.span));
        }
    }

    void read_rule(const WordRule& said, SourceSpan span, std::size_t which, bool frees_braces) {
        const Roles roles = grammar_.systems[which].roles;
        Rule rule;
        const std::u32string letters = letters_of(said.symbol.text);
        if (letters.size() != 1) {
            return report(error("rewriting.bad-letter", "a blank is no symbol", said.symbol.span));
        }
        rule.letter = letters[0];
        rule.left = letters_of(said.left.text);
        rule.right = letters_of(said.right.text);
        rule.first = said.first;
        rule.last = said.last;
        rule.loop = said.loop;
        rule.condition = said.condition;
        rule.span = span;
        const Role role = roles.of(rule.letter);
        const bool has_rules = role == Role::ordinary || role == Role::ordinal || role == Role::follower;
        if (!has_rules) {
            return report(error("rewriting.special-letter",
                                quoted(rule.letter) + " has a meaning of its own, so no rule rewrites it",
                                said.symbol.span, {"'free " + said.symbol.text + "' makes it an ordinary letter"}));
        }
        for (const Name* context : {&said.left, &said.right}) check_brackets(*context);
        for (const WordSuccessor& successor : said.successors) read_successor(successor, rule, frees_braces);
        number_like_ones(rule.successors);
        for (const WordAssignment& assignment : said.assignments) {
            if (find_named(grammar_.registers, assignment.name.text) != nullptr) {
                rule.assignments.push_back({assignment.name.text, assignment.value});
                continue;
            }
            std::vector<std::string_view> names;
            for (const Register& known : grammar_.registers) names.push_back(known.name);
            std::vector<std::string> hints = did_you_mean(assignment.name.text, names);
            if (hints.empty()) hints.push_back("a register is declared as in 'register ix 3'");
            report(error("rewriting.unknown-register", "there is no register " + quoted(assignment.name.text),
                         assignment.name.span, std::move(hints)));
        }
        System& system = grammar_.systems[which];
        std::uint64_t like_it = 0;
        for (const Rule& known : system.rules) like_it += known.letter == rule.letter ? 1 : 0;
        rule.key = child(Key{rule.letter}, like_it);
        check_expressions(rule);
        system.rules.push_back(std::move(rule));
    }
    void check_brackets(const Name& context) {
        int open = 0;
        for (const char c : context.text) {
            open += c == '[' ? 1 : c == ']' ? -1 : 0;
            if (open < 0) break;
        }
        if (open != 0) {
            report(error("rewriting.unmatched-bracket", "the brackets of this context do not match", context.span));
        }
    }
    void read_successor(const WordSuccessor& said, Rule& rule, bool frees_braces) {
        Successor successor;
        successor.weight = said.weight;
        successor.span = said.span;
        if (said.target) {
            successor.kind = Successor::Kind::jump;
            const std::u32string target = letters_of(said.target->text);
            if (target.size() != 1) {
                return report(error("rewriting.bad-letter", "a blank is no symbol", said.target->span));
            }
            if (said.iteration > most_iterations) {
                return report(
                    error("rewriting.out-of-range", "a derivation has at most a million iterations", said.span));
            }
            successor.target = target[0];
            successor.target_iteration = said.iteration;
        } else if (said.array) {
            successor.kind = Successor::Kind::cell;
            successor.array = said.array->text;
            successor.indexes = said.indexes;
            array_of(*said.array, said.indexes.size());
        } else if (said.lookup) {
            successor.kind = Successor::Kind::lookup;
            Result<Lookup> lookup = read_lookup(*said.lookup, grammar_.maps, settings_, document_, frees_braces);
            append(diagnostics, lookup.diagnostics());
            if (lookup) successor.lookup = std::move(*lookup);
        } else {
            successor.pattern = pattern_of(*said.text, frees_braces);
        }
        successor.name = name_of(said);
        rule.successors.push_back(std::move(successor));
    }
    static void number_like_ones(std::vector<Successor>& successors) {
        std::map<std::string, int> met;
        for (Successor& successor : successors) {
            const int number = ++met[successor.name];
            if (number > 1) successor.name += "#" + std::to_string(number);
        }
    }
    std::string name_of(const WordSuccessor& said) const {
        if (said.text) return to_utf8(letters_of(said.text->text));
        if (said.target) return "goto " + said.target->text + "@" + std::to_string(said.iteration);
        if (said.lookup) return (said.lookup->is_image ? "image " : "data ") + said.lookup->map.text;
        // As it is written, up to the bracket behind the last index.
        const std::string& source = document_.sources[said.span.file].text;
        const std::size_t end = source.find(']', said.indexes.back()->span.end);
        return source.substr(said.span.begin, end + 1 - said.span.begin);
    }

    const Settings& settings_;
    const Document& document_;
    const Inputs& inputs_;
    Grammar grammar_;
    std::vector<std::pair<Pattern, SourceSpan>> cell_texts_;
    std::set<std::string, std::less<>> broken_arrays_;  // what is wrong with them is said
    Scope registers_, facts_of_row_, facts_of_symbol_;  // example values
};

}  // namespace

Result<Grammar> read_grammar(const Settings& settings, const Document& document, const Inputs& inputs) {
    return GrammarReader(settings, document, inputs).run();
}

}  // namespace filigree::rewriting
