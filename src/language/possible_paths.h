// Which paths a grammar can produce: a graph of what may stand below what, and the check of a path against it.
//
// A path that is not possible comes back with the reason and with the nearest one that is. The graph may have cycles;
// the time is proportional to the segments times the graph, however many `**` there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "language/choice_path.h"
#include "language/document.h"

namespace filigree {

// A group or a step as paths name it, or `let` or a name below it.
struct PathNode {
    bool is_group = false;
    bool has_ordinals = false;            // whether there may be several in one place: quads[2]
    std::string segment;                  // a tag or a rule's segment
    std::vector<std::uint32_t> next;      // below it
    std::vector<std::string> parameters;  // what may stand behind the dot: rule, distance, when, is_random, ...
};
struct PathGraph {
    std::vector<PathNode> nodes;
    std::vector<std::uint32_t> roots;  // the starts, and `let`
};

struct PathCheck {
    bool possible = false;
    std::vector<std::uint32_t> ends;       // nodes at which it may end, ascending, each once
    std::vector<std::uint32_t> shapes_of;  // groups at single shapes of which it may end, likewise
    std::size_t failing = 0;  // where it is not possible: the first segment that is not; their number for the parameter
    std::string why;          // "nothing called 'outlin' stands below 'big_poly'"
    std::string nearest;      // a path that is possible; empty only where there are no roots
};

// Segments of digits may follow every group, and single shapes have no parameters. A path with a parameter ends only at
// nodes that have it.
PathCheck check_path(const PathGraph& graph, const ChoicePath& path);

// A possible path that keeps what matches of `path`. What does not is replaced by the nearest name, by a name that
// was left out, or by the first that may stand there; what cannot be followed is dropped. Without segments where there
// are no roots.
ChoicePath nearest_path(const PathGraph& graph, const ChoicePath& path);

}  // namespace filigree
