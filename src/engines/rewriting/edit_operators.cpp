#include "engines/rewriting/edit_operators.h"

#include <algorithm>

#include "engines/rewriting/edit_runs.h"

namespace filigree::rewriting {
namespace {

using Type = ParameterType;
using Pairs = EditOperator::Pairs;
using Parameters = std::vector<ParameterDescription>;

constexpr std::string_view paper = "GDesign, \"Editing\"";

constexpr double most_tokens = 4e9;

// The other word of an edit of two.
Parameters with_other(Parameters parameters) {
    Parameters all = {
        {.name = "with",
         .type = Type::any,
         .help = "the other word: the letter of a system, or another document in quotes",
         .default_text = "none"},
        {.name = "with_word", .type = Type::text, .help = "the other word, written out", .default_text = "\"\""},
    };
    all.insert(all.end(), parameters.begin(), parameters.end());
    return all;
}

// Which tokens an edit is for.
Parameters with_selector(Parameters parameters) {
    parameters.push_back({.name = "at",
                          .type = Type::text,
                          .help = "the symbols that are chosen; all letters but those of axes if left out",
                          .default_text = "\"\""});
    parameters.push_back({.name = "where",
                          .type = Type::flag,
                          .help = "which of them: a condition for every token, which knows letter, age, depth, "
                                  "distance and index",
                          .default_text = "true"});
    return parameters;
}

ParameterDescription count(std::string_view name, std::string_view help, std::string_view default_text = "0",
                           double low = 0, double high = most_tokens) {
    return {.name = name, .type = Type::whole, .help = help, .default_text = default_text, .low = low, .high = high};
}
ParameterDescription rate(std::string_view name, std::string_view help, std::string_view default_text = "0") {
    return {.name = name, .type = Type::real, .help = help, .default_text = default_text, .low = 0, .high = 1};
}
ParameterDescription branch_condition(std::string_view help) {
    return {.name = "where", .type = Type::flag, .help = help, .default_text = "true"};
}
ParameterDescription inserted_text() {
    return {.name = "text", .type = Type::text, .help = "what is put, its brackets balanced"};
}
ParameterDescription turns() {
    return {.name = "amount",
            .type = Type::whole,
            .help = "how many + before each, or - below 0; for every token, which knows its ordinal among the chosen",
            .low = -1e6,
            .high = 1e6};
}

std::vector<EditOperator> all_operators() {
    const EditOperator::TokenParameter where = {"where", token_facts};
    const EditOperator::TokenParameter where_branch = {"where", branch_facts};
    return {
        {{.name = "add",
          .help = "puts another word behind this one",
          .source = paper,
          .parameters = with_other({}),
          .example = "once add(B)"},
         run_add},
        {{.name = "breed",
          .help = "a hybrid: tokens of this and another word in turns, then what the longer has left",
          .source = "GDesign, Fig. 17 and 19 to 22",
          .parameters = with_other({{.name = "carry",
                                     .type = Type::flag,
                                     .help = "whether every token keeps the heading (X, Y, Z) of its parent",
                                     .default_text = "false"}}),
          .example = "once breed(B, carry)"},
         run_breed},
        {{.name = "react",
          .help =
              "lets the tokens at one place of two words react: \"ac\" -> \"e\" puts e where one has a, the other c",
          .source = paper,
          .parameters = with_other(
              {{.name = "unreacted",
                .type = Type::word,
                .help = "what is kept of other pairs",
                .default_text = "both",
                .words = {"both", "own", "other", "none"}},
               rate("chance", "of each reaction", "1"),
               {.name = "where",
                .type = Type::flag,
                .help = "a condition for every pair, which knows letter, age, depth and distance of the symbol that "
                        "the reaction names first, and other_letter, other_age, ... of the second",
                .default_text = "true"}}),
          .example = "once react(B, \"ac\" -> \"e\", where: depth > 1)"},
         run_react,
         Pairs::reactions,
         {{"where", pair_facts}}},
        {{.name = "compress",
          .help =
              "puts one symbol in the place of each chunk, as \"aaa\" -> \"b\" says: the longest first, from the left",
          .source = "GDesign, Fig. 16",
          .parameters = {{.name = "by_rules",
                          .type = Type::flag,
                          .help = "whether the grammar's own rules say which, backwards",
                          .default_text = "false"},
                         count("passes", "how often, at most, until nothing is left to replace", "1", 1, 1e6)},
          .example = "after 3 compress(\"aaa\" -> \"b\", \"[P+bb]\" -> \"k\")"},
         run_compress,
         Pairs::chunks},
        {{.name = "substitute",
          .help = "puts any text in the place of each chunk, as \"aa\" -> \"T+b\" says, its brackets like those of the "
                  "chunk",
          .source = paper,
          .parameters = {count("passes", "how often, at most, until nothing is left to replace", "1", 1, 1e6)},
          .example = "once substitute(\"aa\" -> \"T+b\")"},
         run_substitute,
         Pairs::chunks},
        {{.name = "insert",
          .help = "puts a text beside symbols",
          .source = paper,
          .parameters = with_selector({inserted_text(),
                                       {.name = "place",
                                        .type = Type::word,
                                        .help = "on which side of them",
                                        .default_text = "before",
                                        .words = {"before", "after"}}}),
          .example = "once insert(\"T+\", at: \"a\", place: before, where: age > 2)"},
         run_insert,
         Pairs::none,
         {where}},
        {{.name = "append",
          .help = "puts a text at the end of branches",
          .source = paper,
          .parameters = {inserted_text(),
                         {.name = "to",
                          .type = Type::word,
                          .help = "to which end of them",
                          .default_text = "end",
                          .words = {"begin", "end"}},
                         branch_condition("which branches: a condition for each, which knows depth, distance, density "
                                          "(how many objects it holds) and ordinal"),
                         {.name = "trunk",
                          .type = Type::flag,
                          .help = "whether the word itself gets it as well",
                          .default_text = "false"}},
          .example = "once append(\"d\", where: depth == 2)"},
         run_append,
         Pairs::none,
         {where_branch}},
        {{.name = "remove",
          .help = "takes branches out, or the tokens of a range",
          .source = paper,
          .parameters = {count("from", "the first token of the range, from 0"),
                         count("to", "the token behind its last"),
                         branch_condition("which branches, where no range is given: a condition for each, which knows "
                                          "depth, distance, density and ordinal")},
          .example = "once remove(where: density < 3)"},
         run_remove,
         Pairs::none,
         {where_branch}},
        {{.name = "crossover",
          .help = "swaps a branch, or a range of tokens, with another word",
          .source = paper,
          .parameters = with_other({count("branch", "of this word, in the order of their opening brackets, from 0"),
                                    count("other_branch", "of the other word"),
                                    count("from", "the first token of a range, from 0"),
                                    count("to", "the token behind its last"),
                                    count("other_from", "the same in the other word"),
                                    count("other_to", "likewise"),
                                    {.name = "keep",
                                     .type = Type::word,
                                     .help = "which of the two words goes on",
                                     .default_text = "own",
                                     .words = {"own", "other"}}}),
          .example = "once crossover(B, branch: 0, other_branch: 2)"},
         run_crossover},
        {{.name = "mutate",
          .help = "changes tokens at random, never brackets; of the four, at most one happens to a token",
          .source = paper,
          .parameters = {rate("replace", "the chance of another token in its place"),
                         rate("remove", "the chance that it goes"),
                         rate("twice", "the chance that it is put twice"),
                         rate("swap", "the chance that it changes places with the next"),
                         {.name = "by",
                          .type = Type::text,
                          .help = "the tokens that replace, each as likely as it is often; those of the word if left "
                                  "out",
                          .default_text = "\"\""}},
          .example = "each iteration mutate(replace: 5%, by: \"aab\")"},
         run_mutate},
        {{.name = "clean",
          .help = "removes blanks, ']' that close nothing and '=' behind nothing, and closes what is open",
          .source = paper,
          .example = "each iteration clean()"},
         run_clean},
        {{.name = "shrink",
          .help = "scales what comes behind symbols, to the end of the branch, by a ~(factor) before each",
          .source = paper,
          .parameters = with_selector({{.name = "factor",
                                        .type = Type::real,
                                        .help = "by which; for every token, which knows its ordinal among the chosen",
                                        .low = 1e-9,
                                        .high = 1e9}}),
          .example = "once shrink(0.9, at: \"F\")"},
         run_shrink,
         Pairs::none,
         {where, {"factor", chosen_facts}}},
        {{.name = "twist",
          .help = "turns before symbols around the heading, by D and signs",
          .source = paper,
          .parameters = with_selector({turns()}),
          .example = "once twist(1, at: \"a\")"},
         run_twist,
         Pairs::none,
         {where, {"amount", chosen_facts}}},
        {{.name = "bend",
          .help = "turns before symbols in the plane, by T and signs",
          .source = paper,
          .parameters = with_selector({turns()}),
          .example = "once bend(ordinal - 2, where: depth == 0)"},
         run_bend,
         Pairs::none,
         {where, {"amount", chosen_facts}}},
    };
}

}  // namespace

bool EditOperator::takes_other() const {
    return !description.parameters.empty() && description.parameters.front().name == "with";
}

std::span<const EditOperator> edit_operators() {
    static const std::vector<EditOperator> all = all_operators();
    return all;
}

const EditOperator* find_edit(std::string_view name) {
    for (const EditOperator& op : edit_operators()) {
        if (op.description.name == name) return &op;
    }
    return nullptr;
}

}  // namespace filigree::rewriting
