// Presets: what `set`, `default`, `keep`, `reroll` and `apply` say of the places of a derivation.
//
// A derivation is walked from the start downwards; a PresetState says how far along their paths the presets have
// come at a node (a group or a step). At each node the accepted presets are those whose path ends there. `**` stands
// for any number of segments, none included, `*` for one; a name without ordinals is that of every group called so, and
// the only group of a port is its first: quads[1].
//
// Precedence (docs/language.md, "Paths and presets"): what an outer document says goes before the embedded
// one's own; then the narrower scope: one call, one segment left open by `*`, a module within a branch, a module
// anywhere, a branch, everything; in the same scope the longer path, then the later statement. Longer is the path with
// more names and shapes in it, then the one with more segments that say which of several groups or shapes.
//
// Re-rolls: each node's seed is that of the node above, folded with the times that it is re-rolled itself. `keep` gives
// it what it would be without the re-rolls that are said behind the keep in the text: what was drawn until then stays,
// whatever above is drawn again. A re-roll below a kept place counts, and one at it whose path goes before the keep's.
//
// Cost: a node's state is proportional to the different beginnings of paths that have come there, not to the presets;
// everything is immutable and shared, so that any number of threads may walk.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "language/choice_path.h"
#include "language/document.h"
#include "language/evaluate.h"

namespace filigree {

enum class PresetKind : std::uint8_t { set, fallback, keep, reroll, apply };  // fallback: `default`

struct Preset {
    PresetKind kind = PresetKind::set;
    const ChoicePath* path = nullptr;  // these point into the document that says it
    ExpressionPtr value, condition;    // null where there is none
    std::uint32_t times = 1;           // of a re-roll
    std::uint32_t statement = 0;       // index into Document::statements
    SourceSpan span;                   // of the statement
    const Document* document = nullptr;
    const Scope* globals = nullptr;  // the names that its expressions may use
    std::uint64_t seed = 0;          // that of its document
    std::uint32_t level = 0;         // 0: the outermost document
    std::uint32_t rank = 0;          // in its document: 0 goes first
};

struct PresetTree;  // preset_tree.h

// All presets that are in force in one derivation: those of outer documents first, so that their indices stay.
// Made by with_presets_of alone.
struct Presets {
    std::vector<Preset> all;
    std::vector<std::shared_ptr<const PresetTree>> trees;  // the paths of each document, by level
};
// Adds those of a document behind `outer`. A path of one segment without a parameter, in `set`, `default`,
// means let/NAME. An `apply` to several places is as many presets. `document` and `globals` must outlive the result.
Presets with_presets_of(Presets outer, const Document& document, const Scope& globals, std::uint64_t seed);

// Whether any path ends in this parameter.
bool may_name(const Presets& presets, std::string_view parameter);
// Whether any path has a segment that can be a single shape: digits or `*`.
bool has_shape_segments(const Presets& presets);

// How far the presets have come: the places in the trees of their paths, ascending. Null: none is on its way.
struct PresetItem {
    std::uint32_t level = 0;  // of the document
    std::uint32_t node = 0;   // of its tree

    auto operator<=>(const PresetItem&) const = default;
};
using PresetState = std::shared_ptr<const std::vector<PresetItem>>;

// One segment of the walk.
struct WalkSegment {
    std::string_view name = {};
    std::uint32_t ordinal = 0;  // the n of quads[n]; 0: the only group
    std::uint32_t shape = 0;    // a shape's number from 1, instead of a name; 0: none
};

// At the root, before the first segment; `above` is the state of the host's step for the outer presets. `first_own`:
// how many presets the outer documents have.
PresetState begin_presets(const Presets& presets, std::uint32_t first_own, const PresetState& above);
// The state behind one more segment. A state that stays the same is shared.
PresetState advance(const Presets& presets, const PresetState& state, const WalkSegment& segment);
// Beside that, at a step that the `apply` named NAME has made: the paths that begin with NAME. Of the document that
// says the `apply` where its level is given, else of every one that has an `apply` of this name.
PresetState enter_named(const Presets& presets, const PresetState& state, std::string_view name,
                        std::optional<std::uint32_t> level = {});
// Whether the segment of a single shape can lead on from here as a path says by digits or `*`: else there is no need
// to walk the shapes of a group.
bool may_pick_shapes(const Presets& presets, const PresetState& state);

// Indices of the presets whose path ends at this node, the one that goes first in front.
std::vector<std::uint32_t> accepted(const Presets& presets, const PresetState& state);

// What is drawn from at a node, and the re-rolls that led to it: a `keep` goes back to what it would be without those
// that are said behind it in the text.
struct RerollTrail;
struct NodeSeed {
    std::uint64_t value = 0;
    std::shared_ptr<const RerollTrail> rerolls = {};  // null: none since the document, or since the last keep
};

// Whether two nodes draw alike, they and every `keep` below them.
bool same_seed(const NodeSeed& a, const NodeSeed& b);

// The seed of a node, after the re-rolls and keeps (without a parameter) that end here.
NodeSeed seed_at_node(const Presets& presets, std::span<const std::uint32_t> accepted, const NodeSeed& above);
// The seed of one parameter's draws there: after those that name the parameter.
std::uint64_t seed_of_parameter(const Presets& presets, std::span<const std::uint32_t> accepted,
                                std::string_view parameter, const NodeSeed& at_node);

// What is said of one parameter at a node, or of one of its draws (ChoicePath::draw): `set`s, then `default`s, each
// with the one that goes first in front.
std::vector<const Preset*> values_for(const Presets& presets, std::span<const std::uint32_t> accepted,
                                      std::string_view parameter);

}  // namespace filigree
