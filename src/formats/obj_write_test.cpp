#include "formats/obj_write.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "base/test_cases.h"
#include "space/solids.h"
#include "space/space_cases.h"

namespace filigree {
namespace {

struct ReadElement {
    char kind = 'f';
    std::vector<std::size_t> points;  // from 0
    std::string group, material;
};

struct ReadObj {
    std::vector<Vec3> points;
    std::vector<ReadElement> elements;
    std::string library;
};

ReadObj read(const std::string& text) {
    ReadObj obj;
    std::istringstream lines(text);
    std::string group, material;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            obj.points.push_back(p);
        } else if (kind == "f" || kind == "l") {
            obj.elements.push_back({kind[0], {}, group, material});
            for (std::size_t number = 0; words >> number;) {
                EXPECT_GE(number, 1U);
                EXPECT_LE(number, obj.points.size());
                obj.elements.back().points.push_back(number - 1);
            }
        } else if (kind == "g") {
            words >> group;
        } else if (kind == "usemtl") {
            words >> material;
        } else if (kind == "mtllib") {
            words >> obj.library;
        } else {
            ADD_FAILURE() << line;
        }
    }
    return obj;
}

TEST(ObjWrite, WritesFacesLinesGroupsAndMaterials) {
    Mesh mesh;
    add_sheet(mesh, std::array{Vec3{0, 0, 0}, Vec3{1.5, 0, 0}, Vec3{1.5, 1, 0}, Vec3{0, 1, 0}}, {Key{7}, 1});
    add_sheet(mesh, std::array{Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1e-5}}, {Key{8}, 1});
    add_line(mesh, std::array{Vec3{0, 1, 0}, Vec3{0, 2, 0}}, 1, {Key{8}, 0});
    std::array<Material, 2> materials;
    materials[0].name = "red oak";
    materials[0].fill = {255, 51, 0, 255};
    materials[1].fill = {0, 0, 0, 0};
    ObjOptions options;
    options.group_of = [](Key element) { return element == Key{7} ? "a" : "[b"; };
    const ObjFiles files = to_obj(mesh, materials, options);
    EXPECT_EQ(files.obj,
              "mtllib materials.mtl\n"
              "v 0 0 0\nv 1.5 0 0\nv 1.5 1 0\nv 0 1 0\nv 0 0 -0.00001\nv 0 2 0\n"
              "g a\nusemtl material-1\nf 1 2 3 4\n"
              "g _b\nf 1 4 5\n"
              "usemtl red_oak\nl 4 6\n");
    EXPECT_EQ(files.mtl,
              "newmtl red_oak\nKd 1 0.2 0\nd 1\nillum 1\n"
              "newmtl material-1\nKd 0 0 0\nd 0\nillum 1\n");
}

TEST(ObjWrite, ReadsBackAsTheSameMesh) {
    for (std::uint64_t number = 0; number < case_count(200); ++number) {
        SCOPED_TRACE(number);
        CaseRandom random(number);
        Mesh mesh;
        for (std::uint32_t i = 1 + random.below(6); i-- > 0;) {
            const Frame3 frame = random_frame(random);
            const Vec3 at = random_vector(random, 100);
            const MeshOrigin origin{Key{random.bits()}, random.below(4)};
            if (random.coin()) {
                add_prism(mesh, at, at + frame.heading * 5, frame, 2, 3 + random.below(9), origin);
            } else {
                add_line(mesh, std::array{at, at + frame.left, at + frame.up}, 1, origin);
            }
        }
        std::array<Material, 3> materials;
        for (Material& material : materials) material.name = "same";
        const ObjFiles files = to_obj(mesh, materials);
        const ReadObj obj = read(files.obj);
        EXPECT_EQ(obj.library, "materials.mtl");
        ASSERT_EQ(obj.elements.size(), mesh.faces.size() + mesh.lines.size());
        std::array<std::string, 4> names;
        for (std::size_t i = 0; i < obj.elements.size(); ++i) {
            const bool is_face = i < mesh.faces.size();
            const std::size_t at = is_face ? i : i - mesh.faces.size();
            const MeshOrigin& origin = is_face ? mesh.faces[at].origin : mesh.lines[at].origin;
            const auto points = is_face ? corners_of_face(mesh, at) : points_of_line(mesh, at);
            const ReadElement& element = obj.elements[i];
            EXPECT_EQ(element.kind, is_face ? 'f' : 'l');
            EXPECT_EQ(element.group, std::to_string(origin.element.value));
            ASSERT_EQ(element.points.size(), points.size());
            for (std::size_t k = 0; k < points.size(); ++k) {
                EXPECT_LT(length(obj.points[element.points[k]] - mesh.vertices[points[k]]), 2e-6);
            }
            std::string& name = names[origin.material];
            if (name.empty()) name = element.material;
            EXPECT_EQ(name, element.material);
            EXPECT_NE(files.mtl.find("newmtl " + name + "\n"), std::string::npos);
        }
        for (std::size_t a = 0; a < names.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(names[a] != names[b] || names[a].empty());
        }
    }
}

TEST(ObjWrite, SharedPointsAreWrittenOnceAndUnusedOnesNever) {
    Mesh mesh;
    add_vertices(mesh, std::array{Vec3{9, 9, 9}});
    add_box(mesh, {}, {1, 0, 0}, {}, 1, 1, {});
    add_box(mesh, {1, 0, 0}, {2, 0, 0}, {}, 1, 1, {});
    add_sheet(mesh, std::array{Vec3{0, 0, 0}, Vec3{1e-9, 0, 0}, Vec3{0, 1, 0}}, {});
    const ReadObj obj = read(to_obj(mesh, {}).obj);
    EXPECT_EQ(obj.points.size(), 12U + 2U);
    EXPECT_EQ(obj.elements.size(), 12U) << "a face that rounding leaves without area is none";
}

}  // namespace
}  // namespace filigree
