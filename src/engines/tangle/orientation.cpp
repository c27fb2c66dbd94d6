#include "engines/tangle/orientation.h"

#include "base/elementary.h"
#include "plane/transform.h"

namespace filigree::tangle {
namespace {

// The principal axis of the area inside the outer ring, by its second moments.
Vec principal_axis(PolygonView polygon) {
    const Vec centre = centroid(polygon);
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        const RingView ring = polygon.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec a = to_px(ring[i]) - centre;
            const Vec b = to_px(ring[i + 1 == ring.size() ? 0 : i + 1]) - centre;
            const double turn = cross(a, b);
            xx += turn * (a.x * a.x + a.x * b.x + b.x * b.x);
            yy += turn * (a.y * a.y + a.y * b.y + b.y * b.y);
            xy += turn * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 2;
        }
    }
    if (xx == yy && xy == 0) return {1, 0};
    return unit_at_degrees(elementary::atan2(2 * xy, xx - yy) / 2 * 180 / elementary::pi);
}

}  // namespace

Vec turned_by(Vec direction, double degrees) {
    const Vec by = unit_at_degrees(degrees);
    return {direction.x * by.x - direction.y * by.y, direction.x * by.y + direction.y * by.x};
}

Vec direction_of(const Value& value, const Shape& shape, PolygonView polygon) {
    if (const auto* angle = std::get_if<Quantity>(&value.data)) return unit_at_degrees(angle->value);
    if (const auto* word = std::get_if<Symbol>(&value.data)) {
        if (word->name == "across") return perpendicular(shape.direction);
        if (word->name == "axis") return principal_axis(polygon);
        return shape.direction;
    }
    const auto& call = std::get<SymbolicCall>(value.data);
    const Value& argument = call.arguments.front().value;
    if (call.name == "turn") return turned_by(shape.direction, std::get<Quantity>(argument.data).value);
    const Vec towards = std::get<Vec>(argument.data) - centroid(polygon);
    const double distance = length(towards);
    return distance > 0 ? towards * (1 / distance) : shape.direction;
}

}  // namespace filigree::tangle
