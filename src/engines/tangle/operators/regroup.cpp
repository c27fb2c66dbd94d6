// regroup: share the shapes of a group out among n groups (gTangle, section 4.1).
//
// By lattice, the class of a shape is (column + row) mod n: stripes for a plain split, a chessboard or
// diagonals for a dual one. By id it is the paper's s mod k, which looks like a chessboard only where the
// number of columns happens to suit.
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

std::uint64_t class_of(std::int64_t number, std::int64_t count) {
    const std::int64_t rest = number % count;
    return static_cast<std::uint64_t>(rest < 0 ? rest + count : rest);
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const auto count = static_cast<std::int64_t>(input.arguments.number("groups"));
    const bool by_lattice = input.arguments.word("by") == "lattice";
    OperatorOutput output;
    for (std::int64_t k = 0; k < count; ++k) output.groups.push_back({0, static_cast<std::uint64_t>(k), {}});
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Shape& shape = input.shapes[i];
        const std::int64_t number = by_lattice ? std::int64_t{shape.column} + shape.row : static_cast<std::int64_t>(i);
        output.groups[class_of(number, count)].shapes.push_back(shape);
    }
    return output;
}

}  // namespace

Operator regroup_operator() {
    return {{.name = "regroup",
             .help = "share the shapes out among a number of groups, which then draw rules of their own",
             .source = "gTangle, section 4.1",
             .parameters = {{.name = "groups",
                             .type = ParameterType::whole,
                             .help = "how many groups; 2 after a dual split is a chessboard",
                             .low = 1,
                             .high = 1000},
                            {.name = "by",
                             .type = ParameterType::word,
                             .help = "what is counted: the place in the split's lattice, or the shape's id",
                             .default_text = "lattice",
                             .words = {"lattice", "id"}}},
             .ports = {{"shapes", "the same shapes, in as many groups"}},
             .example = "regroup(2) : quads -> fields",
             .shrinks = false,
             .regroups = true},
            run};
}

}  // namespace filigree::tangle
