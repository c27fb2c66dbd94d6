#include "engines/rewriting/turtle_frames.h"

namespace filigree::rewriting {
namespace {

constexpr Vec3 along(double c, Vec3 a, double s, Vec3 b) {  // never -0
    return {c * a.x + s * b.x + 0.0, c * a.y + s * b.y + 0.0, c * a.z + s * b.z + 0.0};
}

}  // namespace

Frame turned(const Frame& frame, Axis axis, elementary::CosSin by) {
    const auto& [heading, left, up] = frame;
    switch (axis) {
        case Axis::up:
            return {along(by.cos, heading, by.sin, left), along(by.cos, left, -by.sin, heading), up};
        case Axis::left:
            return {along(by.cos, heading, -by.sin, up), left, along(by.cos, up, by.sin, heading)};
        default:
            return {heading, along(by.cos, left, by.sin, up), along(by.cos, up, -by.sin, left)};
    }
}

Frame orthonormal(const Frame& frame) {
    const Vec3 heading = unit(frame.heading);
    const Vec3 left = unit(frame.left + heading * -dot(frame.left, heading));
    return {heading, left, cross(heading, left)};
}

}  // namespace filigree::rewriting
