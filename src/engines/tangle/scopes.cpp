#include "engines/tangle/scopes.h"

#include <algorithm>

namespace filigree::tangle {
namespace {

struct Extent {
    double area = 0, width = 0, height = 0;  // px^2, px
};

Extent extent_of(PolygonView polygon) {
    const Box box = bounds(polygon);
    return {area(polygon), to_px(box.max).x - to_px(box.min).x, to_px(box.max).y - to_px(box.min).y};
}

void add(Scope& scope, const char* name, double value, std::int8_t length_power = 0) {
    scope.names[name] = Value{Quantity{value, length_power, false}, {}};
}

void add(Scope& scope, const Extent& extent) {
    add(scope, "area", extent.area, 2);
    add(scope, "width", extent.width, 1);
    add(scope, "height", extent.height, 1);
}

}  // namespace

Scope step_scope(const Tangle& tangle, std::uint32_t group, const Scope& globals) {
    const Group& here = tangle.groups[group];
    const auto count = static_cast<double>(here.shapes.size());
    Extent mean;
    for (const Shape& shape : here.shapes) {
        const Extent one = extent_of(tangle.polygon(shape));
        mean.area += one.area / count;
        mean.width += one.width / count;
        mean.height += one.height / count;
    }
    Scope scope;
    scope.outer = &globals;
    add(scope, mean);
    add(scope, "count", count);
    add(scope, "depth", here.depth);
    add(scope, "group", std::max(1U, here.ordinal));
    return scope;
}

Scope shape_scope(const Tangle& tangle, const Shape& shape, std::uint32_t number) {
    const Vec centre = centroid(tangle.polygon(shape));
    Scope scope;
    add(scope, "index", number);
    add(scope, "x", centre.x, 1);
    add(scope, "y", centre.y, 1);
    add(scope, "i", shape.column);
    add(scope, "j", shape.row);
    return scope;
}

Scope style_scope(const Tangle& tangle, std::uint32_t group, std::size_t index) {
    const Group& here = tangle.groups[group];
    Scope scope = shape_scope(tangle, here.shapes[index], here.number_of(index));
    add(scope, extent_of(tangle.polygon(here.shapes[index])));
    add(scope, "depth", here.depth);
    add(scope, "group", std::max(1U, here.ordinal));
    return scope;
}

}  // namespace filigree::tangle
