#include "plane/curve_cut_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace filigree {
namespace {

constexpr int most_rounds = 64;                          // two to four are usual
constexpr double sight = 2 / grid_per_px;                // px: within it edges are looked at
constexpr std::size_t few_edges = 1024;                  // not worth sorting
constexpr std::size_t most_cuts = std::size_t{1} << 25;  // in one round: a GiB

struct Segment {  // low before high
    Point low, high;

    auto operator<=>(const Segment&) const = default;
};
Segment segment_of(const CutEdge& e) { return e.from < e.to ? Segment{e.from, e.to} : Segment{e.to, e.from}; }

bool is_steep(const Segment& s) { return std::abs(s.high.y - s.low.y) > s.high.x - s.low.x; }
std::int64_t extent(const Segment& s) { return std::max(s.high.x - s.low.x, std::abs(s.high.y - s.low.y)); }

// Whether the boxes meet or lie within a grid unit of each other.
bool are_near(const CutEdge& e, const CutEdge& f) {
    return std::min(e.from.x, e.to.x) <= std::max(f.from.x, f.to.x) + 1 &&
           std::min(f.from.x, f.to.x) <= std::max(e.from.x, e.to.x) + 1 &&
           std::min(e.from.y, e.to.y) <= std::max(f.from.y, f.to.y) + 1 &&
           std::min(f.from.y, f.to.y) <= std::max(e.from.y, e.to.y) + 1;
}

// Whether the edge from a to b passes p, which is none of its ends, by half a grid unit or less, where
// `turn` = cross(a, b, p). Snapping only what crosses would let two edges that all but coincide close like a
// zip, a crossing every few grid units.
bool passes(Point a, Point b, Point p, Int128 turn) {
    const std::int64_t dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
    const std::int64_t run = std::max(dx, dy);
    if (2 * turn > run || 2 * turn < -run) return false;
    const auto [low, high] = dy > dx ? std::minmax(a.y, b.y) : std::minmax(a.x, b.x);
    const std::int64_t at = dy > dx ? p.y : p.x;
    return low < at && at < high;
}

int sign(Int128 turn) { return turn > 0 ? 1 : turn < 0 ? -1 : 0; }

// Which part of e lies before its crossing with f's line.
struct Fraction {
    double from_low = 0, from_high = 0;
};
Fraction fraction(const Segment& e, const Segment& f) {
    const Int128 low = cross(f.low, f.high, e.low);
    const Int128 high = cross(f.low, f.high, e.high);
    return {static_cast<double>(low) / static_cast<double>(low - high),
            static_cast<double>(high) / static_cast<double>(high - low)};
}

// Where two segments cross, rounded to the grid. Measured along the shorter and from its nearer end, where
// doubles are finest.
Point crossing(Segment e, Segment f) {
    if (extent(e) != extent(f) ? extent(f) < extent(e) : f < e) std::swap(e, f);
    const auto [from_low, from_high] = fraction(e, f);
    const bool near_low = from_low <= 0.5;
    const Point from = near_low ? e.low : e.high, to = near_low ? e.high : e.low;
    const double part = near_low ? from_low : from_high;
    const Point at{from.x + std::llround(part * static_cast<double>(to.x - from.x)),
                   from.y + std::llround(part * static_cast<double>(to.y - from.y))};
    const auto [y_low, y_high] = std::minmax(e.low.y, e.high.y);
    return {std::clamp(at.x, e.low.x, e.high.x), std::clamp(at.y, y_low, y_high)};
}

// Where a curve crosses an edge of the shape. Rounding to the nearest grid point bends the edge, and in a lattice
// of equal shapes all of them the same way, until areas are off by more than 1e-9. So, of the columns (for steep
// edges, rows) around the crossing, the one is taken where the edge passes nearest to a grid point.
Point crossing_on_side(const Segment& side, const Segment& curve) {
    constexpr double reach = 4;               // columns: less than 2^-23 px along the edge
    constexpr double reluctance = 1.0 / 512;  // of a grid unit off the edge, for a unit along it
    const bool steep = is_steep(side);
    const double dx = static_cast<double>(side.high.x - side.low.x), dy = static_cast<double>(side.high.y - side.low.y);
    const double run = steep ? dy : dx, rise = steep ? dx : dy;
    const double length = std::fabs(run);
    if (rise == 0 || length < 4 * reach || length > 0x1p46) return crossing(side, curve);
    const auto [from_low, from_high] = fraction(side, curve);
    const double place = from_low <= 0.5 ? from_low * length : length - from_high * length;
    const double slope = rise / length;
    const double middle = std::nearbyint(place);
    double best = middle, least = std::numeric_limits<double>::infinity();
    for (double at = std::max(1.0, middle - reach); at <= std::min(length - 1, middle + reach); ++at) {
        const double level = at * slope;
        const double cost = std::fabs(level - std::nearbyint(level)) + reluctance * std::fabs(at - place);
        if (cost < least) {
            least = cost;
            best = at;
        }
    }
    const std::int64_t along = std::llround(run < 0 ? -best : best), across = std::llround(best * slope);
    return steep ? Point{side.low.x + across, side.low.y + along} : Point{side.low.x + along, side.low.y + across};
}

// Along a Z-order curve of their middles, by 16 bits of x and of y: the boxes of a tree over edges in the order of
// long curves overlap far and wide.
void sort_by_place(std::vector<CutEdge>& edges) {
    const auto spread = [](std::uint32_t bits) {  // abc -> 0a0b0c
        bits = (bits | (bits << 8)) & 0x00FF00FFU;
        bits = (bits | (bits << 4)) & 0x0F0F0F0FU;
        bits = (bits | (bits << 2)) & 0x33333333U;
        return (bits | (bits << 1)) & 0x55555555U;
    };
    Box all;
    for (const CutEdge& e : edges) {
        extend(all, e.from);
        extend(all, e.to);
    }
    int shift = 0;
    while (std::max(all.max.x - all.min.x, all.max.y - all.min.y) >> shift > UINT16_MAX) ++shift;
    struct Place {
        std::uint32_t code = 0, edge = 0;
    };
    std::vector<Place> places(edges.size()), other(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const CutEdge& e = edges[i];
        const std::int64_t x = (e.from.x - all.min.x) / 2 + (e.to.x - all.min.x) / 2;
        const std::int64_t y = (e.from.y - all.min.y) / 2 + (e.to.y - all.min.y) / 2;
        places[i] = {
            spread(static_cast<std::uint32_t>(x >> shift)) | spread(static_cast<std::uint32_t>(y >> shift)) << 1, i};
    }
    for (int digit = 0; digit < 32; digit += 8) {
        std::array<std::uint32_t, 257> begins{};
        for (const Place& p : places) ++begins[((p.code >> digit) & 255) + 1];
        for (std::size_t d = 1; d < begins.size(); ++d) begins[d] += begins[d - 1];
        for (const Place& p : places) other[begins[(p.code >> digit) & 255]++] = p;
        places.swap(other);
    }
    std::vector<CutEdge> sorted;
    sorted.reserve(edges.size());
    for (const Place& p : places) sorted.push_back(edges[p.edge]);
    edges = std::move(sorted);
}

class Cutter {
public:
    Cutter(std::vector<CutEdge>& edges, Point origin) : edges_(edges), origin_(origin) {}

