#include "language/preset_walk.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace filigree {

PresetWalk begin_walk(const DocumentSite& site, const Document& document, const Scope& globals, std::uint64_t seed) {
    PresetWalk walk;
    walk.replay = site.replay;
    walk.document_seed = site.is_embedded ? site.document_seed : seed;
    const auto first_own = static_cast<std::uint32_t>(site.outer.all.size());
    walk.presets = with_presets_of(site.outer, document, globals, walk.document_seed);
    walk.root.state = begin_presets(walk.presets, first_own, site.host.state);
    walk.root.seed = site.is_embedded ? site.host.seed : NodeSeed{seed, nullptr};
    return walk;
}

PresetNode node_in_state(const PresetWalk& walk, PresetState state, const NodeSeed& seed_above) {
    PresetNode node;
    node.state = std::move(state);
    node.seed = seed_above;
    if (!node.state) return node;
    node.accepted = accepted(walk.presets, node.state);
    if (!node.accepted.empty()) {
        node.seed = seed_at_node(walk.presets, node.accepted, seed_above);
    }
    return node;
}

PresetNode node_below(const PresetWalk& walk, const PresetNode& above, const WalkSegment& segment) {
    if (!above.state) return {nullptr, {}, above.seed};
    return node_in_state(walk, advance(walk.presets, above.state, segment), above.seed);
}

PresetState joined(const PresetState& a, const PresetState& b) {
    if (!a || !b) return a ? a : b;
    std::vector<PresetItem> all;
    std::set_union(a->begin(), a->end(), b->begin(), b->end(), std::back_inserter(all));
    return std::make_shared<const std::vector<PresetItem>>(std::move(all));
}

PresetNode definition_node(const PresetWalk& walk, std::string_view name) {
    return node_below(walk, node_below(walk, walk.root, {"let"}), {name});
}

Result<StepChoices> choices_at(const PresetWalk& walk, const PresetNode& node, const Scope& scope,
                               ChoiceBuffer* record) {
    StepChoices choices;
    choices.presets = &walk.presets;
    choices.accepted = node.accepted;
    choices.seed = node.seed;
    choices.replay = walk.replay;
    choices.record = record;
    if (node.accepted.empty()) return choices;
    const Result<bool> is_random = is_random_at(walk.presets, node.accepted, scope);
    if (!is_random) return is_random.diagnostics();
    choices.is_random = *is_random;
    return choices;
}

}  // namespace filigree
