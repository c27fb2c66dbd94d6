#include "engines/tangle/reuse.h"

#include <map>

#include "base/number_text.h"
#include "base/random.h"
#include "language/preset_tree.h"
#include "language/quantity.h"
#include "language/walk.h"

namespace filigree::tangle {
namespace {

std::string text_of(const Document& document, SourceSpan span) {
    if (span.file >= document.sources.size()) return {};
    return document.sources[span.file].text.substr(span.begin, span.end - span.begin) + " " +
           std::to_string(static_cast<int>(bare_unit(&document, span)));
}

// A preset's statement with the values of the names in it.
std::string text_of(const Preset& preset) {
    std::string text = std::to_string(preset.level) + " " + std::to_string(static_cast<int>(preset.kind)) + " " +
                       to_text(*preset.path) + "\n";
    if (preset.document != nullptr) text += text_of(*preset.document, preset.span) + "\n";
    for (const ExpressionPtr& expression : {preset.value, preset.condition}) {
        if (!expression || preset.globals == nullptr) continue;
        for (const NameInExpression& name : names_in(*expression)) {
            const Value* value = preset.globals->find(name.text);
            if (value != nullptr) {
                text += name.text + "=" + to_text(*value) + " " +
                        std::to_string(static_cast<int>(bare_unit(preset.document, value->span))) + "\n";
            }
        }
    }
    return text;
}

void add(Fingerprint& to, std::uint64_t value) {
    to.first = fold(to.first, value);
    to.second = fold(mix(to.second), value);
}
void add(Fingerprint& to, const Fingerprint& other) {
    add(to, other.first);
    add(to, other.second);
}
Fingerprint fingerprint_of(const std::string& text) { return {hash_text(text), hash_text("filigree " + text)}; }

// Nodes stand behind those that lead to them, so they are gone through backwards.
std::vector<Fingerprint> fingerprints(const PresetTree& tree, const Presets& presets,
                                      const std::vector<std::string>& texts) {
    std::vector<Fingerprint> prints(tree.nodes.size());
    std::string all_texts;
    if (!tree.apply_names.empty()) {
        for (const std::string& text : texts) all_texts += text;
    }
    for (std::size_t n = tree.nodes.size(); n-- > 0;) {
        const PresetTree::Node& node = tree.nodes[n];
        Fingerprint& print = prints[n];
        add(print, node.stays ? 1 : 2);
        for (const std::uint32_t next : {node.any, node.any_depth}) {
            add(print, next == PresetTree::none ? Fingerprint{} : prints[next]);
        }
        for (const PresetTree::NameEdge& edge : node.names) {
            add(print, fingerprint_of(std::string(edge.name)));
            add(print, edge.ordinal);
            add(print, prints[edge.to]);
        }
        for (const PresetTree::ShapeEdge& edge : node.shapes) {
            add(print, edge.shape);
            add(print, prints[edge.to]);
        }
        for (const std::uint32_t preset : node.ends) {
            add(print, fingerprint_of(texts[preset]));
            // Below a step with a name, paths that begin with it count too.
            if (presets.all[preset].kind == PresetKind::apply) add(print, fingerprint_of(all_texts));
        }
    }
    return prints;
}

// Whether the presets that both have stand in the same order: which of two goes first may hang on that.
bool keep_their_order(const std::vector<std::string>& old, const std::vector<std::string>& now) {
    std::map<std::string_view, std::vector<std::size_t>> places;
    for (std::size_t i = now.size(); i-- > 0;) places[now[i]].push_back(i);
    std::size_t least = 0;
    for (const std::string& text : old) {
        std::vector<std::size_t>& free = places[text];
        if (free.empty()) continue;
        if (free.back() < least) return false;
        least = free.back();
        free.pop_back();
    }
    return true;
}

}  // namespace

Reads reads_of(const Grammar& grammar, const PlaneStart& start, const Settings& settings, const Document& document,
               const PresetWalk& walk, std::uint64_t files) {
    Reads reads;
    reads.common = std::to_string(walk.document_seed) + " " + std::to_string(files) + " " +
                   to_text(settings.resolution) + " " +
                   std::to_string(static_cast<int>(bare_unit(&document, {0, 0, 0}))) + (walk.replay ? " replay" : "");
    reads.rules_of_tag.resize(grammar.tags.size());
    for (std::size_t tag = 0; tag < grammar.tags.size(); ++tag) {
        for (const std::uint32_t rule : grammar.rules_of_tag[tag]) reads.rules_of_tag[tag] += grammar.rules[rule].reads;
    }
    for (const Preset& preset : walk.presets.all) {
        reads.presets.push_back(text_of(preset));
        // A step applied by hand is one more rule.
        if (preset.kind == PresetKind::apply && preset.document == &document) {
            std::size_t number = 0;
            for (std::uint32_t s = 0; s < preset.statement; ++s) {
                if (std::holds_alternative<ApplyStatement>(document.statements[s].node)) ++number;
            }
            if (number < grammar.applied.size()) {
                reads.presets.back() += grammar.rules[grammar.applied[number]].reads;
            }
        }
    }
    for (const std::shared_ptr<const PresetTree>& tree : walk.presets.trees) {
        reads.places.push_back(fingerprints(*tree, walk.presets, reads.presets));
    }
    reads.start = start;
    reads.start.choices = {};
    return reads;
}

Previous::Previous(const Tangle* tangle, const Reads& now) {
    if (tangle == nullptr || tangle->reads == nullptr) return;
    tangle_ = tangle;
    now_ = &now;
    const Reads& old = *tangle->reads;
    // Values replayed are no part of the texts.
    has_same_common_ = old.common == now.common && now.common.find("replay") == std::string::npos &&
                       keep_their_order(old.presets, now.presets);
    has_same_start_ = has_same_common_ && old.start.is_same(now.start);
}

bool Previous::has_same_rules(std::uint32_t tag, std::uint32_t old_tag) const {
    return has_same_common_ && now_->rules_of_tag[tag] == tangle_->reads->rules_of_tag[old_tag];
}

bool Previous::has_same_presets(const PresetState& state, const PresetState& old_state) const {
    if (!state || !old_state) return !state && !old_state;
    if (state->size() != old_state->size()) return false;
    for (std::size_t i = 0; i < state->size(); ++i) {
        const PresetItem& item = (*state)[i];
        const PresetItem& old = (*old_state)[i];
        if (item.level != old.level) return false;
        if (!(now_->places[item.level][item.node] == tangle_->reads->places[old.level][old.node])) return false;
    }
    return true;
}

}  // namespace filigree::tangle
