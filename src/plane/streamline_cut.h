// The split of a polygon with holes along complete, evenly spaced lines that follow its form (gTangle, section 4.2,
// streamline split).
//
// Kinds: `smooth` runs parallel to the border, in outlines that grow rounder inwards; `strip` crosses the shape from
// border to border, band after band along its length; `circular` runs round a centre. Modes: `iso` draws the level
// lines of a scalar field (outline_field.h, strip_field.h, the distance from the centre), which never meet; `field`
// follows vectors that are given at the border and interpolated inside (boundary_field.h, streamlines.h), the paper's
// way, with strips that split and merge as if drawn by hand.
//
// Guarantees: the pieces partition the shape (curve_cut.h); the result depends on the geometry alone. Without `dual`,
// in iso mode, a piece lies between two neighbouring levels, and thinner slivers than a part of the offset are left
// with their neighbour: at both ends of a strip split, at the rim of circles, and around a summit of outlines.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

enum class StreamlineKind { smooth, strip, circular };

struct StreamlineCutOptions {
    StreamlineKind kind = StreamlineKind::smooth;
    bool by_field = false;
    std::vector<double> offsets{10};  // px, > 0: used in turn, from the border inwards, from the middle of the strips
                                      // to both sides, from the centre; a field takes their mean
    Vec centre;                       // px: of circles; may lie outside or in a hole
    bool dual = false;                // cut by lines across the first ones, too, into fields
    double smoothing = 3;             // of outlines: how far corners are rounded, in offsets; 0 keeps the distance
    double tolerance = 0.1;           // px: of curves
    std::uint64_t limit = 1'000'000;  // of pieces: more is refused
};

struct StreamlineCut {
    Polygons pieces;
    struct Place {
        std::int32_t column = 0;  // the strip: counted inwards, outwards from the centre, or from the middle; in a
                                  // field: how many pieces it is away from the first
        std::int32_t row = 0;     // in a dual cut: how many fields along the strip from its first
        std::uint64_t key = 0;    // of the piece: its strip and which piece of it, or where it lies
    };
    std::vector<Place> places;  // of the pieces
    bool is_too_fine = false;   // there would be more pieces than the limit; no pieces then
};
StreamlineCut cut_by_streamlines(PolygonView shape, const StreamlineCutOptions& options);

}  // namespace filigree
