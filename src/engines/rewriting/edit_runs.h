// What each edit does with its arguments; the table of edits is edit_operators.cpp.
#pragma once

#include <array>

#include "engines/rewriting/edit_operators.h"

namespace filigree::rewriting {

// What arguments that are evaluated by token know: of a token, of one that is chosen, of a pair of tokens that may
// react, and of a branch.
constexpr std::array<std::string_view, 5> token_facts = {"letter", "age", "depth", "distance", "index"};
constexpr std::array<std::string_view, 6> chosen_facts = {"letter", "age", "depth", "distance", "index", "ordinal"};
constexpr std::array<std::string_view, 8> pair_facts = {"letter",       "age",       "depth",       "distance",
                                                        "other_letter", "other_age", "other_depth", "other_distance"};
constexpr std::array<std::string_view, 4> branch_facts = {"depth", "distance", "density", "ordinal"};

Result<EditOutput> run_add(EditInput& input);
Result<EditOutput> run_breed(EditInput& input);
Result<EditOutput> run_react(EditInput& input);
Result<EditOutput> run_compress(EditInput& input);
Result<EditOutput> run_substitute(EditInput& input);
Result<EditOutput> run_insert(EditInput& input);
Result<EditOutput> run_append(EditInput& input);
Result<EditOutput> run_remove(EditInput& input);
Result<EditOutput> run_crossover(EditInput& input);
Result<EditOutput> run_mutate(EditInput& input);
Result<EditOutput> run_clean(EditInput& input);
Result<EditOutput> run_shrink(EditInput& input);
Result<EditOutput> run_twist(EditInput& input);
Result<EditOutput> run_bend(EditInput& input);

}  // namespace filigree::rewriting
