// The paths that a document can produce, and the checks of its presets against them.
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "language/possible_paths.h"
#include "session/check.h"
#include "session/word_paths.h"

namespace filigree {

// What a node of the graph is, for checking what is said of it.
struct PathPlace {
    const OpenedDocument* opened = nullptr;  // whose it is: the document's own, or one that it embeds
    const CheckedDocument* checked = nullptr;
    std::uint32_t rule = tangle::none;           // a step: index into the grammar's rules
    std::uint32_t tag = tangle::none;            // a group: index into its tags
    const OperatorDescription* start = nullptr;  // the shape of a start
    bool is_style = false;
    std::optional<WordPathPlace> word;  // in a word
};
struct DocumentPaths {
    PathGraph graph;
    std::vector<PathPlace> places;  // of each node
};
// `checked` must hold a grammar. With the steps that its `apply` statements add, as far as their places are possible.
DocumentPaths document_paths(const OpenedDocument& opened, const CheckedDocument& checked);

// What is wrong with the document's set, default, keep, reroll and apply: impossible paths (with the nearest one that
// is possible), values outside what their parameters allow.
Diagnostics check_presets(const OpenedDocument& opened, const CheckedDocument& checked);

}  // namespace filigree
