#include "derivation/symmetric_drawing.h"

#include <algorithm>

#include "scene/repeat.h"

namespace filigree {

namespace {

Polygons rectangle(Vec low, Vec high) {
    Polygons out;
    for (const Vec corner : {low, Vec{high.x, low.y}, high, Vec{low.x, high.y}}) out.points.push_back(snap(corner));
    out.end_ring();
    out.end_polygon();
    return out;
}

}  // namespace

Result<Drawing> repeated_over_page(const Drawing& motif, const PlaneStart& start, const Settings& settings,
                                   const Job& job) {
    const Symmetry& symmetry = *start.symmetry;
    const Page& page = settings.page;
    const Vec tile = to_px(symmetry.tile());
    const Box box = bounds(start.polygons);
    Diagnostics warnings;
    RepeatOptions options;
    options.most_shapes = settings.limits.elements;
    options.job = job;
    Canvas& canvas = options.canvas;
    canvas = motif.canvas;
    Polygons clip;
    if (start.in_host) {
        fit_canvas(canvas, box, 0);
        clip = start.polygons;
    } else if (page.kind == PageStatement::Kind::tile) {
        canvas.size = tile;
        // A tile without a symmetry lies around the starts, on the grid; else both have one centre.
        const Vec centre = settings.symmetry ? Vec{} : 0.5 * (to_px(box.min) + to_px(box.max));
        canvas.origin = to_px(snap(centre - 0.5 * tile));
        if (page.margin.value_or(0) > 0) {
            warnings.push_back(warning("page.tile-margin", "a tile has no margin, so that it can be repeated"));
        }
    } else if (page.kind == PageStatement::Kind::fit) {
        if (symmetry.has_tile()) {
            canvas.size = 3 * tile;
            canvas.origin = -0.5 * canvas.size;
        } else {
            fit_canvas(canvas, bounds_of_copies(symmetry, start.polygons), page.margin);
        }
    } else {
        canvas.size = {page.width, page.height};
        canvas.origin = -0.5 * canvas.size;
        const double margin = page.margin.value_or(0);
        if (margin > 0 && 2 * margin < std::min(page.width, page.height)) {
            const Vec inside = 0.5 * canvas.size - Vec{margin, margin};
            clip = rectangle(-inside, inside);
        }
    }
    if (!clip.empty()) options.clip = &clip;
    Result<Drawing> all = repeated(motif, symmetry, options);
    if (!all) return all;
    return {std::move(*all), std::move(warnings)};
}

}  // namespace filigree
