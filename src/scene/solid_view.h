// Pictures of meshes: faces in exact painter's order, shaded by one light, with strokes along their edges.
//
// Faces of solids are seen from outside only; sheets from both sides. Faces and lines that hide each other in part, or
// pass through each other, are cut (space/painters_order.h), and made whole again where the picture allows it
// (space/rejoin.h). Strokes go along edges of faces only, never along cuts: along outlines and creases, that is, where
// a face has no neighbour, one that looks away, or one at a sharp angle; and once more over what would cover half of
// them (space/stroke_again.h). Opaque pieces that are not stroked all around are drawn with a thin pen of their own
// colour as well, so that no seam shows between them.
//
// All shapes of an element have its key. Lines have no thickness where they meet faces: one that lies in a face is
// drawn over it, one that passes behind is cut square where it does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/job.h"
#include "base/limits.h"
#include "base/result.h"
#include "scene/drawing.h"
#include "space/mesh.h"
#include "space/view.h"

namespace filigree {

struct SolidViewOptions {
    double crease = 50;                 // degrees between faces, from which on their common edge is stroked
    double seam_pen = 0.6;              // px
    std::optional<double> margin = {};  // px around the picture; see fit_canvas
    std::string path;                   // of the one group that holds all
    std::uint64_t most_pieces = Limits{}.elements;
    Job job = {};  // its progress is not reported
};

// A material that the table has not is Material{}. The light's shading darkens the fill of faces; lines have it as it
// is. In the drawing the camera's target is the origin. `limit.elements` where more pieces come out than allowed.
Result<Drawing> solid_view(const Mesh& mesh, std::span<const Material> materials, const View& view,
                           const SolidViewOptions& options = {});

}  // namespace filigree
