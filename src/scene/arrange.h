// Drawings inside drawings.
//
// What is put in keeps its geometry where it can: under the identity, shapes that no clip cuts share it with the
// drawing that they come from, and geometry that is there already is not added again. Else every polygon is
// mapped and snapped to the grid; rings that collapse there are dropped, and polygons that leave the plane. Curves are
// mapped with their polygons, and dropped where a clip cuts these.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "plane/transform.h"
#include "scene/drawing.h"

namespace filigree {

struct Placement {
    Transform transform;             // from the one's coordinates to the other's
    const Polygons* clip = nullptr;  // in the other's; what lies outside is cut off, and cuts are stroked
    std::string path_prefix;         // put before all paths with a "/"; none if empty
    std::uint32_t parent = 0;        // a group of the drawing that grows; where it has none, a root is made
    double pen_scale = 1;
    double least_pen = 0;  // px; pens that are not 0 come out no thinner
};

// Adds the groups of `from` as the last child of the parent: painted over what that has, but under its overlay.
// Shapes keep their keys, and the pieces of one that is cut share its key. Neither canvas nor background come
// along. Equal styles are joined, if their pens are equal to the last bit.
void place_drawing(Drawing& to, const Drawing& from, const Placement& placement);

class DrawingIndex;

// Places many drawings in one that grows, as calls of place_drawing would, but a placement takes as long as what
// it adds, however much is there. In between others may add to the drawing; geometry and styles must stay where
// they are.
class DrawingPlacer {
public:
    explicit DrawingPlacer(Drawing& to);
    ~DrawingPlacer();

    void place(const Drawing& from, const Placement& placement);

private:
    Drawing& to_;
    std::unique_ptr<DrawingIndex> index_;
};

}  // namespace filigree
