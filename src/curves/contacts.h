// Where elements touch and cross each other: the points of a shape that stay points of it wherever it is embedded,
// since what lies on two elements lies on their carriers, too.
#pragma once

#include <vector>

#include "curves/element.h"

namespace filigree::curves {

struct Contact {
    Vec at;
    Vec way, other_way;  // unit tangents of the element and of the other one there; their signs mean nothing
    ElementKind other = ElementKind::line;
    bool is_tangential = false;  // they touch without an angle
};

// Where the descriptors of two elements cross, at no less than about a degree, or have a common tangent where they are
// within `reach` (px) of each other; and where that is within `reach` of both elements. By parameter of the first.
// Points touch nothing. Where arcs turn back sharply contacts may be missed, and elements that lie on one descriptor
// have none.
std::vector<Contact> contacts_of(const Element& e, const Element& other, double reach, double least_sine = 0.02);

}  // namespace filigree::curves
