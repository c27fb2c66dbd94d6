#include "space/solids.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "space/space_cases.h"

namespace filigree {
namespace {

// By the divergence theorem; negative where faces look inwards.
double volume(const Mesh& mesh) {
    double sixfold = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto corners = corners_of_face(mesh, face);
        for (std::size_t i = 2; i < corners.size(); ++i) {
            const Vec3 a = mesh.vertices[corners[0]], b = mesh.vertices[corners[i - 1]], c = mesh.vertices[corners[i]];
            sixfold += dot(a, cross(b, c));
        }
    }
    return sixfold / 6;
}

// Every edge is run along once in each direction, and V - E + F = 2.
void expect_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::set<std::uint32_t> vertices;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto corners = corners_of_face(mesh, face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            ++edges[{corners[i], corners[(i + 1) % corners.size()]}];
            vertices.insert(corners[i]);
        }
    }
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_EQ(vertices.size(), mesh.vertices.size());
    EXPECT_EQ(mesh.vertices.size() + mesh.faces.size(), edges.size() / 2 + 2);
}

TEST(Solids, BoxHasItsSizesAlongTheFrame) {
    Mesh mesh;
    const Frame3 frame{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    ASSERT_TRUE(add_box(mesh, {1, 2, 3}, {1, 12, 3}, frame, 4, 6, {Key{9}, 2}));
    expect_closed(mesh);
    EXPECT_EQ(mesh.faces.size(), 6U);
    EXPECT_DOUBLE_EQ(volume(mesh), 240);
    for (const MeshFace& face : mesh.faces) EXPECT_EQ(face.origin, (MeshOrigin{Key{9}, 2}));
    for (const Vec3 v : mesh.vertices) {
        EXPECT_TRUE(v.x == -2 || v.x == 4);
        EXPECT_TRUE(v.y == 2 || v.y == 12);
        EXPECT_TRUE(v.z == 1 || v.z == 5);
    }
}

TEST(Solids, AreClosedAndLookOutwards) {
    for (std::uint64_t number = 0; number < case_count(300); ++number) {
        SCOPED_TRACE(number);
        CaseRandom random(number);
        const Frame3 frame = random_frame(random);
        const Vec3 from = random_vector(random, 50);
        const double reach = random.between(0.1, 30), radius = random.between(0.1, 10);
        const std::uint32_t sides = 3 + random.below(20);
        Mesh prism, box;
        ASSERT_TRUE(add_prism(prism, from, from + frame.heading * reach, frame, radius, sides, {}));
        ASSERT_TRUE(add_box(box, from, from + frame.heading * reach, frame, radius, 2 * radius, {}));
        expect_closed(prism);
        expect_closed(box);
        const double section = sides * radius * radius / 2 * elementary::cos_sin_degrees(360.0 / sides).sin;
        EXPECT_NEAR(volume(prism), section * reach, 1e-9 * (1 + section * reach));
        EXPECT_NEAR(volume(box), 2 * radius * radius * reach, 1e-9 * (1 + radius * radius * reach));
        const Vec3 middle = from + frame.heading * (reach / 2);
        for (const Mesh& solid : {prism, box}) {
            for (std::size_t face = 0; face < solid.faces.size(); ++face) {
                const Vec3 corner = solid.vertices[corners_of_face(solid, face)[0]];
                EXPECT_GT(dot(doubled_area(solid, face), corner - middle), 0) << "face " << face;
            }
        }
    }
}

TEST(Solids, WhatHasNoExtentIsLeftOut) {
    Mesh mesh;
    EXPECT_FALSE(add_box(mesh, {}, {}, {}, 1, 1, {}));
    EXPECT_FALSE(add_box(mesh, {}, {-1, 0, 0}, {}, 1, 1, {})) << "against its frame";
    EXPECT_FALSE(add_box(mesh, {}, {1, 0, 0}, {}, 0, 1, {}));
    EXPECT_FALSE(add_prism(mesh, {}, {1, 0, 0}, {}, -1, 4, {}));
    EXPECT_FALSE(add_prism(mesh, {}, {1, 0, 0}, {}, 1, 2, {}));
    EXPECT_FALSE(add_sheet(mesh, std::array{Vec3{}, Vec3{1, 1, 1}, Vec3{2, 2, 2}}, {}));
    EXPECT_EQ(mesh, Mesh{});
}

TEST(Mesh, AppendKeepsBoth) {
    Mesh box, all;
    add_box(box, {}, {1, 0, 0}, {}, 1, 1, {Key{1}, 0});
    add_line(box, std::array{Vec3{}, Vec3{0, 0, 9}}, 2, {Key{2}, 1});
    add_sheet(all, std::array{Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, {Key{3}, 0});
    add_line(all, std::array{Vec3{}, Vec3{7, 0, 0}}, 1, {});
    EXPECT_EQ(append(all, box), 5U);
    ASSERT_EQ(all.faces.size(), 7U);
    EXPECT_TRUE(all.faces[0].is_sheet);
    EXPECT_FALSE(all.faces[1].is_sheet);
    EXPECT_EQ(all.faces[1].origin.element, Key{1});
    EXPECT_EQ(doubled_area(all, 6), doubled_area(box, 5));
    ASSERT_EQ(all.lines.size(), 2U);
    EXPECT_EQ(all.vertices[points_of_line(all, 1)[1]], (Vec3{0, 0, 9}));
    EXPECT_EQ(all.lines[1].width, 2);
}

}  // namespace
}  // namespace filigree
