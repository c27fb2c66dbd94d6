#include "plane/curve_cut_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "plane/ring_loops.h"
#include "plane/ring_sweep.h"

namespace filigree {
namespace {

// Whether a direction points to the right, or straight to +y.
bool is_right(std::int64_t x, std::int64_t y) { return x > 0 || (x == 0 && y > 0); }

// Whether a ring that starts at its least point has a positive area.
bool is_positive(RingView ring) {
    if (ring.size() > 16) {
        const int turn = orientation(ring.back(), ring[0], ring[1]);
        if (turn != 0) return turn > 0;
    }
    return doubled_area(ring) > 0;
}

// Segments with x and y swapped, so that sweep::compare tells left from right along a level line.
sweep::Segment upright(Point a, Point b) {
    const Point low{a.y, a.x}, high{b.y, b.x};
    return low < high ? sweep::Segment{low, high} : sweep::Segment{high, low};
}

}  // namespace

CutGraph::CutGraph(const std::vector<CutEdge>& edges, Point origin) : edges_(edges), origin_(origin) {
    number_vertices();
    rises_.resize(edges.size());
    is_on_curve_.resize(edges.size());
    is_live_.assign(edges.size(), 1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        is_on_curve_[e] = edges[e].side == CutEdge::on_curve;
        rises_[e] = is_on_curve_[e] != 0 ? 0 : 1;
    }
    collect_arms();
    prune();
    link();
    trace();
    if (remove_bridges()) {
        link();
        trace();
    }
    spread_windings();
    find_containers();
}

void CutGraph::number_vertices() {
    const std::size_t size = std::bit_ceil(edges_.size() * 2 + 16);
    std::vector<std::uint32_t> table(size, none);
    std::vector<Point> points;
    points.reserve(edges_.size() + 16);
    const auto number_of = [&](Point p) {
        std::uint64_t hash = static_cast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15U;
        hash = mix(hash ^ static_cast<std::uint64_t>(p.y));
        for (std::size_t at = hash & (size - 1);; at = (at + 1) & (size - 1)) {
            if (table[at] == none) {
                table[at] = static_cast<std::uint32_t>(points.size());
                points.push_back(p);
                return table[at];
            }
            if (points[table[at]] == p) return table[at];
        }
    };
    vertex_.resize(edges_.size() * 2);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const bool goes_on = e > 0 && edges_[e].from == edges_[e - 1].to;
        vertex_[2 * e] = goes_on ? vertex_[2 * e - 1] : number_of(edges_[e].from);
        vertex_[2 * e + 1] = number_of(edges_[e].to);
    }
    degree_.assign(points.size(), 0);
}

bool CutGraph::comes_before(Half a, Half b) const {
    const Point centre = tail(a);
    const Point p = head(a), q = head(b);
    const bool p_right = is_right(p.x - centre.x, p.y - centre.y);
    if (p_right != is_right(q.x - centre.x, q.y - centre.y)) return p_right;
    const int turn = orientation(centre, p, q);
    if (turn != 0) return turn > 0;
    const std::uint32_t a_side = edges_[a / 2].side, b_side = edges_[b / 2].side;  // equal edges: the shape's first
    return a_side != b_side ? a_side < b_side : a / 2 < b / 2;
}

void CutGraph::sort_arms(std::uint32_t vertex) {
    Half* const first = arms_.data() + (vertex == 0 ? 0 : arm_ends_[vertex - 1]);
    Half* const last = arms_.data() + arm_ends_[vertex];
    const auto before = [this](Half a, Half b) { return comes_before(a, b); };
    if (last - first > 16) return std::sort(first, last, before);
    for (Half* at = first + (first == last ? 0 : 1); at < last; ++at) {
        const Half moving = *at;
        Half* to = at;
        for (; to > first && before(moving, to[-1]); --to) *to = to[-1];
        *to = moving;
    }
}

