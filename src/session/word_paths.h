// The paths that the word of a document can have: which letters may descend from which, and where edits and subsystems
// stand (engines/rewriting/spots.h). Part of the graph of all paths (path_graph.h).
//
// What a grammar can put is told by its texts alone, so that more is taken for possible than ever comes about.
#pragma once

#include <cstdint>
#include <vector>

#include "engines/rewriting/grammar.h"
#include "language/possible_paths.h"

namespace filigree {

// What a node of the graph stands for: a letter as a system rewrites it, or an edit.
struct WordPathPlace {
    const rewriting::Grammar* grammar = nullptr;
    std::uint32_t system = 0;
    char32_t letter = 0;                        // 0: no letter
    const rewriting::WordEdit* edit = nullptr;  // null: no edit
};

// Adds the nodes of a word. Returns what they stand for, in their order; `roots` gets those that paths begin with.
std::vector<WordPathPlace> add_word_nodes(const rewriting::Grammar& grammar, PathGraph& graph,
                                          std::vector<std::uint32_t>& roots);

}  // namespace filigree
