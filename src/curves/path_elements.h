// Paths as elements, and elements joined to paths as long as they go.
//
// Joined, a drawing keeps clean corners and a plotter its pen down. Where more than two ends meet, the curves that go
// on straightest are joined first, so that lines that cross stay lines.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curves/element.h"
#include "plane/path.h"

namespace filigree::curves {

// Every line, curve and arc of a path in its order, as they are meant; a closing line too, where it has length. A
// circle drawn by two arcs stays two.
std::vector<Element> elements_of(const Path& path, std::uint32_t layer = 0, double weight = 1);

struct JoinedPath {
    Path path;                          // one subpath, closed where the elements are; ends less than the tolerance off
    std::vector<std::uint32_t> joined;  // the elements that it is made of, in its order

    bool operator==(const JoinedPath&) const = default;
};

// Every element but the points, each in one path. Ends are equal where they lie within the tolerance (px), or are
// linked by others that do. Only elements of the same group are joined, a number for each; without numbers, those of
// the same layer and weight. The lowest-numbered element of a path runs forwards in it, and the paths are sorted by
// these. Elements must lie on the plane and be longer than the tolerance. Arcs become SVG's, two of them where one
// would know its centre badly.
std::vector<JoinedPath> paths_of(std::span<const Element> elements, double tolerance,
                                 std::span<const std::uint32_t> groups = {});

}  // namespace filigree::curves