void CutGraph::collect_arms() {
    const std::size_t count = degree_.size();
    for (const std::uint32_t v : vertex_) ++degree_[v];
    arm_ends_.resize(count);
    std::exclusive_scan(degree_.begin(), degree_.end(), arm_ends_.begin(), std::uint32_t{0});
    arms_.resize(vertex_.size());
    for (Half h = 0; h < vertex_.size(); ++h) arms_[arm_ends_[vertex_[h]]++] = h;
    for (std::uint32_t v = 0; v < count; ++v) {
        sort_arms(v);
        merge_equal_edges(v);
    }
}

// Equal edges become the first of them. Each is merged once, at the lower of its vertices.
void CutGraph::merge_equal_edges(std::uint32_t vertex) {
    const std::uint32_t begin = vertex == 0 ? 0 : arm_ends_[vertex - 1], end = arm_ends_[vertex];
    for (std::uint32_t i = begin; i < end;) {
        const Half kept = arms_[i];
        const std::uint32_t other = vertex_[kept ^ 1];
        std::uint32_t next = i + 1;
        for (; next < end && vertex_[arms_[next] ^ 1] == other; ++next) {
            if (vertex > other) continue;
            const Half merged = arms_[next];
            rises_[kept / 2] += rise(merged) * ((kept & 1) != 0 ? -1 : 1);
            is_on_curve_[kept / 2] |= is_on_curve_[merged / 2];
            remove(merged / 2);
        }
        // Where the shape has no width and no curve runs, there is nothing.
        if (next > i + 1 && vertex < other && rises_[kept / 2] == 0 && is_on_curve_[kept / 2] == 0) remove(kept / 2);
        i = next;
    }
}

void CutGraph::remove(std::uint32_t edge) {
    is_live_[edge] = 0;
    --degree_[vertex_[2 * edge]];
    --degree_[vertex_[2 * edge + 1]];
}

void CutGraph::prune() {
    std::vector<std::uint32_t> ends;
    for (std::uint32_t v = 0; v < degree_.size(); ++v) {
        if (degree_[v] == 1) ends.push_back(v);
    }
    while (!ends.empty()) {
        const std::uint32_t v = ends.back();
        ends.pop_back();
        if (degree_[v] != 1) continue;
        for (std::uint32_t i = v == 0 ? 0 : arm_ends_[v - 1];; ++i) {
            if (is_live_[arms_[i] / 2] == 0) continue;
            const std::uint32_t other = vertex_[arms_[i] ^ 1];
            remove(arms_[i] / 2);
            if (degree_[other] == 1) ends.push_back(other);
            break;
        }
    }
}

void CutGraph::link() {
    next_.assign(vertex_.size(), none);
    is_idle_.assign(degree_.size(), 0);
    std::uint32_t begin = 0;
    for (std::uint32_t v = 0; v < degree_.size(); ++v) {
        const std::uint32_t end = arm_ends_[v];
        Half first = none, last = none;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Half arm = arms_[i];
            if (is_live_[arm / 2] == 0) continue;
            // The face to the left of who comes in along an arm lies clockwise of it.
            if (last != none) next_[arm ^ 1] = last;
            if (first == none) first = arm;
            last = arm;
        }
        if (first != none) next_[first ^ 1] = last;
        if (degree_[v] == 2) {
            const std::uint32_t side = edges_[first / 2].side;
            is_idle_[v] = side != CutEdge::on_curve && side == edges_[last / 2].side;
        }
        begin = end;
    }
}

void CutGraph::trace() {
    cycle_.assign(vertex_.size(), none);
    first_of_cycle_.clear();
    for (Half start = 0; start < vertex_.size(); ++start) {
        if (is_live_[start / 2] == 0 || cycle_[start] != none) continue;
        const auto cycle = static_cast<std::uint32_t>(first_of_cycle_.size());
        first_of_cycle_.push_back(start);
        for (Half h = start; cycle_[h] == none; h = next_[h]) cycle_[h] = cycle;
    }
}