    bool run() {
        for (int round = 1;; ++round) {
            is_first_round_ = round == 1;
            if (is_first_round_ || edges_.size() - planted_ > planted_ / 8) plant();
            find_cuts();
            if (cuts_.empty()) return true;
            if (cuts_.size() > most_cuts || round == most_rounds) return false;
            apply_cuts();
        }
    }

private:
    struct Cut {
        std::uint32_t edge = 0;
        Point at;
    };

    Edge place(std::size_t i) const { return {to_px(edges_[i].from, origin_), to_px(edges_[i].to, origin_)}; }

    EdgeTree tree_from(std::size_t begin) const {
        std::vector<Edge> places(edges_.size() - begin);
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = place(begin + i);
        return EdgeTree(std::move(places));
    }

    // A tree over all edges. While few are added it serves on: what a cut leaves in an edge's place lies in its box.
    void plant() {
        if (edges_.size() > few_edges) sort_by_place(edges_);
        tree_ = tree_from(0);
        planted_ = edges_.size();
    }

    void find_cuts() {
        cuts_.clear();
        const std::size_t count = edges_.size();
        const auto new_ones = static_cast<std::size_t>(
            std::count_if(edges_.begin(), edges_.end(), [](const CutEdge& e) { return e.is_new; }));
        if (planted_ == count && 2 * new_ones > count) {
            find_all_cuts();
        } else {
            find_new_cuts();
        }
    }

    void find_all_cuts() {
        const std::span<const Edge> places = tree_.edges();
        const auto count = static_cast<std::uint32_t>(edges_.size());
        for (std::uint32_t first = 0; first < count; first += 4) {
            const std::size_t few = std::min<std::size_t>(4, count - first);
            tree_.any_near(places.subspan(first, few), sight, first, [&](std::size_t k, std::uint32_t j) {
                const auto i = static_cast<std::uint32_t>(first + k);
                if (i < j && (edges_[i].is_new || edges_[j].is_new)) test(i, j);
                return cuts_.size() > most_cuts;
            });
        }
    }

