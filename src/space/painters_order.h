// Painter's order in space: convex polygons and stretches of lines so ordered, and where needed so cut, that each may
// be painted over those before it (Fuchs, Kedem and Naylor 1980).
//
// The space is halved by planes until what is left lies in one: what is on the viewer's side of a plane is painted
// after what lies in it, and that after the rest. Planes are those of pieces, for lines the plane through each that
// faces the viewer most, and now and then one across an axis, so that many pieces that cut none of the others (a
// ball) take no square of their number. Which plane goes next is chosen from a few by how many of a sample of pieces it
// cuts and how evenly it parts them; nothing is random. For one viewer the tree need not be kept: it is walked as it
// grows, on a stack of our own.
//
// What lies within 2^-30 of the extent of a plane lies in it, and all that lies in one plane is painted in the order
// given.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/job.h"
#include "base/limits.h"
#include "base/result.h"
#include "space/vector.h"

namespace filigree {

constexpr std::uint32_t no_edge = UINT32_MAX;
constexpr std::uint32_t no_piece = UINT32_MAX;

struct PieceCorner {
    Vec3 at;
    std::uint32_t edge = no_edge;  // which edge of the source goes on from here; none where it was cut, as a line's end
};

struct Piece {
    std::uint32_t first = 0, count = 0;  // of Pieces::corners
    std::uint32_t source = 0;            // what it is a piece of; whatever numbers the caller has
    std::uint32_t plane = 0;             // of Pieces::planes
    std::uint32_t parent = no_piece;     // that was cut into this and others
    bool is_line = false;
};

struct Plane3 {
    Vec3 normal;        // of unit length
    double offset = 0;  // of points in it: dot(normal, p)
};

struct Pieces {
    std::vector<PieceCorner> corners;
    std::vector<Piece> pieces;  // a parent stands before its parts
    std::vector<Plane3> planes;
};

inline std::span<const PieceCorner> corners_of(const Pieces& pieces, std::uint32_t piece) {
    return {pieces.corners.data() + pieces.pieces[piece].first, pieces.pieces[piece].count};
}

// Whoever looks on: from far away, or from a place.
struct Viewer {
    Vec3 towards{0, 0, 1};  // from the scene to one who is far away
    std::optional<Vec3> eye = {};
};
// Above 0 on the plane's front side, below 0 behind it; 0 where it is seen as a line.
double side_of(const Viewer& viewer, const Plane3& plane);
// Through a stretch of a line.
Plane3 plane_facing(const Viewer& viewer, Vec3 from, Vec3 to);

// The pieces on either side of a plane; a piece that crosses it is cut into two new ones, which join `pieces`. Those of
// the plane number `own` lie in it, however well that fits them.
struct PlaneSides {
    std::vector<std::uint32_t> behind, in_plane, before;
};
void part(Pieces& pieces, std::span<const std::uint32_t> which, const Plane3& plane, double tolerance,
          PlaneSides& sides, std::uint32_t own = UINT32_MAX);

// Those of `which` that are not cut, and the parts of the others, the farthest first. More than `most_pieces` in all
// are `limit.elements`.
Result<std::vector<std::uint32_t>> painters_order(Pieces& pieces, std::span<const std::uint32_t> which,
                                                  const Viewer& viewer, std::uint64_t most_pieces = Limits{}.elements,
                                                  const Job& job = {});

}  // namespace filigree
