// Walking a derivation with its presets in hand: what every node knows of them, and where a document stands.
//
//   PresetNode node = root_node(walk);
//   node = node_below(walk, node, {"big_poly"});
//   node = node_below(walk, node, {"outline"});
//   const Result<StepChoices> choices = choices_at(walk, node, scope);
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "language/step_choices.h"

namespace filigree {

// A place of a derivation: a group, a step, or a name behind `let`.
struct PresetNode {
    PresetState state;                    // null: no preset can end here or below
    std::vector<std::uint32_t> accepted;  // presets whose path ends here, the one that goes first in front
    NodeSeed seed;                        // what is drawn here, after the re-rolls on the way
};

// Where a document is derived: on its own, or inside a shape of another.
struct DocumentSite {
    Key root = {};                    // folded into every key of the derivation; 0 for a document on its own
    Presets outer = {};               // of the documents around this one
    PresetNode host = {};             // the step that embeds it
    std::uint64_t document_seed = 0;  // of the outermost document
    bool is_embedded = false;         // else root, host and document_seed mean nothing
    std::uint32_t depth = 0;          // documents around this one
    std::vector<std::pair<std::string, Value>> given = {};  // values of its parameters
    const Replay* replay = nullptr;
};

// A key of a document of its own, as it is at this site.
inline Key rooted(const DocumentSite& site, Key key) { return site.root == Key{} ? key : child(site.root, key.value); }

// What a walk over one document's derivation needs.
struct PresetWalk {
    Presets presets;
    PresetNode root;
    std::uint64_t document_seed = 0;
    const Replay* replay = nullptr;
};
// `document` and `globals` must outlive the result. `seed`: the document's own, which an embedded one does not use.
PresetWalk begin_walk(const DocumentSite& site, const Document& document, const Scope& globals, std::uint64_t seed);

PresetNode node_below(const PresetWalk& walk, const PresetNode& above, const WalkSegment& segment);
// A node in a state that was found otherwise.
PresetNode node_in_state(const PresetWalk& walk, PresetState state, const NodeSeed& seed_above);
// What is on its way by either of two states.
PresetState joined(const PresetState& a, const PresetState& b);
// The node of a name behind `let`.
PresetNode definition_node(const PresetWalk& walk, std::string_view name);

// How choices are made at a node, recorded in `record` if it is not null. `node` and `walk` must outlive the result.
Result<StepChoices> choices_at(const PresetWalk& walk, const PresetNode& node, const Scope& scope,
                               ChoiceBuffer* record);

}  // namespace filigree
