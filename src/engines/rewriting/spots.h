// Where symbols stand in the derivation of a word, as paths name it: a[2]/b[1] is the first b that the second a of the
// axiom has put.
//
// A symbol that is put has a spot below that of the symbol that puts it, and one that stays keeps its own. Below
// `system` stands what grows in a subsystem that is put at once; below the name of an edit, what that puts behind a
// symbol. With `random position` a symbol's spot is its place in one word: iteration[3]/a[5].
//
// Spots are for paths alone: nothing is drawn by them. A spot knows what the presets say there (PresetNode); spots of
// which they say the same share that, so that the walk costs one step for each new kind of place, not for each symbol.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "language/preset_walk.h"

namespace filigree::rewriting {

using Spot = std::uint32_t;

// What paths call a letter: as it is written, or, where no path can hold it, by its number in Unicode: u2B for '+'.
std::string segment_of(char32_t letter);

class Spots {
public:
    static constexpr Spot root = 0;

    // `walk` must outlive this.
    explicit Spots(const PresetWalk& walk);

    // `ordinal`: among its siblings of this name, from 1; 0 where there is one.
    Spot below(Spot above, std::string_view name, std::uint32_t ordinal = 0);
    Spot below(Spot above, char32_t letter, std::uint32_t ordinal);

    const PresetNode& node_of(Spot spot) const { return nodes_[entries_[spot].node]; }
    std::string path_of(Spot spot) const;
    const std::vector<std::uint8_t>& reached() const { return reached_; }  // by preset: whether a spot lies at its end

private:
    struct Entry {
        Spot above = root;
        std::uint32_t name = 0, ordinal = 0;
        std::uint32_t node = 0;
    };
    struct Step {
        std::uint32_t node = 0, name = 0, ordinal = 0;
        bool operator==(const Step&) const = default;
    };
    struct StepHash {
        std::size_t operator()(const Step& step) const;
    };

    Spot add(Spot above, std::uint32_t name, std::uint32_t ordinal);
    std::uint32_t name_index(std::string_view name);
    std::uint32_t node_behind(Step step);
    std::uint32_t node_index(PresetNode node);

    const PresetWalk& walk_;
    std::uint32_t most_named_ = 1;  // the highest ordinal in any path: those above are alike
    std::vector<Entry> entries_;
    std::vector<std::string> names_;
    std::map<std::string, std::uint32_t, std::less<>> name_indices_;
    std::unordered_map<char32_t, std::uint32_t> letters_;  // indices of their names
    std::vector<PresetNode> nodes_;
    std::unordered_map<Step, std::uint32_t, StepHash> steps_;            // to nodes
    std::map<std::uint64_t, std::vector<std::uint32_t>> nodes_by_seed_;  // by the value of their seeds
    std::vector<std::uint8_t> reached_;
};

// The spots of symbols that one symbol puts, in their order.
class Siblings {
public:
    explicit Siblings(Spots& spots) : spots_(spots) {}

    void begin(Spot above);
    Spot next(char32_t letter);

private:
    Spots& spots_;
    Spot above_ = Spots::root;
    std::vector<std::pair<char32_t, std::uint32_t>> counts_;  // by letter
};

}  // namespace filigree::rewriting
