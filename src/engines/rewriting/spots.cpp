#include "engines/rewriting/spots.h"

#include <algorithm>

#include "base/number_text.h"
#include "base/random.h"
#include "base/unicode.h"
#include "engines/rewriting/symbols.h"

namespace filigree::rewriting {

std::string segment_of(char32_t letter) {
    if (unicode::is_letter(letter) || letter == U'_') return to_utf8(std::u32string_view(&letter, 1));
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string number;
    for (auto left = static_cast<std::uint32_t>(letter); left > 0; left /= 16) {
        number.insert(number.begin(), digits[left % 16]);
    }
    return "u" + number;
}

std::size_t Spots::StepHash::operator()(const Step& step) const {
    return static_cast<std::size_t>(fold(fold(step.node, step.name), step.ordinal));
}

Spots::Spots(const PresetWalk& walk) : walk_(walk), entries_(1), names_(1), reached_(walk.presets.all.size()) {
    for (const Preset& preset : walk.presets.all) {
        for (const PathSegment& segment : preset.path->segments) {
            for (const std::uint32_t ordinal : segment.ordinals) most_named_ = std::max(most_named_, ordinal);
        }
    }
    node_index(walk.root);
}

Spot Spots::below(Spot above, std::string_view name, std::uint32_t ordinal) {
    return add(above, name_index(name), ordinal);
}
Spot Spots::below(Spot above, char32_t letter, std::uint32_t ordinal) {
    auto known = letters_.find(letter);
    if (known == letters_.end()) known = letters_.emplace(letter, name_index(segment_of(letter))).first;
    return add(above, known->second, ordinal);
}

Spot Spots::add(Spot above, std::uint32_t name, std::uint32_t ordinal) {
    const std::uint32_t alike = ordinal <= most_named_ ? ordinal : UINT32_MAX;
    const std::uint32_t node = node_behind({entries_[above].node, name, alike});
    entries_.push_back({above, name, ordinal, node});
    return static_cast<Spot>(entries_.size() - 1);
}

std::uint32_t Spots::name_index(std::string_view name) {
    const auto known = name_indices_.find(name);
    if (known != name_indices_.end()) return known->second;
    const auto index = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    name_indices_.emplace(name, index);
    return index;
}

std::uint32_t Spots::node_behind(Step step) {
    const PresetNode& above = nodes_[step.node];
    if (!above.state && above.accepted.empty()) return step.node;
    const auto [known, is_new] = steps_.try_emplace(step);
    if (is_new) known->second = node_index(node_below(walk_, above, {names_[step.name], step.ordinal}));
    return known->second;
}

std::uint32_t Spots::node_index(PresetNode node) {
    std::vector<std::uint32_t>& alike = nodes_by_seed_[node.seed.value];
    for (const std::uint32_t index : alike) {
        const PresetNode& known = nodes_[index];
        const bool is_same_state = known.state && node.state ? *known.state == *node.state : known.state == node.state;
        if (is_same_state && known.accepted == node.accepted && same_seed(known.seed, node.seed)) return index;
    }
    for (const std::uint32_t preset : node.accepted) reached_[preset] = 1;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    alike.push_back(index);
    nodes_.push_back(std::move(node));
    return index;
}

std::string Spots::path_of(Spot spot) const {
    std::string path;
    for (; spot != root; spot = entries_[spot].above) {
        const Entry& entry = entries_[spot];
        std::string segment = names_[entry.name];
        if (entry.ordinal != 0) segment += "[" + filigree::to_text(std::uint64_t{entry.ordinal}) + "]";
        path.insert(0, path.empty() ? segment : segment + "/");
    }
    return path;
}

void Siblings::begin(Spot above) {
    above_ = above;
    counts_.clear();
}

Spot Siblings::next(char32_t letter) {
    auto count = std::find_if(counts_.begin(), counts_.end(), [&](const auto& one) { return one.first == letter; });
    if (count == counts_.end()) count = counts_.insert(counts_.end(), {letter, 0});
    return spots_.below(above_, letter, ++count->second);
}

}  // namespace filigree::rewriting
