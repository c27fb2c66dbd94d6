// What a word draws in space: solids, sheets and lines as a mesh, and how they look.
//
// Lines stay lines unless the document says how many sides they have (`tubes`); a box stands where its letter does, and
// other placed shapes lie as sheets in the plane of the turtle's heading and left.
#pragma once

#include <unordered_map>
#include <vector>

#include "engines/rewriting/word_styles.h"
#include "space/mesh.h"

namespace filigree::rewriting {

struct WordSolid {
    Mesh mesh;
    std::vector<Material> materials;                           // named after letters
    std::unordered_map<std::uint64_t, std::uint64_t> symbols;  // places in Word::symbols by element key: looked up only
};

// The forms' outlines are those of draw.h: by number, px, y downwards.
Result<WordSolid> word_solid(const Derivation& derivation, const TurtleDrawing& turtled, const DrawRules& rules,
                             const std::vector<Polygons>& forms, WordStyles& styles);

}  // namespace filigree::rewriting