    void find_new_cuts() {
        const EdgeTree added = tree_from(planted_);
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (!edges_[i].is_new) continue;
            const auto meet = [&](std::uint32_t j) {
                if (i != j && (i < j || !edges_[j].is_new)) test(std::min(i, j), std::max(i, j));
                return cuts_.size() > most_cuts;
            };
            const VecBox box = around(place(i), sight);
            tree_.any(box, meet);
            added.any(box, [&](std::uint32_t j) { return meet(j + static_cast<std::uint32_t>(planted_)); });
        }
    }

    void cut(std::uint32_t edge, Point at) {
        if (at != edges_[edge].from && at != edges_[edge].to) cuts_.push_back({edge, at});
    }

    void test(std::uint32_t i, std::uint32_t j) {
        const CutEdge& e = edges_[i];
        const CutEdge& f = edges_[j];
        if (!are_near(e, f)) return;
        if (e.to == f.from) return test_corner(i, j, e.to, e.from, f.to);
        if (e.from == f.to) return test_corner(i, j, e.from, e.to, f.from);
        if (e.from == f.from) return test_corner(i, j, e.from, e.to, f.to);
        if (e.to == f.to) return test_corner(i, j, e.to, e.from, f.from);
        const Int128 e_from = cross(f.from, f.to, e.from), e_to = cross(f.from, f.to, e.to);
        const Int128 f_from = cross(e.from, e.to, f.from), f_to = cross(e.from, e.to, f.to);
        const std::size_t before = cuts_.size();
        if (passes(f.from, f.to, e.from, e_from)) cuts_.push_back({j, e.from});
        if (passes(f.from, f.to, e.to, e_to)) cuts_.push_back({j, e.to});
        if (passes(e.from, e.to, f.from, f_from)) cuts_.push_back({i, f.from});
        if (passes(e.from, e.to, f.to, f_to)) cuts_.push_back({i, f.to});
        if (cuts_.size() > before) return;
        if (sign(e_from) * sign(e_to) >= 0 || sign(f_from) * sign(f_to) >= 0) return;
        const bool e_is_side = e.side != CutEdge::on_curve, f_is_side = f.side != CutEdge::on_curve;
        const Segment a = segment_of(e), b = segment_of(f);
        const bool on_side = is_first_round_ && e_is_side != f_is_side;
        const Point at = !on_side ? crossing(a, b) : e_is_side ? crossing_on_side(a, b) : crossing_on_side(b, a);
        cut(i, at);
        cut(j, at);
    }

    // Edges i and j from a common corner to a and to b: they meet elsewhere only where they overlap.
    void test_corner(std::uint32_t i, std::uint32_t j, Point corner, Point a, Point b) {
        if (a == b) return;
        const Int128 turn = cross(corner, a, b);
        if (passes(corner, b, a, -turn)) cuts_.push_back({j, a});
        if (passes(corner, a, b, turn)) cuts_.push_back({i, b});
    }

    // The first piece of an edge takes its place, the others come last.
    void apply_cuts() {
        const std::size_t count = edges_.size();
        std::vector<std::uint32_t> ends(count + 1, 0);  // of each edge's cuts, once they are sorted in
        for (const Cut& c : cuts_) ++ends[c.edge + 1];
        for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
        std::vector<Point> points(cuts_.size());
        for (const Cut& c : cuts_) points[ends[c.edge]++] = c.at;
        edges_.reserve(count + cuts_.size());
        std::uint32_t begin = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t end = ends[i];
            const CutEdge e = edges_[i];
            edges_[i].is_new = begin < end;
            if (begin == end) continue;
            sort_along(e, points.data() + begin, points.data() + end);
            Point from = e.from;
            const auto add = [&](Point to) {
                if (from == to) return;
                const CutEdge piece{from, to, e.side, true};
                if (from == e.from) {
                    edges_[i] = piece;
                } else {
                    edges_.push_back(piece);
                }
                from = to;
            };
            for (; begin < end; ++begin) add(points[begin]);
            add(e.to);
        }
    }

    static void sort_along(const CutEdge& e, Point* first, Point* last) {
        const bool steep = is_steep(segment_of(e));
        const std::int64_t run = steep ? e.to.y - e.from.y : e.to.x - e.from.x;
        const std::int64_t rise = steep ? e.to.x - e.from.x : e.to.y - e.from.y;
        std::sort(first, last, [&](Point a, Point b) {
            if (steep) {
                std::swap(a.x, a.y);
                std::swap(b.x, b.y);
            }
            if (a.x != b.x) return (a.x < b.x) == (run > 0);
            return a.y != b.y && (a.y < b.y) == (rise > 0);
        });
    }

    std::vector<CutEdge>& edges_;
    Point origin_;
    EdgeTree tree_{{}};
    std::size_t planted_ = 0;  // how many edges the tree knows; more follow them
    std::vector<Cut> cuts_;
    bool is_first_round_ = true;
};

}  // namespace

bool cut_where_they_meet(std::vector<CutEdge>& edges, Point origin) { return Cutter(edges, origin).run(); }

}  // namespace filigree
