#include "scene/solid_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/test_cases.h"
#include "plane/verify.h"
#include "space/solids.h"
#include "space/space_cases.h"

namespace filigree {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

// Which element a ray meets first; none where that is not clear to 1e-4.
struct Hit {
    bool is_clear = true;
    std::optional<Key> element;
    double way = inf;  // along the ray
};

struct Ray {
    Vec3 from, along;
};

// How deep a point of a planar ring's plane lies inside it, below 0 outside: the distance to its border.
double depth_in(const std::vector<Vec3>& ring, Vec3 normal, Vec3 p) {
    double nearest = inf, turned = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 a = ring[i] - p, b = ring[(i + 1) % ring.size()] - p, edge = b - a;
        const double share = std::clamp(-dot(a, edge) / dot(edge, edge), 0.0, 1.0);
        nearest = std::min(nearest, length(a + edge * share));
        turned += std::atan2(dot(normal, cross(a, b)), dot(a, b));
    }
    return std::fabs(turned) > 3 ? nearest : -nearest;
}

// Against all faces, one by one, in space.
Hit cast(const Mesh& mesh, const Ray& ray) {
    Hit hit;
    double second = inf;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        std::vector<Vec3> ring;
        for (const std::uint32_t corner : corners_of_face(mesh, face)) ring.push_back(mesh.vertices[corner]);
        const Vec3 normal = unit(doubled_area(ring));
        const double towards = dot(normal, ray.along);
        if (std::fabs(towards) < 1e-3) {  // hit at its edge, if at all
            for (const Vec3 p : ring) hit.is_clear = hit.is_clear && length(cross(p - ray.from, ray.along)) > 100;
            continue;
        }
        const double way = dot(normal, ring[0] - ray.from) / towards;
        const double depth = depth_in(ring, normal, ray.from + ray.along * way);
        if (depth < -1e-3) continue;
        if (depth < 1e-3) hit.is_clear = false;
        if (way < hit.way) {
            second = hit.way;
            hit.way = way;
            hit.element = mesh.faces[face].origin.element;
        } else {
            second = std::min(second, way);
        }
    }
    if (second - hit.way < 1e-3) hit.is_clear = false;
    return hit;
}

Ray ray_through(const Camera& camera, Vec place) {
    const Vec3 at = camera.target + (camera.right * place.x - camera.up * place.y) * (1 / camera.scale);
    if (!camera.distance) return {at + camera.towards * 1000, -camera.towards};
    const Vec3 eye = camera.target + camera.towards * (*camera.distance / camera.scale);
    return {eye, unit(at - eye)};
}

// What is painted last at a place, strokes aside.
std::optional<Key> top_at(const Drawing& drawing, Vec place) {
    std::optional<Key> top;
    for (const DrawnShape& shape : drawing.shapes) {
        if (!has_fill(drawing.styles[shape.style])) continue;
        if (locate(polygon_of(drawing, shape), snap(place)) >= 0) top = shape.key;
    }
    return top;
}

View random_view(CaseRandom& random) {
    View view;
    view.azimuth = random.between(-180, 180);
    view.elevation = random.between(-90, 90);
    view.up = random.coin() ? UpAxis::y : UpAxis::z;
    view.projection = random.coin() ? Projection::orthographic : Projection::perspective;
    view.field_of_view = random.between(20, 70);
    view.scale = random.between(0.5, 3);
    return view;
}

// Boxes, prisms and stars that pass through each other, each an element of its own.
Mesh random_mesh(CaseRandom& random, std::uint32_t count) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const MeshOrigin origin{Key{i + 1}, random.below(3)};
        Frame3 frame = random_frame(random);
        if (random.coin()) frame = {};
        Vec3 at = random_vector(random, 40);
        if (random.coin()) at = {std::round(at.x / 10) * 10, std::round(at.y / 10) * 10, std::round(at.z / 10) * 10};
        const double size = random.coin() ? 10 : random.between(2, 30);
        switch (random.below(3)) {
            case 0:
                add_box(mesh, at, at + frame.heading * size, frame, size * 0.5, random.between(1, 20), origin);
                break;
            case 1:
                add_prism(mesh, at, at + frame.heading * (2 * size), frame, size / 2, 3 + random.below(6), origin);
                break;
            default:
                add_sheet(mesh, random_star(random, at, frame, size), origin);
                break;
        }
    }
    return mesh;
}

