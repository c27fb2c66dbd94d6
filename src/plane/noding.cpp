#include "plane/noding.h"

#include <algorithm>
#include <cmath>

#include "plane/edge_pairs.h"

namespace filigree {

namespace {

using sweep::Segment;

// After so many rounds the grid is doubled every round, so that the rounds end. Two to four are usual.
constexpr int rounds_on_the_fine_grid = 16;

struct Cut {
    std::uint32_t edge = 0;
    Point at;
};

Box box_of(const Segment& s) {
    return {{s.low.x, std::min(s.low.y, s.high.y)}, {s.high.x, std::max(s.low.y, s.high.y)}};
}
Box united(const Box& a, const Box& b) {
    Box box = a;
    extend(box, b.min);
    extend(box, b.max);
    return box;
}

std::int64_t extent(const Segment& s) { return std::max(s.high.x - s.low.x, std::abs(s.high.y - s.low.y)); }

// Where two segments cross, rounded to the grid. Measured along the shorter and from its nearer end, where
// doubles are finest.
Point crossing(Segment e, Segment f) {
    if (extent(e) != extent(f) ? extent(f) < extent(e) : f < e) std::swap(e, f);
    const Int128 low = cross(f.low, f.high, e.low);
    const Int128 high = cross(f.low, f.high, e.high);
    const double from_low = static_cast<double>(low) / static_cast<double>(low - high);
    const double from_high = static_cast<double>(high) / static_cast<double>(high - low);
    const Point from = from_low <= 0.5 ? e.low : e.high;
    const Point to = from_low <= 0.5 ? e.high : e.low;
    const double part = from_low <= 0.5 ? from_low : from_high;
    const Point at{from.x + std::llround(part * static_cast<double>(to.x - from.x)),
                   from.y + std::llround(part * static_cast<double>(to.y - from.y))};
    const Box a = box_of(e), b = box_of(f);
    return {std::clamp(at.x, std::max(a.min.x, b.min.x), std::min(a.max.x, b.max.x)),
            std::clamp(at.y, std::max(a.min.y, b.min.y), std::min(a.max.y, b.max.y))};
}

void find_cuts(std::vector<Cut>& cuts, const std::vector<WeightedEdge>& edges, std::uint32_t i, std::uint32_t j) {
    const Segment& e = edges[i].at;
    const Segment& f = edges[j].at;
    const int e_low = orientation(f.low, f.high, e.low), e_high = orientation(f.low, f.high, e.high);
    if (e_low * e_high > 0) return;
    const int f_low = orientation(e.low, e.high, f.low), f_high = orientation(e.low, e.high, f.high);
    if (f_low * f_high > 0) return;
    const auto cut = [&](std::uint32_t edge, const Segment& s, Point at) {
        if (at != s.low && at != s.high) cuts.push_back({edge, at});
    };
    if (e_low * e_high < 0 && f_low * f_high < 0) {
        const Point at = crossing(e, f);
        cut(i, e, at);
        cut(j, f, at);
        return;
    }
    if (e_low == 0 && f.low < e.low && e.low < f.high) cuts.push_back({j, e.low});
    if (e_high == 0 && f.low < e.high && e.high < f.high) cuts.push_back({j, e.high});
    if (f_low == 0 && e.low < f.low && f.low < e.high) cuts.push_back({i, f.low});
    if (f_high == 0 && e.low < f.high && f.high < e.high) cuts.push_back({i, f.high});
}

std::vector<Cut> all_cuts(const std::vector<WeightedEdge>& edges) {
    EdgePairs pairs;
    for (const WeightedEdge& edge : edges) pairs.add(edge.at.low, edge.at.high);
    std::vector<Cut> cuts;
    pairs.for_each([&](std::uint32_t i, std::uint32_t j) { find_cuts(cuts, edges, i, j); });
    return cuts;
}

void append_edge(std::vector<WeightedEdge>& edges, Point from, Point to, Winding weight) {
    if (from < to) edges.push_back({{from, to}, weight});
    if (to < from) edges.push_back({{to, from}, -weight});
}

// Cuts sorted along their edges: rounded points keep the order of x and of y that the edge has.
void sort_cuts(std::vector<Cut>& cuts, const std::vector<WeightedEdge>& edges) {
    std::sort(cuts.begin(), cuts.end(), [&](const Cut& a, const Cut& b) {
        if (a.edge != b.edge) return a.edge < b.edge;
        if (a.at.x != b.at.x) return a.at.x < b.at.x;
        const Segment& s = edges[a.edge].at;
        return s.low.y <= s.high.y ? a.at.y < b.at.y : a.at.y > b.at.y;
    });
}

std::vector<WeightedEdge> cut_edges(const std::vector<WeightedEdge>& edges, const std::vector<Cut>& cuts) {
    std::vector<WeightedEdge> pieces;
    pieces.reserve(edges.size() + cuts.size());
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        Point from = edges[i].at.low;
        for (; next < cuts.size() && cuts[next].edge == i; ++next) {
            append_edge(pieces, from, cuts[next].at, edges[i].weight);
            from = cuts[next].at;
        }
        append_edge(pieces, from, edges[i].at.high, edges[i].weight);
    }
    return pieces;
}

// Along a Z-order curve of their middles. Pieces of edges that cross far and wide are no longer near each other
// in the order of their rings.
void sort_by_place(std::vector<WeightedEdge>& edges) {
    const auto spread = [](std::uint64_t bits) {  // abc -> 0a0b0c
        bits = (bits | (bits << 16)) & 0x0000FFFF0000FFFFU;
        bits = (bits | (bits << 8)) & 0x00FF00FF00FF00FFU;
        bits = (bits | (bits << 4)) & 0x0F0F0F0F0F0F0F0FU;
        bits = (bits | (bits << 2)) & 0x3333333333333333U;
        return (bits | (bits << 1)) & 0x5555555555555555U;
    };
    Box all;
    for (const WeightedEdge& edge : edges) all = united(all, box_of(edge.at));
    int shift = 0;
    while (std::max(all.max.x - all.min.x, all.max.y - all.min.y) >> shift > INT32_MAX) ++shift;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const Segment& s = edges[i].at;
        const std::int64_t x = (s.low.x - all.min.x) / 2 + (s.high.x - all.min.x) / 2;
        const std::int64_t y = (s.low.y - all.min.y) / 2 + (s.high.y - all.min.y) / 2;
        order[i] = {
            spread(static_cast<std::uint64_t>(x >> shift)) | spread(static_cast<std::uint64_t>(y >> shift)) << 1, i};
    }
    std::sort(order.begin(), order.end());
    std::vector<WeightedEdge> sorted;
    sorted.reserve(edges.size());
    for (const auto& [key, edge] : order) sorted.push_back(edges[edge]);
    edges = std::move(sorted);
}

