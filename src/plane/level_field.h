// A level family made ready for one shape: where points stand along the curves and among the levels.
//
// The field is phi(p) = v - profile(u); the curve of level L is where phi = L. All that is computed here is a
// pure function of the family and of one point or one edge (its ends in lexicographic order), never of the
// shape, so shapes that share an edge get the same crossings on it, to the bit. Distances are taken from the
// frame's origin in exact integers first: doubles then carry a shape of 2^20 px anywhere to 2^-31 px.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "plane/level_cut.h"

namespace filigree {

constexpr double level_tolerance = 0x1p-20;  // px; nearer than this is on the level

// Where phi stands among the levels at hand: 2 s inside strip s, 2 k + 1 exactly on level k, which
// separates strips k and k + 1. Monotone in phi.
using LevelCode = std::int32_t;

// The nearest whole number, halves to even, for |x| < 2^62: the same by both ways.
inline std::int64_t round_to_grid(double x) {
    if (x > -0x1p51 && x < 0x1p51) {  // the sum's last bit is worth 1, so the addition rounds
        constexpr double shift = 0x1.8p52;
        return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x + shift) - std::bit_cast<std::uint64_t>(shift));
    }
    return static_cast<std::int64_t>(std::nearbyint(x));
}

// A breakpoint of the profile.
struct FieldNode {
    double u = 0;      // px
    double value = 0;  // px
    double slope = 0;  // up to the next node
};

// Kept from cut to cut for its memory: `aim`, then `cover`, then `choose_levels` make it ready.
struct LevelField {
    Point origin;       // the frame's, on the grid
    Vec rest;           // px from there to the frame's origin itself
    Vec along, across;  // unit vectors of u and v
    double step = 1;    // px between nodes
    double inverse_step = 1;
    std::int64_t first_node = 0;   // nodes[i].u = (first_node + i) step
    std::vector<FieldNode> nodes;  // over the shape; none for straight lines
    std::vector<Vec> node_points;  // of the curve at level 0, in grid units from `origin`
    double node_reach = 0;         // the greatest coordinate of them
    std::vector<double> levels;    // those that may meet the shape, between -infinity and +infinity
    bool may_flip = false;         // levels so close, or curves so steep, that rounding could turn a face over
    std::vector<std::int64_t> strip_numbers;  // of the family, for the strips between them: indices of levels

    // Without nodes and levels yet. False, and the frame of the plane, for what is no family: a frame that is
    // not finite or not on the plane, a direction of no length, a step below 2^-16 px.
    bool aim(const Frame& frame, const Profile& profile);
    // Makes the nodes for a range of u and one beyond on either side. False, and none, above 2^22 of them
    // or where samples are not finite or beyond 2^32 px.
    bool cover(const Profile& profile, double u_low, double u_high);
    // Takes the levels that shapes within the range of v may meet, without those within the tolerance of the
    // one below them. False, and none, where they do not increase strictly.
    bool choose_levels(std::span<const double> family_levels, double v_low, double v_high);
    // No nodes and no levels: all is one strip.
    void cut_nothing();

    std::int32_t level_count() const { return static_cast<std::int32_t>(levels.size()) - 2; }
    double level(std::int32_t k) const { return levels[static_cast<std::size_t>(k) + 1]; }

    Vec coordinates(Point p) const {  // (u, v) in px
        const Vec d =
            Vec{static_cast<double>(p.x - origin.x) / grid_per_px, static_cast<double>(p.y - origin.y) / grid_per_px} -
            rest;
        return {dot(d, along), dot(d, across)};
    }
    // The index of the last node at or before u, for u that the nodes cover.
    std::size_t node_before(double u) const {
        const double q = u * inverse_step;
        std::int64_t k = static_cast<std::int64_t>(q);
        k -= static_cast<double>(k) > q ? 1 : 0;
        k -= first_node;
        const auto last = static_cast<std::int64_t>(nodes.size()) - 2;
        return static_cast<std::size_t>(k < 0 ? 0 : k > last ? last : k);
    }
    double profile(double u, std::size_t node) const {
        return nodes[node].value + (u - nodes[node].u) * nodes[node].slope;
    }
    double profile(double u) const { return nodes.empty() ? 0 : profile(u, node_before(u)); }
    // The points of a level's curve at the nodes from `begin` to `end`.
    void curve_points(std::int32_t k, std::size_t begin, std::size_t end, Point* out) const;

    // The code of a value. `strip` is a guess (the last answer) and becomes the answer; the cost is the number
    // of levels between the two.
    LevelCode place(double phi, std::int32_t& strip) const {
        const double* at = levels.data() + strip;  // strip s lies between levels[s] and levels[s + 1]
        while (at[1] <= phi) ++at;
        while (at[0] > phi) --at;
        strip = static_cast<std::int32_t>(at - levels.data());
        const double above_lower = phi - at[0], below_upper = at[1] - phi;
        if (above_lower > level_tolerance && below_upper > level_tolerance) return 2 * strip;
        return above_lower <= below_upper ? 2 * strip - 1 : 2 * strip + 1;
    }
    // The strip of a value by bisection: a guess for `place`.
    std::int32_t find_strip(double phi) const;
};

// What a sample of an edge is: a breakpoint of the profile between its ends, or an end.
struct FieldSample {
    double u = 0;         // px
    double fraction = 0;  // of the edge, from its lexicographically lesser end
    double phi = 0;       // px
    LevelCode code = 0;
};

// The indices of the nodes strictly between two values of u, more than the tolerance from both.
struct NodeRange {
    std::size_t begin = 0, end = 0;
};
NodeRange nodes_between(const LevelField& field, double u_low, double u_high);

}  // namespace filigree