TEST(SolidView, TopmostIsWhatARayMeetsFirst) {
    std::size_t clear = 0, hits = 0;
    for (std::uint64_t number = 0; number < case_count(150); ++number) {
        SCOPED_TRACE(number);
        CaseRandom random(number);
        const Mesh mesh = random_mesh(random, 1 + random.below(12));
        const View view = random_view(random);
        const Result<Drawing> drawing = solid_view(mesh, {}, view);
        ASSERT_TRUE(drawing);
        for (const DrawnShape& shape : drawing->shapes) {
            if (drawing->styles[shape.style].is_open) continue;
            ASSERT_EQ(find_flaw(polygon_of(*drawing, shape)), std::nullopt);
        }
        const Camera camera = camera_of(view, mesh);
        for (int i = 0; i < 60; ++i) {
            const Vec place = drawing->canvas.origin +
                              Vec{random.unit() * drawing->canvas.size.x, random.unit() * drawing->canvas.size.y};
            const Hit hit = cast(mesh, ray_through(camera, place));
            if (!hit.is_clear) continue;
            ++clear;
            hits += hit.element ? 1 : 0;
            ASSERT_EQ(top_at(*drawing, place), hit.element) << "at " << place.x << ", " << place.y;
        }
    }
    EXPECT_GT(clear, 25 * case_count(150));
    EXPECT_GT(hits, 5 * case_count(150));
}

TEST(SolidView, LinesAreSeenWhereNothingStandsBefore) {
    std::size_t seen = 0, hidden = 0;
    SolidViewOptions exact;
    exact.seam_pen = 0;  // cut lines are drawn longer by half of it
    for (std::uint64_t number = 0; number < case_count(150); ++number) {
        SCOPED_TRACE(number);
        CaseRandom random(number);
        Mesh mesh = random_mesh(random, 1 + random.below(16));
        std::vector<Vec3> points;
        for (std::uint32_t i = 2 + random.below(4); i-- > 0;) points.push_back(random_vector(random, 50));
        add_line(mesh, points, 0.001, {Key{1000}, 0});
        const View view = random_view(random);
        const Result<Drawing> drawing = solid_view(mesh, {}, view, exact);
        ASSERT_TRUE(drawing);
        const Camera camera = camera_of(view, mesh);
        for (int i = 0; i < 30; ++i) {
            const std::size_t stretch = random.index(points.size() - 1);
            const Vec3 at = points[stretch] + (points[stretch + 1] - points[stretch]) * random.unit();
            const Vec place = projected(camera, seen_from(camera, at));
            const Ray ray = ray_through(camera, place);
            const Hit hit = cast(mesh, ray);
            const double way = dot(at - ray.from, ray.along);
            if (!hit.is_clear || std::fabs(hit.way - way) < 1e-2) continue;
            bool is_line = false;
            for (const DrawnShape& shape : drawing->shapes) {
                const PolygonView polygon = polygon_of(*drawing, shape);
                if (shape.key != Key{1000}) {
                    is_line = is_line && (!has_fill(drawing->styles[shape.style]) || locate(polygon, snap(place)) < 0);
                    continue;
                }
                for (std::size_t k = 1; k < polygon.outer().size(); ++k) {
                    const Vec a = to_px(polygon.outer()[k - 1]), along = to_px(polygon.outer()[k]) - a;
                    const double share = std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0);
                    is_line = is_line || length(a + along * share - place) < 1e-5;
                }
            }
            ASSERT_EQ(is_line, way < hit.way) << "at " << place.x << ", " << place.y;
            ++(is_line ? seen : hidden);
        }
    }
    EXPECT_GT(seen, 5 * case_count(150));
    EXPECT_GT(hidden, 2 * case_count(150));
}

