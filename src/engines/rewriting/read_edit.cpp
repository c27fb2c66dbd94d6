#include "engines/rewriting/read_edit.h"

#include <algorithm>
#include <array>

#include "engines/rewriting/edit_operators.h"
#include "engines/rewriting/edit_step.h"
#include "engines/rewriting/pattern.h"
#include "language/check.h"

namespace filigree::rewriting {
namespace {

// Errors that hang on the word.
constexpr std::array<std::string_view, 3> of_words = {"rewriting.range-outside", "rewriting.torn-range",
                                                      "rewriting.no-such-branch"};

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

Diagnostic unknown_edit(const Name& name) {
    std::vector<std::string_view> names;
    for (const EditOperator& op : edit_operators()) names.push_back(op.description.name);
    std::vector<std::string> hints = did_you_mean(name.text, names);
    if (hints.empty()) {
        std::string list;
        for (const std::string_view known : names) list += (list.empty() ? "" : ", ") + std::string(known);
        hints.push_back("the edits are " + list);
    }
    return error("rewriting.unknown-edit", "there is no edit " + quoted(name.text), name.span, std::move(hints));
}

// Values as they might be, to find wrong kinds.
Scope example_facts(std::span<const std::string_view> facts, const Scope& outer) {
    Scope scope{&outer};
    double number = 2;
    for (const std::string_view fact : facts) {
        const bool is_letter = fact == "letter" || fact == "other_letter";
        scope.names[std::string(fact)] = is_letter ? Value{std::string("a"), {}} : Value{Quantity{number += 0.37}, {}};
    }
    return scope;
}

class EditReader {
public:
    EditReader(const EditCall& call, const EditOperator& op, const Grammar& grammar, const Document& document,
               const Scope& globals)
        : call_(call),
          op_(op),
          grammar_(grammar),
          document_(document),
          globals_(globals),
          names_(names_of_word(grammar.registers, 1, &globals)) {}

