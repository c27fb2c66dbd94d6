// Where a rule can be applied to a design, and what it then takes away and puts.
//
// The left side matches wherever it can be seen (curves/detect.h). Matches that differ by a symmetry of the left side
// take the same elements away; where the right side, or a condition, breaks that symmetry, one match has several
// *variants*. A rule with `match corners` stands for every polygon with as many corners (curves/faces.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/job.h"
#include "base/result.h"
#include "curves/detect.h"
#include "derivation/shape_source.h"
#include "engines/shape/grammar.h"
#include "engines/shape/seen_design.h"
#include "language/choices.h"
#include "language/preset_walk.h"
#include "language/settings.h"

namespace filigree::shape {

// What an evaluation asks of the document around a grammar.
struct Surroundings {
    const Settings& settings;
    const Document& document;
    const ShapeSource& files;
};

struct Application {
    std::uint32_t rule = 0;
    std::uint32_t match = 0;    // from 0
    std::uint32_t variant = 0;  // of the match, from 0
    curves::Match fit;          // the map, and what of the design the left side covers
    std::vector<Vec> corners;   // of `match corners`: where those of the left side lie; else empty
    // Of a match by looks: what of the design it covers, which no descriptor tells; else empty.
    std::vector<curves::Element> covered;
    Vec place;                  // px: where the middle of the left side lies
    bool is_of_family = false;  // one of infinitely many: a canonical member
};

struct Applications {
    std::vector<Application> all;  // by match, then variant
    std::uint32_t matches = 0;     // how many different ones
    std::vector<curves::Family> families;
    std::uint64_t near_misses = 0;  // embeddings that fail by less than ten tolerances
    bool is_complete = true;        // false where there are more than are looked for
};

Result<Applications> applications_of(const Grammar& grammar, std::uint32_t rule, SeenDesign& design,
                                     const Surroundings& around, const Job& job);

// A shape of a rule's plane as an application places it in the design.
curves::Shape placed(const curves::Shape& shape, const Rule& rule, const Application& at, double tolerance);

// The names that a rule's condition knows besides the document's, with example values.
Scope example_scope(const Settings& settings);

// How broad a rule's left side is where it applies, px. What lies within a hundredth of it is one place to a person.
double breadth_of(const Rule& rule, const Application& at);

// The application that is meant by a place: the nearest, and among those at one place the one with the wanted angle,
// scale and hand. An error that names the nearest where none lies within half the left side's breadth.
Result<Application> application_at(const Grammar& grammar, const Applications& found, const ApplyAt& wanted,
                                   const Surroundings& around);

// With those others of its rule that the symmetries of the design take it to, itself first.
std::vector<Application> orbit_of(const Application& application, const Applications& among, const Grammar& grammar,
                                  const curves::Shape& design);

}  // namespace filigree::shape
