#include "language/presets.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "language/preset_tree.h"

namespace filigree {

namespace {

// --- precedence -------------------------------------------------------------------------------------------------

enum class PathScope : std::uint8_t { one_call, open_segment, module_in_branch, module_anywhere, branch, everything };

struct Narrowness {
    PathScope scope = PathScope::one_call;
    std::size_t concrete = 0;  // names and shapes
    std::size_t numbered = 0;  // segments with ordinals or shapes
};

bool is_concrete(const PathSegment& segment) {
    return segment.kind == PathSegment::Kind::name || segment.kind == PathSegment::Kind::shapes;
}

Narrowness narrowness(const ChoicePath& path) {
    Narrowness out;
    bool is_deep = false, in_branch = false, names_module = false;  // names before the first `**`, behind the last
    for (const PathSegment& segment : path.segments) {
        if (segment.kind == PathSegment::Kind::any_depth) {
            if (!is_deep) in_branch = out.concrete > 0;
            is_deep = true;
            names_module = false;
        } else if (is_concrete(segment)) {
            ++out.concrete;
            out.numbered += segment.ordinals.empty() ? 0 : 1;
            names_module = true;
        }
    }
    if (!is_deep) {
        out.scope = out.concrete == path.segments.size() ? PathScope::one_call : PathScope::open_segment;
    } else if (out.concrete == 0) {
        out.scope = PathScope::everything;
    } else if (!names_module) {
        out.scope = PathScope::branch;
    } else {
        out.scope = in_branch ? PathScope::module_in_branch : PathScope::module_anywhere;
    }
    return out;
}

void rank(std::span<Preset> presets) {
    std::vector<Narrowness> all;
    for (const Preset& preset : presets) all.push_back(narrowness(*preset.path));
    std::vector<std::size_t> order(presets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        // Longer and later go first.
        return std::tie(all[a].scope, all[b].concrete, all[b].numbered, b) <
               std::tie(all[b].scope, all[a].concrete, all[a].numbered, a);
    });
    for (std::size_t i = 0; i < order.size(); ++i) presets[order[i]].rank = static_cast<std::uint32_t>(i);
}

// --- making -----------------------------------------------------------------------------------------------------

// Null where the path says itself what it means.
std::unique_ptr<const ChoicePath> let_path(const ChoicePath& path) {
    const PathSegment& first = path.segments.front();
    const bool is_bare = path.segments.size() == 1 && first.kind == PathSegment::Kind::name && first.ordinals.empty();
    if (!is_bare || !path.parameter.empty()) return nullptr;
    ChoicePath out = path;
    out.segments.insert(out.segments.begin(), {PathSegment::Kind::name, "let", {}});
    return std::make_unique<const ChoicePath>(std::move(out));
}

class PresetReader {
public:
    PresetReader(std::vector<Preset>& all, PresetTree& tree, const Preset& common)
        : all_(all), tree_(tree), common_(common) {}

    void read(const Statement& statement, std::uint32_t index) {
        common_.statement = index;
        common_.span = statement.span;
        if (const auto* preset = std::get_if<PresetStatement>(&statement.node)) {
            Preset& added = add(preset->is_default ? PresetKind::fallback : PresetKind::set, preset->path);
            added.value = preset->value;
            added.condition = preset->condition;
            if (std::unique_ptr<const ChoicePath> path = let_path(preset->path)) {
                added.path = path.get();
                tree_.let_paths.push_back(std::move(path));
            }
        } else if (const auto* keep = std::get_if<KeepStatement>(&statement.node)) {
            add(PresetKind::keep, keep->path);
        } else if (const auto* reroll = std::get_if<RerollStatement>(&statement.node)) {
            add(PresetKind::reroll, reroll->path).times = reroll->times;
        } else if (const auto* apply = std::get_if<ApplyStatement>(&statement.node)) {
            for (const ChoicePath& target : apply->targets) add(PresetKind::apply, target);
            if (apply->name) tree_.apply_names.push_back(apply->name->text);
        }
    }

private:
    Preset& add(PresetKind kind, const ChoicePath& path) {
        Preset& added = all_.emplace_back(common_);
        added.kind = kind;
        added.path = &path;
        return added;
    }

