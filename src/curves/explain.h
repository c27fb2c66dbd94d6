// Why an embedding that was expected is none: where the left side comes nearest to lying on the design, and what each
// of its elements lacks there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curves/match.h"
#include "curves/match_index.h"
#include "curves/shape.h"

namespace filigree::curves {

enum class Lack : std::uint8_t {
    none,             // it lies on its carrier
    ends_early,       // it lies along its carrier, which is too short
    off,              // the nearest curve has another descriptor
    other_layer,      // the carrier has another colour, the point another label
    too_light,        // the carrier has too little weight
    too_heavy,        // where weights must be equal
    nothing_here,     // nothing of its kind is near
    nothing_of_kind,  // the whole design has nothing of its kind
};

// What one element of the left side lacks.
struct Finding {
    Lack lack = Lack::none;
    ElementKind kind = ElementKind::line;
    std::optional<std::uint32_t> carrier;  // the slot of the design that comes nearest
    Vec at;                 // ends_early: where the carrier ends; else the middle of the element, carried
    double share = 0;       // ends_early: how much of the element's length sticks out there
    double tolerances = 0;  // off: how far it lies off the carrier

    bool operator==(const Finding&) const = default;
};

struct Explanation {
    Transform by;  // the embedding that comes nearest; the identity where no two elements are of one kind
    double scale = 1, angle_degrees = 0;
    Vec centroid;
    std::vector<Finding> findings;  // of each left element
    std::size_t fitting = 0;        // how many of them lack nothing
    bool is_scale_outside = false;  // the group or the options do not allow the scale
    bool is_turn_outside = false;   // translation: it would have to be turned
    bool needs_reflection = false;  // although reflections are not allowed
    bool is_complete = true;        // false where not all candidates were tried, or the job was cancelled

    bool is_match() const {
        return fitting == findings.size() && !is_scale_outside && !is_turn_outside && !needs_reflection;
    }
    bool operator==(const Explanation&) const = default;
};

// The embedding with the fewest faults: elements that lack something, and ways in which it leaves the group; among
// those the one that lacks least. Where a place is given, those come first that cover it, and among those with equally
// many faults the one whose centroid is nearest to it. The work is bounded; in large designs it looks at a part of what
// could be meant, by a place at what is near it.
Explanation explain(const Shape& left, const MatchIndex& design, const MatchOptions& options,
                    std::optional<Vec> near = std::nullopt);

// One sentence for each thing that is missing, elements numbered from 1: "element 3 (arc): its curve ends 0.4 % too
// early, at (12, 4)". Places in a unit of so many px.
std::vector<std::string> text_of(const Explanation& explanation, double px_per_unit = 1);

}  // namespace filigree::curves
