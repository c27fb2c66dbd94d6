#include "space/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"

namespace filigree {
namespace {

struct Bounds3 {
    Vec3 min, max;
};

Bounds3 bounds(const Mesh& mesh) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Bounds3 box{{inf, inf, inf}, {-inf, -inf, -inf}};
    const auto add = [&](std::uint32_t vertex) {
        const Vec3 p = mesh.vertices[vertex];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    };
    for (const std::uint32_t corner : mesh.corners) add(corner);
    for (const std::uint32_t point : mesh.line_points) add(point);
    if (box.min.x > box.max.x) return {};
    return box;
}

}  // namespace

Camera camera_of(const View& view, const Mesh& mesh) {
    const elementary::CosSin azimuth = elementary::cos_sin_degrees(view.azimuth);
    const elementary::CosSin elevation = elementary::cos_sin_degrees(view.elevation);
    // Right, forwards and up of the level camera at azimuth 0.
    const Vec3 across{1, 0, 0};
    const Vec3 into = view.up == UpAxis::z ? Vec3{0, 1, 0} : Vec3{0, 0, -1};
    const Vec3 upwards = view.up == UpAxis::z ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    const Bounds3 box = bounds(mesh);
    Camera camera;
    camera.target = view.target.value_or(box.min + (box.max - box.min) * 0.5);
    camera.right = across * azimuth.cos + into * azimuth.sin;
    const Vec3 level = across * azimuth.sin - into * azimuth.cos;
    camera.towards = level * elevation.cos + upwards * elevation.sin;
    camera.up = upwards * elevation.cos - level * elevation.sin;
    camera.scale = view.scale;
    if (view.projection == Projection::perspective) {
        const double radius = length(box.max - box.min) / 2;
        const double half = std::clamp(view.field_of_view, 1.0, 170.0) / 2;
        const double fitting = radius / elementary::cos_sin_degrees(half).sin;
        camera.distance = view.distance.value_or(fitting > 0 ? fitting : 1) * view.scale;
    }
    return camera;
}

Vec3 seen_from(const Camera& camera, Vec3 p) {
    const Vec3 offset = (p - camera.target) * camera.scale;
    return {dot(camera.right, offset), dot(camera.up, offset), dot(camera.towards, offset)};
}

Viewer viewer_of(const Camera& camera) {
    Viewer viewer;
    if (camera.distance) viewer.eye = Vec3{0, 0, *camera.distance};
    return viewer;
}

Vec projected(const Camera& camera, Vec3 seen) {
    const double grows = camera.distance ? *camera.distance / (*camera.distance - seen.z) : 1;
    return {seen.x * grows, -seen.y * grows};
}

std::optional<Plane3> near_plane(const Camera& camera) {
    if (!camera.distance) return std::nullopt;
    return Plane3{{0, 0, 1}, *camera.distance * 0.99};
}

}  // namespace filigree
