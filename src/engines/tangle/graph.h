// The graph of a grammar: a node a rule, an edge where one rule's output is another's matching tag
// (gTangle, section 5), and what it shows to be wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "language/document.h"

namespace filigree::tangle {

// Built from rules as they are written, so that it can be shown beside errors.
struct RuleGraph {
    std::vector<std::vector<std::uint32_t>> successors;  // of each rule, ascending, each once
    std::size_t edges = 0;
    // Rules on the longest path; rules that reach each other count once each, in one place.
    std::size_t longest_path = 0;
};
RuleGraph rule_graph(std::span<const GroupRule* const> rules);

// Warnings: rules that can never apply, outputs that differ from a matching tag by a slip, and rules that
// give their own tag back without making shapes smaller.
Diagnostics graph_warnings(const RuleGraph& graph, std::span<const GroupRule* const> rules, const Document& document,
                           std::span<const std::string> start_tags);

}  // namespace filigree::tangle
