// A drawn word as a mesh in Wavefront OBJ.
#pragma once

#include <string>

#include "formats/obj_write.h"
#include "session/run.h"

namespace filigree {

// Groups are named after the letter that made them and its place among the symbols: b_17. The document must be a
// rewriting one. `materials_file`: under which name the materials will lie beside it.
Result<ObjFiles> word_obj(const OpenedDocument& opened, const CheckedDocument& checked, const WordRun& word,
                          const std::string& materials_file);

}  // namespace filigree
