#include "plane/carve.h"

#include <algorithm>
#include <utility>

#include "plane/box_grid.h"
#include "plane/clean.h"

namespace filigree {

namespace {

// Whether an edge of the border comes to the polygon at all: touches, crosses, or lies inside it.
bool meets_border(PolygonView polygon, const EdgeTree& border) {
    constexpr double hair = 0x1p-20;  // px: what comes so near is cut, so that the remainder keeps clean rings
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        const RingView ring = polygon.ring(r);
        for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
            const Edge own{to_px(ring[last]), to_px(ring[i])};
            const bool meets = border.any(around(own, hair), [&](std::uint32_t e) {
                const Edge& edge = border.edges()[e];
                if (is_nearer(edge, own.from, hair * hair) || is_nearer(own, edge.from, hair * hair) ||
                    is_nearer(own, edge.to, hair * hair)) {
                    return true;
                }
                const Vec along = own.to - own.from, across = edge.to - edge.from;
                return (cross(along, edge.from - own.from) > 0) != (cross(along, edge.to - own.from) > 0) &&
                       (cross(across, own.from - edge.from) > 0) != (cross(across, own.to - edge.from) > 0);
            });
            if (meets) return true;
        }
    }
    const Box box = bounds(polygon);
    return border.any({to_px(box.min), to_px(box.max)}, [&](std::uint32_t e) {
        const Point from = snap(border.edges()[e].from);
        return from.x >= box.min.x && from.x <= box.max.x && from.y >= box.min.y && from.y <= box.max.y &&
               locate(polygon, from) > 0;
    });
}

// For pieces cut out of objects: the one each lies in.
class Owners {
public:
    Owners(const Polygons& objects, const std::vector<std::uint32_t>& owners)
        : objects_(objects), owners_(owners), grid_(boxes_of(objects)) {}

    // The object that holds most of the piece's points; a cut moves them by a grid step at most.
    std::uint32_t of(PolygonView piece) {
        std::uint32_t best = 0;
        std::size_t most = 0;
        found_.clear();
        grid_.find(bounds(piece), found_);
        for (const std::uint32_t candidate : found_) {
            std::size_t held = 0;
            for (const Point p : piece.outer()) held += holds(objects_[candidate], p);
            if (held > most || found_.size() == 1) {
                most = held;
                best = owners_[candidate];
            }
        }
        return best;
    }

private:
    // Or a few grid steps beside it, where a crossing was rounded.
    static bool holds(PolygonView object, Point p) {
        for (std::int64_t x = -2; x <= 2; x += 2) {
            for (std::int64_t y = -2; y <= 2; y += 2) {
                if (locate(object, {p.x + x, p.y + y}) >= 0) return true;
            }
        }
        return false;
    }
    static std::vector<Box> boxes_of(const Polygons& polygons) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < polygons.size(); ++i) boxes.push_back(bounds(polygons[i]));
        return boxes;
    }

    const Polygons& objects_;
    const std::vector<std::uint32_t>& owners_;
    BoxGrid grid_;
    std::vector<std::uint32_t> found_;
};

// All rings of the rest around the objects inside it; `outers_before` of them are its own.
void add_remainder(Carving& carving, const Polygons& rest, const Polygons& inside,
                   const std::vector<std::uint32_t>& owners) {
    std::vector<std::vector<Point>> rings;
    rings.reserve(rest.ring_ends.size() + inside.ring_ends.size());
    for (std::size_t i = 0; i < rest.size(); ++i) {
        for (std::size_t r = 0; r < rest[i].ring_count(); ++r) {
            rings.emplace_back(rest[i].ring(r).begin(), rest[i].ring(r).end());
        }
        carving.enclosing.push_back(Carving::none);
    }
    bool has_holes = false;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        for (std::size_t r = 0; r < inside[i].ring_count(); ++r) {
            const RingView ring = inside[i].ring(r);
            rings.emplace_back(ring.rbegin(), ring.rend());
            if (r > 0) carving.enclosing.push_back(owners[i]);
            has_holes = has_holes || r > 0;
        }
    }
    if (rest.size() != 1 || has_holes) {
        carving.remainder = nest_rings(rings);
        return;
    }
    carving.remainder.points.reserve(rest.points.size() + inside.points.size());
    for (const std::vector<Point>& ring : rings) carving.remainder.add_ring(ring);
    carving.remainder.end_polygon();
}

}  // namespace

Carving carve(PolygonView region, const EdgeTree& border, const Polygons& objects,
              const std::vector<std::uint32_t>& owners, bool may_cross) {
    Carving carving;
    Polygons rest;
    rest.add(region);
    Polygons crossing, inside;
    std::vector<std::uint32_t> of_crossing, of_inside;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const bool crosses = may_cross && meets_border(objects[i], border);
        if (may_cross && !crosses && !border.is_inside(to_px(objects[i].outer()[0]))) continue;
        (crosses ? crossing : inside).add(objects[i]);
        (crosses ? of_crossing : of_inside).push_back(owners[i]);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cut_out;  // the object, the piece
    Polygons pieces;
    if (!crossing.empty()) {
        pieces = intersect(rest, crossing);
        rest = subtract(rest, crossing);
        Owners finder(crossing, of_crossing);
        for (std::uint32_t i = 0; i < pieces.size(); ++i) cut_out.emplace_back(finder.of(pieces[i]), i);
        std::sort(cut_out.begin(), cut_out.end());
    }
    auto next = cut_out.begin();
    const auto add_cut_out = [&](std::uint32_t before) {
        for (; next != cut_out.end() && next->first < before; ++next) {
            carving.placed.add(pieces[next->second]);
            carving.owners.push_back(next->first);
        }
    };
    for (std::size_t i = 0; i < inside.size(); ++i) {
        add_cut_out(of_inside[i]);
        carving.placed.add(inside[i]);
        carving.owners.push_back(of_inside[i]);
    }
    add_cut_out(UINT32_MAX);
    add_remainder(carving, rest, inside, of_inside);
    return carving;
}

}  // namespace filigree