std::vector<WeightedEdge> coarsened(const std::vector<WeightedEdge>& edges, int bits) {
    const std::int64_t unit = std::int64_t{1} << bits;
    const auto round = [&](Point p) { return Point{(p.x + unit / 2) & -unit, (p.y + unit / 2) & -unit}; };
    std::vector<WeightedEdge> coarse;
    for (const WeightedEdge& edge : edges) append_edge(coarse, round(edge.at.low), round(edge.at.high), edge.weight);
    return coarse;
}

// Edges that are equal become one with the sum of their weights, in the place of the first of them.
void merge_equal_edges(std::vector<WeightedEdge>& edges, bool parity) {
    struct Place {
        Segment at;
        std::uint32_t edge = 0;

        auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) places[i] = {edges[i].at, i};
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1, first = 0; i < places.size(); ++i) {
        if (places[i].at != places[first].at) {
            first = i;
            continue;
        }
        Winding& sum = edges[places[first].edge].weight;
        sum = sum + edges[places[i].edge].weight;
        edges[places[i].edge].weight = {};
    }
    if (parity) {
        for (WeightedEdge& edge : edges) edge.weight = {edge.weight.first & 1, edge.weight.second & 1};
    }
    std::erase_if(edges, [](const WeightedEdge& edge) { return edge.weight == Winding{}; });
}

}  // namespace

void append_edges(std::vector<WeightedEdge>& edges, RingView ring, Winding weight) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        append_edge(edges, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], weight);
    }
}

void node_edges(std::vector<WeightedEdge>& edges, bool parity) {
    for (int round = 1;; ++round) {
        merge_equal_edges(edges, parity);
        std::vector<Cut> cuts = all_cuts(edges);
        if (cuts.empty()) return;
        sort_cuts(cuts, edges);
        edges = cut_edges(edges, cuts);
        sort_by_place(edges);
        if (round > rounds_on_the_fine_grid) edges = coarsened(edges, std::min(round - rounds_on_the_fine_grid, 56));
    }
}

}  // namespace filigree