    std::vector<Preset>& all_;
    PresetTree& tree_;
    Preset common_;
};

// --- states -----------------------------------------------------------------------------------------------------

// Adds a node, and those behind `**` that it reaches without any segment.
void enter(const PresetTree& tree, std::uint32_t level, std::uint32_t node, std::vector<PresetItem>& items) {
    for (; node != PresetTree::none; node = tree.nodes[node].any_depth) items.push_back({level, node});
}

PresetState state_of(std::vector<PresetItem> items, const PresetState& before) {
    if (items.empty()) return nullptr;
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    if (before && items == *before) return before;
    return std::make_shared<const std::vector<PresetItem>>(std::move(items));
}

std::vector<PresetItem> items_of(const PresetState& state) { return state ? *state : std::vector<PresetItem>{}; }

// --- seeds ------------------------------------------------------------------------------------------------------

std::uint64_t rerolled(std::uint64_t seed, std::uint64_t times) {
    return times == 0 ? seed : fold(fold(seed, hash_text("reroll")), times);
}

struct Reroll {
    std::uint32_t level = 0, statement = 0, times = 0;

    bool operator==(const Reroll&) const = default;
};

// Whether it is said before a keep: in the text, and in an embedded document before those around it.
bool is_said_before(const Reroll& reroll, const Preset& keep) {
    return reroll.level != keep.level ? reroll.level > keep.level : reroll.statement < keep.statement;
}

std::vector<Reroll> rerolls_of(const std::vector<const Preset*>& presets) {
    std::vector<Reroll> rerolls;
    for (const Preset* preset : presets) rerolls.push_back({preset->level, preset->statement, preset->times});
    return rerolls;
}

}  // namespace

// The re-rolls that end at one node.
struct RerollTrail {
    std::uint64_t seed_above = 0;  // where nothing is above
    std::shared_ptr<const RerollTrail> above = {};
    std::vector<Reroll> here = {};
};

namespace {

std::uint64_t times_of(const std::vector<const Preset*>& rerolls) {
    std::uint64_t times = 0;
    for (const Preset* reroll : rerolls) times += reroll->times;
    return times;
}

// The seed behind a trail with only the re-rolls that are said before the keep.
std::uint64_t seed_kept_by(const Preset& keep, const RerollTrail& trail) {
    std::vector<const RerollTrail*> nodes;  // innermost first
    for (const RerollTrail* node = &trail; node != nullptr; node = node->above.get()) nodes.push_back(node);
    std::uint64_t seed = nodes.back()->seed_above;
    while (!nodes.empty()) {
        std::uint64_t times = 0;
        for (const Reroll& reroll : nodes.back()->here) {
            if (is_said_before(reroll, keep)) times += reroll.times;
        }
        seed = rerolled(seed, times);
        nodes.pop_back();
    }
    return seed;
}

NodeSeed seed_after(const Presets& presets, std::span<const std::uint32_t> indices, std::string_view parameter,
                    const NodeSeed& above) {
    const Preset* keep = nullptr;
    std::vector<const Preset*> narrower, others;  // re-rolls: those that go before the keep, and the rest
    for (const std::uint32_t index : indices) {
        const Preset& preset = presets.all[index];
        if (preset.path->parameter != parameter) continue;
        if (preset.kind == PresetKind::keep && keep == nullptr) keep = &preset;
        if (preset.kind == PresetKind::reroll) (keep == nullptr ? narrower : others).push_back(&preset);
    }
    if (keep == nullptr && narrower.empty()) return above;
    if (keep == nullptr) {
        const std::uint64_t value = rerolled(above.value, times_of(narrower));
        return {value,
                std::make_shared<const RerollTrail>(RerollTrail{above.value, above.rerolls, rerolls_of(narrower)})};
    }
    // Of one place kept and drawn again, the keep holds.
    const auto of_the_keep = [&](const Preset* reroll) { return same_path(*reroll->path, *keep->path); };
    std::copy_if(narrower.begin(), narrower.end(), std::back_inserter(others), of_the_keep);
    std::erase_if(narrower, of_the_keep);
    const std::uint64_t kept = seed_kept_by(*keep, {above.value, above.rerolls, rerolls_of(others)});
    if (narrower.empty()) return {kept, nullptr};
    const std::uint64_t value = rerolled(kept, times_of(narrower));
    return {value, std::make_shared<const RerollTrail>(RerollTrail{kept, nullptr, rerolls_of(narrower)})};
}

}  // namespace

Presets with_presets_of(Presets outer, const Document& document, const Scope& globals, std::uint64_t seed) {
    Presets out = std::move(outer);
    const auto tree = std::make_shared<PresetTree>();
    tree->first_preset = static_cast<std::uint32_t>(out.all.size());

    Preset common;
    common.document = &document;
    common.globals = &globals;
    common.seed = seed;
    common.level = static_cast<std::uint32_t>(out.trees.size());
    PresetReader reader(out.all, *tree, common);
    for (std::size_t i = 0; i < document.statements.size(); ++i) {
        reader.read(document.statements[i], static_cast<std::uint32_t>(i));
    }
    std::sort(tree->apply_names.begin(), tree->apply_names.end());

    const std::span<Preset> own = std::span(out.all).subspan(tree->first_preset);
    rank(own);
    grow(*tree, own);
    out.trees.push_back(tree);
    return out;
}

