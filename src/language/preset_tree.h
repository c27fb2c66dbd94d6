// The paths of one document's presets as a tree of shared beginnings. At a place of a derivation only the paths that
// go on from there are asked, found by name, so that thousands of paths cost hardly more than one.
//
// It points into the document and does not change once it is made.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "language/presets.h"

namespace filigree {

struct PresetTree {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    struct NameEdge {
        std::string_view name;
        std::uint32_t ordinal = 0;  // 0: any
        std::uint32_t to = 0;

        auto operator<=>(const NameEdge&) const = default;
    };
    struct ShapeEdge {
        std::uint32_t shape = 0;
        std::uint32_t to = 0;

        auto operator<=>(const ShapeEdge&) const = default;
    };
    struct Node {
        bool stays = false;               // behind `**`: it is still reached, whatever follows
        std::uint32_t any = none;         // behind `*`
        std::uint32_t any_depth = none;   // behind `**`: reached together with this node
        std::vector<NameEdge> names;      // ascending
        std::vector<ShapeEdge> shapes;    // ascending
        std::vector<std::uint32_t> ends;  // presets whose path ends here, ascending
    };

    std::vector<Node> nodes = {Node{}};                        // [0]: before the first segment
    std::uint32_t first_preset = 0;                            // index of the first of the document's presets
    bool names_shapes = false;                                 // whether a path has a segment of digits or `*`
    std::vector<std::string_view> parameters;                  // that its paths end in; ascending, each once
    std::vector<std::string_view> apply_names;                 // of its `apply`s; ascending, each once
    std::vector<std::unique_ptr<const ChoicePath>> let_paths;  // let/NAME, for paths that say only NAME
};

// Fills `nodes`, `names_shapes` and `parameters` from the presets that begin at `first_preset`.
void grow(PresetTree& tree, std::span<const Preset> presets);

// Appends the nodes that one segment leads to, but for the node itself where it stays. With `by_name` without those
// behind `*`.
void follow(const PresetTree& tree, std::uint32_t node, const WalkSegment& segment, bool by_name,
            std::vector<std::uint32_t>& reached);

}  // namespace filigree