std::size_t count_open(const Drawing& drawing) {
    return static_cast<std::size_t>(
        std::count_if(drawing.shapes.begin(), drawing.shapes.end(),
                      [&](const DrawnShape& shape) { return drawing.styles[shape.style].is_open; }));
}

TEST(SolidView, AzimuthAndElevationSayWhereTheCameraStands) {
    View view;
    view.azimuth = view.elevation = 0;
    view.target = Vec3{};
    const auto place_of = [&](Vec3 p) {
        const Camera camera = camera_of(view, {});
        return projected(camera, seen_from(camera, p));
    };
    EXPECT_EQ(place_of({1, 5, 2}), (Vec{1, -2}));
    view.up = UpAxis::y;
    EXPECT_EQ(place_of({1, 2, 5}), (Vec{1, -2}));
    view.azimuth = 90;
    EXPECT_EQ(camera_of(view, {}).towards, (Vec3{1, 0, 0}));
    view.up = UpAxis::z;
    EXPECT_EQ(camera_of(view, {}).towards, (Vec3{1, 0, 0}));
    view.azimuth = 0;
    view.elevation = 90;
    EXPECT_EQ(place_of({1, 2, 9}), (Vec{1, -2}));
}

TEST(SolidView, ABoxIsThreeFacesInThreeShades) {
    Mesh mesh;
    add_box(mesh, {}, {10, 0, 0}, {}, 10, 10, {Key{5}, 0});
    const Result<Drawing> drawing = solid_view(mesh, std::array{Material{}}, {});
    ASSERT_TRUE(drawing);
    ASSERT_EQ(drawing->shapes.size(), 3U);
    EXPECT_EQ(drawing->styles.size(), 3U);
    for (const Style& style : drawing->styles) EXPECT_EQ(style.stroke, Material{}.edge);
    EXPECT_EQ(drawing->shapes[0].key, Key{5});
}

TEST(SolidView, CutsAreNotStroked) {
    // Two stars of a window cross along the z axis.
    Mesh mesh;
    add_sheet(mesh, std::array{Vec3{-9, 0, -5}, Vec3{9, 0, -5}, Vec3{9, 0, 5}, Vec3{-9, 0, 5}}, {Key{1}, 0});
    add_sheet(mesh, std::array{Vec3{0, -9, -4}, Vec3{0, 9, -4}, Vec3{0, 9, 4}, Vec3{0, -9, 4}}, {Key{2}, 0});
    const Result<Drawing> drawing = solid_view(mesh, {}, {});
    ASSERT_TRUE(drawing);
    EXPECT_EQ(drawing->shapes.size() - count_open(*drawing), 3U) << "one of them is cut";
    EXPECT_EQ(count_open(*drawing), 2U);
    const Camera camera = camera_of({}, mesh);
    const Vec middle = projected(camera, seen_from(camera, {0, 0, 1}));
    for (const DrawnShape& shape : drawing->shapes) {
        if (!drawing->styles[shape.style].is_open) continue;
        const RingView line = polygon_of(*drawing, shape).outer();
        EXPECT_EQ(line.size(), 4U);
        for (std::size_t i = 1; i < line.size(); ++i) {
            EXPECT_GT(std::fabs(cross(to_px(line[i]) - to_px(line[i - 1]), middle - to_px(line[i - 1]))), 1);
        }
    }
}

TEST(SolidView, CoplanarFacesKeepTheirOrder) {
    for (const bool is_swapped : {false, true}) {
        Mesh mesh;
        for (const std::uint64_t element : {is_swapped ? 2U : 1U, is_swapped ? 1U : 2U}) {
            const double size = element == 1 ? 9 : 5;
            add_sheet(mesh, std::array{Vec3{0, 0, 0}, Vec3{size, 0, 0}, Vec3{size, size, 0}}, {Key{element}, 0});
        }
        const Result<Drawing> drawing = solid_view(mesh, {}, {});
        ASSERT_TRUE(drawing);
        ASSERT_EQ(drawing->shapes.size() - count_open(*drawing), 2U);
        EXPECT_EQ(drawing->shapes[0].key, mesh.faces[0].origin.element);
        EXPECT_EQ(drawing->shapes[1].key, mesh.faces[1].origin.element);
    }
}

