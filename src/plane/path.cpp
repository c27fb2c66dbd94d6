#include "plane/path.h"

#include <cmath>

#include "base/elementary.h"
#include "plane/arc.h"

namespace filigree {

namespace {

constexpr double degrees_per_radian = 180 / elementary::pi;
// Ellipses thinner than this are too ill-conditioned to be told by end points, radii and rotation.
constexpr double thinnest_arc = 1e-6;

// An arc's radii, rotation and flags under the linear part of a map.
struct ArcShape {
    Vec radii;
    double rotation = 0;  // degrees
    double flags = 0;
};

ArcShape transformed_shape(const Vec shape[2], const Transform& by) {
    const double rx = std::fabs(shape[0].x), ry = std::fabs(shape[0].y);
    const double rotation = shape[1].x;
    const double scale_squared = determinant(by);
    ArcShape out;
    out.flags = shape[1].y;
    if (scale_squared < 0) out.flags = out.flags >= 2 ? out.flags - 2 : out.flags + 2;
    if (by.b == 0 && by.c == 0 && (rotation == 0 || by.a == by.d)) {
        out.radii = {std::fabs(by.a) * rx, std::fabs(by.d) * ry};
        out.rotation = rotation;
    } else if (is_similarity(by)) {
        const double scale = std::sqrt(std::fabs(scale_squared));
        const double turned = elementary::atan2(by.b, by.a) * degrees_per_radian;
        out.radii = {scale * rx, scale * ry};
        out.rotation = rx == ry ? 0 : scale_squared < 0 ? turned - rotation : turned + rotation;
    } else {
        // The map from the unit circle is [u v]; [u v] [u v]^T has the new axes as eigenvectors and the squares
        // of the new radii as eigenvalues.
        const elementary::CosSin axis = elementary::cos_sin_degrees(std::fmod(rotation, 360));
        const Vec u = rx * Vec{by.a * axis.cos + by.c * axis.sin, by.b * axis.cos + by.d * axis.sin};
        const Vec v = ry * Vec{by.c * axis.cos - by.a * axis.sin, by.d * axis.cos - by.b * axis.sin};
        const double xx = u.x * u.x + v.x * v.x, yy = u.y * u.y + v.y * v.y, xy = u.x * u.y + v.x * v.y;
        const double larger = std::sqrt(0.5 * (xx + yy) + length({0.5 * (xx - yy), xy}));
        out.radii = {larger, larger > 0 ? std::fabs(cross(u, v)) / larger : 0};
        out.rotation = 0.5 * elementary::atan2(2 * xy, xx - yy) * degrees_per_radian;
    }
    return out;
}

void append_transformed_arc(Path& out, Vec from, const Vec shape[2], Vec to, const Transform& by) {
    const ArcShape mapped = transformed_shape(shape, by);
    const double thinner = std::fmin(mapped.radii.x, mapped.radii.y);
    const double thicker = std::fmax(mapped.radii.x, mapped.radii.y);
    if (thinner < thinnest_arc * thicker && !is_similarity(by)) {
        const CentreArc arc = centre_arc(from, shape, to);
        if (!arc.is_line) {
            Path cubics;
            append_cubics(cubics, arc, to);
            out.verbs.insert(out.verbs.end(), cubics.verbs.begin(), cubics.verbs.end());
            for (const Vec p : cubics.points) out.points.push_back(apply(by, p));
            return;
        }
    }
    out.verbs.push_back(Verb::arc);
    out.points.insert(out.points.end(), {mapped.radii, {mapped.rotation, mapped.flags}, apply(by, to)});
}

}  // namespace

Path transformed(const Path& path, const Transform& by) {
    Path out;
    out.verbs.reserve(path.verbs.size());
    out.points.reserve(path.points.size());
    Vec start, here;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        const std::size_t count = point_count(verb);
        if (path.points.size() - at < count) break;
        const Vec* points = path.points.data() + at;
        at += count;
        if (verb == Verb::arc) {
            append_transformed_arc(out, here, points, points[2], by);
        } else {
            out.verbs.push_back(verb);
            for (std::size_t i = 0; i < count; ++i) out.points.push_back(apply(by, points[i]));
        }
        here = verb == Verb::close ? start : points[count - 1];
        if (verb == Verb::move) start = here;
    }
    return out;
}

}  // namespace filigree
