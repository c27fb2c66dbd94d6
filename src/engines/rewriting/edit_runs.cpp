#include "engines/rewriting/edit_runs.h"

#include <algorithm>

#include "engines/rewriting/symbols.h"
#include "engines/rewriting/word_edits_checks.h"

namespace filigree::rewriting {
namespace {

Value number_value(double number) { return Value{Quantity{number}, {}}; }
Value letter_value(char32_t letter) { return Value{to_utf8({&letter, 1}), {}}; }

std::array<Value, 5> facts_of(const SymbolAttributes& token, std::uint32_t index) {
    return {letter_value(token.symbol), number_value(token.age), number_value(token.depth),
            number_value(token.distance), number_value(index)};
}
std::array<Value, 4> facts_of(const WordBranch& branch) {
    return {number_value(branch.depth), number_value(branch.distance), number_value(branch.density),
            number_value(branch.ordinal)};
}

// A word, or what was wrong with an argument that was evaluated by token.
Result<EditOutput> finished(const EditInput& input, Result<std::u32string> word, EditTrace trace) {
    if (const std::optional<Diagnostic>& problem = input.arguments.problem()) return *problem;
    if (!word) return std::move(word).diagnostics();
    EditOutput output;
    output.word = std::move(*word);
    output.trace = std::move(trace);
    return output;
}

std::optional<Diagnostic> too_large_together(const EditInput& input) {
    const std::uint64_t size = std::uint64_t{input.word.size()} + input.other.size();
    if (size <= input.most_symbols) return std::nullopt;
    return too_large_word(size, input.most_symbols);
}

// The tokens that `at` and `where` choose.
TokenSelector selector_of(EditInput& input) {
    TokenSelector selector;
    selector.letters = input.arguments.letters("at");
    selector.ages = input.ages;
    if (input.arguments.varies("where")) {
        selector.where = [&input](std::uint32_t index, const SymbolAttributes& token) {
            return input.arguments.holds("where", index, facts_of(token, index));
        };
    } else if (!input.arguments.flag("where")) {
        selector.where = [](std::uint32_t, const SymbolAttributes&) { return false; };
    }
    return selector;
}

BranchSelector branches_of(EditInput& input) {
    BranchSelector selector;
    if (input.arguments.varies("where")) {
        selector.where = [&input](const WordBranch& branch) {
            return input.arguments.holds("where", branch.ordinal, facts_of(branch));
        };
    } else if (!input.arguments.flag("where")) {
        selector.where = [](const WordBranch&) { return false; };
    }
    return selector;
}

// A number for each chosen token.
class ChosenNumber {
public:
    ChosenNumber(EditInput& input, std::string_view parameter) : input_(input), parameter_(parameter) {
        if (!input.arguments.varies(parameter)) return;
        attributes_ = attributes_of(input.word, edit_tokens(input.word), input.ages);
    }
    double operator()(std::uint32_t ordinal, std::uint32_t index) const {
        if (attributes_.empty()) return input_.arguments.number(parameter_);
        const std::array<Value, 5> token = facts_of(attributes_[index], index);
        const std::array<Value, 6> facts = {token[0], token[1], token[2], token[3], token[4], number_value(ordinal)};
        return input_.arguments.number_of(parameter_, index, facts);
    }

private:
    EditInput& input_;
    std::string_view parameter_;
    std::vector<SymbolAttributes> attributes_;  // none where the number is the same for all
};

Result<EditOutput> run_turn(EditInput& input, char32_t axis) {
    const ChosenNumber number(input, "amount");
    const TurnAmount amount = [&](std::uint32_t ordinal, std::uint32_t index) {
        return static_cast<std::int32_t>(number(ordinal, index));
    };
    EditTrace trace;
    Result<std::u32string> word = turn_before(input.word, selector_of(input), axis, amount, input.most_symbols, &trace);
    return finished(input, std::move(word), std::move(trace));
}

// --- chunks and reactions

Result<EditOutput> finished(Result<ChunkEdit> edit, EditTrace trace) {
    if (!edit) return std::move(edit).diagnostics();
    EditOutput output;
    output.word = std::move(edit->word);
    output.trace = std::move(trace);
    output.replaced = edit->replaced;
    output.passes = edit->passes;
    return {std::move(output), edit.diagnostics()};
}

ChunkOptions chunk_options(const EditInput& input, EditTrace& trace) {
    return {static_cast<std::uint32_t>(input.arguments.number("passes")), input.most_symbols, &trace};
}

std::vector<std::u32string_view> split_at_blanks(std::u32string_view text) {
    std::vector<std::u32string_view> parts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(U' ', at), text.size());
        if (end > at) parts.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

// "ab", "a b", "l < a > r  b < c": two symbols, each with what stands around it.
std::optional<std::pair<Reactant, Reactant>> reactants_of(std::u32string_view text) {
    std::vector<std::u32string_view> parts = split_at_blanks(text);
    if (parts.size() == 1) {
        const std::vector<EditToken> tokens = edit_tokens(parts[0]);
        if (tokens.size() != 2) return std::nullopt;
        return std::pair(Reactant{std::u32string(token_text(text, tokens[0]))},
                         Reactant{std::u32string(token_text(text, tokens[1]))});
    }
    std::size_t at = 0;
    const auto next_is = [&](std::u32string_view sign) { return at + 1 < parts.size() && parts[at] == sign; };
    std::array<Reactant, 2> sides;
    for (Reactant& side : sides) {
        if (at == parts.size()) return std::nullopt;
        side.token = parts[at++];
        if (next_is(U"<")) {
            side.left = std::move(side.token);
            side.token = parts[at + 1];
            at += 2;
        }
        if (next_is(U">")) {
            side.right = parts[at + 1];
            at += 2;
        }
    }
    if (at != parts.size()) return std::nullopt;
    return std::pair(std::move(sides[0]), std::move(sides[1]));
}

std::array<Value, 8> facts_of(const SymbolAttributes& x, const SymbolAttributes& y) {
    return {letter_value(x.symbol), number_value(x.age), number_value(x.depth), number_value(x.distance),
            letter_value(y.symbol), number_value(y.age), number_value(y.depth), number_value(y.distance)};
}

TokenRange range_of(const EditInput& input, std::string_view from, std::string_view to) {
    return {static_cast<std::uint32_t>(input.arguments.number(from)),
            static_cast<std::uint32_t>(input.arguments.number(to))};
}

}  // namespace

Result<EditOutput> run_add(EditInput& input) {
    if (std::optional<Diagnostic> problem = too_large_together(input)) return std::move(*problem);
    EditTrace trace;
    std::u32string word = add_words(input.word, input.other, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_breed(EditInput& input) {
    EditTrace trace;
    if (input.arguments.flag("carry")) {
        Result<std::u32string> word = breed_carrying_headings(input.word, input.other, input.most_symbols, &trace);
        return finished(input, std::move(word), std::move(trace));
    }
    if (std::optional<Diagnostic> problem = too_large_together(input)) return std::move(*problem);
    std::u32string word = breed(input.word, input.other, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_react(EditInput& input) {
    std::vector<Reaction> reactions;
    std::uint32_t pair_number = 0;  // that is being asked for
    for (const ChunkPair& pair : input.pairs) {
        std::optional<std::pair<Reactant, Reactant>> sides = reactants_of(pair.from);
        if (!sides) {
            return error("rewriting.no-reactants", quoted(pair.from) + " is not a pair of symbols", {},
                         {"a reaction is written \"ab\" -> \"c\"; with what stands around the symbols, "
                          "\"l < a > r  b\" -> \"c\""});
        }
        Reaction reaction{std::move(sides->first), std::move(sides->second), pair.to};
        if (input.arguments.varies("where")) {
            reaction.condition = [&](const SymbolAttributes& x, const SymbolAttributes& y) {
                return input.arguments.holds("where", pair_number++, facts_of(x, y));
            };
        } else if (!input.arguments.flag("where")) {
            reaction.condition = [](const SymbolAttributes&, const SymbolAttributes&) { return false; };
        }
        const double chance = input.arguments.number("chance");
        if (chance < 1) {
            reaction.happens = [&input, chance](std::uint32_t at) {
                return to_unit(input.bits(at, MutationDraw::replace)) < chance;
            };
        }
        reactions.push_back(std::move(reaction));
    }
    const std::string_view kept = input.arguments.word("unreacted");
    EditTrace trace;
    ReactOptions options;
    options.unreacted = kept == "both"    ? Unreacted::both
                        : kept == "own"   ? Unreacted::a
                        : kept == "other" ? Unreacted::b
                                          : Unreacted::none;
    options.ages_a = input.ages;
    options.most_symbols = input.most_symbols;
    options.trace = &trace;
    Result<std::u32string> word = react(input.word, input.other, reactions, options);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_compress(EditInput& input) {
    EditTrace trace;
    const ChunkOptions options = chunk_options(input, trace);
    const bool by_rules = input.arguments.flag("by_rules");
    if (by_rules == !input.pairs.empty()) {
        return error("rewriting.missing-pairs",
                     by_rules ? "the grammar's own rules are taken, so there is nothing to say of chunks"
                              : "nothing says what is to be replaced",
                     {}, {"write it as in compress(\"aaa\" -> \"b\"), or compress(by_rules)"});
    }
    Result<ChunkEdit> edit = by_rules ? compress_by_rules(input.word, input.productions, options)
                                      : compress(input.word, input.pairs, options);
    return finished(std::move(edit), std::move(trace));
}

Result<EditOutput> run_substitute(EditInput& input) {
    EditTrace trace;
    Result<ChunkEdit> edit = substitute(input.word, input.pairs, chunk_options(input, trace));
    return finished(std::move(edit), std::move(trace));
}

Result<EditOutput> run_insert(EditInput& input) {
    const Side side = input.arguments.word("place") == "before" ? Side::before : Side::after;
    EditTrace trace;
    Result<std::u32string> word = insert_beside(input.word, input.arguments.letters("text"), side, selector_of(input),
                                                input.most_symbols, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_append(EditInput& input) {
    BranchSelector selector = branches_of(input);
    selector.with_trunk = input.arguments.flag("trunk");
    const BranchEnd end = input.arguments.word("to") == "begin" ? BranchEnd::begin : BranchEnd::end;
    EditTrace trace;
    Result<std::u32string> word =
        append_to_branches(input.word, input.arguments.letters("text"), end, selector, input.most_symbols, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_remove(EditInput& input) {
    EditTrace trace;
    const bool has_range = input.arguments.is_given("from") || input.arguments.is_given("to");
    if (has_range && input.arguments.is_given("where")) {
        return error("rewriting.range-or-branches", "both a range and branches are to be removed", {},
                     {"'from' and 'to' are a range of tokens, 'where' says which branches"});
    }
    Result<std::u32string> word = has_range ? remove_range(input.word, range_of(input, "from", "to"), &trace)
                                            : remove_branches(input.word, branches_of(input), &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_crossover(EditInput& input) {
    const EditArguments& arguments = input.arguments;
    const auto any_given = [&](std::initializer_list<std::string_view> names) {
        return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return arguments.is_given(name); });
    };
    const bool by_ranges = any_given({"from", "to", "other_from", "other_to"});
    if (by_ranges && any_given({"branch", "other_branch"})) {
        return error("rewriting.range-or-branches", "both ranges and branches are to be swapped", {},
                     {"'from' to 'other_to' are two ranges of tokens, 'branch' and 'other_branch' two branches"});
    }
    if (std::optional<Diagnostic> problem = too_large_together(input)) return std::move(*problem);
    PairTrace trace;
    Result<WordPair> pair =
        by_ranges ? crossover(input.word, range_of(input, "from", "to"), input.other,
                              range_of(input, "other_from", "other_to"), &trace)
                  : crossover_branches(input.word, static_cast<std::uint32_t>(arguments.number("branch")), input.other,
                                       static_cast<std::uint32_t>(arguments.number("other_branch")), &trace);
    if (!pair) return std::move(pair).diagnostics();
    EditOutput output{std::move(pair->a), std::move(trace.a), std::move(pair->b)};
    if (arguments.word("keep") == "other") {
        std::swap(output.word, output.other);
        output.trace = std::move(trace.b);
    }
    return output;
}

Result<EditOutput> run_mutate(EditInput& input) {
    const EditArguments& arguments = input.arguments;
    const MutationRates rates = {arguments.number("replace"), arguments.number("remove"), arguments.number("twice"),
                                 arguments.number("swap")};
    EditTrace trace;
    Result<std::u32string> word =
        mutate(input.word, rates, arguments.letters("by"), input.bits, input.most_symbols, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_clean(EditInput& input) {
    EditOutput output;
    CleanedWord cleaned = clean_up(input.word, &output.trace);
    output.word = std::move(cleaned.word);
    output.changes = std::move(cleaned.changes);
    return output;
}

Result<EditOutput> run_shrink(EditInput& input) {
    const ChosenNumber factor(input, "factor");
    const ShrinkFactor by = [&](std::uint32_t ordinal, std::uint32_t index) {
        const double number = factor(ordinal, index);
        return input.arguments.problem() ? 1 : number;
    };
    EditTrace trace;
    Result<std::u32string> word = shrink(input.word, selector_of(input), by, input.most_symbols, &trace);
    return finished(input, std::move(word), std::move(trace));
}

Result<EditOutput> run_twist(EditInput& input) { return run_turn(input, U'D'); }
Result<EditOutput> run_bend(EditInput& input) { return run_turn(input, U'T'); }

}  // namespace filigree::rewriting