    Result<WordEdit> run() {
        edit_.op = &op_;
        edit_.span = call_.span;
        edit_.frees_braces = grammar_.systems[0].frees_braces;
        const auto before = std::count_if(grammar_.edits.begin(), grammar_.edits.end(),
                                          [&](const WordEdit& known) { return known.op == &op_; });
        edit_.key = child(child(Key{}, op_.description.name), static_cast<std::uint64_t>(before));
        std::vector<CallArgument> arguments;
        for (const CallArgument& argument : call_.arguments) {
            const auto* from = argument.key ? std::get_if<TextLiteral>(&argument.key->node) : nullptr;
            if (from == nullptr) {
                arguments.push_back(with_name(argument));
            } else {
                read_pair(*from, argument);
            }
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        Scope varying = names_;  // what is known somewhere in this call
        varying.outer = &globals_;
        for (const EditOperator::TokenParameter& parameter : op_.by_token) {
            varying.names.merge(example_facts(parameter.facts, globals_).names);
        }
        Result<BoundCall> bound = filigree::bind(op_.description, arguments, call_.span, document_, globals_, &varying);
        if (!bound) return std::move(bound).diagnostics();
        edit_.call = std::move(*bound);
        for (std::size_t i = 0; i < edit_.call.expressions.size(); ++i) check_names(i);
        if (!has_errors(diagnostics_)) check_other();
        if (!has_errors(diagnostics_)) try_out();
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return {std::move(edit_), std::move(diagnostics_)};
    }

private:
    void report(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }

    void read_pair(const TextLiteral& from, const CallArgument& argument) {
        if (op_.pairs == EditOperator::Pairs::none) {
            return report(error("rewriting.needless-pair", quoted(op_.description.name) + " takes no such pairs",
                                argument.key->span));
        }
        const auto* to = std::get_if<TextLiteral>(&argument.value->node);
        if (to == nullptr) {
            return report(error("rewriting.bad-pair", "expected a text in quotes behind '->'", argument.value->span,
                                {"write it as in \"aaa\" -> \"b\""}));
        }
        Result<Pattern> pattern = read_pattern(to->text, argument.value->span, edit_.frees_braces);
        if (!pattern) return append(diagnostics_, std::move(pattern).diagnostics());
        const bool has_blanks = op_.pairs == EditOperator::Pairs::reactions;  // between the two sides
        edit_.pairs.push_back({letters_of(from.text, has_blanks), std::move(*pattern)});
    }

    // A flag's own name may stand anywhere, where the word of a system could be taken for it: breed(carry, B).
    CallArgument with_name(const CallArgument& argument) const {
        const auto* name = argument.key ? nullptr : std::get_if<NameReference>(&argument.value->node);
        if (name == nullptr) return argument;
        const std::vector<ParameterDescription>& parameters = op_.description.parameters;
        const bool is_flag = std::any_of(parameters.begin(), parameters.end(), [&](const ParameterDescription& known) {
            return known.type == ParameterType::flag && known.name == name->name;
        });
        return is_flag ? CallArgument{argument.value, argument.value} : argument;
    }

    // Binding knows too many names: those of other parameters, and what steps of group grammars know.
    void check_names(std::size_t i) {
        const ParameterDescription& parameter = op_.description.parameters[i];
        if (!edit_.call.given[i] || edit_.call.constants[i]) return;
        const auto by_token = std::find_if(op_.by_token.begin(), op_.by_token.end(),
                                           [&](const auto& known) { return known.name == parameter.name; });
        Scope facts{&names_};
        if (by_token != op_.by_token.end()) facts = example_facts(by_token->facts, names_);
        Evaluation at = edit_.call.expected[i];
        at.document = &document_;
        at.scope = &facts;
        append(diagnostics_, check_expression(*edit_.call.expressions[i], at));
        if (by_token == op_.by_token.end()) return;
        edit_.by_token.push_back({i, edit_.call.expressions[i]});
        const bool is_flag = parameter.type == ParameterType::flag;
        edit_.call.constants[i] = is_flag ? Value{true, {}} : Value{Quantity{1}, {}};
    }

    bool is_given(std::string_view name) const {
        for (std::size_t i = 0; i < op_.description.parameters.size(); ++i) {
            if (op_.description.parameters[i].name == name) return edit_.call.given[i];
        }
        return false;
    }

    void check_other() {
        if (!op_.takes_other()) return;
        const std::string name = quoted(op_.description.name);
        if (is_given("with") == is_given("with_word")) {
            return report(error(
                "rewriting.other-word",
                is_given("with") ? name + " takes one other word, and here are two" : name + " needs another word",
                call_.span, {"give the letter of a system, another document in quotes, or with_word: \"abc\""}));
        }
        const std::optional<Value>& with = edit_.call.constants.front();
        if (!is_given("with") || !with) return;
        const auto* word = std::get_if<filigree::Symbol>(&with->data);
        if (word == nullptr || system_of_letter(grammar_, word->name)) return;
        std::string letters;
        for (std::size_t s = 1; s < grammar_.systems.size(); ++s) {
            letters += (letters.empty() ? "" : ", ") + to_utf8({&grammar_.systems[s].letter, 1});
        }
        report(error("rewriting.unknown-system", "there is no system " + quoted(word->name),
                     edit_.call.expressions.front()->span,
                     {letters.empty() ? "write one as in 'system B { axiom \"ab\" }', or name a document in quotes"
                                      : "the systems are " + letters}));
    }

    // On a word without symbols, most of what is wrong with texts, pairs and rates shows.
    void try_out() {
        const StepChoices choices;
        EditArguments arguments(edit_, document_, names_, choices, {});
        Diagnostics problems = arguments.evaluate_common(most_edited_symbols);
        const Result<std::vector<ChunkPair>> pairs = put_pairs(edit_.pairs, document_, names_, most_edited_symbols);
        append(problems, pairs.diagnostics());
        if (!has_errors(problems)) {
            EditInput input{{}, {}, {}, *pairs, {}, arguments, [](std::uint32_t, MutationDraw) { return 0; }};
            append(problems, op_.run(input).diagnostics());
        }
        for (Diagnostic& problem : problems) {
            const bool hangs_on_word = std::find(of_words.begin(), of_words.end(), problem.code) != of_words.end();
            if (hangs_on_word || problem.severity != Severity::error) continue;
            if (problem.span.file == SourceSpan::no_file) problem.span = call_.span;
            report(std::move(problem));
        }
    }

    const EditCall& call_;
    const EditOperator& op_;
    const Grammar& grammar_;
    const Document& document_;
    const Scope& globals_;
    const Scope names_;
    WordEdit edit_;
    Diagnostics diagnostics_;
};

}  // namespace

Result<WordEdit> read_edit(const EditCall& call, const Grammar& grammar, const Document& document,
                           const Scope& globals) {
    const EditOperator* op = find_edit(call.name.text);
    if (op == nullptr) return unknown_edit(call.name);
    return EditReader(call, *op, grammar, document, globals).run();
}

}  // namespace filigree::rewriting
