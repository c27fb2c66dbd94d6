// Registration points: what of a shape is a point of it wherever it is carried by an affine map. Those are the contacts
// of its elements, its labelled points, and the centres of its arcs; ends are none, since an end of a left side need
// not be an end in the design.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "curves/match.h"
#include "curves/match_index.h"
#include "curves/shape.h"

namespace filigree::curves {

struct Registration {
    Vec at;
    // A contact has two elements, with their unit tangents there; a labelled point or a centre has its own element.
    std::array<std::uint32_t, 2> elements{};
    std::array<Vec, 2> ways{};
    // The element goes on at both sides of the contact; by a tenth of its length at least. What is well inside of a
    // left element is inside of its carrier, too, unless the map makes the element as short as some tolerances.
    std::array<bool, 2> is_inside{}, is_well_inside{};
    bool is_contact = false, is_tangential = false;
};

// All registration points of some elements, and which of them belong to each element.
struct Registrations {
    std::vector<Registration> points;
    std::vector<std::vector<std::uint32_t>> on;
};

Registrations registrations_of(const Shape& shape, double tolerance);

// Those of a design on which one of the left side's may lie: of the same kinds and layers. By slots.
Registrations registrations_of(const MatchIndex& design, const Shape& left, const Registrations& of_left,
                               double tolerance);

}  // namespace filigree::curves
