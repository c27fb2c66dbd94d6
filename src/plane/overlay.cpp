#include "plane/overlay.h"

#include <algorithm>
#include <set>

namespace filigree {

namespace {

using sweep::Segment;

constexpr std::uint32_t none = UINT32_MAX;

bool is_in(Region region, Winding w) {
    switch (region) {
        case Region::first:
            return w.first != 0;
        case Region::first_odd:
            return (w.first & 1) != 0;
        case Region::either:
            return w.first != 0 || w.second != 0;
        case Region::both:
            return w.first != 0 && w.second != 0;
        case Region::only_first:
            return w.first != 0 && w.second == 0;
    }
    return false;
}

enum class Side : std::uint8_t { neither, above, below };  // on which side of an edge alone the region lies

// A sweep over the vertices. It finds the winding number below every edge, and at every vertex links each edge
// of the boundary that comes in to the one that goes out along the same wedge of the region.
class Sweep {
public:
    Sweep(std::vector<WeightedEdge> edges, Region region) : edges_(std::move(edges)), region_(region) {
        std::sort(edges_.begin(), edges_.end(),
                  [](const WeightedEdge& a, const WeightedEdge& b) { return a.at < b.at; });
    }

    std::vector<std::vector<Point>> rings() {
        visit_vertices();
        return trace();
    }

private:
    struct Below {  // compares places of the status by the edges that they hold now
        const Sweep* sweep;
        bool operator()(std::uint32_t a, std::uint32_t b) const {
            const std::uint32_t e = sweep->held_[a], f = sweep->held_[b];
            const int side = sweep::compare(sweep->edges_[e].at, sweep->edges_[f].at);
            return side != 0 ? side < 0 : e < f;
        }
    };
    using Status = std::set<std::uint32_t, Below>;

    void sort_upwards(std::vector<std::uint32_t>& some) const {
        std::sort(some.begin(), some.end(), [&](std::uint32_t a, std::uint32_t b) {
            const int side = sweep::compare(edges_[a].at, edges_[b].at);
            return side != 0 ? side < 0 : a < b;
        });
    }

    void visit_vertices() {
        const auto count = static_cast<std::uint32_t>(edges_.size());
        std::vector<std::uint32_t> by_end(count);
        for (std::uint32_t i = 0; i < count; ++i) by_end[i] = i;
        std::sort(by_end.begin(), by_end.end(), [&](std::uint32_t a, std::uint32_t b) {
            return edges_[a].at.high != edges_[b].at.high ? edges_[a].at.high < edges_[b].at.high : a < b;
        });
        winding_below_.resize(count);
        sides_.resize(count, Side::neither);
        places_.resize(count, status_.end());
        low_vertex_.resize(count);
        high_vertex_.resize(count);
        next_.resize(count, none);
        std::vector<std::uint32_t> ending, starting;
        for (std::uint32_t started = 0, ended = 0; ended < count;) {
            const Point end = edges_[by_end[ended]].at.high;
            const Point at = started < count ? std::min(edges_[started].at.low, end) : end;
            ending.clear();
            starting.clear();
            for (; ended < count && edges_[by_end[ended]].at.high == at; ++ended) ending.push_back(by_end[ended]);
            for (; started < count && edges_[started].at.low == at; ++started) starting.push_back(started);
            visit(ending, starting);
            ++vertex_count_;
        }
    }

    void visit(std::vector<std::uint32_t>& ending, std::vector<std::uint32_t>& starting) {
        for (const std::uint32_t edge : ending) high_vertex_[edge] = vertex_count_;
        for (const std::uint32_t edge : starting) low_vertex_[edge] = vertex_count_;
        if (ending.size() == 1 && starting.size() == 1) {  // most vertices: the place in the order stays
            const std::uint32_t before = ending[0], after = starting[0];
            places_[after] = places_[before];
            held_[*places_[after]] = after;
            winding_below_[after] = winding_below_[before];
            sides_[after] = side_of(after);
        } else {
            sort_upwards(ending);
            sort_upwards(starting);
            for (const std::uint32_t edge : ending) status_.erase(places_[edge]);
            for (const std::uint32_t edge : starting) {
                held_.push_back(edge);
                places_[edge] = status_.insert(static_cast<std::uint32_t>(held_.size()) - 1).first;
            }
            for (const std::uint32_t edge : starting) {
                if (places_[edge] != status_.begin()) {
                    const std::uint32_t below = held_[*std::prev(places_[edge])];
                    winding_below_[edge] = winding_below_[below] + edges_[below].weight;
                }
                sides_[edge] = side_of(edge);
            }
        }
        link(ending, starting);
    }

