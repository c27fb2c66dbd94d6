#include "plane/wobble_reach.h"

#include <algorithm>
#include <limits>

namespace filigree {
namespace {

constexpr double steepest = 0.2;  // px a px: how fast reaches may change along a border
constexpr double unbounded = std::numeric_limits<double>::infinity();

bool are_all_equal(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values[0]; });
}

}  // namespace

WobbleReach::WobbleReach(const WobbleNet& net) : net_(net), reaches_(net.wishes) {
    if (are_all_equal(reaches_) && are_all_equal(net_.wavelengths)) return;
    std::vector<std::uint32_t> all(net_.map.edges.size()), changed;
    for (std::uint32_t e = 0; e < all.size(); ++e) all[e] = e;
    spread(std::move(all), changed);
}

void WobbleReach::lower(std::uint32_t vertex, double reach) { reaches_[vertex] = std::min(reaches_[vertex], reach); }

void WobbleReach::spread_from(const std::vector<std::uint32_t>& lowered, std::vector<std::uint32_t>& changed) {
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t v : lowered) {
        if (net_.is_inner(v)) {
            edges.push_back(net_.edge_of_inner(v));
        } else {
            const auto ending = edges_at(v);
            edges.insert(edges.end(), ending.begin(), ending.end());
        }
    }
    changed.insert(changed.end(), lowered.begin(), lowered.end());
    spread(std::move(edges), changed);
}

std::span<const std::uint32_t> WobbleReach::edges_at(std::uint32_t vertex) {
    if (at_vertices_.begins.empty()) at_vertices_ = edges_at_vertices(net_.map);
    return at_vertices_.of(vertex);
}

// The least reaches are the same in whatever order they are found.
void WobbleReach::spread(std::vector<std::uint32_t> edges, std::vector<std::uint32_t>& changed) {
    std::vector<std::uint32_t> lowered, further;
    while (!edges.empty()) {
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        lowered.clear();
        for (const std::uint32_t e : edges) {
            spread_along(2 * e, lowered);
            spread_along(2 * e + 1, lowered);
        }
        further.clear();
        for (const std::uint32_t v : lowered) {
            if (net_.is_inner(v)) continue;
            const auto ending = edges_at(v);
            further.insert(further.end(), ending.begin(), ending.end());
        }
        changed.insert(changed.end(), lowered.begin(), lowered.end());
        edges.swap(further);
    }
}

void WobbleReach::spread_along(std::uint32_t side, std::vector<std::uint32_t>& lowered) {
    const double wave = net_.wavelengths[BorderMap::edge_of(side)];
    if (!(wave > 0)) return;
    Point before;
    double reach = unbounded;
    const auto pass = [&](std::uint32_t v) {
        const Point p = net_.places[v];
        if (reach != unbounded) reach += steepest * length(to_px(Point{p.x - before.x, p.y - before.y}));
        before = p;
        if (!net_.is_inner(v) && net_.waves[v] != wave) {
            reach = 0;
            return;
        }
        if (reach < reaches_[v]) {
            reaches_[v] = reach;
            lowered.push_back(v);
        }
        reach = reaches_[v];
    };
    net_.walk(side, pass);
    pass(net_.map.end_of(side));
}

}  // namespace filigree
