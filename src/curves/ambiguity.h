// Decisions that fell within ten tolerances of the limit: another tolerance, or a little noise, would decide otherwise.
// They are told, never passed over in silence.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/point.h"

namespace filigree::curves {

// What was not enough, or too much, by a factor of less than ten.
enum class Doubt : std::uint8_t {
    descriptor,  // elements that lie together are taken for parts of different curves
    gap,         // parts of one curve that nearly touch stay apart
    rest,        // a short rest of an element stays
    overlap,     // a short stretch that two elements have in common counts
    flatness,    // a nearly straight curve stays a curve
    place,       // equal labels that lie close together stay two
};

struct Ambiguity {
    Doubt what = Doubt::gap;
    Vec where;
    double tolerances = 0;  // how much it was, in tolerances: above 1, at most 10

    bool operator==(const Ambiguity&) const = default;
};

struct Ambiguities {
    std::vector<Ambiguity> found;
};

inline constexpr double doubtful = 10;  // tolerances

// Notes a decision where it was a near one and somebody asks.
inline void note(Ambiguities* ambiguities, Doubt what, Vec where, double size, double tolerance) {
    if (ambiguities == nullptr || !(size > tolerance) || !(size <= doubtful * tolerance)) return;
    ambiguities->found.push_back({what, where, size / tolerance});
}

}  // namespace filigree::curves
