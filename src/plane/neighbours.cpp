#include "plane/neighbours.h"

#include <algorithm>

#include "plane/weld.h"

namespace filigree {

namespace {

struct Side {
    Point low, high;  // the ends of an edge, in order
    std::uint32_t polygon = 0;

    auto operator<=>(const Side&) const = default;
};

std::vector<Side> sides_of(const Polygons& polygons) {
    std::vector<Side> sides;
    sides.reserve(polygons.points.size());
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
        const PolygonView polygon = polygons[p];
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
            const RingView ring = polygon.ring(r);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
                sides.push_back({std::min(a, b), std::max(a, b), p});
            }
        }
    }
    return sides;
}

}  // namespace

Neighbours neighbours(const Polygons& polygons) {
    std::vector<Side> sides = sides_of(weld(polygons));
    std::sort(sides.begin(), sides.end());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
        for (std::size_t a = i; a < end; ++a) {
            for (std::size_t b = a + 1; b < end; ++b) {
                if (sides[a].polygon == sides[b].polygon) continue;
                pairs.emplace_back(sides[a].polygon, sides[b].polygon);
                pairs.emplace_back(sides[b].polygon, sides[a].polygon);
            }
        }
        i = end;
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Neighbours out;
    out.starts.resize(polygons.size() + 1);
    for (const auto& [from, to] : pairs) {
        ++out.starts[from + 1];
        out.to.push_back(to);
    }
    for (std::size_t i = 1; i < out.starts.size(); ++i) out.starts[i] += out.starts[i - 1];
    return out;
}

namespace {

// Polygons in the order in which they are coloured: last comes the one with the fewest neighbours, before it the one
// with the fewest among the rest, and so on. In the plane each then has at most five that are coloured before it.
std::vector<std::uint32_t> smallest_last(const Neighbours& neighbours) {
    const std::size_t count = neighbours.starts.size() - 1;
    std::vector<std::uint32_t> degree(count);
    std::vector<std::vector<std::uint32_t>> by_degree;
    const auto put = [&](std::uint32_t polygon) {
        if (by_degree.size() <= degree[polygon]) by_degree.resize(degree[polygon] + 1);
        by_degree[degree[polygon]].push_back(polygon);
    };
    for (std::size_t i = count; i-- > 0;) {
        degree[i] = neighbours.starts[i + 1] - neighbours.starts[i];
        put(static_cast<std::uint32_t>(i));
    }
    std::vector<std::uint32_t> order;
    std::vector<bool> taken(count);
    for (std::size_t least = 0; order.size() < count;) {
        if (by_degree[least].empty()) {
            ++least;
            continue;
        }
        const std::uint32_t polygon = by_degree[least].back();
        by_degree[least].pop_back();
        if (taken[polygon] || degree[polygon] != least) continue;  // it has moved to a lower degree since
        taken[polygon] = true;
        order.push_back(polygon);
        for (std::uint32_t n = neighbours.starts[polygon]; n < neighbours.starts[polygon + 1]; ++n) {
            const std::uint32_t other = neighbours.to[n];
            if (taken[other]) continue;
            --degree[other];
            put(other);
        }
        if (least > 0) --least;
    }
    std::reverse(order.begin(), order.end());
    return order;
}

class Colouring {
public:
    Colouring(const Neighbours& neighbours, std::uint32_t colours)
        : neighbours_(neighbours), colours_(colours), colour_(neighbours.starts.size() - 1, none), seen_(colours) {}

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> used(colours_);
        for (const std::uint32_t polygon : smallest_last(neighbours_)) {
            count_around(polygon);
            std::uint32_t best = choose(used);
            if (seen_[best] > 0 && swap_chain(polygon)) {
                count_around(polygon);
                best = choose(used);
            }
            colour_[polygon] = best;
            ++used[best];
        }
        return std::move(colour_);
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    template <class Visit>
    void for_each_neighbour(std::uint32_t polygon, Visit visit) const {
        for (std::uint32_t n = neighbours_.starts[polygon]; n < neighbours_.starts[polygon + 1]; ++n) {
            if (colour_[neighbours_.to[n]] != none) visit(neighbours_.to[n]);
        }
    }
    void count_around(std::uint32_t polygon) {
        std::fill(seen_.begin(), seen_.end(), 0);
        for_each_neighbour(polygon, [&](std::uint32_t other) { ++seen_[colour_[other]]; });
    }
    // The colour that fewest neighbours have; of those the one used least so far, so that all come about equally often.
    std::uint32_t choose(const std::vector<std::uint32_t>& used) const {
        std::uint32_t best = 0;
        for (std::uint32_t c = 1; c < colours_; ++c) {
            if (std::pair(seen_[c], used[c]) < std::pair(seen_[best], used[best])) best = c;
        }
        return best;
    }

    // Frees a colour for the polygon, whose neighbours have them all: exchanges two colours in the chain of polygons
    // that hangs on one neighbour (Kempe), where that chain comes back to no other neighbour.
    bool swap_chain(std::uint32_t polygon) {
        std::vector<std::uint32_t> around;
        for_each_neighbour(polygon, [&](std::uint32_t other) { around.push_back(other); });
        for (const std::uint32_t first : around) {
            const std::uint32_t from = colour_[first];
            if (seen_[from] != 1) continue;
            for (std::uint32_t to = 0; to < colours_; ++to) {
                if (to == from) continue;
                const std::vector<std::uint32_t> chain = chain_from(first, to);
                const bool comes_back = std::any_of(around.begin(), around.end(), [&](std::uint32_t other) {
                    return other != first && std::find(chain.begin(), chain.end(), other) != chain.end();
                });
                if (comes_back || chain.size() > longest_chain) continue;
                for (const std::uint32_t link : chain) colour_[link] = colour_[link] == from ? to : from;
                return true;
            }
        }
        return false;
    }
    std::vector<std::uint32_t> chain_from(std::uint32_t first, std::uint32_t to) const {
        const std::uint32_t from = colour_[first];
        std::vector<std::uint32_t> chain{first};
        std::vector<bool> known(colour_.size());
        known[first] = true;
        for (std::size_t i = 0; i < chain.size() && chain.size() <= longest_chain; ++i) {
            for_each_neighbour(chain[i], [&](std::uint32_t other) {
                if (known[other] || (colour_[other] != from && colour_[other] != to)) return;
                known[other] = true;
                chain.push_back(other);
            });
        }
        return chain;
    }

    static constexpr std::size_t longest_chain = 4096;

    const Neighbours& neighbours_;
    const std::uint32_t colours_;
    std::vector<std::uint32_t> colour_;
    std::vector<std::uint32_t> seen_;  // how many neighbours of the present polygon have each colour
};

}  // namespace

std::vector<std::uint32_t> coloured(const Neighbours& neighbours, std::uint32_t colours) {
    if (neighbours.starts.size() < 2 || colours == 0) {
        return std::vector<std::uint32_t>(neighbours.starts.empty() ? 0 : neighbours.starts.size() - 1);
    }
    return Colouring(neighbours, colours).run();
}

}  // namespace filigree