bool may_name(const Presets& presets, std::string_view parameter) {
    return std::any_of(presets.trees.begin(), presets.trees.end(), [&](const auto& tree) {
        return std::binary_search(tree->parameters.begin(), tree->parameters.end(), parameter);
    });
}

bool has_shape_segments(const Presets& presets) {
    return std::any_of(presets.trees.begin(), presets.trees.end(), [](const auto& tree) { return tree->names_shapes; });
}

PresetState begin_presets(const Presets& presets, std::uint32_t first_own, const PresetState& above) {
    std::vector<PresetItem> items = items_of(above);
    for (std::uint32_t level = 0; level < presets.trees.size(); ++level) {
        const PresetTree& tree = *presets.trees[level];
        if (tree.first_preset >= first_own && tree.nodes.size() > 1) enter(tree, level, 0, items);
    }
    return state_of(std::move(items), above);
}

PresetState advance(const Presets& presets, const PresetState& state, const WalkSegment& segment) {
    if (!state) return nullptr;
    bool is_same = true;
    std::vector<PresetItem> items;
    std::vector<std::uint32_t> reached;
    for (auto item = state->begin(); item != state->end(); ++item) {
        const PresetTree& tree = *presets.trees[item->level];
        const bool stays = tree.nodes[item->node].stays;
        reached.clear();
        follow(tree, item->node, segment, false, reached);
        if (is_same && (!stays || !reached.empty())) {
            is_same = false;
            items.assign(state->begin(), item);
        }
        if (is_same) continue;
        if (stays) items.push_back(*item);
        for (const std::uint32_t node : reached) enter(tree, item->level, node, items);
    }
    return is_same ? state : state_of(std::move(items), state);
}

PresetState enter_named(const Presets& presets, const PresetState& state, std::string_view name,
                        std::optional<std::uint32_t> level) {
    std::vector<PresetItem> items = items_of(state);
    std::vector<std::uint32_t> reached;
    for (std::uint32_t at = 0; at < presets.trees.size(); ++at) {
        const PresetTree& tree = *presets.trees[at];
        if (level && *level != at) continue;
        if (!std::binary_search(tree.apply_names.begin(), tree.apply_names.end(), name)) continue;
        reached.clear();
        follow(tree, 0, {name}, true, reached);
        for (const std::uint32_t node : reached) enter(tree, at, node, items);
    }
    return state_of(std::move(items), state);
}

bool may_pick_shapes(const Presets& presets, const PresetState& state) {
    return state && std::any_of(state->begin(), state->end(), [&](const PresetItem& item) {
               const PresetTree::Node& node = presets.trees[item.level]->nodes[item.node];
               return !node.shapes.empty() || node.any != PresetTree::none;
           });
}

std::vector<std::uint32_t> accepted(const Presets& presets, const PresetState& state) {
    std::vector<std::uint32_t> out;
    if (!state) return out;
    for (const PresetItem& item : *state) {
        const std::vector<std::uint32_t>& ends = presets.trees[item.level]->nodes[item.node].ends;
        out.insert(out.end(), ends.begin(), ends.end());
    }
    std::sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(presets.all[a].level, presets.all[a].rank) <
               std::tie(presets.all[b].level, presets.all[b].rank);
    });
    return out;
}

bool same_seed(const NodeSeed& a, const NodeSeed& b) {
    if (a.value != b.value) return false;
    const RerollTrail* first = a.rerolls.get();
    const RerollTrail* second = b.rerolls.get();
    for (; first != second && first != nullptr && second != nullptr;
         first = first->above.get(), second = second->above.get()) {
        const bool is_last = first->above == nullptr;
        if (first->here != second->here || (is_last && first->seed_above != second->seed_above)) return false;
    }
    return first == second;
}

NodeSeed seed_at_node(const Presets& presets, std::span<const std::uint32_t> accepted, const NodeSeed& above) {
    return seed_after(presets, accepted, "", above);
}

std::uint64_t seed_of_parameter(const Presets& presets, std::span<const std::uint32_t> accepted,
                                std::string_view parameter, const NodeSeed& at_node) {
    return seed_after(presets, accepted, parameter, at_node).value;
}

std::vector<const Preset*> values_for(const Presets& presets, std::span<const std::uint32_t> accepted,
                                      std::string_view parameter) {
    std::vector<const Preset*> out;
    for (const PresetKind kind : {PresetKind::set, PresetKind::fallback}) {
        for (const std::uint32_t index : accepted) {
            const Preset& preset = presets.all[index];
            if (preset.kind == kind && preset.path->parameter == parameter) out.push_back(&preset);
        }
    }
    return out;
}

}  // namespace filigree
