// Which way an operator lays its pattern: the forms of a `direction` parameter of the tangle's operators.
#pragma once

#include "engines/tangle/tangle.h"
#include "language/value.h"

namespace filigree::tangle {

// 0..180, 30, keep, across, axis, turn(a), towards((x, y)) for one shape: a unit vector.
//   a number  degrees from the x axis towards y
//   keep      the shape's own orientation; across: at right angles to it; turn(a): turned by a from it
//   axis      along the shape's longest extent (its principal axis)
//   towards   from the shape's centroid towards a point
Vec direction_of(const Value& value, const Shape& shape, PolygonView polygon);

// A direction turned by an angle, from x towards y.
Vec turned_by(Vec direction, double degrees);

}  // namespace filigree::tangle
