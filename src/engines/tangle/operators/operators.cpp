#include "engines/tangle/operators/operators.h"

#include <algorithm>
#include <vector>

namespace filigree::tangle {

std::span<const Operator> operators() {
    static const std::vector<Operator> all = {
        embed_operator(),     fill_operator(),
        invert_operator(),    outline_operator(),
        place_operator(),     radial_operator(),
        regroup_operator(),   regular_split_operator(),
        stipple_operator(),   streamline_split_operator(),
        transform_operator(), ungroup_operator(),
        voronoi_operator(),
    };
    return all;
}

const Operator* find_operator(std::string_view name) {
    for (const Operator& op : operators()) {
        const auto& aliases = op.description.aliases;
        if (op.description.name == name || std::find(aliases.begin(), aliases.end(), name) != aliases.end()) return &op;
    }
    return nullptr;
}

}  // namespace filigree::tangle
