// Drawings to files: the format by the ending, and which targets must not be written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/job.h"
#include "base/result.h"
#include "formats/svg_write.h"
#include "scene/drawing.h"

namespace filigree {

// Whether the ending is one of a drawing's formats: .svg, .pdf, .png.
bool is_known_format(const std::filesystem::path& output);
// Whether it is that of a mesh, which has a file of materials beside it: .obj.
bool is_mesh_format(const std::filesystem::path& output);
std::filesystem::path materials_beside(const std::filesystem::path& output);
// Errors for endings that are neither.
Diagnostics unknown_formats(const std::vector<std::filesystem::path>& outputs, bool takes_meshes = false);
// For a drawing's ending where a document is written.
Diagnostics not_a_document(const std::filesystem::path& output);
// For targets that are given twice.
Diagnostics same_outputs(const std::vector<std::filesystem::path>& targets);
// For targets that are read: a document and what it reads are never overwritten by what they make.
Diagnostics overwrites(const std::vector<std::filesystem::path>& targets,
                       const std::vector<std::filesystem::path>& read);

struct EncodeOptions {
    double dpi = 192;  // of PNG
    bool lean = false;
    const CarriedDocument* carried = nullptr;  // into an SVG or PDF, if given
    std::string title;
    Job job = {};  // its progress is not reported
};
// The bytes of a drawing in the format that the path's ending names.
Result<std::string> encoded(const Drawing& drawing, const std::filesystem::path& output, const EncodeOptions& options);

}  // namespace filigree
