// Where a grammar is no more than a substitution: one successor a letter, whatever stands around it and whenever.
//
// Then its words are made at the speed of memory (substitution.h), and words that are too long for any memory can be
// asked for their length and their parts (implicit_word.h).
#pragma once

#include <optional>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/substitution.h"

namespace filigree::rewriting {

// The substitution that makes every further word of the derivation; none where something else has a say. The symbols
// that can arise are added to its alphabet.
std::optional<Substitution> plain_substitution(Derivation& derivation, const Grammar& grammar);

// `steps` iterations at once. As by `step`, where the substitution is the derivation's.
std::optional<Diagnostic> step_plainly(Derivation& derivation, const Substitution& substitution, std::uint64_t steps,
                                       const Limits& limits, Executor& executor);

}  // namespace filigree::rewriting
