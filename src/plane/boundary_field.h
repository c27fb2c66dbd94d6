// Vectors at a shape's border, carried smoothly over its inside (gTangle, section 4.2, streamline split).
//
// Mean-value coordinates over all rings, holes with the sign of their turn: they are defined for every polygon with
// holes, inside and out, and reproduce linear functions. (The paper's coordinates hold for convex polygons only.) Each
// node of a grid is evaluated once; a spline runs between the nodes.
#pragma once

#include <vector>

#include "plane/edge_tree.h"
#include "plane/grid_field.h"

namespace filigree {

// A border in even steps: what the coordinates are taken over. Each ring has at least twelve points, some `spacing`
// apart, and unit tangents in its direction.
struct BorderSamples {
    std::vector<Vec> points, tangents;
    std::vector<std::size_t> ring_ends;
};
BorderSamples sampled_border(PolygonView shape, Point origin, double spacing);

struct VectorField {
    GridField x, y;

    Vec at(Vec p) const { return {x.at(p), y.at(p)}; }
};
// `vectors`: one a sample. Nodes farther than two steps outside keep 0. `distances`: of the grid's nodes.
VectorField boundary_field(const BorderSamples& border, const std::vector<Vec>& vectors, const Grid& grid,
                           const std::vector<double>& distances);

// The same of directions without a sign: what comes out at a place, or its opposite, has the interpolated direction.
// The angles are doubled for it, so that the two sides of a narrow place do not cancel where they run against each
// other.
struct DirectionField {
    VectorField doubled;

    Vec at(Vec p) const;
};
DirectionField direction_field(const BorderSamples& border, const std::vector<Vec>& directions, const Grid& grid,
                               const std::vector<double>& distances);

// One value of a vector field.
Vec mean_value(const BorderSamples& border, const std::vector<Vec>& vectors, Vec p);

}  // namespace filigree