    Side side_of(std::uint32_t edge) const {
        const bool below = is_in(region_, winding_below_[edge]);
        const bool above = is_in(region_, winding_below_[edge] + edges_[edge].weight);
        return below == above ? Side::neither : above ? Side::above : Side::below;
    }

    // The arms of a vertex in the order from +x to +y: those that start, upwards, then those that end,
    // downwards. Every wedge of the region begins with an arm that goes out and ends with one that comes in.
    void link(const std::vector<std::uint32_t>& ending, const std::vector<std::uint32_t>& starting) {
        arms_.clear();
        for (const std::uint32_t edge : starting) {
            if (sides_[edge] != Side::neither) arms_.push_back({edge, sides_[edge] == Side::above});
        }
        for (auto edge = ending.rbegin(); edge != ending.rend(); ++edge) {
            if (sides_[*edge] != Side::neither) arms_.push_back({*edge, sides_[*edge] == Side::below});
        }
        for (std::size_t i = 0; i < arms_.size(); ++i) {
            const Arm& before = arms_[i == 0 ? arms_.size() - 1 : i - 1];
            if (!arms_[i].is_out && before.is_out) next_[arms_[i].edge] = before.edge;
        }
    }

    std::uint32_t first_vertex(std::uint32_t edge) const {
        return sides_[edge] == Side::above ? low_vertex_[edge] : high_vertex_[edge];
    }
    Point first_point(std::uint32_t edge) const {
        return sides_[edge] == Side::above ? edges_[edge].at.low : edges_[edge].at.high;
    }

    // Follows the links; whenever the way comes back to a vertex that it has passed, that loop is a ring.
    std::vector<std::vector<Point>> trace() const {
        std::vector<std::vector<Point>> rings;
        std::vector<bool> is_done(edges_.size(), false);
        std::vector<std::uint32_t> position(vertex_count_, none);  // on the way
        std::vector<std::uint32_t> way;                            // edges
        for (std::uint32_t start = 0; start < edges_.size(); ++start) {
            if (sides_[start] == Side::neither || is_done[start]) continue;
            way.clear();
            std::uint32_t edge = start;
            for (; edge != none; edge = next_[edge]) {
                const std::uint32_t vertex = first_vertex(edge);
                if (position[vertex] != none) {
                    std::vector<Point> ring;
                    for (std::size_t i = position[vertex]; i < way.size(); ++i) ring.push_back(first_point(way[i]));
                    while (way.size() > position[vertex]) {
                        const std::uint32_t passed = first_vertex(way.back());
                        way.pop_back();
                        if (passed != vertex) position[passed] = none;
                    }
                    rings.push_back(std::move(ring));
                    position[vertex] = none;
                }
                if (is_done[edge]) break;
                is_done[edge] = true;
                position[vertex] = static_cast<std::uint32_t>(way.size());
                way.push_back(edge);
            }
            for (const std::uint32_t left : way) position[first_vertex(left)] = none;
        }
        return rings;
    }

    struct Arm {
        std::uint32_t edge = 0;
        bool is_out = false;
    };

    std::vector<WeightedEdge> edges_;
    Region region_;
    std::vector<std::uint32_t> held_;  // the edge at each place of the status
    Status status_{Below{this}};
    std::vector<Winding> winding_below_;
    std::vector<Side> sides_;
    std::vector<Status::iterator> places_;
    std::vector<std::uint32_t> low_vertex_, high_vertex_;
    std::uint32_t vertex_count_ = 0;
    std::vector<std::uint32_t> next_;  // along the boundary
    std::vector<Arm> arms_;
};

}  // namespace

std::vector<std::vector<Point>> boundary(std::vector<WeightedEdge> edges, Region region) {
    return Sweep(std::move(edges), region).rings();
}

}  // namespace filigree