bool CutGraph::remove_bridges() {
    bool found = false;
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        if (is_live_[e] == 0 || cycle_[2 * e] != cycle_[2 * e + 1]) continue;
        remove(e);
        found = true;
    }
    return found;
}

void CutGraph::spread_windings() {
    component_.assign(first_of_cycle_.size(), none);
    winding_.assign(first_of_cycle_.size(), 0);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < first_of_cycle_.size(); ++start) {
        if (component_[start] != none) continue;
        const auto component = static_cast<std::uint32_t>(least_half_.size());
        Half least = first_of_cycle_[start];
        component_[start] = component;
        stack.push_back(start);
        while (!stack.empty()) {
            const std::uint32_t cycle = stack.back();
            stack.pop_back();
            Half h = first_of_cycle_[cycle];
            do {
                if (tail(h) < tail(least)) least = h;
                const std::uint32_t beside = cycle_[h ^ 1];
                if (component_[beside] == none) {
                    component_[beside] = component;
                    winding_[beside] = winding_[cycle] - rise(h);
                    stack.push_back(beside);
                }
                h = next_[h];
            } while (h != first_of_cycle_[cycle]);
        }
        // All arms of the least point lead to the right; beyond the last of them lies the outside.
        const std::uint32_t vertex = vertex_[least];
        for (std::uint32_t i = arm_ends_[vertex]; i-- > (vertex == 0 ? 0 : arm_ends_[vertex - 1]);) {
            if (is_live_[arms_[i] / 2] == 0) continue;
            least = arms_[i];
            break;
        }
        least_half_.push_back(least);
        outer_cycle_.push_back(cycle_[least]);
    }
}

void CutGraph::find_containers() {
    const std::size_t count = least_half_.size();
    container_.assign(count, none);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return tail(least_half_[a]) < tail(least_half_[b]); });
    std::vector<std::int32_t> shift(count, 0);
    std::vector<Edge> places;
    if (count > 1) {
        for (const CutEdge& e : edges_) places.push_back({to_px(e.from, origin_), to_px(e.to, origin_)});
    }
    const EdgeTree tree(std::move(places));
    // What lies to the left of a component's least point belongs to a component with a lesser one.
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t component = order[i];
        container_[component] = i == 0 ? none : container_left_of(component, tree);
        const std::uint32_t container = container_[component];
        shift[component] = (container == none ? 0 : winding_[container] + shift[component_[container]]) -
                           winding_[outer_cycle_[component]];
    }
    for (std::size_t c = 0; c < winding_.size(); ++c) winding_[c] += shift[component_[c]];
}

std::uint32_t CutGraph::container_left_of(std::uint32_t component, const EdgeTree& tree) const {
    const Point p = tail(least_half_[component]);
    const Vec at = to_px(p, origin_);
    // Just above p (towards +y), the nearest edge of another component; looked for in growing boxes.
    std::uint32_t found = none;
    const double whole = 0x1p32;
    for (double reach = std::max(1.0, length(tree.edges()[least_half_[component] / 2].to - at));; reach *= 4) {
        const bool is_last = reach > whole;
        found = none;
        tree.any({{is_last ? -whole : at.x - reach, at.y}, at}, [&](std::uint32_t e) {
            if (is_live_[e] == 0 || component_[cycle_[2 * e]] == component) return false;
            const auto [low, high] = std::minmax(edges_[e].from.y, edges_[e].to.y);
            if (low > p.y || high <= p.y) return false;
            const sweep::Segment edge = upright(edges_[e].from, edges_[e].to);
            if (orientation(edge.low, edge.high, {p.y, p.x}) <= 0) return false;  // not to the left
            if (found == none || sweep::compare(upright(edges_[found].from, edges_[found].to), edge) < 0) {
                found = e;
            }
            return false;
        });
        if (is_last) break;
        if (found == none) continue;
        const Edge& edge = tree.edges()[found];
        const double x = edge.from.x + (edge.to.x - edge.from.x) * ((at.y - edge.from.y) / (edge.to.y - edge.from.y));
        if (x > at.x - reach / 2) break;
    }
    if (found == none) return none;
    // The half-edge that leads towards -y has the right on its left.
    const std::uint32_t cycle = cycle_[2 * found + (edges_[found].from.y < edges_[found].to.y ? 1 : 0)];
    const std::uint32_t beside = component_[cycle];
    return outer_cycle_[beside] == cycle ? container_[beside] : cycle;
}