TEST(SolidView, ABallStaysWhole) {
    constexpr std::uint32_t rows = 40, columns = 80;
    Mesh mesh;
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i <= rows; ++i) {
        for (std::uint32_t k = 0; k < columns; ++k) {
            const elementary::CosSin up = elementary::cos_sin_degrees(180.0 * i / rows - 90);
            const elementary::CosSin around = elementary::cos_sin_degrees(360.0 * k / columns);
            points.push_back(Vec3{up.cos * around.cos, up.cos * around.sin, up.sin} * 100);
        }
    }
    add_vertices(mesh, points);
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t k = 0; k < columns; ++k) {
            const std::uint32_t next = (k + 1) % columns, low = i * columns, high = low + columns;
            add_face(mesh, std::array{low + k, low + next, high + next, high + k}, {});
        }
    }
    const Result<Drawing> drawing = solid_view(mesh, {}, {});
    ASSERT_TRUE(drawing);
    EXPECT_NEAR(static_cast<double>(drawing->shapes.size() - count_open(*drawing)), rows * columns / 2, 30);
    for (const DrawnShape& shape : drawing->shapes) {
        const Style& style = drawing->styles[shape.style];
        EXPECT_TRUE(style.is_open || style.stroke == style.fill) << "its faces meet smoothly";
    }
    EXPECT_LT(count_open(*drawing), 4 * columns) << "strokes go round the outline alone";
}

TEST(SolidView, ComesToNoHarm) {
    const auto shapes_of = [](const Mesh& mesh, const View& view = {}) {
        const Result<Drawing> drawing = solid_view(mesh, {}, view);
        return drawing ? drawing->shapes.size() : SIZE_MAX;
    };
    EXPECT_EQ(shapes_of({}), 0U);
    Mesh mesh;
    add_sheet(mesh, std::array{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {});
    mesh.vertices[2].z = std::nan("");
    EXPECT_EQ(shapes_of(mesh), 0U);
    mesh.vertices[2].z = 1e300;
    EXPECT_EQ(shapes_of(mesh), 0U);
    mesh.vertices[2] = {2, 0, 0};
    EXPECT_EQ(shapes_of(mesh), 0U);
    add_line(mesh, std::array{Vec3{0, 0, 3}, Vec3{0, 0, 3}}, 1, {});
    add_line(mesh, std::array{Vec3{0, 0, 3}}, 1, {});
    add_line(mesh, std::array{Vec3{0, 0, 3}, Vec3{1, 1, inf}}, 1, {});
    EXPECT_EQ(shapes_of(mesh), 0U);
    add_line(mesh, std::array{Vec3{0, 0, 3}, Vec3{0, 0, 4}}, 1, {Key{}, 77});
    EXPECT_EQ(shapes_of(mesh), 1U);

    Mesh floor;
    add_sheet(floor, std::array{Vec3{-99, -99, 0}, Vec3{99, -99, 0}, Vec3{99, 99, 0}, Vec3{-99, 99, 0}}, {});
    add_line(floor, std::array{Vec3{0, -99, 1}, Vec3{0, 99, 1}}, 1, {});
    View inside;
    inside.projection = Projection::perspective;
    inside.distance = 20;
    EXPECT_EQ(shapes_of(floor, inside), 4U) << "fill, strokes, the line and its uncut end: what lies behind is gone";

    SolidViewOptions few;
    few.most_pieces = 5;
    CaseRandom random(1);
    const Result<Drawing> refused = solid_view(random_mesh(random, 30), {}, {}, few);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics()[0].code, "limit.elements");
    const std::atomic<bool> is_cancelled = true;
    SolidViewOptions cancelled;
    cancelled.job.cancel_flag = &is_cancelled;
    const Result<Drawing> ended = solid_view(random_mesh(random, 30), {}, {}, cancelled);
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.diagnostics()[0].code, "job.cancelled");
}

}  // namespace
}  // namespace filigree
