// The symmetries of a left side: which transforms within a group carry it onto itself.
#pragma once

#include <vector>

#include "curves/match.h"
#include "curves/shape.h"

namespace filigree::curves {

struct Symmetry {
    Transform by;
    bool is_reflected = false;
    std::vector<std::uint32_t> images;  // the element that each element is carried onto

    bool operator==(const Symmetry&) const = default;
};

// The identity first, then by angle, those that reflect last. Within the options' group, so for `similarity` the
// isometries; weights are equal whatever the options say.
std::vector<Symmetry> symmetries(const Shape& shape, const MatchOptions& options);

}  // namespace filigree::curves
