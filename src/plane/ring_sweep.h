// Edges and monotone chains of rings along a sweep; inner part of nest_rings, the check for crossings and clean.
//
// The sweep visits points in the order of Point (by x, then by y), so an upright edge is like any other. A
// chain is a maximal run of edges that all go forward in that order; a ring has as many chains as turning
// points. Chains that the sweep line meets are ordered by y just after the sweep's point, and as long as no
// two cross that order never changes: one tree operation a chain, not one an edge. All predicates are exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/polygon.h"

namespace filigree::sweep {

struct Segment {  // low before high in the sweep's order
    Point low, high;

    auto operator<=>(const Segment&) const = default;
};

// Whether a lies below (-1) or above (+1) b just after the later of their first points; 0 where they overlap.
// The sweep line must meet both.
inline int compare(const Segment& a, const Segment& b) {
    if (a.low >= b.low) {
        const int side = orientation(b.low, b.high, a.low);
        return side != 0 ? side : orientation(b.low, b.high, a.high);
    }
    const int side = orientation(a.low, a.high, b.low);
    return side != 0 ? -side : -orientation(a.low, a.high, b.high);
}

struct Chain {
    RingView ring;
    std::uint32_t ring_index = 0;
    std::uint32_t at = 0;             // index of the current edge's first point
    std::uint32_t last = 0;           // index of the chain's last point
    bool along = true;                // whether the chain runs in the ring's direction
    std::uint32_t start_partner = 0;  // the chain that the ring continues with at the first point
    std::uint32_t end_partner = 0;    // ... and at the last point

    std::uint32_t next_index() const {
        const auto count = static_cast<std::uint32_t>(ring.size());
        if (along) return at + 1 == count ? 0 : at + 1;
        return at == 0 ? count - 1 : at - 1;
    }
    Point low() const { return ring[at]; }
    Point high() const { return ring[next_index()]; }
    Segment edge() const { return {low(), high()}; }
    Point end() const { return ring[last]; }
};

// Moves to the edge that lies just after `p`; `p` must be before the chain's end.
inline void advance(Chain& chain, Point p) {
    for (std::uint32_t next = chain.next_index(); chain.ring[next] <= p; next = chain.next_index()) chain.at = next;
}

// The chains of a ring of at least two different points.
inline void append_chains(std::vector<Chain>& chains, RingView ring, std::uint32_t ring_index) {
    const auto count = static_cast<std::uint32_t>(ring.size());
    std::uint32_t lowest = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
        if (ring[i] < ring[lowest]) lowest = i;
    }
    const auto first_chain = static_cast<std::uint32_t>(chains.size());
    bool forward = true;  // from the lowest point there is no other way
    std::uint32_t start = lowest;
    std::uint32_t here = lowest;
    const auto close_run = [&](std::uint32_t stop) {
        chains.push_back({ring, ring_index, forward ? start : stop, forward ? stop : start, forward, 0, 0});
    };
    for (std::uint32_t step = 0; step < count; ++step) {
        const std::uint32_t next = here + 1 == count ? 0 : here + 1;
        if (ring[here] != ring[next] && (ring[here] < ring[next]) != forward) {
            close_run(here);
            start = here;
            forward = !forward;
        }
        here = next;
    }
    close_run(lowest);
    const auto added = static_cast<std::uint32_t>(chains.size()) - first_chain;
    for (std::uint32_t i = 0; i < added; ++i) {
        const std::uint32_t before = first_chain + (i + added - 1) % added;
        const std::uint32_t after = first_chain + (i + 1) % added;
        Chain& chain = chains[first_chain + i];
        chain.start_partner = chain.along ? before : after;
        chain.end_partner = chain.along ? after : before;
        advance(chain, chain.low());
    }
}

}  // namespace filigree::sweep