void CutGraph::add_loop(const Half* first, const Half* last, std::uint32_t face) {
    const auto begin = static_cast<std::uint32_t>(loop_points_.size());
    for (const Half* h = first; h != last; ++h) {
        if (is_idle_[vertex_[*h]] == 0) loop_points_.push_back(tail(*h));
    }
    const std::span<Point> ring{loop_points_.data() + begin, loop_points_.data() + loop_points_.size()};
    if (ring.size() < 3) return loop_points_.resize(begin);
    start_at_least(ring);
    loops_.push_back({begin, static_cast<std::uint32_t>(loop_points_.size()), face, !is_positive(ring)});
}

// The simple loops of a cycle: whenever the way comes back to a vertex that it has passed, that loop is a ring.
void CutGraph::add_loops(std::uint32_t cycle, std::uint32_t face) {
    way_.clear();
    Half h = first_of_cycle_[cycle];
    do {
        const std::uint32_t vertex = vertex_[h];
        const std::uint32_t before = position_[vertex];
        if (before != none) {
            add_loop(way_.data() + before, way_.data() + way_.size(), face);
            for (std::size_t i = before; i < way_.size(); ++i) position_[vertex_[way_[i]]] = none;
            way_.resize(before);
        }
        position_[vertex] = static_cast<std::uint32_t>(way_.size());
        way_.push_back(h);
        h = next_[h];
    } while (h != first_of_cycle_[cycle]);
    add_loop(way_.data(), way_.data() + way_.size(), face);
    for (const Half left : way_) position_[vertex_[left]] = none;
}

Polygons CutGraph::faces() {
    position_.assign(degree_.size(), none);
    for (std::uint32_t c = 0; c < first_of_cycle_.size(); ++c) {
        const std::uint32_t component = component_[c];
        const bool is_outside = outer_cycle_[component] == c;
        const std::uint32_t face = is_outside ? container_[component] : c;
        if (winding_[c] > 0 && face != none) add_loops(c, face);
    }
    // By face, the outer ring first, then the holes by their least points.
    const auto ring_of = [&](const Loop& loop) {
        return RingView{loop_points_.data() + loop.first, loop_points_.data() + loop.end};
    };
    const auto comes_before = [&](const Loop& a, const Loop& b) {
        const RingView p = ring_of(a), q = ring_of(b);
        if (p[0] != q[0]) return p[0] < q[0];
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    };
    std::sort(loops_.begin(), loops_.end(), [&](const Loop& a, const Loop& b) {
        if (a.face != b.face) return a.face < b.face;
        return a.is_hole != b.is_hole ? b.is_hole : comes_before(a, b);
    });
    std::vector<std::uint32_t> outers;
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
        if (!loops_[i].is_hole) outers.push_back(i);
    }
    std::sort(outers.begin(), outers.end(),
              [&](std::uint32_t a, std::uint32_t b) { return comes_before(loops_[a], loops_[b]); });
    Polygons result;
    result.points.reserve(loop_points_.size());
    result.ring_ends.reserve(loops_.size());
    result.polygon_ends.reserve(outers.size());
    for (const std::uint32_t outer : outers) {
        result.add_ring(ring_of(loops_[outer]));
        for (std::uint32_t i = outer + 1; i < loops_.size(); ++i) {
            if (!loops_[i].is_hole || loops_[i].face != loops_[outer].face) break;
            result.add_ring(ring_of(loops_[i]));
        }
        result.end_polygon();
    }
    return result;
}

}  // namespace filigree
