// The algebra of shapes: sum, difference, product, part, equality; and what applying a rule makes of a design.
//
// A shape gives a weight to every position on every descriptor, 0 where it has nothing. The sum is the greater of two
// weights, the product the lesser, the difference the first one's where it is the greater, else nothing. So sum and
// product are a lattice; (a - b) + b = a where b is part of a; and (a - b) & b is empty where both have one weight.
// All shapes given are maximal, and all results are; elements keep their kind. What is shorter than the tolerance is
// dropped, and stretches of two elements that overlap by less count as touching. Paper: sections 2.2 and 3.2.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curves/ambiguity.h"
#include "curves/maximal.h"
#include "curves/shape.h"
#include "plane/transform.h"

namespace filigree::curves {

Shape sum(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);
Shape difference(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);
Shape product(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);
// Whether all of a lies on b, which is nowhere lighter there.
bool is_part_of(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);
bool are_equal(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);

// A shape without all that lies along another, whatever their weights: what is left when a rule takes that away.
Shape erased(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities = nullptr);

// Each element carried; of a map that keeps shapes maximal (a similarity, or one that flattens nothing).
Shape transformed(const Shape& shape, const Transform& by);

// With every end that comes within the tolerance of one of the places moved there; along its curve alone where the
// place does not lie on the curve. So errors do not add up when rules put things end to end again and again.
Shape snapped(const Shape& shape, std::span<const Vec> places, double tolerance);

// What a rule changes in a design: `taken` is erased, then `put` is added, its ends and the new ones snapped to the
// design's. Only what lies near these is looked at: by a scan over the design, or among the elements that are named by
// who keeps an index (their indices, ascending: at least all with a box within two tolerances of one of what is taken
// or put; more do no harm). Elements that stay as they are, to the last bit, are in neither list.
struct Change {
    std::vector<Element> removed, added;  // sorted by comes_before

    bool operator==(const Change&) const = default;
};
Change change_by(const Shape& design, const Shape& taken, const Shape& put, double tolerance,
                 Ambiguities* ambiguities = nullptr);
Change change_by(const Shape& design, std::span<const std::uint32_t> near, const Shape& taken, const Shape& put,
                 double tolerance, Ambiguities* ambiguities = nullptr);
void apply(const Change& change, Shape& design);
Change inverse(Change change);

// The design behind the change.
Shape replaced(Shape design, const Shape& taken, const Shape& put, double tolerance,
               Ambiguities* ambiguities = nullptr);

}  // namespace filigree::curves
