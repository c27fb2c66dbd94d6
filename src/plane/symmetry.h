// A symmetry group at its place in the plane: where the copies of a motif lie.
//
// Guarantees: copies that differ by whole tiles differ by exactly that, on the grid. The corners of the domain go to
// where they belong, so copies of it cover a tile without a gap. A point on a mirror, or rounded to the grid beside
// one, has one image in all copies that meet there, so what touches a mirror meets its reflection.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"
#include "plane/transform.h"
#include "plane/wallpaper.h"

namespace filigree {

// One of the group's operations, and then so many whole tiles to the right and down.
struct Copy {
    std::uint32_t operation = 0;  // 0 is the identity
    std::int64_t column = 0, row = 0;

    bool operator==(const Copy&) const = default;
};

class Symmetry {
public:
    // A wallpaper group over its tile (fit_tile); a rosette alone, or repeated by a tile as it stands.
    explicit Symmetry(SymmetryGroup group, Point tile = {});

    const SymmetryGroup& group() const { return group_; }
    Point tile() const { return tile_; }  // grid units; (0, 0) where nothing is repeated
    bool has_tile() const { return tile_ != Point{}; }
    std::uint32_t operation_count() const { return static_cast<std::uint32_t>(maps_.size()); }
    bool reflects(std::uint32_t operation) const { return determinant(maps_[operation]) < 0; }
    Transform transform(const Copy& copy) const;  // px
    Copy composed(const Copy& outer, const Copy& inner) const;

    // All copies of a point of which it is one itself, as far as mirrors show it; none but the identity, which is not
    // among them, off all mirrors.
    std::vector<Copy> copies_here(Point p) const;
    // Where an operation puts a point for which these were found. Points must lie within 2^26 px for the guarantees.
    Point image(std::uint32_t operation, Point p, const std::vector<Copy>& here) const;
    Point image(std::uint32_t operation, Point p) const;  // off all mirrors

private:
    Copy composed_turns(const Copy& outer, const Copy& inner) const;

    SymmetryGroup group_;
    Point tile_;
    std::vector<Transform> maps_;  // grid units
    std::vector<std::uint32_t> reflections_;
};

// A region whose copies cover the tile once, or the disc of the radius about a rosette; its rim stays within
// `tolerance` px of the circle.
Polygons domain_of(const Symmetry& symmetry, double radius, double tolerance);

// The images of polygons under a group's operations.
class SymmetryImages {
public:
    // Symmetry and motif must outlive the images. `is_line` says of each polygon whether it is an open line, of one
    // ring; where it is empty none is.
    SymmetryImages(const Symmetry& symmetry, const Polygons& motif, std::vector<bool> is_line = {});

    // Polygon by polygon; one that collapses or leaves the plane is there without rings.
    Polygons under(std::uint32_t operation) const;

private:
    struct AtMirror {
        std::size_t point;  // index into the motif's points
        std::vector<Copy> here;
    };

    const Symmetry& symmetry_;
    const Polygons& motif_;
    const std::vector<bool> is_line_;
    std::vector<AtMirror> at_mirrors_;
};

}  // namespace filigree
