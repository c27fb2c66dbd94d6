// How a scene in space is looked at, and where its points come to lie in the picture.
#pragma once

#include <cstdint>
#include <optional>

#include "plane/point.h"
#include "space/mesh.h"
#include "space/painters_order.h"

namespace filigree {

enum class UpAxis : std::uint8_t { y, z };
enum class Projection : std::uint8_t { orthographic, perspective };

// At azimuth and elevation 0 the camera looks along +Y with Z up, along -Z with Y up; either way +X is to the right.
struct View {
    double azimuth = 30;    // degrees; the camera goes to the right about the scene
    double elevation = 25;  // degrees; and up
    UpAxis up = UpAxis::z;
    Projection projection = Projection::orthographic;
    double scale = 1;                     // px a unit of space; with perspective, at the target
    std::optional<Vec3> target = {};      // what is looked at; none: the middle of all that is there
    double field_of_view = 30;            // degrees: with perspective, a ball about all just fills it;
    std::optional<double> distance = {};  // unless the camera's distance from the target is given
    Vec3 light{-0.35, 0.6, 0.7};          // towards it, as the camera sees it: right, up, nearer
    double ambient = 0.45;                // of full light, where none falls
};

struct Camera {
    Vec3 target, right, up, towards;  // orthonormal; `towards` the camera
    double scale = 1;
    std::optional<double> distance = {};  // px, from the target; none: far away
};
Camera camera_of(const View& view, const Mesh& mesh);

// In px about the target: right, up, nearer.
Vec3 seen_from(const Camera& camera, Vec3 p);
// The viewer of such points.
Viewer viewer_of(const Camera& camera);
// In the picture, y downwards, the target at the origin. With perspective the point must not be beside the camera.
Vec projected(const Camera& camera, Vec3 seen);
// With perspective, what is nearer than a hundredth of the way to the target is not drawn: it is before this plane.
std::optional<Plane3> near_plane(const Camera& camera);

}  // namespace filigree
