// Meshes as Wavefront OBJ with their materials as MTL.
//
// Guarantee: the same mesh gives the same bytes. Points that read the same are written once, in the order of the mesh's
// vertices, those that nothing uses not at all; polygons stay polygons, lines become `l`. Axes and units are the mesh's
// own. What falls together when numbers are rounded is left out.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "space/mesh.h"

namespace filigree {

struct ObjOptions {
    std::string materials_file = "materials.mtl";   // the name under which the MTL will be found
    std::function<std::string(Key)> group_of = {};  // the group of an element, such as its letter; none: its number
    int decimals = 6;                               // digits after the point, 0..15
};

struct ObjFiles {
    std::string obj, mtl;
};

// A material that the table has not is Material{} under its number. In names, what is no letter, digit or one of .-_ in
// ASCII, nor a letter beyond, becomes '_'; equal names of materials are told apart by their numbers.
ObjFiles to_obj(const Mesh& mesh, std::span<const Material> materials, const ObjOptions& options = {});

}  // namespace filigree
