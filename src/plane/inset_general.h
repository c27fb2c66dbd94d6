// The general way of an inset: a polygon library takes away all that is nearer than the distance.
//
// Every edge sweeps a strip, every reflex corner the piece that its join fills. Each ring's raw offset winds
// about a point once for being inside and once less for every strip or piece that covers it, so that the
// union of the raw rings by positive winding is exactly what remains. It is right for any clean polygon, and
// some ten times slower than a front.
#pragma once

#include "plane/offset_corner.h"

namespace filigree {

// Not checked; rings come out rounded to the grid, those thinner than a few grid steps dropped.
Polygons general_inset(PolygonView shape, Point origin, double distance, const JoinRule& rule);

}  // namespace filigree
