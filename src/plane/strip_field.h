// How far along a shape each of its places lies: the level lines run across it, from border to border (gTangle, section
// 4.2, streamline split, strip).
//
// The paper's vectors point inwards at the border, so its lines meet the border at right angles. So do the
// level lines of the slowest vibration of the shape with free borders, which also tell the two ends of a long shape
// apart however it bends: on a rectangle they are straight, in a ring they go from wall to wall. The field
// is the function whose gradient comes closest to the vibration's at unit length, so that its level lines lie
// evenly. Where a shape is as long as wide the x axis is taken as its length.
#pragma once

#include "plane/edge_tree.h"
#include "plane/grid_field.h"

namespace filigree {

struct StripField {
    GridField along;           // continued a little beyond the border
    double low = 0, high = 0;  // its range inside
};
// On a grid of its own over a shape of the given size, px, and area, px^2, centred on the edges' origin. Its step is
// `detail`, px, but for 150 to 1000 nodes inside; some 0.1 to 2 milliseconds.
StripField strip_field(const EdgeTree& border, Vec size, double area, double detail);

}  // namespace filigree
