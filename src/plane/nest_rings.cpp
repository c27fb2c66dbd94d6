// nest_rings by a sweep: the chain just below a ring's first point tells which ring holds it.
#include <algorithm>
#include <set>

#include "plane/polygon.h"
#include "plane/ring_sweep.h"

namespace filigree {

namespace {

using sweep::Chain;

constexpr std::uint32_t none = UINT32_MAX;

struct Nesting {
    std::vector<Int128> doubled_areas;
    std::vector<Chain> chains;
    Point at;  // where the sweep is

    // Whether the ring's inside lies above this chain.
    bool opens(const Chain& chain) const { return (doubled_areas[chain.ring_index] > 0) == chain.along; }

    // Rings that share an edge: from below come those that end there, inner ones first, then those that begin
    // there, outer ones first; a hole is outside the ring that fills it.
    bool shares_below(const Chain& a, const Chain& b) const {
        const bool a_opens = opens(a);
        if (a_opens != opens(b)) return !a_opens;
        const Int128 a_area = doubled_areas[a.ring_index];
        const Int128 b_area = doubled_areas[b.ring_index];
        const Int128 a_size = a_area < 0 ? -a_area : a_area;
        const Int128 b_size = b_area < 0 ? -b_area : b_area;
        if (a_size != b_size) return (a_size > b_size) == a_opens;
        if ((a_area < 0) != (b_area < 0)) return (a_area < 0) == a_opens;
        if (a.ring_index != b.ring_index) return (a.ring_index < b.ring_index) == a_opens;
        return false;
    }
    bool below(std::uint32_t a_index, std::uint32_t b_index) {
        if (a_index == b_index) return false;
        Chain& a = chains[a_index];
        Chain& b = chains[b_index];
        sweep::advance(a, at);
        sweep::advance(b, at);
        const int side = sweep::compare(a.edge(), b.edge());
        if (side != 0) return side < 0;
        if (shares_below(a, b)) return true;
        if (shares_below(b, a)) return false;
        return a_index < b_index;
    }
};

struct Below {
    Nesting* nesting;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return nesting->below(a, b); }
};
using Status = std::set<std::uint32_t, Below>;

// For every ring the smallest positive ring that holds it, or none.
std::vector<std::uint32_t> find_holders(Nesting& nesting, std::size_t ring_count) {
    std::vector<Chain>& chains = nesting.chains;
    const auto chain_count = static_cast<std::uint32_t>(chains.size());
    std::vector<std::uint32_t> by_start(chain_count), by_end(chain_count);
    for (std::uint32_t i = 0; i < chain_count; ++i) by_start[i] = by_end[i] = i;
    std::vector<Point> starts(chain_count);  // the chains themselves move on
    for (std::uint32_t i = 0; i < chain_count; ++i) starts[i] = chains[i].low();
    std::sort(by_start.begin(), by_start.end(),
              [&](std::uint32_t a, std::uint32_t b) { return starts[a] != starts[b] ? starts[a] < starts[b] : a < b; });
    std::sort(by_end.begin(), by_end.end(), [&](std::uint32_t a, std::uint32_t b) {
        return chains[a].end() != chains[b].end() ? chains[a].end() < chains[b].end() : a < b;
    });

    std::vector<std::uint32_t> holders(ring_count, none);
    std::vector<bool> met(ring_count, false);
    Status status(Below{&nesting});
    std::vector<Status::iterator> places(chain_count, status.end());
    std::vector<std::uint32_t> newcomers;
    for (std::uint32_t next = 0, ended = 0; next < chain_count;) {
        nesting.at = starts[by_start[next]];
        for (; ended < chain_count && chains[by_end[ended]].end() <= nesting.at; ++ended) {
            status.erase(places[by_end[ended]]);
        }
        newcomers.clear();
        for (; next < chain_count && starts[by_start[next]] == nesting.at; ++next) {
            const std::uint32_t chain = by_start[next];
            places[chain] = status.insert(chain).first;
            if (!met[chains[chain].ring_index]) newcomers.push_back(chain);
        }
        // From below, so that what holds a ring has been placed before it.
        std::sort(newcomers.begin(), newcomers.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return nesting.below(a, b); });
        for (const std::uint32_t chain : newcomers) {
            const std::uint32_t ring = chains[chain].ring_index;
            if (met[ring]) continue;
            met[ring] = true;
            if (places[chain] == status.begin()) continue;
            const Chain& below = chains[*std::prev(places[chain])];
            const bool holds = nesting.opens(below) && nesting.doubled_areas[below.ring_index] > 0;
            holders[ring] = holds ? below.ring_index : holders[below.ring_index];
        }
    }
    return holders;
}

}  // namespace

Polygons nest_rings(const std::vector<std::vector<Point>>& rings) {
    Nesting nesting;
    nesting.doubled_areas.reserve(rings.size());
    std::vector<std::uint32_t> outers, holes;
    for (std::uint32_t i = 0; i < rings.size(); ++i) {
        const Int128 doubled = doubled_area(rings[i]);
        nesting.doubled_areas.push_back(doubled);
        if (doubled == 0) continue;
        (doubled > 0 ? outers : holes).push_back(i);
        sweep::append_chains(nesting.chains, rings[i], i);
    }
    std::vector<std::vector<std::uint32_t>> holes_of(rings.size());
    if (!holes.empty()) {
        const std::vector<std::uint32_t> holders = find_holders(nesting, rings.size());
        for (const std::uint32_t hole : holes) {
            if (holders[hole] != none) holes_of[holders[hole]].push_back(hole);
        }
    }
    Polygons polygons;
    for (const std::uint32_t outer : outers) {
        polygons.add_ring(rings[outer]);
        for (const std::uint32_t hole : holes_of[outer]) polygons.add_ring(rings[hole]);
        polygons.end_polygon();
    }
    return polygons;
}

}  // namespace filigree
