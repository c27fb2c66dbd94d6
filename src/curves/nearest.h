// Where elements come nearest to points, and how far elements lie from each other where their descriptors differ.
//
// The search for subshapes compares descriptors (along.h); this is for what only looks alike, and for saying how far
// off something lies.
#pragma once

#include "curves/element.h"

namespace filigree::curves {

// The point of an element that is nearest to another point.
struct Foot {
    double t = 0;         // the element's parameter, within its interval
    double distance = 0;  // px
};
Foot foot_on(const Element& e, Vec p);

// The farthest that any of `count` points, evenly spread over a part's parameter with both ends, lies from an element.
double farthest_of(const Element& part, int count, const Element& from);

}  // namespace filigree::curves
