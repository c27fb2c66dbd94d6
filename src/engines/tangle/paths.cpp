#include "engines/tangle/paths.h"

namespace filigree::tangle {

std::string segment_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group) {
    const Group& here = tangle.groups[group];
    std::string segment = here.hidden ? "_" : grammar.tags[here.tag];
    if (here.ordinal != 0) segment += "[" + std::to_string(here.ordinal) + "]";
    if (here.picked != 0) segment += "/" + std::to_string(here.picked);
    return segment;
}

std::string path_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group) {
    std::string path;
    for (std::uint32_t at = group; at != none;) {
        const Group& here = tangle.groups[at];
        const std::string segment = segment_of_group(tangle, grammar, at);
        if (here.producer == none) return segment + path;
        const Step& step = tangle.steps[here.producer];
        path = "/" + grammar.rules[step.rule].segment + "/" + segment + path;
        at = step.group;
    }
    return path;
}

std::string path_of_step(const Tangle& tangle, const Grammar& grammar, std::uint32_t step) {
    return path_of_group(tangle, grammar, tangle.steps[step].group) + "/" +
           grammar.rules[tangle.steps[step].rule].segment;
}

std::string path_of_embedded(const Tangle& tangle, const Grammar& grammar, std::uint32_t step, std::size_t shape) {
    const Group& group = tangle.groups[tangle.steps[step].group];
    std::string path = path_of_group(tangle, grammar, tangle.steps[step].group);
    if (group.shapes.size() > 1) path += "/" + std::to_string(group.number_of(shape));
    return path + "/" + grammar.rules[tangle.steps[step].rule].segment;
}

}  // namespace filigree::tangle
